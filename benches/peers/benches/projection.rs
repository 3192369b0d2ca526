//! Projection and shading against their dense and nine-term counterparts, in one
//! run: `cargo bench --manifest-path benches/peers/Cargo.toml --bench projection`.
//!
//! After criterion's own figures it prints ratios of medians of interleaved runs.

#[path = "../src/by_hand.rs"]
mod by_hand;

use by_hand::{ByHand, padded};
use criterion::{Criterion, criterion_group};
use eigenshade::index::{light, material, mode};
use eigenshade::{Light, Material, NineTerms, Normals, sphere};
use eigenshade_model::database::Named;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use nalgebra::{DMatrix, DVector};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// A matrix and a vector, formed in full, as a dense product needs them: UᵀM and c, or UᵀM with
/// a material folded in and a light.
struct Dense {
    /// K x modes, a column after the other.
    faer_columns: Mat<f32>,
    /// modes x K, so that a row of UᵀM is contiguous.
    faer_rows: Mat<f32>,
    nalgebra_columns: DMatrix<f32>,
    nalgebra_rows: DMatrix<f32>,
    c: DVector<f32>,
    by_hand: ByHand<{ padded(sphere::COMPONENTS) }>,
    /// c, to whole vectors.
    padded: Vec<f32>,
}

/// How often the dense matrices are held.
///
/// A dense product takes up to a quarter longer with where its matrix lies in
/// memory. The rounds take these in turn, so that a median does not hang on one place.
const PLACES: usize = 5;

/// A light and a material of the database, UᵀM, and the same with the material folded in: a
/// column for each coefficient of the light.
struct Setting {
    light: Vec<f32>,
    material: Vec<f32>,
    dense: [Dense; PLACES],
    folded: [Dense; PLACES],
}

fn narrow(entry: &Named) -> Vec<f32> {
    entry.luminance().iter().map(|&value| value as f32).collect()
}

fn setting() -> Setting {
    let lights = read_lights(
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/lights.csv")),
        Some(9),
    )
    .expect("lights");
    let materials = read_materials(
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/materials.csv")),
        Some(7),
    )
    .expect("materials");
    let light = narrow(&lights.entries[3]);
    let material = narrow(&materials.entries[4]);
    let bytes = std::fs::read("tables/sphere.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&bytes).expect("a table");
    let orders: Vec<i32> = (-9..=9).collect();
    let places: Vec<[usize; 2]> = orders
        .iter()
        .flat_map(|&m| mode::indices(9, 7, m.unsigned_abs() as usize).map(move |mode| (m, mode)))
        .map(|(m, (l, o, p, q))| [light::position(l, m as isize), material::position(o, p, q)])
        .collect();
    let c: Vec<f32> = places.iter().map(|&[l, b]| light[l] * material[b]).collect();
    assert_eq!(c.len(), 3704);
    let mut rows = vec![vec![0.0f32; c.len()]; table.components.len()];
    for (row, component) in rows.iter_mut().zip(&table.components) {
        let mut start = 0;
        for &m in &orders {
            let count = mode::count(9, 7, m.unsigned_abs() as usize);
            if m == component.order {
                let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
                let values = table.gram_row(&table.profiles[component.profile]);
                for (to, value) in row[start..].iter_mut().zip(values) {
                    *to = (sign * value) as f32;
                }
            }
            start += count;
        }
    }
    let folded: Vec<Vec<f32>> = rows
        .iter()
        .map(|row| {
            let mut folded = vec![0.0; light.len()];
            for (&[l, b], value) in places.iter().zip(row) {
                folded[l] += value * material[b];
            }
            folded
        })
        .collect();
    let dense = std::array::from_fn(|_| Dense::new(&rows, &c));
    let folded = std::array::from_fn(|_| Dense::new(&folded, &light));
    Setting { light, material, dense, folded }
}

impl Dense {
    fn new(rows: &[Vec<f32>], c: &[f32]) -> Self {
        let (k, n) = (rows.len(), c.len());
        let mut filled = c.to_vec();
        filled.resize(padded(n), 0.0);
        Self {
            faer_columns: Mat::from_fn(k, n, |i, j| rows[i][j]),
            faer_rows: Mat::from_fn(n, k, |j, i| rows[i][j]),
            nalgebra_columns: DMatrix::from_fn(k, n, |i, j| rows[i][j]),
            nalgebra_rows: DMatrix::from_fn(n, k, |j, i| rows[i][j]),
            c: DVector::from_row_slice(c),
            by_hand: ByHand::new(rows),
            padded: filled,
        }
    }

    fn faer_columns(&self, d: &mut Mat<f32>) {
        let c = faer::ColRef::from_slice(black_box(self.c.as_slice())).as_mat();
        matmul(d.as_mut(), Accum::Replace, self.faer_columns.as_ref(), c, 1.0, Par::Seq);
    }

    fn faer_rows(&self, d: &mut Mat<f32>) {
        let c = faer::ColRef::from_slice(black_box(self.c.as_slice())).as_mat();
        matmul(d.as_mut(), Accum::Replace, self.faer_rows.transpose(), c, 1.0, Par::Seq);
    }

    fn nalgebra_columns(&self, d: &mut DVector<f32>) {
        d.gemv(1.0, &self.nalgebra_columns, black_box(&self.c), 0.0);
    }

    fn nalgebra_rows(&self, d: &mut DVector<f32>) {
        d.gemv_tr(1.0, &self.nalgebra_rows, black_box(&self.c), 0.0);
    }
}

impl Setting {
    fn light(&self) -> Light<'_, f32> {
        Light::new(9, &self.light).expect("100 coefficients")
    }

    fn material(&self) -> Material<'_, f32> {
        Material::new(7, &self.material).expect("40 coefficients")
    }

    fn project(&self) -> sphere::Coefficients {
        sphere::project(black_box(&self.light()), black_box(&self.material())).expect("it fits")
    }

    /// All ways give the same d, or the comparison means nothing.
    fn check(&self) {
        let ours = self.project();
        let largest = ours.iter().fold(0.0f32, |most, d| most.max(d.abs()));
        let transfer = sphere::transfer(&self.material()).expect("it fits");
        let relit = sphere::relight(&transfer, &self.light()).expect("it fits");
        let mut others = vec![relit.to_vec()];
        for dense in [&self.dense, &self.folded] {
            let mut products = Products::new();
            for (_, mut way) in products.ways("", dense) {
                way(0);
            }
            others.extend(products.all());
        }
        for other in &others {
            for (k, (ours, other)) in ours.iter().zip(other).enumerate() {
                assert!((ours - other).abs() < 1e-5 * largest, "component {k}: {ours} {other}");
            }
        }
    }
}

/// What each way to a dense product gave last.
struct Products {
    faer: [Mat<f32>; 2],
    nalgebra: [DVector<f32>; 2],
    by_hand: [[f32; padded(sphere::COMPONENTS)]; 2],
}

impl Products {
    fn new() -> Self {
        let k = sphere::COMPONENTS;
        Self {
            faer: [(); 2].map(|()| Mat::zeros(k, 1)),
            nalgebra: [(); 2].map(|()| DVector::zeros(k)),
            by_hand: [[0.0; _]; 2],
        }
    }

    /// Every way, with the matrix in the round's place.
    fn ways<'a>(&'a mut self, what: &str, dense: &'a [Dense; PLACES]) -> Vec<Way<'a>> {
        let at = |round: usize| &dense[round % PLACES];
        let [f1, f2] = &mut self.faer;
        let [n1, n2] = &mut self.nalgebra;
        let [h1, h2] = &mut self.by_hand;
        let name = |way| format!("{what}, {way}");
        vec![
            (name("faer by columns"), Box::new(move |k| at(k).faer_columns(black_box(f1)))),
            (name("faer by rows"), Box::new(move |k| at(k).faer_rows(black_box(f2)))),
            (name("nalgebra by columns"), Box::new(move |k| at(k).nalgebra_columns(black_box(n1)))),
            (name("nalgebra by rows"), Box::new(move |k| at(k).nalgebra_rows(black_box(n2)))),
            (
                name("by hand, by columns"),
                Box::new(move |k| {
                    *black_box(&mut *h1) = at(k).by_hand.by_columns(black_box(at(k).c.as_slice()));
                }),
            ),
            (
                name("by hand, by rows"),
                Box::new(move |k| {
                    *black_box(&mut *h2) = at(k).by_hand.by_rows(black_box(&at(k).padded));
                }),
            ),
        ]
    }

    fn all(&self) -> Vec<Vec<f32>> {
        let faer = self.faer.iter().map(|d| d.col(0).iter().copied().collect());
        let nalgebra = self.nalgebra.iter().map(|d| d.as_slice().to_vec());
        let by_hand = self.by_hand.iter().map(|d| d.to_vec());
        faer.chain(nalgebra).chain(by_hand).collect()
    }
}

/// Many normals over the visible hemisphere.
fn normals(count: usize) -> [Vec<f32>; 3] {
    let normal = |k: usize| {
        let z = (k as f64 + 0.5) / count as f64;
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
        [sine * tilt.cos(), sine * tilt.sin(), z].map(|value| value as f32)
    };
    std::array::from_fn(|axis| (0..count).map(|k| normal(k)[axis]).collect())
}

const PIXELS: usize = 65_536;
const NINE: NineTerms<f32> = NineTerms::new([0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);

fn benches(criterion: &mut Criterion) {
    let setting = setting();
    setting.check();
    let transfer = sphere::transfer(&setting.material()).expect("it fits");
    criterion.bench_function("project", |b| b.iter(|| setting.project()));
    criterion.bench_function("transfer", |b| {
        b.iter(|| sphere::transfer(black_box(&setting.material())));
    });
    criterion.bench_function("relight", |b| {
        b.iter(|| sphere::relight(black_box(&transfer), black_box(&setting.light())));
    });
    let d = setting.project();
    criterion.bench_function("collapse", |b| b.iter(|| sphere::collapse(black_box(&d))));
    let scene = sphere::collapse(&d).expect("it fits");
    let xyz = normals(PIXELS);
    let mut out = vec![0.0; PIXELS];
    let slices = Normals::new(&xyz[0], &xyz[1], &xyz[2]).expect("one length");
    criterion.bench_function("shade 65536", |b| {
        b.iter(|| scene.shade_slice(black_box(slices), &mut out));
    });
}

/// One way to do a thing, by name; it is told the round.
type Way<'a> = (String, Box<dyn FnMut(usize) + 'a>);

/// Rounds in each place.
const ROUNDS: usize = 9;

/// Seconds of one call.
struct Times {
    /// Median over all rounds.
    median: f64,
    /// Least of the places' medians.
    best_place: f64,
}

/// The median of `times`, which it sorts.
fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Times of one call of each, runs interleaved.
fn interleaved(repeats: usize, ways: &mut [Way<'_>]) -> Vec<Times> {
    let mut times = vec![vec![Vec::new(); PLACES]; ways.len()];
    for round in 0..ROUNDS * PLACES {
        for ((_, way), times) in ways.iter_mut().zip(&mut times) {
            let start = Instant::now();
            for _ in 0..repeats {
                way(round);
            }
            times[round % PLACES].push(start.elapsed().as_secs_f64() / repeats as f64);
        }
    }
    let statistics = |(way, times): (&Way<'_>, &mut Vec<Vec<f64>>)| {
        let places = times.iter_mut().map(|times| median(times));
        let best_place = places.fold(f64::INFINITY, f64::min);
        let median = median(&mut times.concat());
        println!("  {:<28} {:>10.1} ns", way.0, 1e9 * median);
        Times { median, best_place }
    };
    ways.iter().zip(&mut times).map(statistics).collect()
}

/// The ratios that docs/costs.md quotes.
fn ratios() {
    let setting = setting();
    let transfer = sphere::transfer(&setting.material()).expect("it fits");
    println!(
        "\nprojection, K = {}, {} modes, {} coefficients of the light, medians:",
        sphere::COMPONENTS,
        setting.dense[0].c.len(),
        setting.folded[0].c.len(),
    );
    let (mut products, mut folded) = (Products::new(), Products::new());
    let relight: Way<'_> = (
        "relight".into(),
        Box::new(|_| {
            let d = sphere::relight(black_box(&transfer), black_box(&setting.light()));
            drop(black_box(d));
        }),
    );
    let project: Way<'_> = ("project".into(), Box::new(|_| drop(black_box(setting.project()))));
    let mut ways = vec![project, relight];
    ways.extend(products.ways("dense", &setting.dense));
    ways.extend(folded.ways("folded", &setting.folded));
    let times = interleaved(2000, &mut ways);
    let (ours, dense) = times.split_at(2);
    let (dense, folded) = dense.split_at(dense.len() / 2);
    for (what, ways) in [("the best dense product", dense), ("the best folded one", folded)] {
        let least = |of: fn(&Times) -> f64| ways.iter().map(of).fold(f64::INFINITY, f64::min);
        for (what, best) in [
            (what, least(|times| times.median)),
            ("  in the best of its places", least(|times| times.best_place)),
        ] {
            let [project, relight] = [&ours[0], &ours[1]].map(|times| best / times.median);
            println!("  {what}: {project:.1} times project, {relight:.1} times relight");
        }
    }

    let scene = sphere::collapse(&setting.project()).expect("it fits");
    let xyz = normals(PIXELS);
    let slices = Normals::new(&xyz[0], &xyz[1], &xyz[2]).expect("one length");
    let (mut ours, mut nine) = (vec![0.0; PIXELS], vec![0.0; PIXELS]);
    println!("shading {PIXELS} normals, medians:");
    let times = interleaved(
        10,
        &mut [
            (
                "full scene".into(),
                Box::new(|_| {
                    scene.shade_slice(black_box(slices), black_box(&mut ours)).expect("one length");
                }),
            ),
            (
                "nine terms".into(),
                Box::new(|_| {
                    let formula = black_box(&NINE);
                    formula
                        .shade_slice(black_box(slices), black_box(&mut nine))
                        .expect("one length");
                }),
            ),
        ],
    );
    println!(
        "  a pixel of the full scene takes {:.2} ns, {:.1} times the nine-term formula",
        1e9 * times[0].median / PIXELS as f64,
        times[0].median / times[1].median
    );
}

criterion_group!(group, benches);

fn main() {
    group();
    Criterion::default().configure_from_args().final_summary();
    // `cargo test --benches` only checks that everything runs.
    if std::env::args().any(|argument| argument == "--bench") {
        ratios();
    }
}
