//! Pictures of objects with shadows, against direct sums over whole maps with the same visibility.

use crate::numbers::{digits, median};
use crate::palette_errors::summed;
use crate::shadow_lights::{COUNT, DEGREE, Lit, ROTATIONS, rotations};
use crate::shadow_shapes::SHAPES;
use eigenshade::object::{ObjectCoefficients, ShadowedObject};
use eigenshade::screen::{Display, Exposure, Meter, Target, Tone};
use eigenshade::{Light, Rgb};
use eigenshade_generator::material::brdf::{Brdf, Ggx, Lambertian};
use eigenshade_generator::object::surface::{Surface, View};
use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel;
use eigenshade_shadows::eigenimages::eigenimages;
use eigenshade_shadows::light_root::{LightRoot, Turns};
use eigenshade_shadows::material::Material;
use eigenshade_shadows::object::{Object, RANK};
use eigenshade_shadows::packed::{Compression, packed};
use eigenshade_shadows::pixels::Pixels;
use eigenshade_shadows::transport::{Surroundings, transports};
use eigenshade_shadows::visibility::Occluders;
use eigenshade_shadows::weights::Columns;
use faer::Mat;
use indicatif::ProgressBar;
use palette::{LinSrgb, Srgb};
use std::f64::consts::FRAC_PI_4;
use std::path::Path;

/// Pixels across.
pub const SIZE: usize = 96;

/// The materials.
pub const MATERIALS: [&str; 4] = ["matte", "plastic 0.3", "metal 0.5", "metal 0.3"];

/// The ways to draw: the convex model, transports of all pixels, and the runtime's object with at most
/// this many codes.
pub const WAYS: [(&str, Option<usize>); 5] = [
    ("convex", None),
    ("transports", None),
    ("codes: all", Some(65_535)),
    ("codes: 4096", Some(4096)),
    ("codes: 1024", Some(1024)),
];

/// The bytes of the file. Then, of pictures under tilted lights: the rms in percent of white of channels
/// clipped at white, of the median picture and of that which 95 of 100 do not exceed; CIEDE2000, the
/// mean and the 95th percentile of pixels, of the median picture. Then the same of lights turned by
/// any angles. Last, the largest rms of the eight pictures of each light. White is that of a `Meter`
/// on the reference.
pub const COLUMNS: &str = "shape,material,way,bytes,tilted_rms,tilted_rms_p95,tilted_mean,tilted_p95,\
    turned_rms,turned_rms_p95,turned_mean,turned_p95,apartment,dawn,hall,night,studio,venice";

/// The errors of one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub shape: &'static str,
    pub material: &'static str,
    pub way: &'static str,
    pub bytes: Option<usize>,
    /// The last of [`COLUMNS`].
    pub errors: Vec<f64>,
}

impl Row {
    #[must_use]
    pub fn fields(&self) -> Vec<String> {
        let bytes = self.bytes.map_or_else(String::new, |bytes| bytes.to_string());
        let texts = [self.shape.into(), self.material.into(), self.way.into(), bytes];
        texts.into_iter().chain(self.errors.iter().map(|&one| digits(one, 3))).collect()
    }
}

/// One channel of a material of [`MATERIALS`].
fn brdf(name: &str) -> Result<Box<dyn Brdf>> {
    Ok(match name {
        "plastic 0.3" => Box::new(Ggx::new(0.3, 0.04, 0.5)?),
        "metal 0.5" => Box::new(Ggx::new(0.5, 0.9, 0.0)?),
        "metal 0.3" => Box::new(Ggx::new(0.3, 0.9, 0.0)?),
        _ => Box::new(Lambertian::new(0.8)?),
    })
}

/// The irradiances of pixels.
type Picture = Vec<Rgb<f32>>;

/// A shape and the irradiances of its pixels.
pub struct Drawn {
    /// With shadows, one part for each material.
    objects: Vec<Object>,
    /// The same without.
    convex: Vec<Object>,
    /// For each material, the direct sums.
    direct: Vec<Vec<Picture>>,
}

impl Drawn {
    /// # Errors
    ///
    /// If a shape or a material does not exist.
    pub fn new(shape: &'static str, materials: &[&str], size: usize, lit: &Lit) -> Result<Self> {
        let found = SHAPES.iter().find(|(name, _)| *name == shape);
        let (_, mesh) = found.ok_or_else(|| Error::new("no such shape", "take one of SHAPES"))?;
        let surface = Surface::new(&shape.into(), &mesh(), &View::default())?;
        let pixels = Pixels::new(&surface, size)?;
        let (seen, pixels) = (pixels.points(), &pixels.covered);
        let brdfs = materials.iter().map(|name| brdf(name)).collect::<Result<Vec<_>>>()?;
        let brdfs: Vec<Material<'_>> = brdfs.iter().map(|one| Material::Formula(&**one)).collect();
        let columns = lit.columns();
        let occluders = Occluders::new(&surface.facets);
        // Light between walls is left out of both.
        let around = Surroundings { occluders: &occluders, bounces: 0 };
        let light = |all| Columns { degree: Some(DEGREE), all };
        let all = transports(&seen, Some(around), &brdfs, light(columns.as_ref()), &());
        let harmonics = columns.as_ref().subcols(0, COUNT);
        let convex = transports(&seen, None, &brdfs, light(harmonics), &());
        let object = |transports: Vec<Mat<f32>>| Object {
            size,
            degree: DEGREE,
            pixels: pixels.clone(),
            transports,
        };
        let direct = |of_material: &Mat<f32>, k: usize| -> Picture {
            let pixel = |row| Rgb::from([0, 1, 2].map(|c| of_material[(row, COUNT + 3 * k + c)]));
            (0..pixels.len()).map(pixel).collect()
        };
        Ok(Self {
            direct: all
                .iter()
                .map(|one| (0..lit.drawn.len()).map(|k| direct(one, k)).collect())
                .collect(),
            objects: all
                .iter()
                .map(|one| object(vec![one.as_ref().subcols(0, COUNT).to_owned()]).smoothed())
                .collect(),
            convex: convex.into_iter().map(|one| object(vec![one])).collect(),
        })
    }
}

/// An object of one part as the runtime draws it.
pub struct Packed {
    pub bytes: Vec<u8>,
    /// The code of each pixel.
    codes: Vec<u16>,
}

impl Packed {
    /// As [`Object::packed`], which does not give the codes.
    fn new(object: &Object, lights: &Lights, turns: Turns, codes: usize) -> Result<Self> {
        let root = LightRoot::new(lights, turns)?;
        let transports: Vec<_> = object.transports.iter().map(Mat::as_ref).collect();
        let images = eigenimages(&transports, &[1.0], &root, RANK)?;
        let compression = Compression { codes, ..Compression::default() };
        let Object { size, degree, pixels, .. } = object;
        let (file, _) = packed(&images, *degree, *size, pixels, &[[1.0; 3]], compression);
        let codes = file.pixels.iter().map(|pixel| pixel.code).collect();
        Ok(Self { bytes: file.encode(), codes })
    }

    /// The exposed picture under a light.
    fn picture(
        &self,
        light: &[Vec<f64>; 3],
        exposure: Exposure,
    ) -> std::result::Result<Picture, eigenshade::Error> {
        let object = ShadowedObject::new(&self.bytes)?;
        let mut of_codes = Vec::with_capacity(object.codes());
        object.shade(&coefficients(&object, light)?, exposure, |color| {
            of_codes.push(color.map(|linear| linear.0 as f32 / 65_536.0));
        });
        Ok(self.codes.iter().map(|&code| of_codes[usize::from(code)]).collect())
    }
}

fn coefficients(
    object: &ShadowedObject<'_>,
    light: &[Vec<f64>; 3],
) -> std::result::Result<Rgb<ObjectCoefficients>, eigenshade::Error> {
    let light = light.each_ref().map(|all| all.iter().map(|&one| one as f32).collect());
    let light: Rgb<Vec<f32>> = light.into();
    object.coefficients(light.each_ref().try_map(|channel| Light::new(channel))?)
}

/// The exposed picture of an object of one part from its transports.
fn picture(object: &Object, light: &[Vec<f64>; 3], exposure: Exposure) -> Picture {
    let channels = light.each_ref().map(|channel| object.irradiance(channel, &[1.0]));
    let pixel = |k| exposure.of(Rgb::from([0, 1, 2].map(|c: usize| channels[c][k])));
    (0..object.pixels.len()).map(pixel).collect()
}

/// The exposure of a picture: white is its unit.
fn metered(picture: &Picture) -> Exposure {
    let mut meter = Meter::default();
    picture.iter().for_each(|&color| meter.add(color));
    meter.exposure().unwrap_or_default()
}

/// The rms of clipped channels in percent, and CIEDE2000, the mean and the 95th percentile.
fn compared(expected: &Picture, found: &Picture) -> [f64; 3] {
    let shown = |picture: &Picture| -> Vec<[f32; 3]> {
        let clipped = |color: &Rgb<f32>| <[f32; 3]>::from(color.map(|one| one.clamp(0.0, 1.0)));
        picture.iter().map(clipped).collect()
    };
    let [expected, found] = [expected, found].map(shown);
    let apart = expected.as_flattened().iter().zip(found.as_flattened()).map(|(a, b)| a - b);
    let square: f64 = apart.map(|one| f64::from(one * one)).sum();
    let rms = 100.0 * (square / (3 * expected.len()) as f64).sqrt();
    let encoded = |picture: &[[f32; 3]]| -> Vec<Srgb> {
        picture.iter().map(|&[r, g, b]| Srgb::from_linear(LinSrgb::new(r, g, b))).collect()
    };
    let errors = summed(&encoded(&expected), &encoded(&found));
    [rms, errors.mean, errors.p95]
}

/// The errors of these shapes in these materials.
///
/// # Errors
///
/// If a shape or a material does not exist.
pub fn errors(
    shapes: &[&'static str],
    materials: &[&'static str],
    lit: &Lit,
    bar: &ProgressBar,
) -> Result<Vec<Row>> {
    bar.set_length((shapes.len() * materials.len()) as u64);
    let mut rows = Vec::new();
    for &shape in shapes {
        let drawn = Drawn::new(shape, materials, SIZE, lit)?;
        for (number, &material) in materials.iter().enumerate() {
            for (way, codes) in WAYS {
                rows.push(drawn.row((shape, material, way), number, codes, Turns::All, lit)?);
            }
            bar.inc(1);
        }
    }
    Ok(rows)
}

/// The errors of a shape with a code for each pixel, made for lights that turn freely and for lights that
/// are tilted by up to 45 degrees.
///
/// # Errors
///
/// If the shape or the material does not exist.
pub fn of_turns(shape: &'static str, material: &'static str, lit: &Lit) -> Result<[Row; 2]> {
    let drawn = Drawn::new(shape, &[material], SIZE, lit)?;
    let row = |turns| drawn.row((shape, material, "codes: all"), 0, Some(65_535), turns, lit);
    Ok([row(Turns::All)?, row(Turns::Tilts(FRAC_PI_4))?])
}

impl Drawn {
    fn row(
        &self,
        (shape, material, way): (&'static str, &'static str, &'static str),
        number: usize,
        codes: Option<usize>,
        turns: Turns,
        lit: &Lit,
    ) -> Result<Row> {
        let object = if way == "convex" { &self.convex[number] } else { &self.objects[number] };
        let packed =
            codes.map(|codes| Packed::new(object, &lit.known, turns, codes)).transpose()?;
        let found = parallel::map(lit.drawn.len(), &(), |k| {
            let (direct, light) = (&self.direct[number][k], &lit.drawn[k].light);
            let exposure = metered(direct);
            let found = match &packed {
                Some(packed) => packed.picture(light, exposure).map_err(fault)?,
                None => picture(object, light, exposure),
            };
            Ok(compared(&direct.iter().map(|&color| exposure.of(color)).collect(), &found))
        });
        let found = found.into_iter().collect::<Result<Vec<_>>>()?;
        let summary = |is_tilted: bool| {
            let sorted = |k: usize| {
                let chosen = found.iter().zip(&lit.drawn);
                let chosen = chosen.filter(|(_, light)| light.is_tilted == is_tilted);
                let mut numbers: Vec<f64> = chosen.map(|(errors, _)| errors[k]).collect();
                numbers.sort_by(f64::total_cmp);
                numbers
            };
            let [rms, mean, p95] = [0, 1, 2].map(sorted);
            let most = rms.get(rms.len() * 95 / 100).copied().unwrap_or(f64::NAN);
            [median(&rms), most, median(&mean), median(&p95)]
        };
        let [tilted, turned] = [true, false].map(summary);
        let each = found.chunks_exact(ROTATIONS);
        let worst =
            each.map(|of_light| of_light.iter().fold(0.0, |most: f64, one| most.max(one[0])));
        let errors = tilted.into_iter().chain(turned).chain(worst).collect();
        Ok(Row { shape, material, way, bytes: packed.map(|one| one.bytes.len()), errors })
    }
}

fn fault(error: eigenshade::Error) -> Error {
    Error::new(error.to_string(), "a defect: please report it")
}

/// A shape under one light, exposed.
pub struct Shown {
    /// The column and row of each pixel, and its coverage of 255.
    pub pixels: Vec<([usize; 2], u8)>,
    pub convex: Picture,
    pub direct: Picture,
    /// The runtime's picture in RGB565 on black.
    pub of_runtime: Vec<u16>,
}

/// A shape in a colored material under a tilted map.
///
/// # Errors
///
/// If the shape or the map does not exist.
pub fn shown(
    (shape, material, map): (&'static str, &'static str, &str),
    color: [f64; 3],
    size: usize,
    maps: &Path,
) -> Result<Shown> {
    static DISPLAY: Display = Display::new(Tone::Linear);
    let rotations = rotations();
    let chosen = |_, name: &str| if name == map { rotations[5..6].to_vec() } else { Vec::new() };
    let mut lit = Lit::of(maps, chosen)?;
    let light = &mut lit.drawn[0];
    for (channel, factor) in color.into_iter().enumerate() {
        light.radiance[channel].iter_mut().for_each(|one| *one *= factor as f32);
        light.light[channel].iter_mut().for_each(|one| *one *= factor);
    }
    let drawn = Drawn::new(shape, &[material], size, &lit)?;
    let light = &lit.drawn[0].light;
    let exposure = metered(&drawn.direct[0][0]);
    let packed = Packed::new(&drawn.objects[0], &lit.known, Turns::All, 4096)?;
    let draw = || {
        let object = ShadowedObject::new(&packed.bytes)?;
        let mut colors = vec![0_u16; object.codes()];
        object.colors(&coefficients(&object, light)?, exposure, &DISPLAY, &mut colors)?;
        let mut pixels = vec![0_u16; size * size];
        object.draw(&colors, &mut Target::new(&mut pixels, size)?);
        Ok(pixels)
    };
    Ok(Shown {
        convex: picture(&drawn.convex[0], light, exposure),
        direct: drawn.direct[0][0].iter().map(|&color| exposure.of(color)).collect(),
        of_runtime: draw().map_err(fault)?,
        pixels: drawn.objects[0].pixels.clone(),
    })
}
