//! `eigenshade pack-object`: makes an object or its normals for the runtime.

use super::options::{Green, Pose, count, input_file};
use super::shadows::{DEGREE, Packing, SIZE};
use clap::Args;
use eigenshade_asset::asset::Asset;
use eigenshade_asset::packed::{MOST_REGIONS, Packed};
use eigenshade_asset::texels::Texels;
use eigenshade_cli::export::c;
use eigenshade_cli::export::entry::identifier;
use eigenshade_cli::messages::{grouped, printable, spinner};
use eigenshade_cli::object::ObjectView;
use eigenshade_cli::output;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::shipped;
use eigenshade_shading::presets::Source;
use eigenshade_shadows::light_root::Turns;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Bytes in a line of source.
const PER_LINE: usize = 20;

/// Pack an object for the runtime: its normals, and its own materials if it has some
///
/// A file with materials becomes an `Object`: for each pixel a normal within 0.51 degrees, a base
/// color, a coverage, and one of a few regions of the same metallic and roughness. Each region
/// needs a palette of 13 KB when it is drawn. Occlusion darkens the base colors of what is matte.
///
/// Without materials, or with --normals-only, the file becomes a `NormalMap`, two bytes a pixel, to
/// be drawn in any material. A normal map has x in red, y (up) in green and z in blue; its opacity
/// is the object's coverage.
///
/// With --shadows, a mesh becomes a `ShadowedObject` in one --material, or without one a
/// `TexturedObject` in its own, which C does not draw.
///
/// A mesh is seen from +z, with x to the right and y up. The output is the bytes; Rust source with
/// the object as the static `OBJECT`, or the map as `MAP`; or, for F.h, a C header with the
/// constant `object_F`, `shadowed_object_F` or `normal_map_F` for `eigenshade.h`.
#[derive(Args, Debug)]
pub struct PackObject {
    /// A mesh (.glb, .gltf, .obj, .ply, .stl), a normal map (.png), or `sphere`
    #[arg(id = "normals", value_name = "OBJECT")]
    object: PathBuf,
    /// Pixels across the longer side, 2 to 4096, with --shadows to 512; a normal map can only
    /// shrink [default: 240, or all of a normal map]
    #[arg(short, long, value_name = "N", value_parser = count(2, 4096))]
    size: Option<usize>,
    /// The most regions, 1 to 16; fewer if they keep 19 of 20 pixels within 0.1 in metallic and 15
    /// % in roughness
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = count(1, MOST_REGIONS as u64))]
    regions: usize,
    /// Pack the normals alone
    #[arg(long = "normals-only", conflicts_with = "regions")]
    has_normals_only: bool,
    /// Pack a mesh with the shadows that it casts on itself
    #[arg(long = "shadows", conflicts_with_all = ["has_normals_only", "regions"])]
    has_shadows: bool,
    /// The material of an object with shadows: the name of a shipped one, a material CSV, or one
    /// material of a CSV [default: those of the object]
    #[arg(short, long, value_name = "NAME|FILE[:NAME]", requires = "has_shadows")]
    material: Option<Source>,
    /// The most colors of an object with shadows in a frame, 1 to 65535: pixels alike share one
    #[arg(long, value_name = "N", default_value_t = 4096, value_parser = count(1, 65535),
        requires = "has_shadows")]
    codes: usize,
    #[command(flatten)]
    green: Green,
    #[command(flatten)]
    pose: Pose,
    /// Write bytes (.bin), Rust source (.rs) or a C header (.h) to this file
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
}

/// The kinds of output.
#[derive(Clone, Copy)]
enum Kind {
    Bytes,
    Rust,
    C,
}

/// The types of the runtime that a file is packed for.
#[derive(Clone, Copy)]
enum Item {
    NormalMap,
    Object,
    ShadowedObject,
    TexturedObject,
}

impl Item {
    /// Its type, and the name of a static.
    fn names(self) -> [&'static str; 2] {
        match self {
            Self::NormalMap => ["NormalMap", "MAP"],
            Self::Object => ["Object", "OBJECT"],
            Self::ShadowedObject => ["ShadowedObject", "OBJECT"],
            Self::TexturedObject => ["TexturedObject", "OBJECT"],
        }
    }
}

/// The contents of a file.
struct Contents {
    item: Item,
    bytes: Vec<u8>,
    /// Pixels across and down, and those with an object.
    size: [usize; 2],
    covered: usize,
    /// More lines of the report.
    notes: String,
}

impl Contents {
    /// The call that makes it of bytes.
    fn call(&self, bytes: &str) -> String {
        let [kind, _] = self.item.names();
        let [width, height] = self.size;
        let size = match self.item {
            Item::NormalMap => format!("{width}, {height}, "),
            _ => String::new(),
        };
        format!("eigenshade::object::{kind}::new({size}{bytes})")
    }

    /// A C header, and the name of its constant.
    fn header(&self, stem: &str, command: &str) -> Result<(String, String)> {
        let named = |prefix: &str| identifier(&format!("{prefix} {stem}"));
        let of_file = |prefix: &str, kind: &str| {
            let name = named(prefix);
            (c::object(kind, &name, &self.bytes, command), name)
        };
        Ok(match self.item {
            Item::Object => of_file("object", "eigenshade_object_t"),
            Item::ShadowedObject => of_file("shadowed object", "eigenshade_shadowed_object_t"),
            Item::NormalMap => {
                let name = named("normal map");
                (c::normal_map(&name, self.size, &self.bytes, command), name)
            }
            Item::TexturedObject => return Err(not_in_c()),
        })
    }
}

impl PackObject {
    pub fn run(self) -> Result<()> {
        output::refuse_collisions([&self.out], [&self.object])?;
        let extension = self.out.extension().unwrap_or_default().to_ascii_lowercase();
        let kind = match extension.to_str() {
            Some("bin") => Kind::Bytes,
            Some("rs") => Kind::Rust,
            Some("h") => Kind::C,
            _ => {
                let remedy = "name it .bin for bytes, .rs for Rust source, or .h for a C header";
                return Err(Error::new("unknown kind of output", remedy).in_file(&self.out));
            }
        };
        if matches!(kind, Kind::C) && self.has_shadows && self.material.is_none() {
            return Err(not_in_c().in_file(&self.out));
        }
        let contents = self.contents()?;
        let Contents { bytes, size, covered, notes, .. } = &contents;
        let stem = self.out.file_stem().unwrap_or_default().to_string_lossy();
        let (text, (language, line)) = match kind {
            Kind::Bytes => {
                let file = self.out.display().to_string();
                (bytes.clone(), ("in Rust", contents.call(&format!("include_bytes!({file:?})"))))
            }
            Kind::Rust => (
                self.source(&contents),
                ("in Rust", module(&self.out.file_name().unwrap_or_default().to_string_lossy())),
            ),
            Kind::C => {
                let (text, name) = contents.header(&stem, &self.command())?;
                (text.into_bytes(), ("in C", format!("&{name}")))
            }
        };
        output::write_all(Some(&self.out), text)?;
        let [width, height] = size;
        output::report(format!(
            "{:<12} {width} x {height}, {} with an object\n{:<12} {}\n{notes}{language:<12} {line}\n",
            "pixels",
            grouped(*covered),
            "bytes",
            grouped(bytes.len()),
        ))
    }

    fn contents(&self) -> Result<Contents> {
        let file = input_file(&self.object);
        if self.has_shadows {
            return self.shadowed(&file);
        }
        if !self.has_normals_only
            && let Some(asset) = Asset::read(&file)?
        {
            let progress = spinner("packing the object");
            let options = self.pose.options(self.size, self.green);
            options.check(&file)?;
            let texels = Texels::of(&file, &asset, self.size.unwrap_or(SIZE), &options.view())?;
            let packed =
                Packed::of(&texels, self.regions).map_err(|error| error.in_file(file.path()))?;
            progress.finish_and_clear();
            return Ok(of_object(&texels, packed));
        }
        let is_map = self.object.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
        let size = self.size.or((!is_map).then_some(SIZE));
        let view = ObjectView::read(file, self.pose.options(size, self.green))?;
        Ok(Contents {
            item: Item::NormalMap,
            bytes: view.codes()?.concat(),
            size: [view.width, view.height],
            covered: view.pixels.len(),
            notes: String::new(),
        })
    }

    /// An object with its shadows, in one material or in its own.
    fn shadowed(&self, file: &InputFile) -> Result<Contents> {
        let options = self.pose.options(self.size, self.green);
        options.check(file)?;
        let size = self.size.unwrap_or(SIZE);
        let packing = Packing {
            file,
            view: options.view(),
            size,
            degree: DEGREE,
            material: self.material.as_ref(),
            lights: &shipped::lights()?,
            turns: Turns::All,
            codes: self.codes,
        };
        let packed = packing.pack()?;
        Ok(Contents {
            item: match self.material {
                Some(_) => Item::ShadowedObject,
                None => Item::TexturedObject,
            },
            notes: packed.notes(),
            size: [size; 2],
            covered: packed.covered,
            bytes: packed.bytes,
        })
    }

    /// The command, without folders.
    fn command(&self) -> String {
        let name =
            |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let size = self.size.map(|size| format!(" --size {size}")).unwrap_or_default();
        let flip = if self.green.is_flipped { " --flip-green" } else { "" };
        let regions =
            if self.regions == 4 { String::new() } else { format!(" --regions {}", self.regions) };
        let shadows = match &self.material {
            Some(material) => {
                format!(" --shadows --material {} --codes {}", material.short(), self.codes)
            }
            None if self.has_shadows => format!(" --shadows --codes {}", self.codes),
            None => String::new(),
        };
        let only = if self.has_normals_only { " --normals-only" } else { "" };
        let pose = self.pose.written();
        let [object, out] = [&self.object, &self.out].map(|path| name(path));
        let all = format!("{object}{size}{regions}{shadows}{only}{flip}{pose} --out {out}");
        format!("eigenshade pack-object {}", printable(&all))
    }

    /// Source that holds the object or the map, below a comment with the command.
    fn source(&self, contents: &Contents) -> Vec<u8> {
        let ([kind, name], count) = (contents.item.names(), contents.bytes.len());
        let mut text = format!(
            "// {}\n\n/// The {}.\n\
             pub static {name}: eigenshade::object::{kind}<'static> =\n    \
             eigenshade::specialized::checked({});\n\n\
             #[rustfmt::skip]\nstatic BYTES: [u8; {count}] = [\n",
            self.command(),
            name.to_lowercase(),
            contents.call("&BYTES"),
        );
        for line in contents.bytes.chunks(PER_LINE) {
            text.push_str("   ");
            line.iter().for_each(|byte| {
                let _ = write!(text, " {byte},");
            });
            text.push('\n');
        }
        text.push_str("];\n");
        text.into_bytes()
    }
}

fn of_object(texels: &Texels, packed: Packed) -> Contents {
    let covered = texels.pixels.len();
    let mut notes =
        format!("{:<12} {:.1}\n", "a pixel", packed.bytes.len() as f64 / covered as f64);
    for (number, found) in packed.regions.iter().enumerate() {
        let [low, high] = found.roughness;
        let _ = writeln!(
            notes,
            "{:<12} {} pixels, metallic {:.2}, roughness {:.2} for {low:.2} to {high:.2}",
            format!("region {number}"),
            grouped(found.pixels),
            found.region.metallic(),
            found.region.roughness(),
        );
    }
    Contents { item: Item::Object, bytes: packed.bytes, size: [texels.size; 2], covered, notes }
}

/// C has no objects with shadows in their own materials.
fn not_in_c() -> Error {
    let what = "C draws objects with shadows in one material only";
    Error::new(what, "give a --material, or write .rs or .bin for Rust")
}

/// The declaration of a file as a module, which has the name of the file if that is one.
fn module(file: &str) -> String {
    let is_name = |stem: &&str| {
        stem.starts_with(|letter: char| letter.is_ascii_lowercase()) && identifier(stem) == **stem
    };
    match file.strip_suffix(".rs").filter(is_name) {
        Some(stem) => format!("mod {stem};"),
        None => format!("#[path = {file:?}] mod object;"),
    }
}
