//! The recorded errors of the table of formulas: against a quadrature that shares no code with the
//! one that found them, in the manifest, in tables/README.md, and refused beside another table.

use crate::support::{Folder, assert_fails, repository, rows};
use crate::tolerances;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::reference::DirectSum;
use eigenshade_testing::largest;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fs;
use std::path::PathBuf;

/// The error of the shipped components against that of all, relative: what 250 components leave out
/// is small beside what the degree leaves out.
const ERROR_OF_COMPONENTS: f64 = 0.01;

/// The median error over the maps at degree 12 for rough materials, relative to the peak, as
/// documented.
const ERROR_WHERE_ROUGH: f64 = 0.01;

const HEADER: &str = "material,degree,order,components,median,worst,map,normals,scene,energy";

fn tables(name: &str) -> PathBuf {
    repository().join("tables").join(name)
}

fn shipped() -> Vec<Vec<String>> {
    rows(&fs::read_to_string(tables("pbr.errors.csv")).unwrap(), HEADER)
}

/// The formulas of the literature, in the cosines n • i, n • r and i • r.
enum Formula {
    /// Oren and Nayar's qualitative model of 1994; Lambert's law at σ = 0.
    Rough { sigma: f64, albedo: f64 },
    /// Trowbridge and Reitz's facets with Smith's height-correlated shadowing and
    /// Schlick's reflectance, over a matte base, as glTF has it.
    Facets { roughness: f64, f0: f64, albedo: f64 },
}

impl Formula {
    fn value(&self, incident: f64, reflected: f64, between: f64) -> f64 {
        match *self {
            Self::Rough { sigma, albedo } => {
                let square = sigma * sigma;
                let a = 1.0 - 0.5 * square / (square + 0.33);
                let b = 0.45 * square / (square + 0.09);
                // cos Δφ sin θ_i sin θ_r.
                let azimuthal = (between - incident * reflected).max(0.0);
                albedo / PI * (a + b * azimuthal / incident.max(reflected))
            }
            Self::Facets { roughness, f0, albedo } => {
                let length = (2.0 + 2.0 * between).sqrt();
                let (h, d) = ((incident + reflected) / length, 0.5 * length);
                let alpha2 = roughness.powi(4);
                let facets = alpha2 / (PI * (h * h * (alpha2 - 1.0) + 1.0).powi(2));
                let smith = |a: f64, b: f64| a * (alpha2 + (1.0 - alpha2) * b * b).sqrt();
                let visible = 0.5 / (smith(incident, reflected) + smith(reflected, incident));
                let fresnel = f0 + (1.0 - f0) * (1.0 - d).powi(5);
                (1.0 - fresnel) * albedo / PI + fresnel * facets * visible
            }
        }
    }
}

/// Materials whose errors are found together.
struct Group {
    /// The number of normals over which errors are averaged: a few in each lobe.
    averaged: usize,
    /// The nodes in each texel along either axis: lobes of roughness 0.5 are much wider than a
    /// texel.
    nodes: &'static [f64],
    materials: &'static [(&'static str, Formula)],
}

const GROUPS: [Group; 2] = [
    Group {
        averaged: 320,
        nodes: &[0.5],
        materials: &[
            ("lambertian", Formula::Rough { sigma: 0.0, albedo: 0.8 }),
            ("oren-nayar-0.35", Formula::Rough { sigma: 0.35, albedo: 0.8 }),
            ("dielectric-0.5", Formula::Facets { roughness: 0.5, f0: 0.04, albedo: 0.5 }),
            ("metal-0.5", Formula::Facets { roughness: 0.5, f0: 0.9, albedo: 0.0 }),
        ],
    },
    Group {
        averaged: 1000,
        nodes: &GAUSS,
        materials: &[("metal-0.2", Formula::Facets { roughness: 0.2, f0: 0.9, albedo: 0.0 })],
    },
];

/// The 18 maps together.
struct Maps {
    width: usize,
    height: usize,
    names: Vec<String>,
    /// By texel: r, g, b of each map.
    radiance: Vec<Vec<f64>>,
}

/// The two nodes of Gauss in [0, 1], (1 -+ 1/sqrt 3) / 2.
const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

impl Maps {
    fn read() -> Self {
        let mut paths: Vec<PathBuf> = fs::read_dir(tables("inputs/maps"))
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "exr"))
            .collect();
        paths.sort();
        let names = paths.iter().map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned());
        let names = names.collect();
        let maps: Vec<_> =
            paths.iter().map(|path| EnvironmentMap::from_path(path).unwrap()).collect();
        let (width, height) = (maps[0].width, maps[0].height);
        let radiance = (0..width * height)
            .map(|k| maps.iter().flat_map(|map| map.texels[k].map(f64::from)).collect())
            .collect();
        Self { width, height, names, radiance }
    }

    /// x right, y up, z toward the camera, of cos θ, sin t and cos t.
    fn direction(cosine: f64, (sine, turn): (f64, f64)) -> [f64; 3] {
        let across = (1.0 - cosine * cosine).sqrt();
        [sine * across, cosine, -turn * across]
    }

    /// The normal that mirrors a map's greenest texel to the camera.
    fn mirror(&self, map: usize) -> [f64; 3] {
        let green = |k: &usize| self.radiance[*k][3 * map + 1];
        let brightest =
            (0..self.radiance.len()).max_by(|a, b| green(a).total_cmp(&green(b))).unwrap();
        let polar = PI * ((brightest / self.width) as f64 + 0.5) / self.height as f64;
        let turn = TAU * (((brightest % self.width) as f64 + 0.5) / self.width as f64 - 0.5);
        let [x, y, z] = Self::direction(polar.cos(), turn.sin_cos());
        let length = (x * x + y * y + (1.0 + z) * (1.0 + z)).sqrt();
        [x / length, y / length, (1.0 + z) / length]
    }

    /// The irradiance of a normal: by material, then r, g, b of each map. These nodes in each
    /// texel, in cos θ and t.
    fn irradiance(
        &self,
        materials: &[(&str, Formula)],
        nodes: &[f64],
        normal: [f64; 3],
    ) -> Vec<Vec<f64>> {
        let mut sums = vec![vec![0.0; 3 * self.names.len()]; materials.len()];
        let mut factors = vec![0.0; materials.len()];
        let height = self.height as f64;
        let turn = |column: f64| (TAU * (column / self.width as f64 - 0.5)).sin_cos();
        let turns: Vec<Vec<(f64, f64)>> = (0..self.width)
            .map(|k| nodes.iter().map(|node| turn(k as f64 + node)).collect())
            .collect();
        for row in 0..self.height {
            let edge = |k: usize| (PI * k as f64 / height).cos();
            let (top, bottom) = (edge(row), edge(row + 1));
            let weight = (top - bottom) * TAU / (self.width * nodes.len().pow(2)) as f64;
            let cosines: Vec<f64> = nodes.iter().map(|node| top + (bottom - top) * node).collect();
            for (column, turns) in turns.iter().enumerate() {
                factors.fill(0.0);
                let mut is_lit = false;
                for (cosine, turn) in cosines.iter().flat_map(|c| turns.iter().map(move |t| (c, t)))
                {
                    let light = Self::direction(*cosine, *turn);
                    let incident: f64 = light.iter().zip(normal).map(|(a, b)| a * b).sum();
                    if incident > 0.0 {
                        is_lit = true;
                        for (factor, (_, formula)) in factors.iter_mut().zip(materials) {
                            let value = formula.value(incident, normal[2], light[2]);
                            *factor += weight * incident * value;
                        }
                    }
                }
                if is_lit {
                    let radiance = &self.radiance[row * self.width + column];
                    for (sums, factor) in sums.iter_mut().zip(&factors) {
                        sums.iter_mut()
                            .zip(radiance)
                            .for_each(|(sum, value)| *sum += factor * value);
                    }
                }
            }
        }
        sums
    }

    /// By normal, then as [`irradiance`](Self::irradiance).
    fn images(
        &self,
        materials: &[(&str, Formula)],
        nodes: &[f64],
        normals: &[[f64; 3]],
    ) -> Vec<Vec<Vec<f64>>> {
        let work = |part: &[[f64; 3]]| -> Vec<_> {
            part.iter().map(|normal| self.irradiance(materials, nodes, *normal)).collect()
        };
        std::thread::scope(|scope| {
            let parts: Vec<_> = normals
                .chunks(normals.len().div_ceil(2))
                .map(|part| scope.spawn(move || work(part)))
                .collect();
            parts.into_iter().flat_map(|part| part.join().unwrap()).collect()
        })
    }
}

/// Slant and number of the normals near the rim, where peaks of metals are: as close to it as the
/// outermost ones of the recorded errors.
const RIM: (f64, usize) = (FRAC_PI_2 - 0.03, 48);

/// First the normals over which errors are averaged, a spiral evenly over the disc; then others,
/// only for the peak.
fn normals(maps: &Maps, averaged: usize) -> Vec<[f64; 3]> {
    let at =
        |sine: f64, tilt: f64| [sine * tilt.cos(), sine * tilt.sin(), (1.0 - sine * sine).sqrt()];
    let radius = |k: usize| ((k as f64 + 0.5) / averaged as f64).sqrt();
    let spiral = (0..averaged).map(|k| at(radius(k), 2.399_963_229_728_653 * k as f64));
    let rim = (0..RIM.1).map(|k| at(RIM.0.sin(), TAU * k as f64 / RIM.1 as f64));
    let mirrors = (0..maps.names.len()).map(|map| maps.mirror(map));
    spiral.chain(rim).chain(mirrors).collect()
}

/// Median and worst of five materials over all maps, with the worst's name: the direct sum
/// of the shipped coefficients against this quadrature.
#[test]
fn recorded_errors_are_those_of_another_quadrature() {
    let maps = Maps::read();
    let lights = read_lights(tables("inputs/lights.csv"), Some(12)).unwrap();
    let materials = read_materials(tables("inputs/pbr-materials.csv"), Some(12)).unwrap();
    let reference = DirectSum::new(12, 12);
    let recorded = shipped();
    for Group { averaged, nodes, materials: group } in GROUPS {
        let normals = normals(&maps, averaged);
        let images = maps.images(group, nodes, &normals);
        for (place, (name, _)) in group.iter().enumerate() {
            let material = materials.entries.iter().find(|entry| entry.name == *name).unwrap();
            let channels = 3 * maps.names.len();
            let light = |channel: usize| {
                let name = &maps.names[channel / 3];
                let light = lights.entries.iter().find(|entry| entry.name == *name).unwrap();
                &light.rgb[channel % 3]
            };
            let lights: Vec<&Vec<f64>> = (0..channels).map(light).collect();
            let mut squares = vec![0.0; maps.names.len()];
            for (normal, image) in normals[..averaged].iter().zip(&images) {
                let modes = reference.at(*normal);
                let scattered = modes.scatter(&material.rgb[0]);
                for (channel, light) in lights.iter().enumerate() {
                    let left = modes.irradiance(light, &scattered) - image[place][channel];
                    squares[channel / 3] += left * left / (3 * averaged) as f64;
                }
            }
            let peak = |map: usize| {
                let values = images.iter().flat_map(|image| &image[place][3 * map..3 * map + 3]);
                values.fold(0.0, |most: f64, value| most.max(value.abs()))
            };
            let error = |map: usize| squares[map].sqrt() / peak(map);
            let mut sorted: Vec<f64> = (0..squares.len()).map(error).collect();
            sorted.sort_by(f64::total_cmp);
            let (median, worst) = (0.5 * (sorted[8] + sorted[9]), sorted[17]);
            for row in recorded.iter().filter(|row| row[0] == *name && row[1] == "12") {
                let map = maps.names.iter().position(|map| *map == row[6]).unwrap();
                let off = |k: usize, found: f64| found / row[k].parse::<f64>().unwrap() - 1.0;
                // The worst map may be another one, by a small margin.
                let all = [off(4, median), off(5, worst), off(5, error(map))];
                println!("{name} {}: {median:.6}, {worst:.6}, differences {all:+.3?}", row[3]);
                let largest = largest(all);
                assert!(largest <= tolerances::ERROR_FIGURE, "{row:?}: {all:?}");
            }
        }
    }
}

/// The manifest repeats the recorded errors.
#[test]
fn the_manifest_holds_the_errors() {
    let manifest = fs::read_to_string(tables("pbr.manifest.csv")).unwrap();
    let mut found = 0;
    for row in shipped() {
        let of = if row[3].is_empty() { "direct sum" } else { "table" };
        let entry = format!("error of {} {}/{} {of}", row[0], row[1], row[2]);
        assert!(manifest.contains(&format!("\n{entry} median,{},,\n", row[4])), "{entry}");
        assert!(
            manifest.contains(&format!("\n{entry} worst,{} {},,\n", row[5], row[6])),
            "{entry}"
        );
        found += 2;
    }
    assert_eq!(manifest.lines().filter(|line| line.starts_with("error of ")).count(), found);
}

/// Figures that the documentation states.
#[test]
fn shipped_errors_are_small_from_roughness_one_half() {
    let rows = shipped();
    assert_eq!(rows.len(), 24 * 4);
    let number = |row: &Vec<String>, k: usize| row[k].parse::<f64>().unwrap();
    for pair in rows.chunks(4) {
        // The table's components are enough: its figures are those of all.
        for k in [4, 5] {
            let (table, all) = (number(&pair[0], k), number(&pair[1], k));
            assert!((table / all - 1.0).abs() < ERROR_OF_COMPONENTS, "{pair:?}");
        }
    }
    for row in rows.iter().filter(|row| row[1] == "12") {
        let roughness: f64 = row[0].rsplit_once('-').map_or(1.0, |(_, r)| r.parse().unwrap());
        let rough = roughness >= 0.5 || row[0].starts_with("oren") || row[0] == "lambertian";
        assert!(!rough || number(row, 4) < ERROR_WHERE_ROUGH, "{row:?}");
        assert!(number(row, 4) <= number(row, 5), "{row:?}");
    }
}

/// The table of tables/README.md has the file's figures in percent.
#[test]
fn the_readme_shows_the_errors() {
    let readme = fs::read_to_string(tables("README.md")).unwrap();
    let (_, shown) = readme.split_once("<!-- errors: ").unwrap();
    let (shown, _) = shown.split_once("<!-- end of errors -->").unwrap();
    let percent = |text: &str| {
        let value = 100.0 * text.parse::<f64>().unwrap();
        if value < 0.1 { "< 0.1".into() } else { format!("{value:.2}") }
    };
    for of_material in shipped().chunks(4) {
        let [table, _, middle, high] = of_material else { panic!() };
        let both = |row: &Vec<String>| format!("{}, {}", percent(&row[4]), percent(&row[5]));
        let (name, map) = (&table[0], &table[6]);
        let line =
            format!("| {name} | {} ({map}) | {} | {} |\n", both(table), both(middle), both(high));
        print!("{line}");
        assert!(shown.contains(&line), "{line}");
    }
}

/// Errors of another table are not repeated in a manifest.
#[test]
fn errors_of_another_table_are_refused() {
    let folder = Folder::new();
    let basis = "basis --scene scene.toml --out b.bin";
    folder.ok(basis);
    let manifest = folder.read("b.manifest.csv");
    let scene = manifest.lines().find(|line| line.starts_with("scene,")).unwrap();
    let stamp = scene.rsplit(',').next().unwrap().to_owned();
    // A section has the same name as the number of components.
    let count = |name: &str| {
        let mut values =
            manifest.lines().filter_map(|line| line.strip_prefix(name)?.split(',').next());
        values.find(|value| !value.is_empty()).unwrap().to_owned()
    };
    let (degree, order, components) = (count("degree,"), count("order,"), count("components,"));
    let row = |material: &str, map: &str, scene: &str, energy: &str| {
        format!(
            "{HEADER}\n{material},{degree},{order},{components},0.1,0.2,{map},9,{scene},{energy}\n"
        )
    };
    let refused = |text: String, fragments: &[&str]| {
        folder.write("b.errors.csv", text);
        let fragments: Vec<&str> = ["b.errors.csv:2", "remove the file"]
            .into_iter()
            .chain(fragments.iter().copied())
            .collect();
        assert_fails(&folder, basis, &fragments);
        assert_eq!(folder.read("b.manifest.csv"), manifest);
    };
    let (material, map) = ("material-0", "light-0");
    refused(row(material, map, "00000000", "1"), &["scene `00000000`", &stamp]);
    refused(row(material, map, &stamp, "1"), &["energy 1,", "lights or materials differ"]);
    // The error message contains the energy.
    let report = folder.run(basis);
    let report = String::from_utf8_lossy(&report.stderr).into_owned();
    let energy =
        report.split("this one has ").nth(1).unwrap().split(':').next().unwrap().to_owned();
    refused(row("other", map, &stamp, &energy), &["no material `other`"]);
    refused(row(material, "other", &stamp, &energy), &["no light `other`"]);
    let other = row(material, map, &stamp, &energy).replace(",0.1,0.2,", "0,0.1,0.2,");
    refused(other, &["0 components"]);
    folder.write("b.errors.csv", "material,degree,order,components,median,worst,map,normals\n");
    assert_fails(&folder, basis, &["b.errors.csv:1", "scene,energy"]);
    folder.write("b.errors.csv", row(material, map, &stamp, &energy));
    folder.ok(basis);
    let line = format!("error of {material} {degree}/{order} table worst,0.2 {map},,");
    assert_eq!(folder.read("b.manifest.csv").lines().next_back(), Some(line.as_str()));
}
