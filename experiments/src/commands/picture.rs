//! `experiments picture`: the picture at the top of the README.

use clap::Args;
use eigenshade_cli::picture::sphere_view::SphereView;
use eigenshade_cli::picture::{png_file, tone};
use eigenshade_cli::table::table_file;
use eigenshade_generator::material::brdf::projection::project;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_shading::shipped;
use std::path::PathBuf;

/// Width of a sphere and of the gap beside it, in pixels.
const SIZE: usize = 168;
const GAP: usize = 12;

/// The share of a row's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.985;

/// The light of each row.
const LIGHTS: [&str; 2] = ["esplanade", "workshop"];

/// The roughness, and for each channel the reflectance at normal incidence and the diffuse albedo.
const MATERIALS: [(f64, [f64; 3], [f64; 3]); 5] = [
    (0.5, [1.0, 0.77, 0.34], [0.0; 3]),
    (0.45, [0.04; 3], [0.55, 0.04, 0.03]),
    (0.6, [0.95, 0.64, 0.54], [0.0; 3]),
    (0.8, [0.04; 3], [0.08, 0.22, 0.45]),
    (1.0, [0.04; 3], [0.75, 0.72, 0.66]),
];

/// Spheres of GGX materials under captured lights by the runtime in f32, docs/spheres.png
#[derive(Args, Debug)]
pub struct Picture {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// The table of formulas
    #[arg(long, value_name = "B.bin", default_value = "tables/pbr.bin")]
    table: PathBuf,
}

impl Picture {
    pub fn run(self) -> Result<()> {
        let table = table_file::read(&self.table)?;
        let (degree, order) = (table.gram.degree, table.gram.order);
        let lights = shipped::lights()?.truncated(degree);
        let mut materials = Vec::new();
        for (roughness, reflectance, albedo) in MATERIALS {
            let mut rgb = [const { Vec::new() }; 3];
            for ((f0, albedo), channel) in reflectance.into_iter().zip(albedo).zip(&mut rgb) {
                let brdf = Ggx::new(roughness, f0, albedo)?;
                *channel = project(&brdf, order, Measure::Projected).coefficients;
            }
            materials.push(Named { name: format!("{roughness}"), rgb });
        }
        let basis = OwnedBasis::<f32>::new(&table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, table.count());
        let view = SphereView::new(SIZE);
        let normals = OwnedNormals::new(&view.normals);
        let (width, height) = (across(MATERIALS.len()), across(LIGHTS.len()));
        let mut bytes = vec![0; 4 * width * height];
        for (row, name) in LIGHTS.into_iter().enumerate() {
            let light = lights.entries.iter().find(|light| light.name == name);
            let light = light.ok_or_else(|| Error::new("no such light", "take a shipped one"))?;
            let mut images = Vec::new();
            for material in &materials {
                images.push(shader.colour((degree, light), (order, material), &normals)?);
            }
            let all = images.iter().flatten().flatten().map(|&value| f64::from(value)).collect();
            let exposure = tone::exposure(all, UNCLIPPED);
            for (column, image) in images.iter().enumerate() {
                for (k, pixel) in view.pixels.iter().enumerate() {
                    let (x, y) = (across(column) + pixel.column, across(row) + pixel.row);
                    let start = 4 * (y * width + x);
                    for (channel, byte) in image.iter().zip(&mut bytes[start..]) {
                        *byte = tone::srgb(exposure * f64::from(channel[k]));
                    }
                    bytes[start + 3] = (255.0 * pixel.coverage).round() as u8;
                }
            }
        }
        png_file::write(&self.out, width, height, &bytes)
    }
}

/// The width in pixels of this many spheres side by side, with gaps on all sides.
const fn across(count: usize) -> usize {
    GAP + count * (SIZE + GAP)
}
