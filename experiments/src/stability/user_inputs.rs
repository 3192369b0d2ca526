//! Difficult user inputs: normals of 8 bits and behind the rim, a sun, a light that rings,
//! successive rotations, pixels at full weight. Images of the shipped table are compared with its
//! f64 sums.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade::mathematics::{Libm, SinglePrecision};
use eigenshade::quantised;
use eigenshade::{
    Error, Light, MapPoint, Material, Negatives, Normal, Normals, Q15, Rotation, Tolerance, sphere,
};
use eigenshade_index::light;
use eigenshade_model::database::Named;
use eigenshade_model::inputs::coefficient_csv::read_materials;
use eigenshade_model::rotation;
use eigenshade_model::special::gauss_legendre;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_testing::fixtures::{ROOT, captured};
use eigenshade_testing::largest;
use eigenshade_testing::oracle::{ExplicitLight, Numbers};
use std::f64::consts::PI;
use std::path::Path;

/// Error of 8-bit normals taken as they are: rms relative to the peak, for the worst pair.
const NAIVE_EIGHT_BITS: f64 = 2.5e-3;

/// Error of taking normals behind the rim as they are, as a multiple of the value at the rim: z =
/// -0.01 and -0.1.
const NAIVE_BEHIND: [f64; 2] = [1.01, 1.5];

/// Error of moving a normal to the rim: an image's slope times an f32 rounding.
const LAID_ON_RIM: f64 = 5e-6;

/// Error of a sun in f32, rms relative to the peak: the same as for any light.
const SUN_F32: f64 = 1e-6;

/// Error of a sun in Q15: the worst pair's 68 dB.
const SUN_Q15: f64 = 4e-4;

/// The ratio by which rounding may exceed a bound, for images of some thousand times the error.
const SUN_BOUND: f64 = 1.0001;

/// Error of a sun through baked maps of 64 x 64, in floats and in integers: twice the worst of
/// [`BAKED`].
const SUN_BAKED: [f64; 2] = [1e-3, 1e-3];

/// How far a light from one direction, to degree 9, falls below zero, relative to the peak.
const RINGING: f64 = 5e-2;

/// Error of a thousand plain products in f32, whose roundings add up.
const NAIVE_DRIFT: f64 = 5e-6;

/// Error of RRᵀ of any rotation in f32: sixteen roundings, and those of the sum itself.
const ORTHONORMAL_F32: f64 = 1.2e-6;

/// Error of matrices within 1e-3 of a rotation, taken as they are.
const NAIVE_ALMOST: f64 = 9e-4;

/// Error of the energy of a degree of a light rotated in f32.
const ALMOST_ENERGY: f64 = 1e-6;

/// Error of a mean of equal pixels: d has 31 bits.
const HALF_WEIGHT: f64 = 1e-8;

pub const EIGHT_BITS: Case = Case {
    name: "a normal map of 8 bits",
    naively: "vectors of other lengths than 1, taken as they are",
    here: "`Normals::normalized`, in integers `Normal::along`, once a map; directions stay rounded",
    measure: eight_bits,
};

pub const BEHIND: Case = Case {
    name: "normals slightly behind the rim, z = -0.01 to -0.1",
    naively: "polynomials leave their range, the faster the longer they are",
    here: "laid on the rim where normals are scaled, down to z = -1/8; loops over pixels are as they were",
    measure: behind,
};

pub const SUN: Case = Case {
    name: "a sun 1e6 times the sky on shipped materials, by every way to a pixel",
    naively: "a number format, a tolerance or a map that has room for the sky or for the sun",
    here: "one exponent for an image, tolerances of its peak; the sky beside the sun keeps the peak's digits",
    measure: sun,
};

pub const DELTA: Case = Case {
    name: "a light that is one direction: its lobes below zero, by every way to a pixel",
    naively: "each way clamps for itself, or overflows",
    here: "all ways keep the same negative values; `Negatives` clamps them, in floats and integers",
    measure: delta,
};

pub const DRIFT: Case = Case {
    name: "a thousand small rotations in a row in f32",
    naively: "products of matrices stop being rotations",
    here: "products are made orthonormal again beyond 16 roundings; turning keeps each degree's energy. What is left is the \
           rounding of the small rotation, a thousand times",
    measure: drift,
};

pub const ALMOST: Case = Case {
    name: "a matrix 1e-3 off orthonormal, as a rotation in f32",
    naively: "light that is turned gains or loses energy, more with the degree",
    here: "the rotation next to it",
    measure: almost,
};

pub const FULL_WEIGHT: Case = Case {
    name: "65,536 pixels at full weight, read in Q15",
    naively: "a sum that saturates",
    here: "`Error::Saturated`; half the weight fits, and gives what weight 1 gives",
    measure: full_weight,
};

fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

/// The shipped materials, every `step`-th.
fn materials(step: usize) -> Vec<Vec<f64>> {
    let path = Path::new(ROOT).join("tables/inputs/materials.csv");
    let materials = read_materials(path, Some(7)).expect("the shipped materials");
    materials.entries.iter().step_by(step).map(Named::luminance).collect()
}

/// Unit normals of a picture of a sphere.
fn disc(across: i32) -> Vec<[f64; 3]> {
    let place = |k: i32| f64::from(2 * k + 1) / f64::from(across) - 1.0;
    let pixels = (0..across).flat_map(|j| (0..across).map(move |k| (place(k), place(j))));
    let visible = pixels.filter(|(x, y)| x * x + y * y <= 1.0);
    visible.map(|(x, y)| [x, y, (1.0 - x * x - y * y).sqrt()]).collect()
}

/// The shipped table in f64, whose sums are the reference.
fn reference() -> OwnedBasis<f64> {
    let bytes = std::fs::read(Path::new(ROOT).join("tables/sphere.bin")).expect("the table");
    OwnedBasis::new(&eigenshade_table::decode(&bytes).expect("a table"))
}

/// d and the image in f64.
fn image(
    owned: &OwnedBasis<f64>,
    light: &[f64],
    material: &[f64],
    normals: &[[f64; 3]],
) -> Vec<f64> {
    let basis = owned.basis().expect("a basis");
    let light = Light::new(9, light).expect("coefficients");
    let material = Material::new(7, material).expect("coefficients");
    let mut d = vec![0.0; basis.components()];
    let mut workspace = vec![0.0; basis.workspace_len()];
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
    let seen = |&[x, y, z]: &[f64; 3]| {
        basis.reconstruct(&d, Normal::new(x, y, z).expect("visible")).expect("components")
    };
    normals.iter().map(seen).collect()
}

/// A scene in f32 with the same light on the same material.
fn scene(light: &[f64], material: &[f64]) -> (sphere::Coefficients, sphere::Scene) {
    let (light, material) = (single(light), single(material));
    let light = Light::checked(9, &light).expect("finite coefficients");
    let material = Material::checked(7, &material).expect("finite coefficients");
    let d = sphere::project(&light, &material).expect("it fits");
    let scene = sphere::collapse(&d).expect("it fits");
    (d, scene)
}

/// The image in Q15, as mantissas and their common exponent, at normals that are rounded to Q15.
fn integers(light: &[f64], material: &[f64], normals: &[[f64; 3]]) -> (Vec<i32>, f64) {
    let (light, material) = (single(light), single(material));
    let (mut of_light, mut of_material, mut exponents) = ([Q15(0); 100], [Q15(0); 40], [0; 8]);
    let light = quantised::Light::quantise(9, &light, &mut of_light).expect("a light");
    let material = quantised::Material::quantise(7, &material, &mut of_material, &mut exponents);
    let folded = sphere::q15::fold(&material.expect("a material")).expect("it fits");
    let d = sphere::q15::relight(&folded.view(), &light).expect("it fits");
    let scene = sphere::q15::collapse(&d).expect("it fits");
    let seen = |normal: &[f64; 3]| scene.shade(in_integers(*normal));
    (normals.iter().map(seen).collect(), 2f64.powi(scene.exponent()))
}

fn in_integers(normal: [f64; 3]) -> quantised::Normal<Q15> {
    let [x, y, z] = normal.map(|c| (c * f64::from(i32::MAX)) as i32);
    quantised::Normal::along(x, y, z).expect("a direction")
}

/// The rms and the largest error, relative to the peak of the reference.
fn errors(found: impl IntoIterator<Item = f64>, expected: &[f64]) -> [f64; 2] {
    let apart: Vec<f64> = found.into_iter().zip(expected).map(|(a, b)| a - b).collect();
    assert_eq!(apart.len(), expected.len());
    let rms = (apart.iter().map(|e| e * e).sum::<f64>() / apart.len() as f64).sqrt();
    let peak = largest(expected.iter().copied());
    [rms / peak, largest(apart) / peak]
}

/// The median and the largest value.
fn spread(mut values: Vec<f64>) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    [values[values.len() / 2], values[values.len() - 1]]
}

fn shaded(scene: &sphere::Scene, [x, y, z]: [&[f32]; 3]) -> Vec<f64> {
    let mut irradiance = vec![0.0; x.len()];
    let normals = Normals::new(x, y, z).expect("one length");
    scene.shade_slice(normals, &mut irradiance).expect("one length");
    irradiance.into_iter().map(f64::from).collect()
}

fn eight_bits() -> Vec<Figure> {
    let normals = disc(64);
    let decoded: Vec<[i32; 3]> = normals
        .iter()
        .map(|normal| normal.map(|c| 2 * ((c + 1.0) * 127.5).round() as i32 - 255))
        .collect();
    let axis = |axis: usize| -> Vec<f32> {
        decoded.iter().map(|vector| vector[axis] as f32 / 255.0).collect()
    };
    let raw = [0, 1, 2].map(axis);
    let [mut x, mut y, mut z] = raw.clone();
    Normals::normalized::<Libm>(&mut x, &mut y, &mut z).expect("visible");
    let owned = reference();
    let (mut naive, mut ours, mut of_integers) = (Vec::new(), Vec::new(), Vec::new());
    for light in captured(9).entries.iter().step_by(3) {
        for material in materials(5) {
            let light = light.luminance();
            let expected = image(&owned, &light, &material, &normals);
            let (_, scene) = scene(&light, &material);
            naive.push(errors(shaded(&scene, raw.each_ref().map(Vec::as_slice)), &expected));
            ours.push(errors(shaded(&scene, [&x, &y, &z]), &expected));
            let scaled: Vec<[f64; 3]> = decoded.iter().map(|v| v.map(f64::from)).collect();
            let length = |[x, y, z]: [f64; 3]| (x * x + y * y + z * z).sqrt();
            let scaled: Vec<_> = scaled.iter().map(|&v| v.map(|c| c / length(v))).collect();
            let (seen, unit) = integers(&light, &material, &scaled);
            let seen = seen.into_iter().map(|one| f64::from(one) * unit);
            of_integers.push(errors(seen, &expected));
        }
    }
    let rms = |errors: &[[f64; 2]]| spread(errors.iter().map(|error| error[0]).collect());
    let [_, naive_worst] = rms(&naive);
    let [median, worst] = rms(&ours);
    let [median_15, worst_15] = rms(&of_integers);
    let [_, point] = spread(ours.iter().map(|error| error[1]).collect());
    vec![
        Figure::least("as they are, rms of the peak, worst", naive_worst, NAIVE_EIGHT_BITS),
        Figure::most("scaled: median", median, tolerances::EIGHT_BITS[0]),
        Figure::most("worst", worst, tolerances::EIGHT_BITS[1]),
        Figure::most("worst pixel", point, tolerances::EIGHT_BITS[2]),
        Figure::most("scaled, in Q15: median", median_15, tolerances::EIGHT_BITS[0]),
        Figure::most("worst", worst_15, tolerances::EIGHT_BITS[1]),
    ]
}

/// Uses a table of degree 12, whose polynomials are longer than those of the shipped table.
fn behind() -> Vec<Figure> {
    let bytes = std::fs::read(Path::new(ROOT).join("tables/pbr.bin")).expect("the table");
    let owned = OwnedBasis::<f32>::new(&eigenshade_table::decode(&bytes).expect("a table"));
    let basis = owned.basis().expect("a basis");
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut d = vec![0.0; basis.components()];
    let light = single(&captured(9).entries[5].luminance());
    let light = Light::new(9, &light).expect("coefficients");
    let (mut naive, mut ours, mut of_integers) = ([0.0f64; 2], 0.0f64, 0u16);
    for material in materials(7) {
        let material = single(&material);
        let material = Material::new(7, &material).expect("coefficients");
        basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
        let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
        let seen = |normal: [f64; 3]| {
            let [x, y, z] = normal.map(|c| [c as f32]);
            let normals = Normals::new(&x, &y, &z).expect("one length");
            let as_it_is = normals.iter().next().expect("one normal");
            let laid = Normal::new(x[0], y[0], z[0]).expect("laid on the rim");
            [as_it_is, laid].map(|normal| f64::from(scene.shade(normal)))
        };
        for turn in 0..16 {
            let (sine, cosine) = (PI * f64::from(turn) / 8.0).sin_cos();
            let [rim, _] = seen([cosine, sine, 0.0]);
            for (z, naive) in [-0.01, -0.1].into_iter().zip(&mut naive) {
                let root = (1.0f64 - z * z).sqrt();
                let normal = [cosine * root, sine * root, z];
                let [as_it_is, laid] = seen(normal);
                *naive = naive.max((as_it_is / rim).abs());
                ours = ours.max((laid / rim - 1.0).abs());
                let at_rim = in_integers([cosine, sine, 0.0]).components();
                let laid = in_integers(normal).components();
                let apart = at_rim.iter().zip(&laid).map(|(a, b)| a.0.abs_diff(b.0));
                of_integers = of_integers.max(apart.max().expect("three"));
            }
        }
    }
    let [near, far] = naive;
    let [least_near, least_far] = NAIVE_BEHIND;
    vec![
        Figure::least("z = -0.01 as it is, times the rim's value", near, least_near),
        Figure::least("z = -0.1", far, least_far),
        Figure::most("laid on the rim, off its value", ours, LAID_ON_RIM),
        Figure::most("in Q15, units of a component", of_integers.into(), 1.0),
    ]
}

/// The harmonics at a direction, which represent light from that direction alone.
fn from_direction(direction: [f64; 3]) -> Vec<f64> {
    let mut unit = vec![0.0; 100];
    (0..100)
        .map(|k| {
            unit.fill(0.0);
            unit[k] = 1.0;
            ExplicitLight::new(&unit).radiance(direction)
        })
        .collect()
}

/// An image by each method, and the bound of the scene within a tolerance.
struct Ways {
    f32: Vec<f64>,
    q15: (Vec<i32>, f64),
    within: Vec<f64>,
    bound: f64,
    baked: Vec<f64>,
    map: (Vec<i32>, f64),
}

fn every_way(light: &[f64], material: &[f64], normals: &[[f64; 3]]) -> Ways {
    let (d, scene) = scene(light, material);
    let visible: Vec<Normal<f32>> = normals
        .iter()
        .map(|&[x, y, z]| Normal::new(x as f32, y as f32, z as f32).expect("visible"))
        .collect();
    let mut lengths = [0; sphere::DEGREE + 1];
    let (within, told) = sphere::BASIS
        .collapse_within(&d, Tolerance::OfPeak(1e-2), &mut lengths, [0.0; sphere::SCENE])
        .expect("sizes");
    let baked = scene.bake_into(64, vec![0.0f32; 64 * 64]).expect("sizes");
    let map = scene.bake_integers_into(64, vec![0; 64 * 64]).expect("numbers that fit");
    let point = |normal: &[f64; 3]| MapPoint::of_quantised(in_integers(*normal));
    Ways {
        f32: visible.iter().map(|&normal| scene.shade(normal).into()).collect(),
        q15: integers(light, material, normals),
        within: visible.iter().map(|&normal| within.shade(normal).into()).collect(),
        bound: told.bound.into(),
        baked: visible.iter().map(|&one| baked.bilinear(MapPoint::of(one)).into()).collect(),
        map: (
            normals.iter().map(|normal| map.bilinear(point(normal))).collect(),
            2f64.powi(map.exponent()),
        ),
    }
}

fn floats((mantissas, unit): &(Vec<i32>, f64)) -> Vec<f64> {
    mantissas.iter().map(|&mantissa| f64::from(mantissa) * unit).collect()
}

/// Normals and weights that integrate squares of images over a sphere's normals.
fn quadrature() -> (Vec<[f64; 3]>, Vec<f64>) {
    let at = |(z, weight): (f64, f64)| {
        (0..40).map(move |k| {
            let (sine, cosine) = (PI * f64::from(k) / 20.0).sin_cos();
            let root = (1.0 - z * z).sqrt();
            ([root * cosine, root * sine, z], 2.0 * z * weight / 40.0)
        })
    };
    gauss_legendre::rule(48, 0.0, 1.0).into_iter().flat_map(at).unzip()
}

fn sun() -> Vec<Figure> {
    let (normals, weights) = quadrature();
    let rms = |found: &[f64], expected: &[f64]| {
        let squares = found.iter().zip(expected).map(|(a, b)| (a - b).powi(2));
        squares.zip(&weights).map(|(square, weight)| square * weight).sum::<f64>().sqrt()
    };
    let owned = reference();
    let mut worst = [0.0f64; 5];
    for direction in [[0.6, 0.0, 0.8], [-0.48, 0.6, 0.64], [0.0, 0.96, -0.28]] {
        // A texel of a map of 64 x 32 with radiance 1e6, in a sky of radiance 1.
        let mut light: Vec<f64> =
            from_direction(direction).iter().map(|value| 1e6 * 9.6e-3 * value).collect();
        light[0] += (4.0 * PI).sqrt();
        for material in materials(3) {
            let expected = image(&owned, &light, &material, &normals);
            let ways = every_way(&light, &material, &normals);
            let [of_f32, of_q15, of_baked, of_map] =
                [&ways.f32, &floats(&ways.q15), &ways.baked, &floats(&ways.map)]
                    .map(|found| rms(found, &expected) / largest(expected.iter().copied()));
            let of_bound = rms(&ways.within, &expected) / ways.bound;
            for (worst, found) in worst.iter_mut().zip([of_f32, of_q15, of_bound, of_baked, of_map])
            {
                *worst = worst.max(found);
            }
        }
    }
    let [of_f32, of_q15, of_bound, of_baked, of_map] = worst;
    vec![
        Figure::most("f32, rms of the peak", of_f32, SUN_F32),
        Figure::most("Q15", of_q15, SUN_Q15),
        Figure::most("within 1e-2: rms, of the bound stated", of_bound, SUN_BOUND),
        Figure::most("baked, 64 x 64", of_baked, SUN_BAKED[0]),
        Figure::most("baked in integers", of_map, SUN_BAKED[1]),
    ]
}

fn delta() -> Vec<Figure> {
    let normals = disc(64);
    let owned = reference();
    let light = from_direction([0.6, 0.0, 0.8]);
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let (mut deepest, mut apart, mut left) = (0.0f64, [0.0f64; 5], 0);
    for material in materials(3) {
        let expected = image(&owned, &light, &material, &normals);
        let peak = largest(expected.iter().copied());
        let ways = every_way(&light, &material, &normals);
        let below = least(&expected);
        deepest = deepest.max(-below / peak);
        let found = [ways.f32, floats(&ways.q15), ways.within, ways.baked, floats(&ways.map)];
        for (apart, mut found) in apart.iter_mut().zip(found) {
            let told = Negatives::Clamped.apply(&mut found).expect("pixels");
            *apart = apart.max((told - below).abs() / peak);
            left += found.iter().filter(|&&value| value < 0.0).count();
        }
        for (mut mantissas, _) in [ways.q15, ways.map] {
            let told = Negatives::Clamped.apply(&mut mantissas).expect("pixels");
            assert_eq!(told < 0, mantissas.contains(&0), "a value below zero became zero");
            left += mantissas.iter().filter(|&&value| value < 0).count();
        }
    }
    let [of_f32, of_q15, of_within, of_baked, of_map] = apart;
    vec![
        Figure::least("least value, of the peak, below zero by", deepest, RINGING),
        Figure::most("the same in f32, off by", of_f32, tolerances::DELTA[0]),
        Figure::most("in Q15", of_q15, tolerances::DELTA[1]),
        Figure::most("within 1e-2", of_within, tolerances::DELTA[2]),
        Figure::most("baked, 64 x 64", of_baked, tolerances::DELTA[3]),
        Figure::most("baked in integers", of_map, tolerances::DELTA[4]),
        Figure::exactly("values below zero that clamping left", left, 0),
    ]
}

/// The distance of R Rᵀ from the identity matrix.
fn off(matrix: [[f32; 3]; 3]) -> f64 {
    let rows = matrix.map(|row| row.map(f64::from));
    let entry = |i: usize, j: usize| {
        let product: f64 = rows[i].iter().zip(&rows[j]).map(|(a, b)| a * b).sum();
        product - f64::from(u8::from(i == j))
    };
    largest((0..9).map(|k| entry(k / 3, k % 3)))
}

/// The plain product of two matrices.
fn product(a: [[f32; 3]; 3], b: [[f32; 3]; 3]) -> [[f32; 3]; 3] {
    a.map(|row| [0, 1, 2].map(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
}

/// A light in f32, rotated.
fn turned(light: &[f32], rotation: &Rotation<f32>) -> Vec<f32> {
    const ROOM: usize = Light::<f32>::turn_len(9);
    let light = Light::new(9, light).expect("100 coefficients");
    light.turned::<100, ROOM>(rotation).expect("room").to_vec()
}

/// The largest relative change of the energy of a degree.
fn gained(before: &[f32], after: &[f32]) -> f64 {
    let energy = |values: &[f32]| values.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>();
    let of_degree = |l: usize| {
        let range = if l == 0 { 0..1 } else { light::count(l - 1)..light::count(l) };
        energy(&after[range.clone()]) / energy(&before[range]) - 1.0
    };
    largest((0..10).map(of_degree))
}

fn drift() -> Vec<Figure> {
    let mut numbers = Numbers(47);
    let first: Vec<f64> = (0..100).map(|_| numbers.next()).collect();
    let first_single = single(&first);
    // The same small rotation repeated in f32; in f64 a single rotation by the total.
    let angles = [0.004f32, 0.003, -0.002];
    let [a, b, c] = angles;
    let small = Rotation::from_euler::<SinglePrecision>(a, b, c).expect("a rotation");
    let [a, b, c] = angles.map(f64::from);
    let mut exact = first.clone();
    let once = rotation::Rotation { alpha: b, beta: a, gamma: c };
    let (mut naive, mut all, mut light) = (small.matrix(), small, turned(&first_single, &small));
    for _ in 1..1000 {
        naive = product(small.matrix(), naive);
        all = small.after(all);
        light = turned(&light, &small);
    }
    for _ in 0..1000 {
        exact = once.turn(9, &exact);
    }
    let scale = largest(first.iter().copied());
    let apart =
        |found: &[f32]| largest(found.iter().zip(&exact).map(|(&a, b)| f64::from(a) - b)) / scale;
    let of_product = turned(&first_single, &all);
    vec![
        Figure::least("R of plain products, off orthonormal", off(naive), NAIVE_DRIFT),
        Figure::most("R of `after`", off(all.matrix()), ORTHONORMAL_F32),
        Figure::most(
            "light turned by their product, of the largest",
            apart(&of_product),
            tolerances::DRIFT[0],
        ),
        Figure::most("light turned a thousand times", apart(&light), tolerances::DRIFT[1]),
        Figure::most(
            "its energy, of a degree",
            gained(&first_single, &light),
            tolerances::DRIFT[2],
        ),
    ]
}

fn almost() -> Vec<Figure> {
    let mut numbers = Numbers(48);
    let light: Vec<f32> = (0..100).map(|_| numbers.next() as f32).collect();
    let exact = Rotation::from_quaternion([0.3f32, -0.5, 0.2, 0.8]).expect("a rotation");
    // Rows 4.9e-4 too long, so that their squares are 1e-3 off.
    let stretched = exact.matrix().map(|row| row.map(|element| element * 1.000_49));
    let mut sheared = exact.matrix();
    for (element, other) in sheared[0].iter_mut().zip(exact.matrix()[1]) {
        *element += 9.9e-4 * other;
    }
    let (mut before, mut after, mut energy) = (0.0f64, 0.0f64, 0.0f64);
    for matrix in [stretched, sheared] {
        let rotation = Rotation::from_matrix(matrix).expect("within 1e-3");
        before = before.max(off(matrix));
        after = after.max(off(rotation.matrix()));
        energy = energy.max(gained(&light, &turned(&light, &rotation)).abs());
    }
    vec![
        Figure::least("off orthonormal, as given", before, NAIVE_ALMOST),
        Figure::most("as it is taken", after, ORTHONORMAL_F32),
        Figure::most("energy of a turned light, of a degree", energy, ALMOST_ENERGY),
    ]
}

/// A table whose single image is as large as Q15 allows, and the shipped table.
fn full_weight() -> Vec<Figure> {
    let places = [quantised::Profile::new(0, -3, [0, quantised::Profile::NONE], [u16::MAX; 2])];
    let largest_table = quantised::Basis::<Q15>::new(quantised::Parts {
        degree: 0,
        order: 0,
        effects: eigenshade::Effects::ALL,
        components: 1,
        profiles: &places,
        lengths: &[3],
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        terms: &[Q15(i16::MAX); 3],
    });
    let largest_table = largest_table.expect("parts that fit");
    let seen = |basis: &quantised::Basis<'_, Q15>, pixels: u32, weight: u16| {
        let mut estimate = basis.estimate::<50>().expect("room");
        for _ in 0..pixels {
            estimate.add(in_integers([0.0, 0.0, 1.0]), Q15(i16::MIN), weight);
        }
        estimate.coefficients(-15)
    };
    let refused = Err(Error::Saturated { what: eigenshade::What::Coefficients });
    let d = |found: Result<quantised::Coefficients<50>, Error>| {
        let found = found.expect("sums that fit");
        f64::from(found.mantissas()[0]) * 2f64.powi(found.exponent())
    };
    let one = d(seen(&largest_table, 1, 1));
    let half = d(seen(&largest_table, 1 << 16, 1 << 15));
    let fewer = d(seen(&largest_table, 1 << 15, u16::MAX));
    let off = largest([half / one - 1.0, fewer / one - 1.0]);
    let is_refused = seen(&largest_table, 1 << 16, u16::MAX) == refused;
    let of_shipped = seen(&sphere::q15::BASIS, 1 << 16, u16::MAX) == refused;
    vec![
        Figure::exactly("refused by the largest table there can be", is_refused.into(), 1),
        Figure::exactly("by the shipped one", of_shipped.into(), 0),
        Figure::most("half the weight or the pixels against one, relative", off, HALF_WEIGHT),
    ]
}
