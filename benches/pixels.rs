//! How far each path is from the limit of the target's arithmetic, and the pixel loop from
//! the nine-term formula: `cargo bench --bench pixels`. docs/performance.md says what the
//! limit is.
//!
//! With `-- --write` the figures go into that page, between the marks of the target.

use eigenshade::{Economy, Light, Material, Normals, Scene, Tolerance, sphere};
use eigenshade_generator::inputs::coefficient_csv::{read_lights, read_materials};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Few enough that normals and irradiances stay in the second cache.
const PIXELS: usize = 16_384;
const ROUNDS: usize = 41;
/// Independent sums that hide the latency of a multiplication and an addition.
const CHAINS: usize = 12;
/// Numbers in a vector of the target.
const LANES: usize = if cfg!(target_feature = "avx512f") {
    16
} else if cfg!(target_feature = "avx") {
    8
} else {
    4
};

/// sum + a b as the runtime has it: fused where the target has it.
#[inline(always)]
fn add_product(sum: f32, a: f32, b: f32) -> f32 {
    if cfg!(target_feature = "fma") { a.mul_add(b, sum) } else { sum + a * b }
}

/// Multiply-adds on registers, nothing else: `repeats` of them in each lane of each chain.
#[inline(never)]
fn multiply_adds(repeats: usize, term: f32, t: f32) -> [f32; CHAINS * LANES] {
    let mut sums = [1.0; CHAINS * LANES];
    for _ in 0..repeats {
        for sum in &mut sums {
            *sum = add_product(term, *sum, t);
        }
    }
    sums
}

/// The nine-term formula (Ramamoorthi and Hanrahan 2001), as a polynomial of the normal.
#[inline(never)]
fn nine_terms(c: &[f32; 9], [x, y, z]: [&[f32]; 3], out: &mut [f32]) {
    for (((out, &x), &y), &z) in out.iter_mut().zip(x).zip(y).zip(z) {
        let linear = add_product(add_product(add_product(c[0], c[1], x), c[2], y), c[3], z);
        let square = add_product(x * x, -y, y);
        let sum = add_product(add_product(linear, c[4], square), c[5], x * y);
        *out = add_product(add_product(sum, add_product(c[6] * x, c[7], y), z), c[8], z * z);
    }
}

/// Multiply-adds that a pixel of polynomials of these lengths cannot do without.
fn necessary(lengths: &[u16]) -> usize {
    let of = |length: u16| usize::from(length).saturating_sub(1);
    let (&pole, around) = lengths.split_first().unwrap_or((&0, &[]));
    let polynomials = of(pole) + around.iter().map(|&length| 2 * of(length)).sum::<usize>();
    let azimuths = (4 * around.len()).saturating_sub(2);
    // t = 2 z - 1 is one more.
    polynomials + azimuths + usize::from(polynomials > 0)
}

/// Many normals over the visible hemisphere.
fn normals() -> [Vec<f32>; 3] {
    let normal = |k: usize| {
        let z = (k as f64 + 0.5) / PIXELS as f64;
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
        [sine * tilt.cos(), sine * tilt.sin(), z].map(|value| value as f32)
    };
    std::array::from_fn(|axis| (0..PIXELS).map(|k| normal(k)[axis]).collect())
}

type Image = Scene<'static, [f32; sphere::SCENE]>;

/// A scene, and the lengths of its polynomials.
struct Trimmed {
    scene: Image,
    lengths: Vec<u16>,
}

impl Trimmed {
    /// Of one image within a share of its peak.
    fn new(d: &[f32], share: f32) -> Self {
        let mut lengths = [0; 16];
        let azimuths = within(d, share, &mut lengths).1.azimuths;
        let (scene, _) = within(d, share, Box::leak(Box::new([0; 16])));
        Self { scene, lengths: lengths[..azimuths].to_vec() }
    }

    fn cost(&self) -> usize {
        necessary(&self.lengths)
    }
}

fn within<'l>(
    d: &[f32],
    share: f32,
    lengths: &'l mut [u16],
) -> (Scene<'l, [f32; sphere::SCENE]>, Economy<f32>) {
    let room = [0.0; sphere::SCENE];
    sphere::BASIS.collapse_within(d, Tolerance::OfPeak(share), lengths, room).expect("sizes")
}

/// d of each light on each material of the database.
fn database() -> Vec<Vec<f32>> {
    let inputs = Path::new("tables/inputs");
    let lights = read_lights(&inputs.join("lights.csv"), Some(9)).expect("lights");
    let materials = read_materials(&inputs.join("materials.csv"), Some(7)).expect("materials");
    let single = |values: Vec<f64>| values.iter().map(|&value| value as f32).collect::<Vec<_>>();
    let pairs = lights.entries.iter().flat_map(|light| {
        materials.entries.iter().map(|material| {
            coefficients(&single(light.luminance()), 7, &single(material.luminance()))
        })
    });
    pairs.collect()
}

fn coefficients(light: &[f32], order: usize, material: &[f32]) -> Vec<f32> {
    let degree = light.len().isqrt() - 1;
    let light = Light::new(degree, light).expect("a light");
    let material = Material::new(order, material).expect("a material");
    sphere::project(&light, &material).expect("it fits").to_vec()
}

/// The image of middle cost within a tolerance.
fn median(database: &[Vec<f32>], share: f32) -> Trimmed {
    let mut images: Vec<_> = database.iter().map(|d| Trimmed::new(d, share)).collect();
    images.sort_by_key(Trimmed::cost);
    images.swap_remove(images.len() / 2)
}

/// A white matte, f = 1/π, under each light of the database.
fn mattes() -> Vec<Vec<f32>> {
    let lights = read_lights(Path::new("tables/inputs/lights.csv"), Some(9)).expect("lights");
    let single = |values: Vec<f64>| values.iter().map(|&value| value as f32).collect::<Vec<_>>();
    lights.entries.iter().map(|light| coefficients(&single(light.luminance()), 0, &[2.0])).collect()
}

/// What is timed: it is called so often in a round, for so many pixels each.
struct Way<'a> {
    name: String,
    /// Multiply-adds a pixel.
    arithmetic: usize,
    run: Box<dyn FnMut() + 'a>,
    times: Vec<f64>,
}

/// Seconds of each way, medians of interleaved rounds.
fn interleaved(ways: &mut [Way<'_>], repeats: usize) -> Vec<f64> {
    for _ in 0..ROUNDS {
        for way in &mut *ways {
            let start = Instant::now();
            for _ in 0..repeats {
                (way.run)();
            }
            way.times.push(start.elapsed().as_secs_f64() / repeats as f64);
        }
    }
    let middle = |way: &mut Way<'_>| {
        way.times.sort_by(f64::total_cmp);
        way.times[ROUNDS / 2]
    };
    ways.iter_mut().map(middle).collect()
}

fn main() {
    // `cargo test --benches` only checks that it compiles.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let xyz = normals();
    let axes = [&xyz[0][..], &xyz[1], &xyz[2]];
    let slices = Normals::new(axes[0], axes[1], axes[2]).expect("one length");
    let shaded = |scene: &Image| {
        let (scene, mut out) = (*scene, vec![0.0; PIXELS]);
        Box::new(move || black_box(&scene).shade_slice(black_box(slices), &mut out).expect("one length"))
    };
    let way = |name: &str, arithmetic, run| Way { name: name.into(), arithmetic, run, times: Vec::new() };
    let database = database();
    let full = Trimmed {
        scene: sphere::BASIS.collapse_into(&database[database.len() / 2], [0.0; sphere::SCENE]).expect("sizes"),
        lengths: vec![14, 14, 13, 12, 12, 13, 12],
    };
    let repeats = PIXELS / CHAINS / LANES * 64;
    let (mut nine, c) = (vec![0.0; PIXELS], [0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);
    let mut ways = vec![
        way("limit", 64, Box::new(move || drop(black_box(multiply_adds(repeats, black_box(0.3), black_box(0.5)))))),
        way("nine terms", 11, Box::new(move || nine_terms(black_box(&c), black_box(axes), &mut nine))),
        way("full", full.cost(), shaded(&full.scene)),
    ];
    for share in [1e-4, 1e-3, 1e-2] {
        let image = median(&database, share);
        println!("{share}: {:?}", image.lengths);
        ways.push(way(&format!("{share}"), image.cost(), shaded(&image.scene)));
    }
    let mut mattes: Vec<_> = mattes().iter().map(|d| Trimmed::new(d, 1e-2)).collect();
    mattes.sort_by_key(Trimmed::cost);
    for image in [&mattes[0], &mattes[mattes.len() / 2], &mattes[mattes.len() - 1]] {
        println!("matte: {:?}", image.lengths);
        ways.push(way("matte", image.cost(), shaded(&image.scene)));
    }
    let light: Vec<f32> = (0..9).map(|k| 3.5 / (1.0 + k as f32)).collect();
    let image = Trimmed::new(&coefficients(&light, 0, &[2.0]), 1e-2);
    println!("matte2: {:?}", image.lengths);
    ways.push(way("matte2", image.cost(), shaded(&image.scene)));
    let image = Trimmed::new(&coefficients(&[3.5], 0, &[2.0]), 1e-2);
    println!("ambient: {:?}", image.lengths);
    ways.push(way("ambient", image.cost(), shaded(&image.scene)));
    let times = interleaved(&mut ways, 4);
    let pixel = |time: f64| 1e9 * time / PIXELS as f64;
    let product = times[0] / (repeats * CHAINS * LANES) as f64 * 1e9;
    println!("{product:.5} ns");
    for (way, time) in ways.iter().zip(&times) {
        println!("{:10} {:4} {:.4} ns {:.1} % {:.2}", way.name, way.arithmetic, pixel(*time), 100.0 * product * way.arithmetic as f64 / pixel(*time), time / times[1]);
    }
}
