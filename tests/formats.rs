//! Every number format against the f64 sum of the same components, over every light on
//! every material of the database.

use eigenshade::quantised::{Light, Material, Normal};
use eigenshade_cli::owned_basis::OwnedBasis;
use eigenshade_cli::owned_quantised::{Integer, OwnedQuantised};
use eigenshade_cli::shipped;
use eigenshade_table::Table;
use eigenshade_table::quantise::{self, Format};

fn table() -> Table {
    eigenshade_table::decode(&std::fs::read("tables/sphere.bin").expect("the shipped table"))
        .expect("a table")
}

fn chebyshev(terms: &[f64], t: f64) -> f64 {
    let (mut before, mut current, mut sum) = (1.0, t, 0.0);
    for (k, term) in terms.iter().enumerate() {
        match k {
            0 => sum += term,
            1 => sum += term * t,
            _ => {
                let next = 2.0 * t * current - before;
                before = current;
                current = next;
                sum += term * next;
            }
        }
    }
    sum
}

#[derive(Default, Debug)]
struct Score {
    signal: f64,
    noise: f64,
    worst: f64,
    name: String,
    d_signal: Vec<f64>,
    d_noise: Vec<f64>,
    ratio: f64,
    bounds: [Vec<f64>; 6],
    raw_s: f64,
    raw_n: f64,
    raw_ds: Vec<f64>,
    raw_dn: Vec<f64>,
}

trait To {
    fn to(self) -> f64;
}
impl To for eigenshade::Q15 {
    fn to(self) -> f64 {
        self.0.into()
    }
}
impl To for eigenshade::Q31 {
    fn to(self) -> f64 {
        self.0.into()
    }
}
fn score<Q: Integer + To>(tolerance: f64) -> Score {
    let table = table();
    let owned = OwnedQuantised::<Q>::new(&table, tolerance).unwrap();
    let basis = owned.view().unwrap();
    println!("lengths {:?} sum {}", basis.parts().lengths, basis.scene_len());
    let lights = shipped::lights().unwrap().truncated(9);
    let materials = shipped::materials().unwrap().truncated(7);
    let rows: Vec<Vec<f64>> = table.profiles.iter().map(|p| table.gram_row(p)).collect();
    let _ = rows;
    let f64_basis = OwnedBasis::<f64>::new(&table);
    let eigenshade_cli::owned_basis::AnyBasis::Sphere(truth) = f64_basis.any().unwrap() else {
        panic!()
    };
    // normals: spiral with equal weights in projected area
    let count = 400;
    let one = 2f64.powi(Q::FORMAT.bits());
    let normals: Vec<([f64; 3], Normal<Q>)> = (0..count)
        .filter_map(|k| {
            let z = ((k as f64 + 0.5) / count as f64).sqrt();
            let b = 2.399963 * k as f64;
            let s = (1.0 - z * z).sqrt();
            let n = [s * b.cos(), s * b.sin(), z];
            let q =
                n.map(|c| Q::of(((c * one).round()).clamp(-one + 1.0, one - 1.0) as i64 as i32));
            let nq = Q::normal(q);
            let _ = n;
            let n = if std::env::var("QN").is_ok() {
                nq.components().map(|c| Q::to(c) / one)
            } else {
                n
            };
            Some((n, nq))
        })
        .collect();
    let k = table.count();
    let mut result = Score {
        raw_ds: vec![0.0; k],
        raw_dn: vec![0.0; k],
        d_signal: vec![0.0; k],
        d_noise: vec![0.0; k],
        worst: f64::INFINITY,
        ..Default::default()
    };
    let mut workspace = vec![Default::default(); basis.workspace_len()];
    let mut numbers = vec![Q::default(); basis.transfer_len()];
    let mut exponents = vec![0i16; basis.profiles()];
    let mut scene_buffer = vec![0i32; basis.scene_len()];
    let shapes: Vec<Vec<f64>> = table
        .profiles
        .iter()
        .map(|p| {
            let scale = if p.azimuth == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
            normals.iter().map(|(n, _)| scale * chebyshev(&p.chebyshev, 2.0 * n[2] - 1.0)).collect()
        })
        .collect();
    let images: Vec<Vec<f64>> = table
        .components
        .iter()
        .map(|c| {
            normals
                .iter()
                .enumerate()
                .map(|(j, (n, _))| {
                    let (mut re, mut im) = (1.0, 0.0);
                    for _ in 0..c.order.abs() {
                        (re, im) = (re * n[0] - im * n[1], re * n[1] + im * n[0]);
                    }
                    shapes[c.profile][j] * if c.order < 0 { -im } else { re }
                })
                .collect()
        })
        .collect();
    let sup: Vec<f64> =
        images.iter().map(|im| im.iter().fold(0.0f64, |a, b| a.max(b.abs()))).collect();
    let steps: Vec<f64> = {
        let n = basis.parts();
        let mut out = vec![];
        let mut at = 0;
        for (p, q) in table.profiles.iter().zip(n.profiles) {
            let len = n.lengths[p.azimuth] as usize;
            let _ = q;
            let e = owned.place(out.len()).exponent;
            let x: Vec<f64> = (at..at + len).map(|i| owned.term(i) * 2f64.powi(e.into())).collect();
            at += len;
            let mut m: f64 = 0.0;
            for g in 0..=100 {
                let t = -1.0 + 0.02 * g as f64;
                let mut b = 0.0;
                for v in &x {
                    b = b * t + v;
                    m = m.max(f64::abs(b));
                }
            }
            out.push(m);
        }
        out
    };
    for m in &materials.entries {
        let b = &m.rgb[1];
        let (mant, exps) = quantise::material(materials.order, b, Q::FORMAT);
        let mant: Vec<Q> = mant.into_iter().map(Q::of).collect();
        let material = Material::new(materials.order, &exps, &mant).unwrap();
        basis.fold_into(&material, &mut workspace, &mut numbers, &mut exponents).unwrap();
        let transfer = eigenshade::quantised::Transfer::new(&numbers, &exponents);
        for l in &lights.entries {
            let c = &l.rgb[1];
            let (lm, le) = quantise::row(c, Q::FORMAT.bits(), i64::MAX);
            let lm: Vec<Q> = lm.into_iter().map(Q::of).collect();
            let light = Light::new(lights.degree, le.into(), &lm).unwrap();
            let mut d = vec![0i32; k];
            let e = basis.relight_into(&transfer, &light, &mut d).unwrap();
            let mut exact = vec![0.0; k];
            let mut ws = vec![0.0; truth.workspace_len()];
            truth
                .project_into(
                    &eigenshade::Light::new(lights.degree, c).unwrap(),
                    &eigenshade::Material::new(materials.order, b).unwrap(),
                    &mut ws,
                    &mut exact,
                )
                .unwrap();
            let norm: f64 = exact.iter().map(|d| d * d).sum::<f64>().sqrt();
            for i in 0..k {
                let found = f64::from(d[i]) * 2f64.powi(e);
                result.raw_ds[i] += exact[i].powi(2);
                result.raw_dn[i] += (found - exact[i]).powi(2);
                result.d_signal[i] += (exact[i] / norm).powi(2);
                result.d_noise[i] += ((found - exact[i]) / norm).powi(2);
            }
            let scene = basis.collapse_into(&d, e, &mut scene_buffer).unwrap();
            let scale = 2f64.powi(scene.exponent());
            let (mut signal, mut noise, mut peak) = (0.0, 0.0, 0.0f64);
            for (j, (_, q)) in normals.iter().enumerate() {
                let exact: f64 = (0..k).map(|i| exact[i] * images[i][j]).sum();
                let raw = scene.shade(*q);
                let found = f64::from(raw) * scale;
                peak = peak.max(f64::from(raw.abs()));
                signal += exact * exact;
                noise += (found - exact).powi(2);
            }
            if std::env::var("SHOW").is_ok() && l.name == "sky" && m.name == "61-moss" {
                for (j, (n, q)) in normals.iter().enumerate().step_by(10) {
                    let exact: f64 = (0..k).map(|i| exact[i] * images[i][j]).sum::<f64>() / scale;
                    let found: f64 =
                        (0..k).map(|i| f64::from(d[i]) * 2f64.powi(e) * images[i][j]).sum::<f64>()
                            / scale;
                    println!(
                        "{:?} {exact:.2} {found:.2} {}",
                        n.map(|c| (c * 1000.0).round() / 1000.0),
                        scene.shade(*q)
                    );
                }
            }
            if std::env::var("SHAPE").is_ok()
                && Q::FORMAT == Format::Q31
                && (m.name == "61-moss" || m.name == "05-leather" || m.name == "ptfe-633nm")
                && (l.name == "sky" || l.name == "park" || l.name == "studio")
            {
                let h = scene.terms();
                let mut rest: &[i32] = h;
                let pk = (0..normals.len())
                    .map(|j| (0..k).map(|i| exact[i] * images[i][j]).sum::<f64>().abs())
                    .fold(0.0, f64::max)
                    / scale;
                let mut line = String::new();
                let (mut l1, mut su, mut sw) = (0.0, 0.0, 0.0);
                let mut mp: f64 = 0.0;
                for (a, &n) in basis.parts().lengths.iter().enumerate() {
                    for s in 0..if a == 0 { 1 } else { 2 } {
                        let (x, y) = rest.split_at(n.into());
                        rest = y;
                        let _ = s;
                        let sum: f64 = x.iter().map(|v| f64::from(*v).abs()).sum();
                        let mut sup: f64 = 0.0;
                        let mut part: f64 = 0.0;
                        let mut supw: f64 = 0.0;
                        for g in 0..=200 {
                            let t = -1.0 + 0.01 * g as f64;
                            let z = (t + 1.0) / 2.0;
                            let mut b = 0.0f64;
                            for v in x {
                                b = b * t + f64::from(*v);
                                part = part.max(b.abs());
                            }
                            sup = sup.max(b.abs());
                            supw = supw.max(b.abs() * (1.0 - z * z).max(0.0).sqrt().powi(a as i32));
                        }
                        l1 += sum;
                        su += sup;
                        sw += supw;
                        mp = mp.max(part);
                        line += &format!(
                            " {a}:{:.2}/{:.2}/{:.2}/{:.2}",
                            sum / pk,
                            part / pk,
                            sup / pk,
                            supw / pk
                        );
                    }
                }
                println!(
                    "{} {} L1 {:.1} sup {:.1} supw {:.1} largest partial {:.2} of peak |{line}",
                    l.name,
                    m.name,
                    l1 / pk,
                    su / pk,
                    sw / pk,
                    mp / pk
                );
            }
            if std::env::var("BOUND").is_ok() && Q::FORMAT == Format::Q31 {
                let pk = (0..normals.len())
                    .map(|j| (0..k).map(|i| exact[i] * images[i][j]).sum::<f64>().abs())
                    .fold(0.0, f64::max);
                let h = scene.terms();
                let mut rest: &[i32] = h;
                let (mut l1, mut l1max, mut end) = (0.0f64, 0.0f64, 0.0f64);
                for (a, &n) in basis.parts().lengths.iter().enumerate() {
                    for _ in 0..if a == 0 { 1 } else { 2 } {
                        let (x, y) = rest.split_at(n.into());
                        rest = y;
                        let sum: f64 = x.iter().map(|v| f64::from(*v).abs() * scale).sum();
                        l1 += sum;
                        l1max = l1max.max(sum);
                        let (mut p, mut q) = (0.0f64, 0.0f64);
                        for v in x {
                            p = p + f64::from(*v) * scale;
                            q = f64::from(*v) * scale - q;
                            end = end.max(p.abs()).max(q.abs());
                        }
                    }
                }
                let l1d: f64 = (0..k).map(|i| exact[i].abs() * sup[i]).sum();
                let l2d: f64 = (0..k).map(|i| exact[i] * exact[i]).sum::<f64>().sqrt();
                let l1h: f64 = {
                    let mut by = vec![0.0f64; 20];
                    for i in 0..k {
                        by[(table.components[i].order + 10) as usize] +=
                            exact[i].abs() * steps[table.components[i].profile];
                    }
                    by.into_iter().fold(0.0, f64::max)
                };
                for (v, b) in result.bounds.iter_mut().zip([
                    l1,
                    l1max / 2.0,
                    l1d,
                    l1h / 2.0,
                    end / 2.0,
                    l2d * 29.0,
                ]) {
                    v.push((b / pk).log2());
                }
            }
            let unit = normals.len() as f64 * norm * norm;
            result.signal += signal / unit;
            result.noise += noise / unit;
            result.raw_s += signal;
            result.raw_n += noise;
            result.ratio += peak;
            let db = 10.0 * (signal / noise).log10();
            if db < result.worst {
                result.worst = db;
                result.name = format!("{} {}", l.name, m.name);
            }
        }
    }
    result
}

fn show(name: &str, s: &Score) {
    let comps: Vec<f64> =
        s.d_signal.iter().zip(&s.d_noise).map(|(a, b)| 10.0 * (a / b).log10()).collect();
    let least = comps.iter().copied().fold(f64::INFINITY, f64::min);
    let raw: Vec<f64> =
        s.raw_ds.iter().zip(&s.raw_dn).map(|(a, b)| 10.0 * (a / b).log10()).collect();
    println!(
        "raw overall {:.1} least comp {:.1}",
        10.0 * (s.raw_s / s.raw_n).log10(),
        raw.iter().copied().fold(f64::INFINITY, f64::min)
    );
    for (n, b) in ["L1 terms", "L1 max poly/2", "L1 d", "L1 d steps/2", "ends/2", "cauchy"]
        .iter()
        .zip(&s.bounds)
    {
        let mut b = b.clone();
        b.sort_by(f64::total_cmp);
        if !b.is_empty() {
            println!(
                "{n}: mean {:.2} med {:.2} max {:.2}",
                b.iter().sum::<f64>() / b.len() as f64,
                b[b.len() / 2],
                b[b.len() - 1]
            );
        }
    }
    println!(
        "{name}: overall {:.1} dB, worst {:.1} {} weakest comp {:.1} mean peak {:.0}",
        10.0 * (s.signal / s.noise).log10(),
        s.worst,
        s.name,
        least,
        s.ratio / (26.0 * 62.0)
    );
    println!("{:?}", comps.iter().map(|c| c.round()).collect::<Vec<_>>());
}

#[test]
fn formats() {
    for t in [1e-5] {
        show(&format!("q15 {t}"), &score::<eigenshade::Q15>(t));
    }
    for t in [1e-8] {
        show(&format!("q31 {t}"), &score::<eigenshade::Q31>(t));
    }
    let _ = Format::Q15;
}
