//! The picture of a sphere.

use crate::light::Light;
use crate::material::Material;
use eigenshade::{Highlights, Rgb};
use eigenshade_cli::picture::SphereView;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::highlights::take_out;
use eigenshade_model::parallel;
use eigenshade_model::source::{Gloss, Source};
use eigenshade_shading::highlights;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{self, OwnedNormals, Shader, fault};
use eigenshade_table::Table;
use eigenshade_table::highlights::MAX_SOURCES;
use numpy::ndarray::Array3;

/// The number of pixels that one step draws.
const BATCH: usize = 1 << 14;

/// Linear red, green, blue and the covered share of each pixel of a sphere, with at most this many
/// sources as highlights.
pub fn of_sphere(
    table: &Table,
    light: &Light,
    material: &Material,
    size: usize,
    most: usize,
) -> Result<Array3<f32>> {
    let sources = sources(light, material, most)?;
    let mut rest = light.clone();
    if let Some((_, sources)) = &sources {
        take_out(&mut rest.entry.rgb, rest.degree, sources);
    }
    let (rest, material) = fitted(table, &rest, material);
    let basis = OwnedBasis::new(table)?;
    let basis_view = basis.basis().map_err(fault)?;
    let shader = Shader::new(basis_view, table.count()).with_transfers(basis.transfers());
    let highlights = match &sources {
        Some((gloss, sources)) => {
            let sources = sources.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
            let gloss = highlights::gloss(gloss)?;
            Some(Highlights::<MAX_SOURCES>::new(&gloss, &sources).map_err(fault)?)
        }
        None => None,
    };
    let rows = (BATCH / size).max(1);
    let parts = parallel::map(size.div_ceil(rows), &(), |k| {
        let (first, next) = (k * rows, size.min((k + 1) * rows));
        let (pixels, normals): (Vec<_>, Vec<_>) = SphereView::rows(size, first..next).unzip();
        let normals = OwnedNormals::new(&normals);
        let [r, g, b] = shader.clone().color(&rest, &material, &normals)?;
        let mut colors: Vec<Rgb<f32>> =
            r.into_iter().zip(g).zip(b).map(|((r, g), b)| Rgb::new(r, g, b)).collect();
        if let Some(highlights) = &highlights {
            highlights.add_slice(normals.view()?, &mut colors).map_err(fault)?;
        }
        let mut part = vec![[0.0; 4]; (next - first) * size];
        for (pixel, Rgb { r, g, b }) in pixels.into_iter().zip(colors) {
            let place = (pixel.row - first) * size + pixel.column;
            part[place] = [r, g, b, pixel.coverage as f32];
        }
        Ok(part)
    });
    let mut numbers = Vec::with_capacity(4 * size * size);
    // Each part is freed before the next is copied.
    for part in parts {
        numbers.extend_from_slice(part?.as_flattened());
    }
    Ok(Array3::from_shape_vec((size, size, 4), numbers).expect("the numbers of all rows"))
}

/// A light and a material in the degree, the order and the colors of a table.
pub fn fitted(table: &Table, light: &Light, material: &Material) -> (Named, Named) {
    let lights = Lights { degree: light.degree, entries: vec![light.entry.clone()] };
    let materials = Materials { order: material.order, entries: vec![material.entry.clone()] };
    let (mut lights, mut materials) = shader::fitted(table, &lights, &materials);
    (lights.entries.remove(0), materials.entries.remove(0))
}

/// The sources of a picture and the gloss that reflects them, if the material shines.
fn sources(
    light: &Light,
    material: &Material,
    most: usize,
) -> Result<Option<(Gloss, Vec<Source>)>> {
    if most == 0 {
        return Ok(None);
    }
    let gloss = material.gloss.ok_or_else(|| {
        let what = format!("the gloss of `{}` is not known", material.entry.name);
        Error::new(what, "use `Material.gltf`, a shipped material, or sources=0")
    })?;
    if light.sources.is_empty() {
        let what = format!("`{}` has no sources", light.entry.name);
        return Err(Error::new(what, "load the map with `sources=8`, or ask for sources=0"));
    }
    let sources = light.sources.iter().take(most).copied().collect();
    Ok(gloss.needs_sources().then_some((gloss, sources)))
}
