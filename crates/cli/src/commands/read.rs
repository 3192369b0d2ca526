//! `eigenshade read`: estimates components, light and material from an image.

use super::options::{Destination, Green, Pose, TableChoice, count, input_file, number};
use super::read_answer::{self, Answer};
use clap::Args;
use eigenshade_asset::asset::Asset;
use eigenshade_cli::messages::print_message;
use eigenshade_cli::object::is_mesh;
use eigenshade_cli::output;
use eigenshade_cli::pixels::{self, LinearImage, Transfer};
use eigenshade_cli::table::{self, rounding};
use eigenshade_generator::reading::observation::{
    EigenimageValues, LARGEST, Observation, Observer,
};
use eigenshade_generator::reading::reader::Reader;
use eigenshade_generator::scene_file;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials_and_order};
use eigenshade_model::inputs::input_file::{InputFile, is_file};
use eigenshade_model::shipped;
use eigenshade_shading::presets::{Source, refuse_stale_sources};
use eigenshade_shading::shader::{fitted, of_higher_order};
use eigenshade_table::Table;
use eigenshade_table::wire::NumberFormat;
use std::path::{Path, PathBuf};

/// Estimate components, light and material from an image and its normals
///
/// Writes the CSV `quantity,name,index,r,g,b`: the fit, the components d by scalar product, by
/// weighted least squares, and as the posterior mean under the statistics of the database, the best
/// light, and the materials of the database, most likely first. A summary goes to standard error.
/// Units are those of the linear image; the full scale of a PNG is 1.
#[derive(Args, Debug)]
pub struct Read {
    /// Image: .png, .exr, .hdr, .pfm, or a CSV `r,g,b` or `value` with a row for each pixel
    #[arg(value_name = "IMAGE")]
    image: PathBuf,
    /// Normals: `sphere`, a mesh (.obj, .stl, .ply, .glb, .gltf), a normal map (.png), or a CSV
    /// `x,y,z` with a row for each pixel
    #[arg(short, long, visible_alias = "object", value_name = "NORMALS")]
    normals: PathBuf,
    #[command(flatten)]
    green: Green,
    #[command(flatten)]
    pose: Pose,
    /// Weight of each pixel: a gray PNG, or a CSV `weight` with a row for each pixel
    #[arg(long, value_name = "FILE")]
    mask: Option<PathBuf>,
    #[command(flatten)]
    table: TableChoice,
    /// Only the first K components
    #[arg(long, value_name = "K", value_parser = count(1, u64::from(u16::MAX)))]
    components: Option<usize>,
    /// Standard deviation of a pixel's noise, in units of the image [default: that of the
    /// residual]
    #[arg(long, value_name = "S",
        value_parser = number(LARGEST.recip()..=LARGEST, "a number from 1e-100 to 1e100"))]
    noise: Option<f64>,
    /// Leave out pixels with a channel at 0, where the picture may be clipped: `render` draws what
    /// is below zero as black. In a photograph they are dark, and count
    #[arg(long)]
    without_black: bool,
    /// Transfer function of a PNG [default: that of its chunks sRGB, gAMA or cICP, or else sRGB for
    /// 8 bits and linear for 16 bits]. Required for another gamma, or for a color profile without
    /// these chunks
    #[arg(long, value_enum)]
    transfer: Option<Transfer>,
    /// Lights of the statistics [default: the file that the table's scene names, relative to the
    /// table's folder, or else the shipped one, if it has as many lights]
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    light: Option<Source>,
    /// Materials of the statistics [default: as for --light]
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    material: Option<Source>,
    #[command(flatten)]
    out: Destination,
    /// Write the best light to this light CSV
    #[arg(long, value_name = "FILE")]
    light_out: Option<PathBuf>,
    /// Write the modes c to this CSV, `estimate,l,m,o,p,q,r,g,b`
    #[arg(long, value_name = "FILE")]
    modes_out: Option<PathBuf>,
}

impl Read {
    pub fn run(self) -> Result<()> {
        let table = self.table.read()?;
        self.refuse_collisions(&table)?;
        self.refuse_store(&table)?;
        let components = table::components(&table, self.components, self.table.path())?;
        let (lights, lights_are_shipped) = self.lights(&table)?;
        let (materials, materials_are_shipped) = self.materials(&table)?;
        let path = match &self.material {
            Some(source) => Some(source.path().to_owned()),
            None => self.beside_all(&table).ok().and_then(|paths| paths.into_iter().next()),
        };
        let warning = path.and_then(|path| {
            of_higher_order((&path, materials_are_shipped), materials.order, table.gram.order)
        });
        let (lights, materials) = fitted(&table, &lights, &materials);
        let reader = Reader::new(&table, components, &lights, &materials)?;
        // Databases from the options may be others than those of the table.
        let are_of_scene = self.light.is_none() && self.material.is_none();
        let are_shipped = lights_are_shipped || materials_are_shipped;
        if are_of_scene && are_shipped && !reader.is_of_the_database() {
            let what =
                "the databases of its scene are missing, and the shipped ones differ from them";
            let remedy = "give them with --light and --material";
            return Err(Error::new(what, remedy).in_file(self.table.path()));
        }
        if reader.is_black() {
            let what = "with these materials all its images are black";
            let remedy = "use a table and --material of which some reflect light";
            return Err(Error::new(what, remedy).in_file(self.table.path()));
        }

        let image = LinearImage::read(input_file(&self.image), self.transfer)?;
        let (observation, summary) = self.observe(&table, components, &image)?;
        let reading = reader.read(&observation, self.noise)?;

        let answer = Answer {
            reading: &reading,
            observation: &observation,
            materials: &materials,
            all_components: table.count(),
            is_png: input_file(&self.image).extension() == "png",
        };
        self.write(&answer)?;
        warning.iter().chain(&rounding::warning(&table, NumberFormat::F32)).for_each(print_message);
        print_message(summary);
        read_answer::summarize(&answer);
        Ok(())
    }

    /// Writes all outputs, or none if one cannot be written. Standard output comes last: its reader
    /// may stop early, and the files are complete all the same.
    fn write(&self, answer: &Answer<'_>) -> Result<()> {
        // The name of the light is that of the image.
        let name = self.image.file_stem().unwrap_or_default().to_string_lossy();
        let light = || match &self.light_out {
            Some(path) => answer.write_light(path, &name),
            None => Ok(()),
        };
        let modes = || {
            let path = self.modes_out.as_deref();
            output::write_before(path, |out| answer.write_modes(out), light)
        };
        output::write_before(self.out.path.as_deref(), |out| answer.write(out), modes)?;
        match self.out.path {
            Some(_) => Ok(()),
            None => output::write(None, |out| answer.write(out)),
        }
    }

    /// Checks that the outputs are different files and that none is an input.
    fn refuse_collisions(&self, table: &Table) -> Result<()> {
        let is_file = self.normals != Path::new("sphere");
        let mut inputs = vec![self.image.clone(), self.table.path().to_owned()];
        inputs.extend(is_file.then(|| self.normals.clone()));
        inputs.extend(self.mask.clone());
        match &self.light {
            Some(source) => inputs.push(source.path().to_owned()),
            None => inputs.extend(self.beside(&table.scene.light.database)),
        }
        match &self.material {
            Some(source) => inputs.push(source.path().to_owned()),
            None => inputs.extend(self.beside_all(table).into_iter().flatten()),
        }
        let outputs = [&self.out.path, &self.light_out, &self.modes_out];
        output::refuse_collisions(outputs.into_iter().flatten(), inputs)?;
        refuse_stale_sources(self.light_out.as_deref())
    }

    /// Checks that the table stores what reading needs.
    fn refuse_store(&self, table: &Table) -> Result<()> {
        let store = table.scene.basis.store.name();
        let what = if !table.has_projection() {
            "light and material cannot be read"
        } else if self.modes_out.is_some() && !table.has_modes() {
            "the modes of its eigenimages are missing"
        } else {
            return Ok(());
        };
        let what = format!("it was made with store = \"{store}\": {what}");
        let remedy = "make it again with basis.store = \"modes\"";
        Err(Error::new(what, remedy).in_file(self.table.path()))
    }

    /// The lights of the option, or those of the table's scene; and whether the shipped ones
    /// replace the latter.
    fn lights(&self, table: &Table) -> Result<(Lights, bool)> {
        let count = table.summary.lights;
        if let Some(source) = &self.light {
            return Ok((source.lights()?, false));
        }
        match self.beside(&table.scene.light.database) {
            Ok(path) => Ok((read_lights(input_file(path), None)?, false)),
            Err(missing) => shipped::lights()
                .ok()
                .filter(|lights| lights.entries.len() == count)
                .map(|lights| (lights, true))
                .ok_or_else(|| without(missing, "--light")),
        }
    }

    /// The materials of the option, or those of the table's scene; and whether the shipped ones
    /// replace the latter.
    fn materials(&self, table: &Table) -> Result<(Materials, bool)> {
        if let Some(source) = &self.material {
            return Ok((source.materials(table.gram.order)?, false));
        }
        let scene = &table.scene.material;
        let beside = self.beside_all(table);
        let read = |path: &Path| read_materials_and_order(input_file(path), None);
        let Materials { order, mut entries } = match &beside {
            Ok(paths) => scene_file::together(paths.iter().cloned(), read)?.0,
            Err(missing) => {
                let read = |path: &Path| shipped::materials_in(path).map(|all| (all, usize::MAX));
                let all = scene_file::together(scene.database.iter().map(PathBuf::from), read);
                all.map_err(|_| without(missing.clone(), "--material"))?.0
            }
        };
        if !scene.names.is_empty() {
            entries.retain(|entry| scene.names.contains(&entry.name));
        }
        match beside {
            Err(missing) if entries.len() != table.summary.materials => {
                Err(without(missing, "--material"))
            }
            _ => Ok((Materials { order, entries }, beside.is_err())),
        }
    }

    /// The file that the table's scene names, relative to the table's folder. There is none beside
    /// a shipped table. If there is no such file, the error is its path.
    fn beside(&self, of_scene: &str) -> std::result::Result<PathBuf, PathBuf> {
        let table = self.table.path();
        let path = table.parent().unwrap_or(Path::new("")).join(of_scene);
        let is_beside = is_file(&path) && table::shipped(table).is_none();
        if is_beside { Ok(path) } else { Err(path) }
    }

    /// The material files that the table's scene names, relative to the table's folder. If one of
    /// them is missing, the error is its path.
    fn beside_all(&self, table: &Table) -> std::result::Result<Vec<PathBuf>, PathBuf> {
        table.scene.material.database.iter().map(|path| self.beside(path)).collect()
    }

    /// Notes about the place and the materials of the object.
    fn notes(&self, size: Option<[usize; 2]>) -> [Option<String>; 2] {
        let file = InputFile::new(&self.normals);
        let (is_sphere, is_mesh) = (self.normals == Path::new("sphere"), is_mesh(&file));
        let shape = match is_mesh {
            true => "the object fills the largest square",
            false => "`sphere` is the largest circle",
        };
        let oblong = size.filter(|[width, height]| (is_sphere || is_mesh) && width != height);
        let place = oblong.map(|[width, height]| {
            format!("note: the image is {width} x {height}, and {shape} in its middle")
        });
        let has_materials = is_mesh && Asset::read(&file).is_ok_and(|asset| asset.is_some());
        let name = file.path().display();
        let materials = has_materials.then(|| {
            format!("note: {name}: its materials are ignored: one is read for the whole object")
        });
        [place, materials]
    }

    /// The pixels that are used, and a line about those that are not.
    fn observe(
        &self,
        table: &Table,
        components: usize,
        image: &LinearImage,
    ) -> Result<(Observation, String)> {
        let count = image.pixels.len();
        let mask = match &self.mask {
            Some(path) => pixels::weights(&input_file(path), image.size, count)?,
            None => vec![1.0; count],
        };
        let counts: Vec<bool> =
            image.weights.iter().zip(&mask).map(|(weight, mask)| weight * mask > 0.0).collect();
        let file = input_file(&self.normals);
        let options = self.pose.options(None, self.green);
        let normals = pixels::normals(&file, image.size, &counts, options)?;
        self.notes(image.size).into_iter().flatten().for_each(print_message);
        let channels = if image.is_gray() { 1 } else { 3 };
        let values = EigenimageValues::new(table, components);
        let mut observer = Observer::new(values, channels);
        let (mut without_normal, mut masked, mut unusable) = (0, 0, 0);
        let mut largest = 0.0f64;
        // A channel that is 0 wherever the object is has nothing to clip.
        let mut is_lit = [false; 3];
        for ((pixel, counts), normal) in image.pixels.iter().zip(&counts).zip(&normals) {
            if self.without_black && *counts && normal.is_some() {
                is_lit = [0, 1, 2].map(|c| is_lit[c] || pixel[c] != 0.0);
            }
        }
        let is_black = |pixel: &[f64; 3]| (0..3).any(|c| is_lit[c] && pixel[c] == 0.0);
        for (((pixel, weight), normal), mask) in
            image.pixels.iter().zip(&image.weights).zip(&normals).zip(&mask)
        {
            match normal {
                None => without_normal += 1,
                Some(_) if *mask == 0.0 => masked += 1,
                Some(_) if *weight == 0.0 || is_black(pixel) => unusable += 1,
                Some(normal) => {
                    largest = pixel.iter().fold(largest, |most, value| most.max(value.abs()));
                    observer.see(*normal, &pixel[..channels], weight * mask);
                }
            }
        }
        let observation = observer.finish();
        if largest > LARGEST || (largest > 0.0 && largest < LARGEST.recip()) {
            let what = format!("the largest of its values is {largest:e}");
            let remedy = "scale it to between 1e-100 and 1e100, where squares are finite";
            return Err(Error::new(what, remedy).in_file(&self.image));
        }
        if largest == 0.0 && observation.pixels > 0 {
            let what = "every pixel that is used is black";
            let remedy = "use an image that is not black: no light or material can be read from it";
            return Err(Error::new(what, remedy).in_file(&self.image));
        }
        if observation.pixels < components {
            let used = observation.pixels;
            let what = format!("{used} of its pixels are used, for {components} components");
            let first = if self.without_black {
                "leave --without-black out"
            } else {
                "show more of the object"
            };
            let remedy = format!("{first}, or request fewer with --components");
            return Err(Error::new(what, remedy).in_file(&self.image));
        }
        let (clipped, transparent) = (image.clipped, image.transparent);
        let summary = format!(
            "{}: {count} pixels, {} used; left out: {without_normal} without a normal, {masked} \
             masked, {unusable} clipped or transparent (of all: {clipped} clipped, {transparent} \
             transparent)",
            self.image.display(),
            observation.pixels,
        );
        Ok((observation, summary))
    }
}

/// The error of a missing database.
fn without(path: PathBuf, option: &str) -> Error {
    let what = "the database of the table's scene is missing";
    Error::new(what, format!("give it with {option}")).in_file(path)
}
