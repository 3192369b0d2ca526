use eigenshade_generator::{basis, database::*, scene_file};
use eigenshade_index::{light, material};
fn main() {
    let path = std::path::Path::new("tables/sphere.toml");
    let t0 = std::time::Instant::now();
    let (mut scene, lights, materials) = match scene_file::load(path) {
        Ok(l) => (l.scene, l.lights, l.materials),
        Err(e) => {
            println!("{e}; synthetic");
            let mut x = 1u64;
            let mut r = move || { x = x.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407); ((x >> 33) as f64) / (1u64 << 31) as f64 - 0.5 };
            let lights = Lights { degree: 9, entries: (0..26).map(|k| { let v: Vec<f64> = light::indices(9).map(|(l, _)| if l == 0 {1.0} else {r() / (l as f64).powf(1.2)}).collect(); Named { name: format!("{k}"), rgb: [v.clone(), v.clone(), v] } }).collect() };
            let materials = Materials { order: 7, entries: (0..62).map(|k| { let v: Vec<f64> = material::indices(7).map(|(o, p, q)| if o == 0 {1.0} else {r() / ((o + p + q) as f64)}).collect(); Named { name: format!("{k}"), rgb: [v.clone(), v.clone(), v] } }).collect() };
            let text = std::fs::read_to_string(path).unwrap();
            (toml::from_str(&text).unwrap(), lights, materials)
        }
    };
    if let Some(k) = std::env::args().nth(1) { scene.basis.components = Some(k.parse().unwrap()); }
    if let Some(k) = std::env::args().nth(2) { scene.basis.rank_cutoff = k.parse().unwrap(); }
    println!("load {:?}", t0.elapsed());
    let t0 = std::time::Instant::now();
    let table = basis::build(&scene, &lights, &materials).unwrap();
    println!("build {:?}", t0.elapsed());
    println!("{:?}", table.summary);
    println!("components {} profiles {} spectrum {}", table.components.len(), table.profiles.len(), table.spectrum.len());
    println!("{:?}", table.components.iter().take(12).collect::<Vec<_>>());
    for p in table.profiles.iter() { print!("{}:{} ", p.azimuth, p.chebyshev.len()); }
    println!();
    for c in [50, 100, 150, 200, 250, 300, 1000] { println!("orth {c} {:e}", basis::orthonormality(&table, c)); }
    println!("bytes {}", eigenshade_table::encode(&table).len());
    let parts = eigenshade_table::Parts::new(&table);
    println!("factors {} terms {} lengths {:?}", parts.factors.len(), parts.terms.len(), parts.lengths);
}
