//! Try.
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_sources::pursuit::{ROUGHNESS, find, metals};
use std::time::Instant;
fn main() {
    let t = Instant::now();
    let materials = metals(&ROUGHNESS).unwrap();
    eprintln!("materials {:?}", t.elapsed());
    for name in std::env::args().skip(1) {
        let t = Instant::now();
        let map = EnvironmentMap::from_path(format!("tables/inputs/maps/{name}.exr")).unwrap();
        let sets = find(&map, &materials, 8).unwrap();
        for (k, set) in sets { println!("{name} {k}: {} {:?}", set.len(), set.first()); }
        eprintln!("{name} {:?}", t.elapsed());
    }
}
