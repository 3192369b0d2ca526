//! `eigenshade shader`: writes a scene as a function of a shader.

use super::highlights::{HighlightInputs, estimate_note};
use super::options::{Destination, Inputs, Parsed, TableChoice, choice, count, tolerance};
use clap::Args;
use clap::builder::TypedValueParser;
use eigenshade::shader::ShaderLanguage;
use eigenshade::truncation::Tolerance;
use eigenshade::{Highlights, Rgb, Scene};
use eigenshade_cli::messages::print_message;
use eigenshade_cli::output;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::overflow;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::preview::Preview;
use eigenshade_shading::shader::{Lit, Shader as Projector, fault, fitted, of_higher_order};
use eigenshade_table::Table;
use eigenshade_table::highlights::MAX_SOURCES;
use serde::Serialize;

/// Write a light on a material as a function of a shader
///
/// The function is `vec3 irradiance(vec3 normal)`, in WGSL `fn irradiance(normal: vec3f) -> vec3f`:
/// the linear irradiance of a visible unit normal, z toward the camera. It reads an array of
/// vectors, `eigenshade`, which --json writes beside it. Scenes of the same table with the same
/// --sources and without --tolerance have the same text.
#[derive(Args, Debug)]
pub struct Shader {
    /// Language, and where the array is
    #[arg(long, value_parser = languages())]
    lang: (ShaderLanguage, usize),
    #[command(flatten)]
    inputs: Inputs,
    #[command(flatten)]
    table: TableChoice,
    /// Leave out as many terms as this error allows: the rms over a picture of a sphere, as a share
    /// of white under its metered exposure, like 2e-3
    #[arg(long, value_name = "T", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Add a loop over K small bright sources, for sharp highlights. With --json or --tolerance, up
    /// to K sources are taken out of the light, as `render --sources` does; this needs a shipped
    /// material in color, or a CSV with FILE.gloss.csv beside it. Text alone serves any light and
    /// material
    #[arg(long, value_name = "K", value_parser = count(1, MAX_SOURCES as u64))]
    sources: Option<usize>,
    /// Begin the names of the function, the array and the block with P, such as `front_`, beside
    /// other names of a program
    #[arg(long, value_name = "P", value_parser = prefix)]
    prefix: Option<String>,
    /// Group and binding of the buffer in WGSL
    #[arg(long, value_name = "G,B", value_parser = binding)]
    binding: Option<(u16, u16)>,
    /// Write JSON instead of the text: text, number of terms, and vectors
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    out: Destination,
}

/// Languages, with the vectors that WebGL 2 and WebGPU promise.
fn languages() -> impl TypedValueParser<Value = (ShaderLanguage, usize)> {
    use ShaderLanguage::{Glsl, GlslBlock, GlslTexture, Wgsl};
    let block = "GLSL ES 3.00 with a uniform block, for up to 1,024 vectors";
    let texture = "GLSL ES 3.00 with a float texture of one row, for any number of vectors";
    choice([
        ("glsl", "GLSL ES 3.00 with a uniform array; WebGL 2 promises 224 vectors", (Glsl, 224)),
        ("glsl-block", block, (GlslBlock, 1024)),
        ("glsl-texture", texture, (GlslTexture, usize::MAX)),
        ("wgsl", "WGSL with a uniform buffer at group 0, binding 0", (Wgsl, 4096)),
    ])
}

/// Parses what names of GLSL and WGSL may begin with. GLSL reserves `gl_`, and two underscores in a
/// row.
fn prefix(text: &str) -> Parsed<String> {
    let is_word = text.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    let is_prefix = is_word && text.starts_with(|first: char| first.is_ascii_alphabetic());
    if text.starts_with("gl_") || text.contains("__") || !is_prefix {
        return Err("expected a letter, then letters, digits and single underscores".to_owned());
    }
    Ok(text.to_owned())
}

/// Parses a group and a binding.
fn binding(text: &str) -> Parsed<(u16, u16)> {
    let place = text.split_once(',').map(|(group, binding)| (group.parse(), binding.parse()));
    match place {
        Some((Ok(group), Ok(binding))) => Ok((group, binding)),
        _ => Err("expected two whole numbers, as in 1,0".to_owned()),
    }
}

/// The highlights of a scene.
type Lobes = Highlights<MAX_SOURCES>;

/// What --json writes.
#[derive(Serialize)]
struct Written {
    text: String,
    terms: usize,
    vectors: Vec<[f32; 4]>,
}

impl Shader {
    pub fn run(self) -> Result<()> {
        if self.binding.is_some() && self.lang.0 != ShaderLanguage::Wgsl {
            return Err(Error::new("--binding is for --lang wgsl", "leave it out"));
        }
        output::refuse_collisions(&self.out.path, self.inputs.files(&[self.table.path()]))?;
        let table = self.table.read()?;
        let lights = self.inputs.light.lights()?;
        let of_file = self.inputs.material.materials(table.gram.order)?;
        let (lights, materials) = fitted(&table, &lights, &of_file);
        let light = self.inputs.light.only(lights.entries)?;
        let material = self.inputs.material.only(materials.entries)?;
        let mut lights = Lights { degree: lights.degree, entries: vec![light] };
        let materials = Materials { order: materials.order, entries: vec![material] };
        let (highlights, sharp) = self.highlights(&table, &mut lights, &materials)?;
        let (light, material) = (&lights.entries[0], &materials.entries[0]);
        let basis = OwnedBasis::new(&table)?;
        let any = basis.basis().map_err(fault)?;
        let projector = Projector::new(any, table.count()).with_transfers(basis.transfers());
        let channels = [0, 1, 2].map(|c| (&light.rgb[c][..], &material.rgb[c][..]));
        let written = self.written(projector, channels, highlights.as_ref());
        let written = written.map_err(|error| error.of(overflow::pair(light, material)))?;
        let (found, most) = (written.vectors.len(), self.lang.1);
        let many = (found > most).then(|| {
            format!(
                "note: {found} vectors are more than the {most} that a device surely has; allow an \
                 error by --tolerance, or write another --lang"
            )
        });
        let contents = if self.json {
            let text = serde_json::to_string(&written);
            text.map_err(|error| Error::new(error.to_string(), "report it"))? + "\n"
        } else {
            written.text
        };
        output::write_all(self.out.path.as_deref(), contents.into_bytes())?;
        let higher = of_higher_order(self.inputs.material.named(), of_file.order, materials.order);
        higher.iter().chain(&many).chain(&sharp).for_each(print_message);
        Ok(())
    }

    /// The highlights, if the text or the vectors depend on them, with a note if pictures are far
    /// off. Their sources are taken out of the light.
    fn highlights(
        &self,
        table: &Table,
        lights: &mut Lights,
        materials: &Materials,
    ) -> Result<(Option<Lobes>, Option<String>)> {
        let depends = self.json || self.tolerance.is_some();
        let Some(most) = self.sources.filter(|_| depends) else { return Ok((None, None)) };
        let pair = (&mut *lights, materials);
        let highlights = HighlightInputs::taken_out(&self.inputs, table, pair, most)?;
        let Some(highlights) = highlights else { return Ok((None, None)) };
        let pair = (&*lights, materials);
        let note = estimate_note(&self.inputs, table, pair, highlights.count())?;
        Ok((Some(highlights.shaded()?), note))
    }

    /// The shader of three channels.
    fn written(
        &self,
        projector: Projector<'_>,
        channels: [Lit<'_>; 3],
        highlights: Option<&Lobes>,
    ) -> Result<Written> {
        if let Some(share) = self.tolerance {
            let mut projector = projector;
            let exposure = Preview::new(&mut projector, highlights).exposure(&channels)?.factor();
            let tolerance = Tolerance::OfWhite { share: share as f32, exposure };
            return projector.truncated(&channels, tolerance, |scenes, _| match scenes {
                [r, g, b] => self.of_scenes(Rgb::new(r, g, b), highlights),
                _ => unreachable!("three channels have three scenes"),
            });
        }
        let mut projectors = [projector.clone(), projector.clone(), projector];
        for (projector, (light, material)) in projectors.iter_mut().zip(channels) {
            projector.project(light, material)?;
        }
        let [r, g, b] = projectors.each_mut().map(Projector::scene);
        self.of_scenes(Rgb::new(&r?, &g?, &b?), highlights)
    }

    fn of_scenes<B: AsRef<[f32]>>(
        &self,
        scene: Rgb<&Scene<'_, B>>,
        highlights: Option<&Lobes>,
    ) -> Result<Written> {
        let shader = eigenshade::shader::Shader::new(scene.r);
        let shader = shader.with_sources(self.sources.unwrap_or(0)).map_err(fault)?;
        let (mut text, mut vectors) = (String::new(), vec![[0.0; 4]; shader.vectors()]);
        let report = |error: std::fmt::Error| Error::new(error.to_string(), "report it");
        shader.write(self.lang.0, &mut text).map_err(report)?;
        if let Some(prefix) = &self.prefix {
            text = prefixed(&text, prefix);
        }
        if let Some((group, binding)) = self.binding {
            let place = format!("@group({group}) @binding({binding})");
            text = text.replacen("@group(0) @binding(0)", &place, 1);
        }
        shader.uniforms(scene, &mut vectors).map_err(fault)?;
        if let Some(highlights) = highlights {
            shader.highlight_uniforms(highlights, &mut vectors).map_err(fault)?;
        }
        Ok(Written { text, terms: shader.terms(), vectors })
    }
}

/// The text with a prefix before each of its names.
fn prefixed(text: &str, prefix: &str) -> String {
    const NAMES: [&str; 3] = ["irradiance", "eigenshade", "Eigenshade"];
    let (mut found, mut rest) = (String::new(), text);
    loop {
        let next = NAMES.iter().filter_map(|name| Some((rest.find(name)?, name.len()))).min();
        let Some((place, length)) = next else { return found + rest };
        found += &rest[..place];
        found += prefix;
        found += &rest[place..place + length];
        rest = &rest[place + length..];
    }
}
