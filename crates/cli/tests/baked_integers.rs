//! Tables of small orders as compiled code in integers: the generated functions give, bit
//! for bit, what the general ones give.

use crate::support::{Folder, compiled, lights, materials};
use eigenshade_table::quantize::{Format, QuantizedParts};
use eigenshade_table::{decode, rust_quantised};
use std::fmt::Write;
use std::fs;

/// Degree and order.
const SIZES: [(usize, usize); 6] = [(2, 0), (4, 0), (3, 1), (9, 1), (5, 2), (2, 3)];

/// What is compared, of the module `NAME` in the format `KIND` of `BITS` bits.
const PROGRAM: &str = r#"
{
    use eigenshade::quantised::{Light, Material, Normal};
    use eigenshade::KIND;
    let lights = NAME::DEGREE + 1;
    let (mut brightest, mut images) = (0, 0);
    for seed in 1..40_u32 {
        let mut state = seed;
        let mut number = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            KIND(((i64::from(state as i32) * 32_767) >> (62 + 1 - 31 - (BITS - 15))) as _)
        };
        // The first coefficient is as large as can be: its product is the largest.
        let mut material: Vec<KIND> = (0..MATERIAL).map(|_| number()).collect();
        let mut light: Vec<KIND> = (0..lights * lights).map(|_| number()).collect();
        if seed % 2 == 0 {
            material[0] = KIND(if seed % 4 == 0 { -1 } else { 1 } * (((1_i64 << BITS) - 1) as i32 as INT));
            light[0] = material[0];
        }
        for rise in [0_i8, 3, -2] {
            let exponents: Vec<i8> = (0..=NAME::ORDER as i8).map(|o| rise * o - 4).collect();
            let material = Material::new(NAME::ORDER, &exponents, &material).unwrap();
            let light = Light::new(NAME::DEGREE, 1, &light).unwrap();
            let transfer = NAME::fold(&material).unwrap();
            let general = NAME::BASIS
                .fold::<{ NAME::WORKSPACE }, { NAME::TRANSFER }, { NAME::PROFILES }>(&material);
            assert_eq!(transfer, general.unwrap(), "NAME, fold, {seed}, {rise}");
            let d = NAME::relight(&transfer.view(), &light).unwrap();
            let general = NAME::BASIS.relight::<{ NAME::COMPONENTS }>(&transfer.view(), &light);
            assert_eq!(d, general.unwrap(), "NAME, relight, {seed}, {rise}");
            let scene = NAME::collapse(&d).unwrap();
            let general = NAME::BASIS.collapse::<{ NAME::SCENE }>(d.mantissas(), d.exponent()).unwrap();
            assert_eq!(scene.exponent(), general.exponent(), "NAME, collapse, {seed}, {rise}");
            let half = KIND((1_i64 << (BITS - 1)) as INT);
            let aslant = KIND(((1_i64 << BITS) as f64 * 0.75_f64.sqrt()) as INT);
            for normal in [[half, KIND(0), aslant], [KIND(0), KIND(-half.0), aslant], [-aslant.0, 0, half.0].map(KIND)] {
                let normal = Normal::<KIND>::new(normal[0], normal[1], normal[2]).unwrap();
                let pixel = NAME::shade(&scene, normal);
                assert_eq!(pixel, general.shade(normal), "NAME, pixel, {seed}, {rise}");
                brightest = brightest.max(pixel.unsigned_abs());
                images += 1;
            }
        }
    }
    println!("NAME {images} {brightest}");
}
"#;

#[test]
fn compiled_integers_are_the_general_ones() {
    let folder = Folder::new();
    fs::create_dir(folder.path("src")).expect("a folder");
    let (mut modules, mut body) = (String::new(), String::new());
    for (degree, order) in SIZES {
        folder.write("lights.csv", lights(degree, 3));
        folder.write("materials.csv", materials(order, 4));
        folder.write(
            "scene.toml",
            format!(
                "[geometry]\nnormals = \"sphere\"\n\
                 [light]\ndegree = {degree}\ndatabase = \"lights.csv\"\nrotation = \"any\"\n\
                 [material]\norder = {order}\ndatabase = \"materials.csv\"\n\
                 [basis]\ncriterion = \"image-centered\"\ncomponents = 30\n"
            ),
        );
        folder.ok("basis --scene scene.toml --out small.bin");
        let table = decode(&fs::read(folder.path("small.bin")).expect("a table")).expect("a table");
        for (format, kind, bits, int) in
            [(Format::Q15, "Q15", "15", "i16"), (Format::Q31, "Q31", "31", "i32")]
        {
            let name = format!("of_{degree}_{order}_{bits}");
            let parts = QuantizedParts::new(&table, format, format.tolerance()).expect("parts");
            let source = rust_quantised::module(&parts, "a test");
            folder.write(&format!("src/{name}.rs"), source);
            writeln!(modules, "mod {name} {{ include!(\"{name}.rs\"); }}").expect("text");
            let count = eigenshade_index::material::count(order).to_string();
            let program = PROGRAM.replace("NAME", &name).replace("KIND", kind);
            let program = program.replace("BITS", bits).replace("INT", int);
            body += &program.replace("MATERIAL", &count);
        }
    }
    folder.write("src/main.rs", format!("{modules}fn main() {{{body}}}\n"));
    let text = compiled(&folder);
    println!("{text}");
    assert_eq!(text.lines().count(), 2 * SIZES.len());
    for line in text.lines() {
        let numbers: Vec<u64> =
            line.split(' ').skip(1).map(|n| n.parse().expect("a number")).collect();
        assert!(numbers[0] > 300 && numbers[1] > 1 << 12, "black images: {line}");
    }
}
