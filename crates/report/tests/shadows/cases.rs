//! Hard cases against the oracle and against formulas.

use super::oracle::{Glossy, Heights, Sky, is_hit, percent};
use super::{DEGREE, every, lobby, object, shadowed, surface};
use eigenshade_generator::material::brdf::{Brdf, Ggx, Lambertian};
use eigenshade_generator::object::mesh_data::Mesh;
use eigenshade_generator::object::points::Point;
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::reference::DirectSum;
use eigenshade_shadows::material::Material;
use eigenshade_shadows::object::Object;
use eigenshade_shadows::pixels::Pixels;
use eigenshade_shadows::transport::transports;
use eigenshade_shadows::weights::Columns;
use eigenshade_testing::oracle::ExplicitLight;
use faer::Mat;
use report::shadow_shapes::SHAPES;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Directions of the oracle.
const DIRECTIONS: usize = 4000;

/// A quadrilateral, by its corners in order, as two triangles that face the side of that order.
fn quad(mesh: &mut Mesh, corners: [[f64; 3]; 4]) {
    let first = mesh.corners.len() as u32;
    mesh.corners.extend(corners);
    mesh.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|three| three.map(|k| first + k)));
}

/// A level rectangle that faces the camera.
fn level(mesh: &mut Mesh, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2], z: f64) {
    quad(mesh, [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]]);
}

/// The walls of a box, which face outward, or inward if `top` is below `bottom`.
fn walls(mesh: &mut Mesh, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2], bottom: f64, top: f64) {
    let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    for k in 0..4 {
        let ([a, b], [c, d]) = (corners[k], corners[(k + 1) % 4]);
        quad(mesh, [[a, b, bottom], [c, d, bottom], [c, d, top], [a, b, top]]);
    }
}

fn plate() -> Mesh {
    let mut mesh = Mesh::default();
    level(&mut mesh, [-1.0; 2], [1.0; 2], 0.0);
    mesh
}

/// A square hole of this half width in a plate.
pub fn pit(half: f64, depth: f64) -> Mesh {
    let mut mesh = Mesh::default();
    level(&mut mesh, [-1.0, -1.0], [1.0, -half], 0.0);
    level(&mut mesh, [-1.0, half], [1.0, 1.0], 0.0);
    level(&mut mesh, [-1.0, -half], [-half, half], 0.0);
    level(&mut mesh, [half, -half], [1.0, half], 0.0);
    level(&mut mesh, [-half; 2], [half; 2], -depth);
    walls(&mut mesh, [-half; 2], [half; 2], 0.0, -depth);
    mesh
}

/// A wall of one pixel of 32.
fn wall() -> Mesh {
    let (mut mesh, half) = (plate(), 1.0 / 31.0);
    level(&mut mesh, [-half, -0.7], [half, 0.7], 0.5);
    walls(&mut mesh, [-half, -0.7], [half, 0.7], 0.0, 0.5);
    mesh
}

/// A plate of two parts, with a fin on their common edge, and a tilted sheet that floats above it.
pub fn sheets() -> Mesh {
    let mut mesh = Mesh {
        corners: [[-1., -1., 0.], [0., -1., 0.], [1., -1., 0.], [1., 1., 0.], [0., 1., 0.]].into(),
        ..Mesh::default()
    };
    mesh.corners.extend([[-1., 1., 0.], [0.2, -1., 0.6], [0.2, 1., 0.6]]);
    mesh.triangles.extend([[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4], [4, 1, 6], [4, 6, 7]]);
    quad(&mut mesh, [[0.4, -0.8, 0.3], [0.9, -0.8, 0.6], [0.9, 0.5, 0.6], [0.4, 0.5, 0.3]]);
    mesh
}

/// A cone whose side the camera sees at a cosine of 0.1, on a plate.
fn cone() -> Mesh {
    let mut mesh = plate();
    let at = |k: usize| (TAU * k as f64 / 24.0).sin_cos();
    for k in 0..24 {
        let ((s, c), (t, d)) = (at(k), at(k + 1));
        let first = mesh.corners.len() as u32;
        let radius = 0.3;
        mesh.corners.extend([
            [radius * c, radius * s, 0.],
            [radius * d, radius * t, 0.],
            [0., 0., 3.],
        ]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    mesh
}

/// A ball of this many rings.
fn ball(rings: usize) -> Mesh {
    let mut mesh = Mesh::default();
    let sine = |k: usize| (PI * k as f64 / rings as f64).sin_cos();
    let at = |i: usize, j: usize| {
        let ((s, c), (u, v)) = (sine(i), sine(j));
        [s * v, s * u, c]
    };
    for (i, j) in (0..rings).flat_map(|i| (0..2 * rings).map(move |j| (i, j))) {
        quad(&mut mesh, [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    mesh
}

pub fn triangles(surface: &Surface) -> Vec<[[f64; 3]; 3]> {
    surface.facets.iter().map(|facet| facet.corners).collect()
}

/// Compares one pixel in `step` with the oracle: the rms difference in percent of the largest irradiance,
/// and the oracle's own with other directions.
fn apart(
    surface: &Surface,
    size: usize,
    step: usize,
    (given, material): (Material<'_>, Glossy),
    blocked: super::oracle::Blocked<'_>,
) -> [f64; 2] {
    let light = lobby();
    let found = every(step, surface, size, given, 0).irradiance(&light, &[1.0]);
    let pixels = Pixels::new(surface, size).unwrap();
    let chosen: Vec<_> = pixels.points().into_iter().step_by(step).collect();
    let found: Vec<f64> = found.into_iter().map(f64::from).collect();
    let one = |start| Sky::new(&light, DIRECTIONS, start).irradiances(&chosen, material, blocked);
    let (expected, again) = (one(0.0), one(1.0));
    [percent(&expected, &found), percent(&expected, &again)]
}

pub fn matte() -> (Box<dyn Brdf>, Glossy) {
    (Box::new(Lambertian::new(0.8).unwrap()), Glossy::Matte(0.8))
}

pub fn glossy([roughness, f0, albedo]: [f64; 3]) -> (Box<dyn Brdf>, Glossy) {
    let brdf = Ggx::new(roughness, f0, albedo).unwrap();
    (Box::new(brdf), Glossy::Ggx([roughness, f0, albedo]))
}

#[test]
fn objects_are_those_of_the_oracle() {
    for (name, mesh, bound) in [
        ("pit", pit(0.4, 0.8), 0.5),
        ("wall", wall(), 0.5),
        ("sheets", sheets(), 0.5),
        ("cone", cone(), 0.5),
    ] {
        let surface = surface(&mesh, true);
        let triangles = triangles(&surface);
        let (brdf, metal) = glossy([0.5, 0.9, 0.0]);
        // A matte series has one coefficient, twice the albedo.
        let series = [1.6];
        for (given, material) in [
            (Material::Series(&series), matte().1),
            (Material::Formula(&*matte().0), matte().1),
            (Material::Formula(&*brdf), metal),
        ] {
            let blocked = |from, along| is_hit(&triangles, from, along);
            let [found, of_oracle] = apart(&surface, 32, 5, (given, material), &blocked);
            println!("{name}: {found:.3} %, the oracle {of_oracle:.3} %");
            assert!(found < bound && of_oracle < 0.3, "{name}");
        }
    }
}

#[test]
fn a_relief_is_that_of_the_oracle() {
    let (_, coin) = SHAPES[0];
    let mesh = coin();
    let surface = surface(&mesh, false);
    // The unit of the surface is the largest coordinate of its triangles.
    let used = mesh.triangles.iter().flatten().map(|&k| mesh.corners[k as usize]);
    let unit = used.flatten().fold(0.0, |most: f64, one| most.max(one.abs()));
    let side = mesh.corners.len().isqrt();
    let heights: Vec<f64> = mesh.corners.iter().map(|[.., z]| z / unit).collect();
    let step = 2.0 / (side - 1) as f64 / unit;
    let heights = Heights::new(side, step, 0.98 / unit, heights);
    let blocked = |from, along| heights.is_hit(from, along);
    for (brdf, material) in [matte(), glossy([0.5, 0.9, 0.0])] {
        let [found, of_oracle] =
            apart(&surface, 48, 37, (Material::Formula(&*brdf), material), &blocked);
        println!("coin: {found:.3} %, the oracle {of_oracle:.3} %");
        assert!(found < 1.0 && of_oracle < 0.3);
    }
}

/// The configuration factor of a rectangle above its middle.
fn factor(half: f64, height: f64) -> f64 {
    let a = half / height;
    let root = (1.0 + a * a).sqrt();
    4.0 / TAU * 2.0 * (a / root) * (a / root).atan()
}

#[test]
fn the_bottom_of_a_pit_sees_its_opening() {
    let ambient: Vec<f64> = [vec![(4.0 * PI).sqrt()], vec![0.0; 99]].concat();
    for depth in [0.1, 0.4, 1.5, 6.0] {
        let half = 0.2;
        let surface = surface(&pit(half, depth), true);
        let object = shadowed(&surface, 33, &Lambertian::new(1.0).unwrap());
        let all = object.irradiance(&ambient, &[1.0]);
        let middle = object.pixels.iter().position(|(pixel, _)| *pixel == [16; 2]).unwrap();
        let (found, expected) = (f64::from(all[middle]), factor(half, depth));
        println!("depth {depth}: {found:.4} {expected:.4}");
        assert!((found - expected).abs() < 0.004);
    }
}

#[test]
fn what_sees_all_is_convex() {
    let brdf = Ggx::new(0.3, 0.9, 0.0).unwrap();
    let convex = |surface: &Surface, size: usize| {
        let columns = super::harmonics();
        let pixels = Pixels::new(surface, size).unwrap();
        let pixels = pixels.points();
        let materials = [Material::Formula(&brdf as &dyn Brdf)];
        let light = Columns { degree: Some(DEGREE), all: columns.as_ref() };
        let mut found = transports(&pixels, None, &materials, light, &());
        found.remove(0)
    };
    // A plate sees half of the sphere, but for rays along the horizon.
    let flat = surface(&plate(), true);
    let (found, expected) = (&shadowed(&flat, 8, &brdf).transports[0], convex(&flat, 8));
    let rows = (0..expected.nrows()).flat_map(|row| (0..100).map(move |k| (row, k)));
    let apart = rows.fold(0.0, |most: f32, at| most.max((found[at] - expected[at]).abs()));
    println!("plate: {apart:e}");
    assert!(apart < 1e-4);
    // Facets of a ball hide what is above the horizon of a smooth normal alone.
    let ball = surface(&ball(48), false);
    let convex = Object { transports: vec![convex(&ball, 32)], ..shadowed(&ball, 32, &brdf) };
    let [found, expected] = [&shadowed(&ball, 32, &brdf), &convex].map(|object| {
        let all = object.irradiance(&lobby(), &[1.0]);
        all.into_iter().map(f64::from).collect::<Vec<_>>()
    });
    let rms = percent(&expected, &found);
    println!("ball: {rms:.3} %");
    assert!(rms < 0.3);
    // A matte plate has the irradiance of formulas: 1 under uniform light, 2/3 under the cosine.
    let plate = shadowed(&flat, 8, &Lambertian::new(1.0).unwrap());
    for (k, radiance, expected) in
        [(0, (4.0 * PI).sqrt(), 1.0), (2, (4.0 * PI / 3.0).sqrt(), 2.0 / 3.0)]
    {
        let mut light = vec![0.0; 100];
        light[k] = radiance;
        for found in plate.irradiance(&light, &[1.0]) {
            assert!((f64::from(found) - expected).abs() < 1e-3, "{found} {expected}");
        }
    }
}

/// A convex object has the irradiance of the direct sum (15) of today's tables at the same normals, as
/// near as transports in f32 are.
#[test]
fn open_pixels_are_those_of_the_direct_sum() {
    let surface = surface(&ball(4), true);
    let coefficients: Vec<f64> =
        (0..55).map(|k| f64::from(k * k).sin() / f64::from(1 + k)).collect();
    let found = object(&surface, 24, Material::Series(&coefficients), 3);
    let found = found.irradiance(&lobby(), &[1.0]);
    let (light, sum) = (lobby(), DirectSum::new(DEGREE, 8));
    let at = |point: &Point| {
        let modes = sum.at(point.normal);
        modes.irradiance(&light, &modes.scatter(&coefficients))
    };
    let pixels = Pixels::new(&surface, 24).unwrap();
    let expected: Vec<f64> = (pixels.points().into_iter())
        .map(|points| points.iter().map(at).sum::<f64>() / points.len() as f64)
        .collect();
    let white = expected.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    let worst = expected.iter().zip(found);
    let worst = worst.fold(0.0, |most: f64, (a, b)| most.max((a - f64::from(b)).abs() / white));
    println!("{} pixels: {worst:e} of white", expected.len());
    assert!(worst < 1e-6);
}

/// Coefficients of ((1 + z) / 2)^9, which is positive and of degree 9, and of a lamp at z = 1 up to
/// this degree.
fn ahead() -> [Vec<f64>; 2] {
    let mut lights = [vec![0.0; 100], vec![0.0; 100]];
    for l in 0..=DEGREE {
        let place = l * l + l;
        let mut one = vec![0.0; 100];
        one[place] = 1.0;
        let harmonic = ExplicitLight::new(&one);
        let at = |z: f64| harmonic.radiance([(1.0 - z * z).max(0.0).sqrt(), 0.0, z]);
        let steps = 20_000;
        let smooth = (0..steps).map(|k| {
            let z = f64::from(2 * k + 1) / f64::from(steps) - 1.0;
            at(z) * (0.5 * (1.0 + z)).powi(9)
        });
        lights[0][place] = smooth.sum::<f64>() * TAU * 2.0 / f64::from(steps);
        lights[1][place] = at(1.0);
    }
    lights
}

/// The light turned to the back: z to -z.
fn behind(light: &[f64]) -> Vec<f64> {
    let turn =
        eigenshade_model::rotation::Rotation { alpha: 2.0 * FRAC_PI_2, beta: 0.0, gamma: 0.0 };
    turn.turn(DEGREE, light)
}

#[test]
fn light_from_behind_leaves_a_dial_black() {
    let (_, dial) = SHAPES[1];
    let surface = surface(&dial(), false);
    for (brdf, bounds) in [(matte().0, [0.1, 2.5]), (glossy([0.5, 0.9, 0.0]).0, [0.4, 2.5])] {
        let object = shadowed(&surface, 48, &*brdf);
        for (light, bound) in ahead().into_iter().zip(bounds) {
            let lit = |light: &[f64]| {
                let all = object.irradiance(light, &[1.0]);
                all.into_iter().map(|one| one * one).sum::<f32>().sqrt()
            };
            let percent = f64::from(100.0 * lit(&behind(&light)) / lit(&light));
            println!("{percent:.3} % (rms) of the picture of the same light in front");
            assert!(percent < bound);
        }
    }
}

#[test]
fn what_faces_away_is_refused() {
    let mut mesh = plate();
    mesh.triangles.iter_mut().for_each(|corners| corners.reverse());
    let (surface, brdf) = (surface(&mesh, true), Lambertian::new(0.5).unwrap());
    let material = [Material::Formula(&brdf as &dyn Brdf)];
    let error = Object::new(&surface, 8, DEGREE, &material, &()).err().unwrap().to_string();
    assert!(error.contains("faces away"), "{error}");
    // Some facets that do show nothing, and block light.
    let mut mesh = plate();
    level(&mut mesh, [0.0, -1.0], [1.0, 1.0], 0.5);
    let count = mesh.triangles.len();
    mesh.triangles[count - 2..].iter_mut().for_each(|corners| corners.reverse());
    let surface = super::surface(&mesh, true);
    let object = shadowed(&surface, 16, &brdf);
    let ambient: Vec<f64> = [vec![(4.0 * PI).sqrt()], vec![0.0; 99]].concat();
    let all = object.irradiance(&ambient, &[1.0]);
    let least = all.iter().copied().fold(1.0, f32::min);
    println!("{} pixels, the darkest {least}", all.len());
    assert!(all.len() < 16 * 9 && least < 0.35 && all.iter().all(|one| (0.0..0.501).contains(one)));
}

/// An object of the transports of these pixels.
pub fn rows(of: &Object, pixels: &[usize]) -> Object {
    let transport = &of.transports[0];
    Object {
        size: of.size,
        degree: of.degree,
        pixels: of.pixels[..pixels.len()].to_vec(),
        transports: vec![Mat::from_fn(pixels.len(), transport.ncols(), |row, k| {
            transport[(pixels[row], k)]
        })],
    }
}
