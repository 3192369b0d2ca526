use eigenshade_generator::brdf::projection::*;
use eigenshade_generator::brdf::*;
#[test]
fn scratch() {
    let l = Lambertian::new(0.8).unwrap();
    let p = project(&l, 12);
    println!(
        "lambert {:?} left {:e} worst {:e}",
        p.coefficients[0] - 1.6,
        p.left_out,
        p.coefficients[1..].iter().fold(0.0f64, |m, x| m.max(x.abs()))
    );
    let o = OrenNayar::new(0.8, 0.5).unwrap();
    for (name, b) in [
        ("on", Box::new(o) as Box<dyn Brdf>),
        ("g1", Box::new(Ggx::new(0.1, 0.04, 0.5).unwrap())),
        ("m1", Box::new(Ggx::new(0.1, 0.9, 0.).unwrap())),
        ("m.03", Box::new(Ggx::new(0.03, 0.9, 0.).unwrap())),
        ("m.3", Box::new(Ggx::new(0.3, 0.9, 0.).unwrap())),
        ("m.5", Box::new(Ggx::new(0.5, 0.9, 0.).unwrap())),
        ("d.5", Box::new(Ggx::new(0.5, 0.04, 0.5).unwrap())),
        ("m1.", Box::new(Ggx::new(1., 0.9, 0.).unwrap())),
    ] {
        for order in [12usize, 32] {
            let t = std::time::Instant::now();
            let p = project(&*b, order);
            let dt = t.elapsed();
            let r = project_with(&*b, order, 2 * nodes(order));
            let top = r.coefficients.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let diff = p
                .coefficients
                .iter()
                .zip(&r.coefficients)
                .fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            println!(
                "{name} {order} {dt:?} left {:e} vs {:e} top {top:e} diff/top {:e} energy {:e} {:e}",
                p.left_out,
                r.left_out,
                diff / top,
                p.energy,
                (p.energy - r.energy) / r.energy
            );
        }
    }
}
use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::inputs::environment::EnvironmentMap;
use eigenshade_generator::inputs::light_projection::{named_maps, project as project_map};
use eigenshade_generator::truth::Truth;
#[test]
fn direct() {
    let maps =
        named_maps(&[concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/maps")]).unwrap();
    let maps: Vec<_> =
        maps.into_iter().map(|(n, p)| (n, EnvironmentMap::from_path(p).unwrap())).collect();
    let all: Vec<EnvironmentMap> = maps.iter().map(|m| m.1.clone()).collect();
    let s = Surroundings::new(&all).unwrap();
    let mut normals = vec![];
    for k in 0..300 {
        let r = ((k as f64 + 0.5) / 300.).sqrt();
        let b = 2.399963 * k as f64;
        normals.push([r * b.cos(), r * b.sin(), (1. - r * r).sqrt()]);
    }
    let lights: Vec<_> = all.iter().map(|m| project_map(m, 24)).collect();
    for (name, b) in [
        ("lam", Box::new(Lambertian::new(0.8).unwrap()) as Box<dyn Brdf>),
        ("on", Box::new(OrenNayar::new(0.8, 0.5).unwrap())),
        ("d.5", Box::new(Ggx::new(0.5, 0.04, 0.5).unwrap())),
        ("m.5", Box::new(Ggx::new(0.5, 0.9, 0.).unwrap())),
        ("m.3", Box::new(Ggx::new(0.3, 0.9, 0.).unwrap())),
        ("m1", Box::new(Ggx::new(1., 0.9, 0.).unwrap())),
    ] {
        let t = std::time::Instant::now();
        let mut e = vec![];
        for c in normals.chunks(25) {
            e.extend(s.irradiance(&[&*b], c, 1.0));
        }
        println!("{name} direct {:?}", t.elapsed());
        for order in [12usize, 16, 24] {
            let p = eigenshade_generator::brdf::projection::project(&*b, order);
            let truth = Truth::new(order, order);
            let mut errs = vec![];
            let mut sq = vec![0.0; all.len()];
            let mut pk = vec![0.0f64; all.len()];
            for (k, n) in normals.iter().enumerate() {
                let m = truth.at(*n);
                let sc = m.scatter(&p.coefficients);
                for i in 0..all.len() {
                    for c in 0..3 {
                        let v = m.irradiance(&lights[i][c][..(order + 1) * (order + 1)], &sc);
                        let w = e[k][0][i][c];
                        sq[i] += (v - w) * (v - w) / 3.;
                        pk[i] = pk[i].max(w.abs());
                    }
                }
            }
            for i in 0..all.len() {
                errs.push(((sq[i] / 300.).sqrt() / pk[i], &maps[i].0));
            }
            errs.sort_by(|a, b| a.0.total_cmp(&b.0));
            println!(
                "{name} {order} median {:.4} worst {:?} best {:?}",
                0.5 * (errs[8].0 + errs[9].0),
                errs[17],
                errs[0]
            );
        }
    }
}
