//! What `basis` chooses for a tolerance: degree, order, components and terms, against direct sums
//! of the whole degree and order under lights that are turned at random.

mod support;

#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

use eigenshade_cli::owned_basis::OwnedBasis;
use eigenshade_cli::shader::{OwnedNormals, Shader};
use eigenshade_cli::shipped;
use eigenshade_generator::basis::chosen;
use eigenshade_generator::choice::{Choice, Reach};
use eigenshade_generator::database::{Lights, Materials};
use eigenshade_generator::rotation::Rotation;
use eigenshade_generator::scene_file;
use eigenshade_generator::truth::Truth;
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::{light, material};
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Parts, Scene, Table, decode};
use std::f64::consts::{FRAC_PI_2, TAU};
use support::{Folder, assert_fails, lights, materials, noise, repository, scene};

const DEGREE: usize = 8;
const ORDER: usize = 7;

/// Lights and materials, captured ones, of these degree and order.
fn databases() -> (Lights, Materials) {
    let (lights, materials) = (shipped::lights(), shipped::materials());
    let mut lights = lights.expect("lights").truncated(DEGREE);
    let mut materials = materials.expect("materials").truncated(ORDER);
    lights.entries = lights.entries.into_iter().step_by(4).collect();
    materials.entries = materials.entries.into_iter().step_by(6).collect();
    (lights, materials)
}

fn asked(criterion: Criterion, effects: Effects, tolerance: f64) -> Scene {
    let path = repository().join("tables/sphere.toml");
    let mut asked = scene_file::load(&path).expect("a scene").scene;
    (asked.light.degree, asked.material.order) = (DEGREE, ORDER);
    (asked.basis.components, asked.basis.tolerance) = (None, Some(tolerance));
    asked.basis.criterion = criterion;
    asked.effects.wanted = Effect::ALL.into_iter().filter(|one| effects.has(*one)).collect();
    asked
}

/// Normals of equal projected areas.
fn normals() -> Vec<[f64; 3]> {
    let count = 150;
    let normal = |k| {
        let square = (f64::from(k) + 0.5) / f64::from(count);
        let (y, x) = (TAU * 0.618_034 * f64::from(k)).sin_cos();
        let radius = square.sqrt();
        [radius * x, radius * y, (1.0 - square).sqrt()]
    };
    (0..count).map(normal).collect()
}

/// The database's lights, scaled to L_0^0 = 1.
fn scaled(lights: &Lights) -> Vec<Vec<f64>> {
    let unit = |light: Vec<f64>| light.iter().map(|value| value / light[0]).collect();
    lights.entries.iter().map(|entry| unit(entry.luminance())).collect()
}

/// Each light turned by so many rotations, all alike.
fn turned(lights: &Lights, count: usize) -> Vec<Vec<f64>> {
    let mut noise = noise(5);
    let mut rotation = || Rotation {
        alpha: (2.0 * noise()).clamp(-1.0, 1.0).acos(),
        beta: TAU * noise(),
        gamma: TAU * noise(),
    };
    let of = |light: &Vec<f64>| (0..count).map(|_| rotation().turn(DEGREE, light)).collect();
    scaled(lights).iter().flat_map::<Vec<_>, _>(of).collect()
}

/// Direct sums (15) over the modes of some effects and of a degree and an order: for each
/// material, each light, each normal.
fn direct(
    lights: &[Vec<f64>],
    materials: &Materials,
    normals: &[[f64; 3]],
    effects: Effects,
    [degree, order]: [usize; 2],
) -> Vec<Vec<f64>> {
    let truth = Truth::new(DEGREE, ORDER);
    let at: Vec<_> = normals.iter().map(|normal| truth.at(*normal)).collect();
    let mut images = Vec::new();
    for entry in &materials.entries {
        let of_effects = |l: usize| {
            let each = material::indices(ORDER).zip(entry.luminance());
            let kept = |o| o <= order && effects.keeps(l, o);
            each.map(|((o, _, _), b)| if kept(o) { b } else { 0.0 }).collect::<Vec<_>>()
        };
        let (ambient, rest) = (of_effects(0), of_effects(1));
        let scattered: Vec<_> =
            at.iter().map(|at| [at.scatter(&ambient), at.scatter(&rest)]).collect();
        for light in lights {
            let of = |taken: &dyn Fn(usize) -> bool| {
                let each = light::indices(DEGREE).zip(light);
                each.map(|((l, _), value)| if taken(l) { *value } else { 0.0 }).collect::<Vec<_>>()
            };
            let (ambient, rest) = (of(&|l| l == 0), of(&|l| l > 0 && l <= degree));
            let pixel = |(at, [of_ambient, of_rest]): (_, &[_; 2])| {
                let at: &eigenshade_generator::truth::Modes<'_> = at;
                at.irradiance(&ambient, of_ambient) + at.irradiance(&rest, of_rest)
            };
            images.push(at.iter().zip(&scattered).map(pixel).collect());
        }
    }
    images
}

/// Root of the mean square of all differences.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let differences = a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).powi(2));
    let count = a.iter().map(Vec::len).sum::<usize>();
    (differences.sum::<f64>() / count as f64).sqrt()
}

/// The database's peak, on a grid of its own.
fn peak(lights: &Lights, materials: &Materials, effects: Effects) -> f64 {
    let grid: Vec<[f64; 3]> = (0..=30)
        .flat_map(|slant| {
            let (sine, z) = (FRAC_PI_2 * f64::from(slant) / 30.0).sin_cos();
            (0..40).map(move |tilt| {
                let (y, x) = (TAU * f64::from(tilt) / 40.0).sin_cos();
                [sine * x, sine * y, z.max(0.0)]
            })
        })
        .collect();
    let images = direct(&scaled(lights), materials, &grid, effects, [DEGREE, ORDER]);
    let largest = |image: &Vec<f64>| image.iter().fold(0.0f64, |most, one| most.max(one.abs()));
    let squares: f64 = images.iter().map(|image| largest(image).powi(2)).sum();
    (squares / images.len() as f64).sqrt()
}

/// The table's images, in f64, lights and materials as far as it takes them.
fn shaded(
    table: &Table,
    lights: &[Vec<f64>],
    materials: &Materials,
    normals: &[[f64; 3]],
) -> Vec<Vec<f64>> {
    let basis = OwnedBasis::<f64>::new(table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let owned = OwnedNormals::new(normals);
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut images = Vec::new();
    for entry in &materials.entries {
        let material = &entry.luminance()[..material::count(order)];
        for light in lights {
            let light = &light[..light::count(degree)];
            let image = shader.polynomial((degree, light), (order, material), &owned);
            images.push(image.expect("it fits"));
        }
    }
    images
}

/// Numbers of the runtime's table.
fn numbers(table: &Table) -> usize {
    let parts = Parts::new(table);
    parts.polar.len() + parts.factors.len() + parts.ambient.len() + parts.terms.len()
}

/// What is said is what is in the table.
fn agree(choice: &Choice, table: &Table) {
    let Reach::Chosen { degree, order } = choice.reach else { panic!("{:?}", choice.reach) };
    assert_eq!([degree.of, order.of], [DEGREE, ORDER]);
    assert_eq!([degree.kept, order.kept], [table.gram.degree, table.gram.order]);
    assert_eq!([degree.kept, order.kept], [table.scene.light.degree, table.scene.material.order]);
    assert_eq!(choice.components.kept, table.components.len());
    assert_eq!(choice.components.of, table.spectrum.len());
    let lengths = Parts::new(table).lengths;
    let both = |(m, length): (usize, &u16)| usize::from(*length) * if m == 0 { 1 } else { 2 };
    let terms: usize = lengths.iter().enumerate().map(both).sum();
    assert_eq!(choice.terms.expect("terms").kept, terms);
    assert!(choice.total <= choice.tolerance * (1.0 + 1e-9));
}

/// The real error is within the tolerance, and not much less; a smaller tolerance has no smaller
/// table.
#[test]
fn tables_are_within_their_tolerance_and_no_larger_than_it_asks_for() {
    let (lights, materials) = databases();
    let (turned, normals) = (turned(&lights, 24), normals());
    let matte: Effects = [Effect::Ambient, Effect::Diffuse, Effect::Broad].into_iter().collect();
    for effects in [Effects::ALL, matte] {
        let truth = direct(&turned, &materials, &normals, effects, [DEGREE, ORDER]);
        let peak = peak(&lights, &materials, effects);
        for criterion in [Criterion::ImageCentered, Criterion::Standard] {
            let mut before = 0;
            for tolerance in [0.1, 0.03, 1e-2, 3e-3, 1e-3, 1e-4] {
                let asked = asked(criterion, effects, tolerance);
                let (table, choice) = chosen(&asked, &lights, &materials).expect("a table");
                let choice = choice.expect("a choice");
                agree(&choice, &table);
                assert!((choice.peak / peak - 1.0).abs() <= tolerances::PEAK_GRID);
                let found = apart(&shaded(&table, &turned, &materials, &normals), &truth) / peak;
                let numbers = numbers(&table);
                println!("{criterion:?} {tolerance}: {found:.2e}, {numbers} numbers\n{choice}");
                assert!(found <= choice.total * tolerances::CHOICE_SAMPLED, "{found}");
                assert!(found <= tolerance * tolerances::CHOICE_SAMPLED, "{found} of {tolerance}");
                assert!(found >= tolerance * tolerances::CHOICE_USED, "{found} of {tolerance}");
                assert!(numbers >= before, "{numbers} after {before}");
                before = numbers;
            }
        }
    }
}

/// What degree, order and components are said to leave, and would with one less, against
/// direct sums; and the components that are left out are the fewest that have to stay.
#[test]
fn what_is_said_to_be_left_out_is() {
    let (lights, materials) = databases();
    let (turned, normals) = (turned(&lights, 24), normals());
    let sum = |reach| direct(&turned, &materials, &normals, Effects::ALL, reach);
    let truth = sum([DEGREE, ORDER]);
    let peak = peak(&lights, &materials, Effects::ALL);
    let asked = asked(Criterion::ImageCentered, Effects::ALL, 0.01);
    let (table, choice) = chosen(&asked, &lights, &materials).expect("a table");
    let choice = choice.expect("a choice");
    let Reach::Chosen { degree, order } = choice.reach else { panic!("{:?}", choice.reach) };
    let whole_order = |degree| sum([degree, ORDER]);
    let own = whole_order(degree.kept);
    let less = sum([degree.kept, order.kept - 1]);
    let kept = sum([degree.kept, order.kept]);
    for (what, said, found) in [
        ("degrees", degree.leaves, apart(&own, &truth)),
        ("one less", degree.one_less.expect("less"), apart(&whole_order(degree.kept - 1), &truth)),
        ("orders", order.leaves, apart(&kept, &own)),
        ("one less", order.one_less.expect("less"), apart(&less, &own)),
    ] {
        let found = found / peak;
        println!("{what}: {said:.3e} said, {found:.3e} found");
        assert!(found <= said * tolerances::CHOICE_SAMPLED, "{what}: {found} for {said}");
        assert!(said <= found * tolerances::CHOICE_SAMPLED, "{what}: {found} for {said}");
    }
    let left = |count| table.energy_left(count).sqrt() / choice.peak;
    assert!((left(table.count()) / choice.components.leaves - 1.0).abs() < 1e-9);
    assert!((left(table.count() - 1) / choice.components.one_less.unwrap() - 1.0).abs() < 1e-9);
    // With one less too little would be left to the polynomials.
    let rest = (choice.tolerance.powi(2) - degree.leaves.powi(2)).sqrt() - order.leaves;
    assert!(left(table.count() - 1).powi(2) > 0.9 * rest * rest);
}

/// The small scene with a tolerance, and these lines of `[basis]`.
fn folder(tolerance: &str, basis: &str) -> Folder {
    let folder = Folder::new();
    folder.write("lights.csv", lights(6, 3));
    folder.write("materials.csv", materials(5, 4));
    let text = scene("image-centered", 1, "[]").replace("degree = 4", "degree = 6");
    let text = text.replace("order = 3", "order = 5");
    let text = text.replace("components = 1\n", &format!("tolerance = {tolerance}\n{basis}"));
    folder.write("scene.toml", text);
    folder
}

/// What `basis` says on standard error.
fn said(folder: &Folder) -> Vec<String> {
    let output = folder.run("basis --scene scene.toml --out b.bin");
    let text = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(0), "{text}");
    text.lines().map(str::to_owned).collect()
}

#[test]
fn basis_says_what_it_chose_and_why() {
    for tolerance in ["0.3", "0.05", "1e-3"] {
        let folder = folder(tolerance, "");
        let lines = said(&folder);
        println!("{lines:#?}");
        let table = decode(&std::fs::read(folder.path("b.bin")).unwrap()).unwrap();
        let (degree, order) = (table.gram.degree, table.gram.order);
        let (count, of) = (table.components.len(), table.spectrum.len());
        assert_eq!(lines.len(), 5);
        for (line, start) in lines.iter().zip([
            format!("degree {degree} of 6"),
            format!("order {order} of 5"),
            format!("components {count} of {of}"),
            "polynomial terms ".to_owned(),
            "in all at most ".to_owned(),
        ]) {
            assert!(line.starts_with(&start), "{line}: {start}");
        }
        let manifest = folder.read("b.manifest.csv");
        for row in [format!("degree,{degree},"), format!("order,{order},")] {
            assert!(manifest.lines().any(|line| line.starts_with(&row)), "{row}");
        }
        let info = folder.ok("info b.bin");
        let value = |what: &str| {
            let line = info.lines().find(|line| line.split_whitespace().next() == Some(what));
            line.and_then(|line| line.split_whitespace().last().map(str::to_owned))
        };
        assert_eq!(value("degree"), Some(degree.to_string()));
        assert_eq!(value("order"), Some(order.to_string()));
        folder.ok("basis --scene scene.toml --check b.bin");
        folder.ok("shade b.bin --lights lights.csv --materials materials.csv --normals normals.csv");
    }
    let coarse = folder("0.3", "");
    said(&coarse);
    let table = decode(&std::fs::read(coarse.path("b.bin")).unwrap()).unwrap();
    assert!(table.gram.degree < 6 && table.gram.order < 5, "nothing was chosen");
}

/// Where the degree and the order stay as the scene has them, it is said; the components
/// are chosen all the same.
#[test]
fn degree_and_order_stay_where_they_are_not_chosen() {
    let selection = folder("0.05", "modes = 60\n");
    let object = folder("0.05", "");
    let text = object.read("scene.toml").replace("\"sphere\"", "\"normals.csv\"");
    object.write("scene.toml", text);
    let as_captured = folder("0.05", "");
    let text = as_captured.read("scene.toml").replace("\"any\"", "\"none\"");
    as_captured.write("scene.toml", text);
    let black = folder("0.05", "");
    black.write("materials.csv", "name,o,p,q,value\n".to_owned() + &zeros());
    for (folder, why) in [
        (&selection, "modes"),
        (&object, "spheres"),
        (&as_captured, "freely"),
        (&black, "black"),
    ] {
        let lines = said(folder);
        println!("{lines:#?}");
        assert!(lines[0].starts_with("degree and order as asked: ") && lines[0].contains(why));
        assert!(lines[1].starts_with("components "), "{}", lines[1]);
        let table = decode(&std::fs::read(folder.path("b.bin")).unwrap()).unwrap();
        assert_eq!([table.gram.degree, table.gram.order], [6, 5]);
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

fn zeros() -> String {
    let row = |(o, p, q)| format!("black,{o},{p},{q},0\n");
    material::indices(5).map(row).collect()
}

/// A cut-off that leaves more out than the tolerance.
#[test]
fn a_tolerance_that_is_not_met_is_refused() {
    let cut = folder("1e-3", "rank_cutoff = 0.3\n");
    assert_fails(&cut, "basis --scene scene.toml --out b.bin", &["basis.tolerance", "rank_cutoff"]);
    for wrong in ["0.0", "1.0", "-1e-3", "nan"] {
        let bad = folder(wrong, "");
        assert_fails(&bad, "basis --scene scene.toml --out b.bin", &["basis.tolerance"]);
    }
}

/// A table of transfers, and one of a set of effects that leaves ambient apart.
#[test]
fn stores_and_effects_choose_too() {
    for basis in [
        "store = \"materials\"\n",
        "store = \"projection\"\n",
        "[effects]\nuse = [\"ambient\"]\n",
        "[effects]\nuse = [\"gloss\"]\n",
        "[effects]\nuse = [\"ambient\", \"diffuse\"]\n",
    ] {
        let folder = folder("0.02", "");
        let text = folder.read("scene.toml") + basis;
        folder.write("scene.toml", text);
        println!("{basis}{:#?}", said(&folder));
        folder.ok("basis --scene scene.toml --check b.bin");
        folder.ok("info b.bin");
    }
}
