//! How far each path is from the limit of the target's arithmetic, and the pixel loop from
//! the nine-term formula: `cargo bench --bench pixels`. docs/performance.md says what the
//! limit is.
//!
//! With `-- --write` the figures go into that page, between the marks of the target.

use eigenshade::{
    BakedMap, Economy, Light, Lookup, MapPoint, Material, Normal, Normals, Scene, Tolerance, sphere,
};
use eigenshade_generator::inputs::coefficient_csv::{read_lights, read_materials};
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Few enough that normals and irradiances stay in the second cache.
const PIXELS: usize = 16_384;
const PAGE: &str = "docs/performance.md";
/// What the page calls the target.
const TARGET: &str = if cfg!(target_feature = "fma") { "native" } else { "default" };
/// Lengths of the shipped table's polynomials.
const FULL: [u16; 7] = [14, 14, 13, 12, 12, 13, 12];
const NINE: [f32; 9] = [0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07];
const REPEATS: usize = 400;
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
    let lights = read_lights(inputs.join("lights.csv"), Some(9)).expect("lights");
    let materials = read_materials(inputs.join("materials.csv"), Some(7)).expect("materials");
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

/// What is timed.
struct Way<'a> {
    name: String,
    /// Multiply-adds of a call.
    arithmetic: usize,
    /// Numbers that one instruction of the way takes.
    lanes: usize,
    /// Pixels of a call; none of what makes no pixels.
    pixels: Option<usize>,
    run: Box<dyn FnMut() + 'a>,
    times: Vec<f64>,
}

impl<'a> Way<'a> {
    fn new(name: impl Into<String>, arithmetic: usize, run: impl FnMut() + 'a) -> Self {
        let (name, run) = (name.into(), Box::new(run));
        Self { name, arithmetic, lanes: LANES, pixels: None, run, times: Vec::new() }
    }

    /// What shades all normals, at so many multiply-adds a pixel.
    fn pixels(name: impl Into<String>, arithmetic: usize, run: impl FnMut() + 'a) -> Self {
        Self { pixels: Some(PIXELS), ..Self::new(name, arithmetic, run) }
    }

    fn scene(name: &str, image: &'a Trimmed, slices: Normals<'a, f32>) -> Self {
        let mut out = vec![0.0; PIXELS];
        let name = format!("{name}: {}", lengths(&image.lengths));
        Self::pixels(name, image.cost(), move || {
            let scene = black_box(&image.scene);
            scene.shade_slice(black_box(slices), black_box(&mut out)).expect("one length");
        })
    }

    /// What takes one normal after the other, a number an instruction.
    fn one_by_one(self) -> Self {
        Self { lanes: 1, ..self }
    }
}

fn lengths(lengths: &[u16]) -> String {
    lengths.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// Seconds of each way, the least of interleaved rounds: what another program on the machine
/// took is not in it.
fn interleaved(ways: &mut [Way<'_>]) -> Vec<f64> {
    for _ in 0..ROUNDS {
        for way in &mut *ways {
            let repeats = if way.pixels.is_some() { 4 } else { 500 };
            let start = Instant::now();
            for _ in 0..repeats {
                (way.run)();
            }
            way.times.push(start.elapsed().as_secs_f64() / f64::from(repeats));
        }
    }
    let least = |way: &Way<'_>| way.times.iter().copied().fold(f64::INFINITY, f64::min);
    ways.iter().map(least).collect()
}

/// The page's table.
fn report() -> String {
    let xyz = normals();
    let axes = [&xyz[0][..], &xyz[1], &xyz[2]];
    let slices = Normals::new(axes[0], axes[1], axes[2]).expect("one length");
    let each: Vec<_> = (0..PIXELS)
        .map(|k| Normal::new(axes[0][k], axes[1][k], axes[2][k]).expect("visible"))
        .collect();
    let database = database();
    let image = &database[database.len() / 2];
    let full = sphere::BASIS.collapse_into(image, [0.0; sphere::SCENE]).expect("sizes");
    let full = Trimmed { scene: full, lengths: FULL.to_vec() };
    let trimmed = [1e-4, 1e-3, 1e-2].map(|share| (share, median(&database, share)));
    let mut mattes: Vec<_> = mattes().iter().map(|d| Trimmed::new(d, 1e-2)).collect();
    mattes.sort_by_key(Trimmed::cost);
    let light: Vec<f32> = (0..9).map(|k| 3.5 / (1.0 + k as f32)).collect();
    let matte = Trimmed::new(&coefficients(&light, 0, &[2.0]), 1e-3);
    let ambient = Trimmed::new(&coefficients(&[3.5], 0, &[2.0]), 1e-3);
    let lookup: Lookup<f32, Vec<f32>> =
        full.scene.lookup_into(32, vec![0.0; full.scene.lookup_len::<f32>(32)]).expect("sizes");
    let baked: BakedMap<f32, Vec<f32>> =
        full.scene.bake_into(64, vec![0.0; 64 * 64]).expect("sizes");
    let (light, material) = (vec![0.1; 100], vec![0.1; 40]);
    let light = Light::new(9, &light).expect("a light");
    let material = Material::new(7, &material).expect("a material");
    let transfer = sphere::transfer(&material).expect("it fits");

    let mut nine = vec![0.0; PIXELS];
    let [mut by_knots, mut by_texels] = [(); 2].map(|()| vec![0.0; PIXELS]);
    let mut ways = vec![
        Way::new("limit", REPEATS * CHAINS * LANES, || {
            black_box(multiply_adds(black_box(REPEATS), black_box(0.3), black_box(0.5)));
        }),
        Way::pixels("nine-term formula", 11, || {
            nine_terms(black_box(&NINE), black_box(axes), black_box(&mut nine));
        }),
        Way::scene("full scene", &full, slices),
    ];
    for (share, image) in &trimmed {
        ways.push(Way::scene(&format!("median image within {share:e}"), image, slices));
    }
    for (which, image) in [("least", 0), ("median", mattes.len() / 2), ("most", mattes.len() - 1)] {
        ways.push(Way::scene(&format!("matte within 1e-2, {which}"), &mattes[image], slices));
    }
    ways.extend([
        Way::scene("matte, light of degree 2, within 1e-3", &matte, slices),
        Way::scene("matte, ambient light, within 1e-3", &ambient, slices),
        Way::pixels("look-up, 32 knots, cubic", 91, || {
            for (out, &normal) in by_knots.iter_mut().zip(black_box(&each)) {
                *out = lookup.cubic(normal);
            }
            black_box(&by_knots);
        })
        .one_by_one(),
        Way::pixels("baked, 64 x 64, bilinear", 9, || {
            for (out, &normal) in by_texels.iter_mut().zip(black_box(&each)) {
                *out = baked.bilinear(MapPoint::of(normal));
            }
            black_box(&by_texels);
        })
        .one_by_one(),
        Way::new("`relight`", 570, || {
            black_box(sphere::relight(black_box(&transfer), black_box(&light)).expect("it fits"));
        }),
        Way::new("`collapse`", 650, || {
            let d = black_box(image).as_slice().try_into().expect("50 coefficients");
            black_box(sphere::collapse(&d).expect("it fits"));
        }),
        Way::new("`project`", 7200, || {
            black_box(sphere::project(black_box(&light), black_box(&material)).expect("it fits"));
        }),
    ]);
    let times = interleaved(&mut ways);
    let product = times[0] / (REPEATS * CHAINS * LANES) as f64;
    let mut page = format!(
        "A multiply-add takes {:.4} ns of {LANES} numbers at once.\n\n\
         | path: terms of azimuths 0, 1, ... | multiply-adds | limit, ns | found, ns | of the limit | nine-term pixels |\n\
         |---|---:|---:|---:|---:|---:|\n",
        1e9 * product * LANES as f64
    );
    for (way, time) in ways.iter().zip(&times).skip(1) {
        let time = time / way.pixels.unwrap_or(1) as f64;
        let limit = way.arithmetic as f64 * product * (LANES / way.lanes) as f64;
        let nine = times[1] / PIXELS as f64;
        let of_nine = way.pixels.map_or(String::new(), |_| format!("{:.2}", time / nine));
        let (share, limit, found) = (100.0 * limit / time, 1e9 * limit, 1e9 * time);
        let Way { name, arithmetic, .. } = way;
        let _ = writeln!(
            page,
            "| {name} | {arithmetic} | {limit:.3} | {found:.3} | {share:.0} % | {of_nine} |"
        );
    }
    page
}

/// Puts the table between the marks of the target.
fn write(table: &str) {
    let page = std::fs::read_to_string(PAGE).expect("the page");
    let (start, end) = (format!("<!-- {TARGET} -->\n"), format!("<!-- end of {TARGET} -->"));
    let from = page.find(&start).expect("a mark") + start.len();
    let to = page.find(&end).expect("a mark");
    let page = format!("{}{table}{}", &page[..from], &page[to..]);
    std::fs::write(PAGE, page).expect("the page");
}

fn main() {
    // `cargo test --benches` only checks that it compiles.
    let asked = |what: &str| std::env::args().any(|argument| argument == what);
    if asked("--bench") {
        let table = report();
        println!("{table}");
        if asked("--write") {
            write(&table);
        }
    }
}
