//! The paths whose instructions are counted: pictures of the shipped inputs, and the calls that are
//! made once for a light or a material.

use crate::shipped::{Axes, Pair, Shipped, Shown, full, tables, white_matte, within};
use eigenshade::lights::NineTerms;
use eigenshade::object::NormalMap;
use eigenshade::presets::{light, material};
use eigenshade::screen::{Display, Palette, Target, Tone};
use eigenshade::truncation::Tolerance;
use eigenshade::wire::aligned;
use eigenshade::{Basis, Normals, Rgb, Scene, sphere};
use eigenshade_model::shipped;
use eigenshade_model::source::Source;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_shading::textured::{Blend, Texel, irradiance};
use eigenshade_table::wire::{Endian, NumberFormat, encode};
use std::hint::black_box;

/// Pixels of a picture.
const PIXELS: usize = 16_384;
/// How often a call is made.
const CALLS: usize = 50;

/// A path.
pub struct Path {
    /// Name in counts.csv.
    pub name: String,
    /// Multiply-adds that a pixel or a call cannot do without.
    pub multiply_adds: usize,
    /// Pixels or calls of one run.
    pub count: usize,
    /// Draws a picture, or makes the calls.
    pub run: Box<dyn FnMut()>,
}

/// All paths.
#[must_use]
pub fn all() -> Vec<Path> {
    let mut paths = pictures();
    paths.extend(textured());
    paths.extend(frames());
    paths.extend(calls());
    paths
}

/// Pixels across the picture of a frame.
const SIDE: usize = 240;

/// A frame of a gold sphere with every pixel shaded, and from a palette: both from the scene up to
/// RGB565.
fn frames() -> [Path; 2] {
    let scene = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).expect("it fits");
    let scene: &'static sphere::color::Scene = Box::leak(Box::new(scene));
    let exposure = scene.exposure_by_factor(1.5).expect("above zero");
    let codes = Vec::leak(vec![NormalMap::BACKGROUND; SIDE * SIDE]);
    NormalMap::sphere(SIDE, codes).expect("one length");
    let map = NormalMap::new(SIDE, SIDE, codes.as_flattened()).expect("one length");
    let whole: Vec<_> = map.pixels().collect();
    let places: Vec<_> =
        whole.iter().map(|pixel| pixel.normal().components().map(f64::from)).collect();
    let normals = Box::leak(Box::new(Axes::new(&places))).normals();
    let (count, mut picture) = (whole.len(), vec![0_u16; SIDE * SIDE]);
    let (nodes, mut palette, mut drawn) = (map.nodes(), Palette::default(), picture.clone());
    let mut colors = vec![Rgb::gray(0.0); count];
    let shaded = move || {
        black_box(scene).shade_slice(black_box(normals), &mut colors).expect("one length");
        let mut target = Target::new(&mut picture, SIDE).expect("whole rows");
        for (pixel, &color) in whole.iter().zip(&colors) {
            pixel.put(&mut target, DISPLAY.rgb565(exposure.of(color)));
        }
        black_box(&mut picture);
    };
    let from_palette = move || {
        palette.fill_mirrored(&nodes, &DISPLAY, |normal| {
            black_box(scene).shade_mirrored(normal).map(|color| exposure.of(color))
        });
        palette.draw(&map, &mut Target::new(&mut drawn, SIDE).expect("whole rows"));
        black_box(&mut drawn);
    };
    let path =
        |name: &str, multiply_adds, run| Path { name: name.into(), multiply_adds, count, run };
    [
        path("a gold sphere to RGB565", 534, Box::new(shaded)),
        path("the same from a palette", 6, Box::new(from_palette)),
    ]
}

static DISPLAY: Display = Display::new(Tone::Filmic);

fn pictures() -> Vec<Path> {
    let normals = Box::leak(Box::new(Axes::spread(PIXELS))).normals();
    let picture = |name: &str, multiply_adds, run| Path {
        name: name.to_owned(),
        multiply_adds,
        count: PIXELS,
        run,
    };
    let gray = |name: &str, (scene, lengths): &Image| {
        picture(name, necessary(lengths), shading(normals, *scene))
    };
    let in_color = |name: &str, (scene, lengths): &Image| {
        let (scene, mut pixels) = (Rgb::gray(*scene), vec![Rgb::gray(0.0); PIXELS]);
        let run = move || {
            let (scene, normals) = (black_box(&scene), black_box(normals));
            scene.shade_slice(normals, black_box(&mut pixels)).expect("one length");
        };
        picture(&format!("{name}, in color"), 3 * necessary(lengths), Box::new(run))
    };

    let read = Shipped::read();
    let every = read.lights.len() * read.materials.len();
    let database: Vec<_> = read.pairs(every).iter().map(Pair::project).collect();
    let mattes: Vec<_> = read.on_matte(sphere::DEGREE).iter().map(Pair::project).collect();
    let falling: Vec<f64> = (0..9).map(|k| 3.5 / f64::from(1 + k)).collect();
    let matte = within(&Pair::new(falling, white_matte()).project(), 1e-3);
    let whole = full(&database[database.len() / 2]);
    let whole = (whole, used(sphere::BASIS.parts().lengths));
    let hundredth = median(&database, 1e-2);

    let formula = NineTerms::new([0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);
    let mut out = vec![0.0; PIXELS];
    let nine_terms = move || {
        let (formula, normals) = (black_box(&formula), black_box(normals));
        formula.shade_slice(normals, black_box(&mut out)).expect("one length");
    };
    let pbr = pbr();
    let long = pbr.collapse_into(&[1.0], vec![0.0; pbr.scene_len()]).expect("it fits");
    vec![
        picture("nine-term formula", NineTerms::MULTIPLY_ADDS, Box::new(nine_terms)),
        gray("full scene", &whole),
        gray("median image within 1e-4", &median(&database, 1e-4)),
        gray("median image within 1e-3", &median(&database, 1e-3)),
        gray("median image within 1e-2", &hundredth),
        gray("median matte within 1e-2", &median(&mattes, 1e-2)),
        gray("matte, light of degree 2, within 1e-3", &matte),
        in_color("full scene", &whole),
        in_color("median image within 1e-2", &hundredth),
        in_color("matte, light of degree 2, within 1e-3", &matte),
        picture(
            "full scene of `pbr`",
            necessary(&used(pbr.parts().lengths)),
            shading(normals, long),
        ),
    ]
}

/// Multiply-adds of a full scene of `pbr`, and of a source on a texel.
const OF_PBR: usize = 477;
const OF_A_SOURCE: usize = 28;

/// Pictures of an object in its own materials, in color, with the projections of their images: of
/// one roughness, with a roughness map, which blends five, and with sources.
fn textured() -> [Path; 3] {
    let table = eigenshade_table::decode(shipped::PBR).expect("a table");
    let basis: &'static OwnedBasis = Box::leak(Box::new(OwnedBasis::new(&table).expect("a basis")));
    let lights = shipped::lights().expect("lights").truncated(table.gram.degree);
    let light = lights.entries.into_iter().find(|one| one.name == "lobby").expect("a light");
    let sources = shipped::sources().expect("sources");
    let sources = sources.into_iter().find(|one| one.name == "lobby").expect("sources");
    let path = |name: &str, images: usize, of_roughness: fn(usize) -> f32, sources: Vec<Source>| {
        let texel = |(k, normal)| Texel {
            normal,
            matte: [0.2, 0.3, (k % 7) as f32 / 10.0],
            reflectance: [0.04, 0.1, (k % 5) as f32 / 10.0],
            metallic: 0.0,
            roughness: of_roughness(k),
        };
        let texels: Vec<Texel> = Axes::spread(PIXELS).each().enumerate().map(texel).collect();
        let blend = Blend::of(texels.iter().map(|texel| texel.roughness)).expect("weights");
        let mut shader = Shader::new(basis.basis().expect("a basis"), usize::MAX);
        let (light, multiply_adds) = (light.clone(), sources.len() * OF_A_SOURCE);
        Path {
            name: name.to_owned(),
            multiply_adds: 3 * (images * OF_PBR + images) + multiply_adds,
            count: PIXELS,
            run: Box::new(move || {
                let texels = (&blend, black_box(&texels[..]));
                black_box(irradiance(&mut shader, &light, ORDER, texels, &sources))
                    .expect("colors");
            }),
        }
    };
    let map = |k: usize| 0.3 + 0.7 * (k % 100) as f32 / 100.0;
    [
        path("texels of one roughness, in color", 3, |_| 0.5, Vec::new()),
        path("texels with a roughness map, in color", 11, map, Vec::new()),
        path("the same with 8 sources", 11, map, sources.first(8).to_vec()),
    ]
}

/// The order of glTF's materials.
const ORDER: usize = 12;

/// A scene, and the lengths of its polynomials by azimuth.
type Image = (Shown, Vec<u16>);

/// The image of middle cost.
fn median(ds: &[sphere::Coefficients], share: f32) -> Image {
    let mut images: Vec<Image> = ds.iter().map(|d| within(d, share)).collect();
    images.sort_by_key(|(_, lengths)| necessary(lengths));
    images.swap_remove(images.len() / 2)
}

/// The lengths of the azimuths that have terms.
fn used(lengths: &[u16]) -> Vec<u16> {
    lengths.iter().copied().take_while(|&length| length > 0).collect()
}

/// Draws a scene.
fn shading<B: AsRef<[f32]> + 'static>(
    normals: Normals<'static>,
    scene: Scene<'static, B>,
) -> Box<dyn FnMut()> {
    let mut out = vec![0.0; PIXELS];
    Box::new(move || {
        let (scene, normals) = (black_box(&scene), black_box(normals));
        scene.shade_slice(normals, black_box(&mut out)).expect("one length");
    })
}

/// The second shipped table, of degree 12.
fn pbr() -> Basis<'static> {
    let bytes = std::fs::read(tables().join("pbr.bin")).expect("the shipped table");
    let table = eigenshade_table::decode(&bytes).expect("a table");
    let bytes = encode(&table, NumberFormat::F32, Endian::Little).expect("it fits");
    let room = Vec::leak(vec![0; bytes.len().div_ceil(4)]);
    Basis::from_bytes(aligned(&bytes, room).expect("room")).expect("a wire file")
}

/// Multiply-adds that a pixel of polynomials of these lengths cannot do without: README.md has them
/// in words.
fn necessary(lengths: &[u16]) -> usize {
    let of = |length: u16| usize::from(length).saturating_sub(1);
    let (&pole, around) = lengths.split_first().unwrap_or((&0, &[]));
    let polynomials = of(pole) + around.iter().map(|&length| 2 * of(length)).sum::<usize>();
    polynomials + (4 * around.len()).saturating_sub(2) + 2 * usize::from(polynomials > 0)
}

fn calls() -> [Path; 5] {
    // The numbers change no count but that of `collapse_within`: like real ones, these fall.
    let falling = |count: u8| (0..count).map(|k| 1.0 / f64::from(1 + 2 * k)).collect();
    let pair: &'static Pair = Box::leak(Box::new(Pair::new(falling(100), falling(40))));
    let transfer = sphere::transfer(&pair.material()).expect("it fits");
    let d: &'static sphere::Coefficients = Box::leak(Box::new(pair.project()));
    [
        call("relight", 570, move || {
            sphere::relight(black_box(&transfer), &black_box(pair).light())
        }),
        call("collapse", 590, move || sphere::collapse(black_box(d))),
        call("collapse_within", 590, move || {
            let (mut lengths, mut room) = ([0; sphere::DEGREE + 1], [0.0; sphere::SCENE]);
            let (d, share) = (black_box(d), Tolerance::OfPeak(1e-2));
            let found = sphere::BASIS.collapse_within(d, share, &mut lengths, &mut room[..]);
            found.map(|(_, report)| report)
        }),
        call("transfer", 5400, move || sphere::transfer(&black_box(pair).material())),
        call("project", 7200, move || black_box(pair).project()),
    ]
}

fn call<T>(name: &str, multiply_adds: usize, call: impl Fn() -> T + 'static) -> Path {
    let run = move || (0..CALLS).for_each(|_| drop(black_box(call())));
    Path { name: format!("`{name}`"), multiply_adds, count: CALLS, run: Box::new(run) }
}
