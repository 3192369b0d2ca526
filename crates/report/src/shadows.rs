//! Pictures of objects with shadows, against direct sums over whole maps with visibility.

use crate::shadow_shapes::SHAPES;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Brdf, Ggx, Lambertian};
use eigenshade_generator::object::points::{Point, points};
use eigenshade_generator::object::surface::{Surface, View};
use eigenshade_model::error::Result;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::shipped;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_model::vector::dot;
use eigenshade_shadows::codebook::codebook;
use eigenshade_shadows::directions::{FINE, cell_of, cells};
use eigenshade_shadows::eigenimages::{Turning, eigenimages, light_root};
use eigenshade_shadows::material::Material;
use eigenshade_shadows::transport::transports;
use eigenshade_shadows::visibility::Occluders;
use faer::Mat;
use std::time::Instant;

fn rotations() -> Vec<Rotation> {
    let mut all = Vec::new();
    for k in 0..4 {
        let share = |step: f64| (0.37 + step * k as f64).fract();
        all.push(Rotation {
            alpha: (1.0 - 2.0 * share(0.618)).acos(),
            beta: 6.283 * share(0.755),
            gamma: 6.283 * share(0.569),
        });
    }
    for k in 0..4 {
        let axis = 1.3 + 1.7 * k as f64;
        let tilt = std::f64::consts::FRAC_PI_4 * [0.3, 0.6, 0.8, 1.0][k];
        all.push(Rotation { alpha: tilt, beta: axis, gamma: -axis });
    }
    all
}

/// The mean luminance of a turned map in each fine cell.
fn of_cells(map: &EnvironmentMap, rotation: Rotation, angles: &[f64]) -> Vec<f32> {
    let matrix = rotation.matrix();
    let mut sums = vec![0.0; angles.len()];
    for row in 0..map.height {
        let solid = map.solid_angle(row);
        for column in 0..map.width {
            let direction = map.direction(column, row);
            let turned = matrix.map(|axis| dot(axis, direction));
            let [r, g, b] = map.texels[row * map.width + column].map(f64::from);
            sums[cell_of(FINE, turned)] += solid * (0.2126 * r + 0.7152 * g + 0.0722 * b);
        }
    }
    sums.iter().zip(angles).map(|(sum, angle)| (sum / angle) as f32).collect()
}

pub fn experiment(size: usize, names: &[&str], folder: &str) -> Result<()> {
    let degree = 12;
    let count = (degree + 1) * (degree + 1);
    let fine = cells(FINE);
    let angles: Vec<f64> = fine.iter().map(|(_, angle)| *angle).collect();
    let lights = shipped::lights()?.truncated(degree);
    let mut tests = Vec::new();
    for (k, light) in lights.entries.iter().enumerate() {
        let path = format!("{folder}/{}.exr", light.name);
        if k % 3 == 0 && std::path::Path::new(&path).exists() {
            tests.push((light, EnvironmentMap::from_path(&path)?));
        }
    }
    let train: Vec<_> = lights
        .entries
        .iter()
        .enumerate()
        .filter(|(k, _)| k % 3 != 0)
        .map(|(_, one)| one.clone())
        .collect();
    let train = eigenshade_model::database::Lights { degree, entries: train };
    let rotations = rotations();
    // Columns: harmonics, then turned maps.
    let mut columns: Vec<Vec<f32>> = vec![Vec::with_capacity(fine.len()); count];
    for (direction, _) in &fine {
        for (column, value) in columns.iter_mut().zip(spherical_harmonic::all(degree, *direction)) {
            column.push(value as f32);
        }
    }
    let mut turned: Vec<Vec<f64>> = Vec::new();
    for rotation in &rotations {
        for (_, map) in &tests {
            columns.push(of_cells(map, *rotation, &angles));
            // Coefficients from the cells.
            let column = columns.last().unwrap();
            let mut coefficients = vec![0.0; count];
            for ((direction, angle), radiance) in fine.iter().zip(column) {
                for (sum, value) in
                    coefficients.iter_mut().zip(spherical_harmonic::all(degree, *direction))
                {
                    *sum += angle * value * f64::from(*radiance);
                }
            }
            turned.push(coefficients);
        }
    }
    let light = Mat::from_fn(fine.len(), columns.len(), |row, column| columns[column][row]);
    println!("{} test lights, {} columns", tests.len(), columns.len());
    let materials: Vec<(&str, Box<dyn Brdf>)> = vec![
        ("matte", Box::new(Lambertian::new(0.8)?)),
        ("plastic 0.3", Box::new(Ggx::new(0.3, 0.04, 0.5)?)),
        ("metal 0.5", Box::new(Ggx::new(0.5, 0.9, 0.0)?)),
        ("metal 0.3", Box::new(Ggx::new(0.3, 0.9, 0.0)?)),
    ];
    let refs: Vec<Material<'_>> =
        materials.iter().map(|(_, one)| Material::Formula(&**one)).collect();
    for (name, shape) in SHAPES {
        if !names.is_empty() && !names.contains(&name) {
            continue;
        }
        let start = Instant::now();
        let mesh = shape();
        let surface = Surface::new(&name.into(), &mesh, &View::default())?;
        let mut all = points(&surface, size, 2);
        all.sort_by_key(|point| (point.pixel[1], point.pixel[0]));
        let pixels: Vec<&[Point]> = all.chunk_by(|a, b| a.pixel == b.pixel).collect();
        let occluders = Occluders::new(&surface.facets);
        println!(
            "{name}: {} facets, {} pixels, {:?}",
            surface.facets.len(),
            pixels.len(),
            start.elapsed()
        );
        let with = transports(&pixels, Some(&occluders), &refs, light.as_ref(), &());
        println!("  transports {:?}", start.elapsed());
        let without = transports(&pixels, None, &refs, light.as_ref(), &());
        println!("  without {:?}", start.elapsed());
        for (k, (material, _)) in materials.iter().enumerate() {
            let report = |label: &str, picture: &dyn Fn(usize) -> Vec<f32>| {
                let mut errors = [Vec::new(), Vec::new()];
                for column in 0..turned.len() {
                    let truth = with[k].col(count + column);
                    let found = picture(column);
                    // White is the 99th percentile of the irradiance.
                    let mut sorted: Vec<f32> = truth.iter().copied().collect();
                    sorted.sort_by(f32::total_cmp);
                    let white = sorted[sorted.len() * 99 / 100];
                    let sum: f32 = truth
                        .iter()
                        .zip(&found)
                        .map(|(a, b)| {
                            let shown = |x: f32| (x / white).clamp(0.0, 1.0);
                            (shown(*a) - shown(*b)).powi(2)
                        })
                        .sum();
                    errors[usize::from(column >= 4 * tests.len())]
                        .push(100.0 * (sum / truth.nrows() as f32).sqrt());
                }
                let text = errors.map(|mut all| {
                    all.sort_by(f32::total_cmp);
                    format!("{:.2}/{:.2}", all[all.len() / 2], all[all.len() * 95 / 100])
                });
                println!("  {name:6} {material:12} {label:36} any {} tilts {}", text[0], text[1]);
            };
            let lit = |transport: &Mat<f32>, column: usize, degree: usize| -> Vec<f32> {
                let used = (degree + 1) * (degree + 1);
                (0..transport.nrows())
                    .map(|row| {
                        (0..used).map(|c| transport[(row, c)] * turned[column][c] as f32).sum()
                    })
                    .collect()
            };
            report("convex, whole map", &|column| {
                without[k].col(count + column).iter().copied().collect()
            });
            report("convex, degree 9", &|column| lit(&without[k], column, 9));
            report("transports, degree 9", &|column| lit(&with[k], column, 9));
            report("transports, degree 12", &|column| lit(&with[k], column, 12));
            for (degree, turning) in
                [(9, Turning::Freely), (12, Turning::Freely), (9, Turning::Tilts(0.785))]
            {
                let root = light_root(&train.clone().truncated(degree), turning)?;
                let used = (degree + 1) * (degree + 1);
                let images = eigenimages(&[with[k].as_ref().subcols(0, used)], &[1.0], &root, 64)?;
                let d = |column: usize, rank: usize| -> Vec<f32> {
                    (0..rank)
                        .map(|row| {
                            (0..used)
                                .map(|c| images.rows[0][(row, c)] * turned[column][c])
                                .sum::<f64>() as f32
                        })
                        .collect()
                };
                for rank in [16, 40] {
                    report(&format!("{turning:?} {degree}: rank {rank}"), &|column| {
                        let d = d(column, rank);
                        (0..images.pixels.nrows())
                            .map(|row| (0..rank).map(|j| images.pixels[(row, j)] * d[j]).sum())
                            .collect()
                    });
                }
                let rank = 40;
                for (codes, clusters, own) in [
                    (2048, 64, 8),
                    (4096, 64, 8),
                    (4096, 32, 8),
                    (4096, 64, 4),
                    (usize::MAX, 64, 8),
                ] {
                    let book =
                        codebook(images.pixels.as_ref().subcols(0, rank), codes, clusters, own);
                    let rows: Vec<Vec<f32>> = book
                        .clusters
                        .iter()
                        .flat_map(|one| (0..one.weights.len()).map(|code| one.row(code)))
                        .collect();
                    report(
                        &format!(
                            "{turning:?} {degree}: codes {} in {clusters} x {own}",
                            rows.len()
                        ),
                        &|column| {
                            let d = d(column, rank);
                            let of_codes: Vec<f32> = rows
                                .iter()
                                .map(|row| row.iter().zip(&d).map(|(a, b)| a * b).sum())
                                .collect();
                            book.of_pixel.iter().map(|&code| of_codes[code as usize]).collect()
                        },
                    );
                }
            }
        }
        println!("  {:?}", start.elapsed());
    }
    Ok(())
}
