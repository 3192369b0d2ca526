//! The inputs: the shipped lights on the shipped materials, normals, and the calls that are made
//! once for a light or a material.

use eigenshade::{Light, Material, NineTerms, Normals, Tolerance, sphere};
use eigenshade_index::{light, material};
use std::hint::black_box;
use std::path::Path;

/// Name of the nine-term formula in docs/performance.md.
pub const NINE: &str = "nine-term formula";

/// The nine-term formula with some coefficients.
pub const NINE_TERMS: NineTerms =
    NineTerms::new([0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);

/// Room for irradiances, apart from the normals.
pub fn irradiances() -> &'static mut [f32] {
    zeros(3)
}

/// Few enough that normals and irradiances stay in the second cache.
pub const PIXELS: usize = 16_384;
const DEGREE: usize = 9;
const ORDER: usize = 7;

/// Many normals over the visible hemisphere.
pub fn normals() -> Normals<'static> {
    let normal = |k: usize| {
        let z = (k as f64 + 0.5) / PIXELS as f64;
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
        [sine * tilt.cos(), sine * tilt.sin(), z].map(|value| value as f32)
    };
    let [x, y, z] = [0, 1, 2].map(|axis| {
        let numbers = zeros(axis);
        numbers.iter_mut().enumerate().for_each(|(k, number)| *number = normal(k)[axis]);
        &*numbers
    });
    Normals::new(x, y, z).expect("one length")
}

/// Luminances of the shipped lights.
pub fn lights() -> Vec<Vec<f32>> {
    entries("lights.csv", light::count(DEGREE), |row| {
        let [r, g, b] = [3, 4, 5].map(|column| number(row, column));
        let [l, m] = [1, 2].map(|column| number(row, column) as isize);
        let place = (l <= DEGREE as isize).then(|| light::position(l.unsigned_abs(), m))?;
        Some((place, 0.2126 * r + 0.7152 * g + 0.0722 * b))
    })
}

/// The shipped materials, which are gray.
fn materials() -> Vec<Vec<f32>> {
    entries("materials.csv", material::count(ORDER), |row| {
        let [o, p, q] = [1, 2, 3].map(|column| number(row, column) as usize);
        Some((material::position(o, p, q), number(row, 4)))
    })
}

/// Entries of a file by name: each row's place and number.
fn entries(
    file: &str,
    count: usize,
    place: impl Fn(&[&str]) -> Option<(usize, f64)>,
) -> Vec<Vec<f32>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tables/inputs").join(file);
    let text = std::fs::read_to_string(path).expect("the shipped inputs");
    let mut found: Vec<(&str, Vec<f32>)> = Vec::new();
    // The first line after the comments is the header.
    for row in text.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let row: Vec<&str> = row.split(',').collect();
        if found.last().is_none_or(|(name, _)| *name != row[0]) {
            found.push((row[0], vec![0.0; count]));
        }
        if let (Some((place, value)), Some((_, values))) = (place(&row), found.last_mut()) {
            values[place] = value as f32;
        }
    }
    found.into_iter().map(|(_, values)| values).collect()
}

fn number(row: &[&str], column: usize) -> f64 {
    row[column].parse().expect("a number")
}

/// d of a light on a material.
pub fn coefficients(light: &[f32], material: &[f32]) -> sphere::Coefficients {
    let light = Light::from_finite(light).expect("a light");
    let material = Material::from_finite(material).expect("a material");
    sphere::project(&light, &material).expect("it fits")
}

/// d of each light on each material.
pub fn database() -> Vec<sphere::Coefficients> {
    let (lights, materials) = (lights(), materials());
    let pairs = lights.iter().flat_map(|light| materials.iter().map(move |of| (light, of)));
    pairs.map(|(light, material)| coefficients(light, material)).collect()
}

/// Name of a scene within a tolerance in docs/performance.md.
pub const WITHIN: &str = "`collapse_within` 1e-2";
/// Name of a projection there.
pub const PROJECT: &str = "`project`";

/// Name of each call in docs/performance.md, and the multiply-adds that it needs at least.
pub const CALLS: [(&str, usize); 5] =
    [("`relight`", 570), ("`collapse`", 590), (WITHIN, 590), ("`transfer`", 5400), (PROJECT, 7200)];

/// A light, a material and what is made of them.
pub struct CallInputs {
    light: Vec<f32>,
    material: Vec<f32>,
    transfer: sphere::Transfer,
    d: sphere::Coefficients,
    /// Of a light and a material that grow darker with their degree, as real ones do.
    darker: sphere::Coefficients,
}

impl CallInputs {
    /// Their numbers change no count, but those of [`darker`](Self::darker) do.
    pub fn new() -> Self {
        let (light, material) = (vec![0.1; 100], vec![0.1; 40]);
        let transfer = sphere::transfer(&Material::from_finite(&material).expect("a material"));
        let d = coefficients(&light, &material);
        let falling =
            |count: u8| (0..count).map(|k| 1.0 / f32::from(1 + 2 * k)).collect::<Vec<f32>>();
        let darker = coefficients(&falling(100), &falling(40));
        Self { light, material, transfer: transfer.expect("it fits"), d, darker }
    }

    /// One call of the [`CALLS`] of this number.
    pub fn call(&self, which: usize) {
        let light = || Light::from_finite(black_box(&self.light)).expect("a light");
        let material = || Material::from_finite(black_box(&self.material)).expect("a material");
        match which {
            0 => drop(black_box(sphere::relight(black_box(&self.transfer), &light()))),
            1 => drop(black_box(sphere::collapse(black_box(&self.d)))),
            2 => {
                let (mut lengths, mut room) = ([0; sphere::DEGREE + 1], [0.0; sphere::SCENE]);
                let (d, tolerance) = (black_box(&self.darker), Tolerance::OfPeak(1e-2));
                let found =
                    sphere::BASIS.collapse_within(d, tolerance, &mut lengths, &mut room[..]);
                let _ = black_box(found.map(|(_, report)| report));
            }
            3 => drop(black_box(sphere::transfer(&material()))),
            _ => drop(black_box(sphere::project(&light(), &material()))),
        }
    }
}

/// Bytes of a cache line.
const LINE: usize = 64;
/// Bytes after which the low twelve bits of an address repeat.
const PAGE: usize = 4096;

/// Zeros, kept to the end, of which the first starts a cache line in the given quarter of a page, 0
/// to 3, so that what is written does not look like what is read: processors compare the low twelve
/// bits of an address first.
fn zeros(quarter: usize) -> &'static mut [f32] {
    let numbers = Vec::leak(vec![0.0_f32; PIXELS + PAGE / size_of::<f32>()]);
    let wanted = quarter * PAGE / 4 + quarter * LINE;
    let to_go = (wanted + PAGE - numbers.as_ptr().addr() % PAGE) % PAGE;
    &mut numbers[to_go / size_of::<f32>()..][..PIXELS]
}
