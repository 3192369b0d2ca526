//! Tables as Rust source and as wire files.

use crate::support::{
    DEGREE, Folder, ORDER, assert_fails, assert_usage_errors, lights, materials, repository, scene,
    stderr,
};
use crate::tolerances;
use eigenshade::Basis;
use eigenshade_cli::messages::grouped;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_shading::integer_shader::OwnedQuantized;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::quantize::{TOLERANCE, integers};
use eigenshade_table::{Table, statics};
use std::fs;
use std::path::Path;
use std::process::Command;

const NORMALS: [[f64; 3]; 4] =
    [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.48, 0.6, 0.64], [0.28, -0.96, 0.0]];

/// Name, geometry, rotation, degree, order, criterion, components, modes.
type Kind = (&'static str, usize, usize, usize);

const KINDS: [Kind; 3] = [("centered", 9, 7, 37), ("lambertian", 2, 0, 9), ("high", 12, 12, 60)];

fn table(folder: &Folder, kind: &Kind) -> (Table, Lights, Materials) {
    let (name, degree, order, components) = kind;
    folder.write("lights.csv", lights(*degree, 3));
    folder.write("materials.csv", materials(*order, 4));
    folder.write(
        "scene.toml",
        format!(
            "[light]\ndegree = {degree}\ndatabase = \"lights.csv\"\n\
             [material]\norder = {order}\ndatabase = \"materials.csv\"\n\
             [basis]\ncriterion = \"image-centered\"\ncomponents = {components}\n"
        ),
    );
    let file = format!("{name}.bin");
    folder.ok(&format!("basis --scene scene.toml --out {file}"));
    let table = folder.table(&file);
    let lights = read_lights(folder.path("lights.csv"), Some(*degree)).expect("lights");
    let materials = read_materials(folder.path("materials.csv"), Some(*order)).expect("materials");
    (table, lights, materials)
}

/// Code that prints, for the table of this name, d by `project`, d by `transfer` and `relight`, and
/// the irradiance of the normals.
fn print_floats(name: &str, light: &[f64], material: &[f64]) -> String {
    format!(
        "{{
    let light: &[f32] = &{light:?};
    let material: &[f32] = &{material:?};
    let light = eigenshade::Light::new(light).unwrap();
    let material = eigenshade::Material::new(material).unwrap();
    let d = {name}::project(&light, &material).unwrap();
    let transfer = {name}::transfer(&material).unwrap();
    let relit = {name}::relight(&transfer, &light).unwrap();
    let scene = {name}::collapse(&d);
    assert_eq!(d.len(), {name}::COMPONENTS);
    let normals: [[f32; 3]; 4] = {NORMALS:?};
    for value in d.iter().chain(&relit) {{ print!(\"{{value:?}} \"); }}
    for [x, y, z] in normals {{
        let normal = eigenshade::Normal::new(x, y, z).unwrap();
        print!(\"{{:?}} \", scene.shade(normal));
    }}
    println!();
}}\n"
    )
}

/// Luminance, rounded to f32.
fn rounded(values: Vec<f64>) -> Vec<f64> {
    values.into_iter().map(|value| f64::from(value as f32)).collect()
}

/// Degree and order of the tables in integers.
const SIZES: [(usize, usize); 6] = [(2, 0), (4, 0), (3, 1), (9, 1), (5, 2), (2, 3)];

/// Compares the generated functions of the module `NAME` with the general ones.
const COMPARE_INTEGERS: &str = r#"
{
    use eigenshade::q15::{Light, Material, Normal};
    use eigenshade::Q15;
    let lights = NAME::DEGREE + 1;
    let (mut brightest, mut images) = (0, 0);
    for seed in 1..40_u32 {
        let mut state = seed;
        let mut number = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            Q15(((i64::from(state as i32) * 32_767) >> 32) as i16)
        };
        // The first coefficient is as large as possible, so that its product is the largest.
        let mut material: Vec<Q15> = (0..MATERIAL).map(|_| number()).collect();
        let mut light: Vec<Q15> = (0..lights * lights).map(|_| number()).collect();
        if seed % 2 == 0 {
            material[0] = Q15(if seed % 4 == 0 { -32_767 } else { 32_767 });
            light[0] = material[0];
        }
        for rise in [0_i8, 3, -2] {
            let exponents: Vec<i8> = (0..=NAME::ORDER as i8).map(|o| rise * o - 4).collect();
            let material = Material::new(&exponents, &material).unwrap();
            let light = Light::new(1, &light).unwrap();
            let transfer = NAME::transfer(&material).unwrap();
            let general = NAME::BASIS
                .transfer::<{ NAME::WORKSPACE }, { NAME::TRANSFER }, { NAME::PROFILES }>(&material);
            assert_eq!(transfer, general.unwrap(), "NAME, transfer, {seed}, {rise}");
            let d = NAME::relight(&transfer.view(), &light).unwrap();
            let general = NAME::BASIS.relight::<{ NAME::COMPONENTS }>(&transfer.view(), &light);
            assert_eq!(d, general.unwrap(), "NAME, relight, {seed}, {rise}");
            let scene = NAME::collapse(&d);
            let general = NAME::BASIS.collapse::<{ NAME::SCENE }>(d.mantissas(), d.exponent()).unwrap();
            assert_eq!(scene.exponent(), general.exponent(), "NAME, collapse, {seed}, {rise}");
            let half = Q15(1 << 14);
            let aslant = Q15((32_768.0 * 0.75_f64.sqrt()) as i16);
            for normal in [[half, Q15(0), aslant], [Q15(0), Q15(-half.0), aslant], [-aslant.0, 0, half.0].map(Q15)] {
                let normal = Normal::from_unit(normal[0], normal[1], normal[2]).unwrap();
                let pixel = scene.shade(normal);
                assert_eq!(pixel, general.shade(normal), "NAME, pixel, {seed}, {rise}");
                brightest = brightest.max(pixel.unsigned_abs());
                images += 1;
            }
        }
    }
    println!("NAME {images} {brightest}");
}
"#;

/// Compiles the source of all tables in one program and runs it: what it printed, and d and the
/// image of each of [`KINDS`], which it should print.
fn compiled() -> (String, Vec<[Vec<f32>; 2]>) {
    let folder = Folder::new();
    let (mut files, mut expected, mut body) = (Vec::new(), Vec::new(), String::new());
    for kind in &KINDS {
        let (table, lights, materials) = table(&folder, kind);
        files.push((
            kind.0.to_owned(),
            statics::floats(&table, "a test").expect("a table that projects"),
        ));
        let light = rounded(lights.entries[1].luminance());
        let material = rounded(materials.entries[2].luminance());
        let owned = OwnedBasis::new(&table).expect("a table for f32");
        let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
        let d = shader.project(&light, &material).expect("d").to_vec();
        let normals = OwnedNormals::new(&NORMALS);
        let image = shader.polynomial(&light, &material, &normals).expect("an image");
        expected.push([d, image]);
        body += &print_floats(kind.0, &light, &material);
    }
    for (degree, order) in SIZES {
        let small = ("small", degree, order, 30);
        let (table, ..) = self::table(&folder, &small);
        let name = format!("of_{degree}_{order}");
        let parts = integers(&table, TOLERANCE).expect("parts");
        let count = eigenshade_table::material::count(order).to_string();
        body += &COMPARE_INTEGERS.replace("NAME", &name).replace("MATERIAL", &count);
        files.push((name, statics::integers(&parts, "a test")));
    }
    (output_of("compiled-tables", &files, &body), expected)
}

/// Compiles a program of these modules and this body of `main`, in a folder that keeps the compiled
/// dependencies for the next run, and returns what it prints.
pub fn output_of(program: &str, modules: &[(String, String)], body: &str) -> String {
    let programs = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compiled");
    let folder = programs.join(program);
    fs::create_dir_all(folder.join("src")).expect("a folder");
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file");
    let mut main = format!("fn main() {{{body}}}\n");
    for (name, source) in modules {
        write(&format!("src/{name}.rs"), source);
        main += &format!("mod {name} {{ include!(\"{name}.rs\"); }}\n");
    }
    write("src/main.rs", &main);
    // The workspace's versions of the dependencies, which are on this machine.
    let lock = fs::read_to_string(repository().join("Cargo.lock")).expect("a lock file");
    write("Cargo.lock", &lock);
    let runtime = repository().canonicalize().expect("a path");
    write(
        "Cargo.toml",
        &format!(
            "[package]\nname = \"{program}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\
             [workspace]\n[dependencies]\n\
             eigenshade = {{ path = {runtime:?}, default-features = false }}\n\
             [profile.dev]\ndebug = false\n"
        ),
    );
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline"])
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", programs.join("target"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8(output.stdout).expect("text")
}

/// The generated source of tables of many kinds gives what the same tables give when they are read
/// at run time; small ones in integers give the same bits as the general functions.
#[test]
fn compiled_tables_agree_with_tables_that_are_read() {
    let (printed, expected) = compiled();
    let lines: Vec<&str> = printed.lines().collect();
    assert_eq!(lines.len(), KINDS.len() + SIZES.len());
    for ((line, [d, image]), (name, ..)) in lines.iter().zip(&expected).zip(KINDS) {
        let found: Vec<f32> =
            line.split_whitespace().map(|number| number.parse().expect("a number")).collect();
        let expected: Vec<f32> = d.iter().chain(d).chain(image).copied().collect();
        assert_eq!(found.len(), expected.len(), "{name}");
        let largest = expected.iter().fold(0.0f32, |most, value| most.max(value.abs()));
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let error = (found - expected).abs() / largest;
            assert!(error <= tolerances::SAME_SUM_F32, "{name}, number {k}: {found} {expected}");
        }
    }
    // The program compares integers itself, and prints the number of pixels and the brightest.
    for line in &lines[KINDS.len()..] {
        let numbers: Vec<u64> =
            line.split(' ').skip(1).map(|n| n.parse().expect("a number")).collect();
        assert!(numbers[0] > 300 && numbers[1] > 1 << 12, "black images: {line}");
    }
}

fn of_floats(basis: &Basis<'_>) -> String {
    let [workspace, transfer, components, scene] =
        [basis.workspace_len(), basis.transfer_len(), basis.components(), basis.scene_len()]
            .map(grouped);
    format!("WORKSPACE {workspace}, TRANSFER {transfer}, COMPONENTS {components}, SCENE {scene}")
}

fn of_integers(table: &Table) -> String {
    let owned = OwnedQuantized::new(table, TOLERANCE).expect("integers");
    let basis = owned.view().expect("a basis");
    let profiles = basis.profiles();
    let [workspace, transfer, components, scene] =
        [basis.workspace_len(), basis.transfer_len(), basis.components(), basis.scene_len()]
            .map(grouped);
    format!(
        "WORKSPACE {workspace}, TRANSFER {transfer}, PROFILES {profiles}, COMPONENTS {components}, \
         SCENE {scene}"
    )
}

#[test]
fn info_describes_wire_files() {
    let folder = Folder::with_table();
    let table = folder.table("b.bin");
    for format in ["f32", "q15"] {
        let summary = folder.ok(&format!("pack --table b.bin --format {format} --out w.esw"));
        let bytes = folder.bytes("w.esw");
        assert!(bytes.starts_with(b"EIGSWIRE"));
        let length = grouped(bytes.len());
        let (bytes, error) = summary.split_once('\n').expect("two lines");
        assert_eq!(bytes, format!("bytes        {length}"));
        assert!(error.starts_with("error        ") && error.contains("of the peak"), "{error}");
        let buffers = match format {
            "f32" => {
                of_floats(&OwnedBasis::new(&table).expect("a table").basis().expect("a basis"))
            }
            _ => of_integers(&table),
        };
        let description = folder.ok("info --table w.esw");
        for line in [
            "wire version             4".to_owned(),
            format!("format                   {format}"),
            format!("degree                   {DEGREE}"),
            format!("order                    {ORDER}"),
            format!("file                     {length:>9} bytes"),
            format!("buffers                  {buffers}"),
        ] {
            assert!(description.lines().any(|found| found == line), "no `{line}` in {description}");
        }
    }
}

#[test]
fn the_first_components_are_a_table_of_fewer() {
    let folder = Folder::with_table();
    let count = folder.table("b.bin").count();
    folder.write("few.toml", scene("image-centered", 5, "[]"));
    folder.ok("basis --scene few.toml --out few.bin");
    for format in ["f32", "q15"] {
        folder.ok(&format!("pack --table few.bin --format {format} --out few.esw"));
        let summary = folder
            .ok(&format!("pack --table b.bin --components 5 --format {format} --out first.esw"));
        assert_eq!(folder.bytes("few.esw"), folder.bytes("first.esw"), "{format}");
        assert!(summary.contains("over the shipped lights and materials"), "{summary}");
    }
    let more = format!("pack --table b.bin --components {} --out new.esw", count + 1);
    assert_fails(&folder, &more, &["b.bin", &format!("it has {count} components"), "at most"]);
    assert_usage_errors(&folder, &["pack --table b.bin --components 0 --out new.esw"]);
    folder.write("stored.toml", scene("image-centered", 5, "[]") + "store = \"materials\"\n");
    folder.ok("basis --scene stored.toml --out stored.bin");
    let stored = "pack --table stored.bin --components 2 --out new.esw";
    assert_fails(&folder, stored, &["stored.bin", "a table that projects", "with fewer"]);
}

#[test]
fn tables_without_a_wire_file_are_refused() {
    let folder = Folder::with_table();
    let make = |name: &str, scene: String| {
        folder.write("scene.toml", scene);
        folder.ok(&format!("basis --scene scene.toml --out {name}.bin"));
    };
    make("mean", scene("standard", 10, "[]"));
    let selected = scene("image-centered", 10, "[]");
    make("selected", selected.replace("profile_tolerance", "modes = 20\nprofile_tolerance"));
    for format in ["f32", "q15"] {
        let pack = |table: &str| format!("pack --table {table}.bin --format {format} --out v.esw");
        assert_fails(&folder, &pack("mean"), &["mean.bin: ", "mean image", "image-centered"]);
        assert_fails(&folder, &pack("selected"), &["selected.bin: ", "a selection", "modes = 0"]);
    }
    let drawn = "render -t mean.bin -l lights.csv:light-0 -m materials.csv:material-0 --size 8 \
                 --out p.png";
    assert_fails(&folder, drawn, &["mean image", "use --format f64"]);
    folder.ok(&format!("{drawn} --format f64"));
    make("materials", scene("image-centered", 10, "[]") + "store = \"materials\"\n");
    for (arguments, fragments) in [
        ("materials.bin --out v.esw", &["materials.bin: ", "store = \"projection\""][..]),
        ("scene.toml --out v.esw", &["not an eigenshade table"]),
        ("b.bin --out none/v.esw", &["none/v.esw", "folder exists"]),
    ] {
        assert_fails(&folder, &format!("pack --table {arguments}"), fragments);
    }
}

/// Except for what depends on this machine. Damaged files are refused.
#[test]
fn info_describes_files_of_either_byte_order() {
    let folder = Folder::with_table();
    folder.ok("pack --table b.bin --out little.esw");
    folder.ok("pack --table b.bin --big-endian --out big.esw");
    let [little, big] = ["little", "big"].map(|order| {
        let text = folder.ok(&format!("info --table {order}.esw"));
        let is_own = |line: &&str| line.starts_with("byte order") || line.starts_with("buffers");
        let (own, others): (Vec<&str>, Vec<&str>) = text.lines().partition(is_own);
        assert!(own[0].ends_with(&format!(" {order}-endian")), "{own:?}");
        folder.write("short.esw", &folder.bytes(&format!("{order}.esw"))[..200]);
        assert_fails(&folder, "info --table short.esw", &["short.esw: ", "200 found", "take all"]);
        others.join("\n")
    });
    assert_eq!(little, big);
    let mut damaged = folder.bytes("little.esw");
    damaged[300] ^= 1;
    folder.write("damaged.esw", damaged);
    assert_fails(&folder, "info --table damaged.esw", &["damaged.esw: ", "checksum"]);
}
