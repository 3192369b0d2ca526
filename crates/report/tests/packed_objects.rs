//! Packed objects, drawn as firmware draws them, against the pictures of the program.

use eigenshade::object::{Object, Region};
use eigenshade::screen::{Display, Exposure, LinearPalette, Meter, Target, Tone};
use eigenshade::{Light, Material, Rgb, Source, q15, sphere};
use eigenshade_asset::asset::Asset;
use eigenshade_asset::packed::Packed;
use eigenshade_asset::texels::{Covered, Texels};
use eigenshade_generator::object::surface::View;
use eigenshade_model::database::Named;
use eigenshade_model::{highlights, shipped};
use eigenshade_shading::highlights::source;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_shading::textured::{Blend, irradiance};
use palette::{LinSrgb, Srgb};
use report::objects::all as objects;
use report::palette_errors::{Errors, summed};

/// Pixels across.
const SIZE: usize = 120;

/// Sources of the lights.
const SOURCES: usize = 4;

static DISPLAY: Display = Display::new(Tone::Linear);

/// Most regions, and the medians of the mean and of the 95th percentile of CIEDE2000 over all
/// pictures, in hundredths.
const MEDIANS: [(usize, [u32; 2]); 3] = [(1, [149, 541]), (4, [122, 399]), (16, [78, 241])];

/// Integers against floats: about a level of 255 where a flat dial rounds all of its pixels alike.
const OF_INTEGERS: f64 = 0.6;

/// A light without its sources, and these.
type Lit = (Rgb<Vec<f32>>, Vec<Source>);

type Picture = Vec<[u8; 3]>;

/// The picture of a packed object in 8 bits a channel.
fn drawn(object: &Object<'_>, (light, sources): &Lit, exposure: Exposure) -> Picture {
    let light = light.each_ref().try_map(|channel| Light::new(channel)).expect("a light");
    picture(object, |number, region, palette| {
        let parts = region.materials().expect("materials").map(|part| {
            let material = Material::new(&part).expect("a material");
            sphere::color::scene(light, material).expect("a scene")
        });
        let lobes = region.highlights::<SOURCES>(sources).expect("sources");
        palette.fill(&object.nodes(number), |normal| {
            let part = |part: usize| parts[part].shade(normal) + lobes[part].shade(normal);
            [part(0), part(1)].map(|color| exposure.of(color))
        });
    })
}

/// The same in integers.
fn drawn_q15(object: &Object<'_>, (light, sources): &Lit, exposure: Exposure) -> Picture {
    let mut mantissas = [[q15::Q15(0); 100]; 3];
    let channels: Vec<q15::Light<'_>> = <[_; 3]>::from(light.each_ref())
        .into_iter()
        .zip(&mut mantissas)
        .map(|(from, to)| q15::Light::quantize(from, to).expect("a light"))
        .collect();
    let light = Rgb::new(channels[0], channels[1], channels[2]);
    picture(object, |number, region, palette| {
        let parts = region.materials_q15().expect("materials").map(|part| {
            let material = part.material().expect("a material");
            sphere::q15::color::scene(light, material).expect("a scene")
        });
        let lobes = region.highlights::<SOURCES>(sources).expect("sources");
        let lobes = [0, 1].map(|part: usize| {
            let exponents = parts[part].each_ref().map(|channel| channel.exponent());
            q15::Highlights::<Rgb<i32>, SOURCES>::quantize(&lobes[part], exponents).expect("room")
        });
        let exposures = parts
            .each_ref()
            .map(|part| part.exposure_by_factor(exposure.factor()).expect("an exposure"));
        palette.fill(&object.nodes(number), |normal| {
            let part = |part: usize| {
                exposures[part].of(lobes[part].add(parts[part].shade(normal), normal))
            };
            [part(0), part(1)]
        });
    })
}

fn picture(
    object: &Object<'_>,
    mut fill: impl FnMut(usize, &Region, &mut LinearPalette),
) -> Picture {
    let mut palettes = vec![LinearPalette::default(); object.regions().len()];
    for ((number, region), palette) in object.regions().enumerate().zip(&mut palettes) {
        fill(number, &region, palette);
    }
    let mut pixels = vec![[0; 3]; SIZE * SIZE];
    let painted = object.painted(&palettes, &DISPLAY).expect("palettes");
    painted.draw(&mut Target::new(&mut pixels, SIZE).expect("a target"));
    pixels
}

/// The irradiances of the program's picture, and their exposure.
fn reference(
    shader: &mut Shader<'_>,
    light: &Named,
    texels: &Texels,
    sources: &[eigenshade_model::source::Source],
) -> (Vec<Rgb<f32>>, Exposure) {
    let blend = Blend::of(texels.texels.iter().map(|texel| texel.roughness)).expect("weights");
    let texels_of = (&blend, &texels.texels[..]);
    let colors = irradiance(shader, light, 7, texels_of, sources).expect("colors");
    let mut shown = colors.iter().zip(&texels.shares);
    let mut meter = Meter::default();
    let mut pixel = |count: usize| {
        let mut sum = Rgb::gray(0.0);
        for (color, share) in shown.by_ref().take(count) {
            sum = sum + color.map(|channel| share * channel);
        }
        meter.add(sum);
        sum
    };
    let colors = texels.pixels.iter().map(|covered| pixel(covered.texels)).collect();
    (colors, meter.exposure().expect("light"))
}

fn shown(picture: &Picture, covered: &Covered) -> Srgb {
    let [r, g, b] = picture[covered.row * SIZE + covered.column];
    let [r, g, b] = [r, g, b].map(|level| f32::from(level) / 255.0);
    Srgb::new(r, g, b)
}

/// The errors on pixels that the object covers completely, of floats and of integers against them.
fn errors(
    texels: &Texels,
    (colors, exposure): &(Vec<Rgb<f32>>, Exposure),
    [floats, integers]: [&Picture; 2],
) -> [Errors; 2] {
    let (mut expected, mut found, mut found_q15) = (Vec::new(), Vec::new(), Vec::new());
    for (covered, color) in texels.pixels.iter().zip(colors) {
        if covered.coverage == 1.0 {
            let [r, g, b] = <[f32; 3]>::from(exposure.of(*color)).map(|c| c.clamp(0.0, 1.0));
            expected.push(Srgb::from_linear(LinSrgb::new(r, g, b)));
            found.push(shown(floats, covered));
            found_q15.push(shown(integers, covered));
        }
    }
    [summed(&expected, &found), summed(&found, &found_q15)]
}

#[test]
fn packed_objects_look_as_the_program_draws_them() {
    let table = eigenshade_table::decode(shipped::TABLE).expect("a table");
    let owned = OwnedBasis::new(&table).expect("a basis");
    let mut shader = Shader::new(owned.basis().expect("a basis"), table.count());
    let folder = tempfile::tempdir().expect("a folder");
    let mut all = MEDIANS.map(|_| Vec::new());
    for (name, glb) in objects() {
        let path = folder.path().join("object.glb");
        std::fs::write(&path, glb.bytes()).expect("a file");
        let file = path.into();
        let asset = Asset::read(&file).expect("an object").expect("materials");
        let texels = Texels::of(&file, &asset, SIZE, &View::default()).expect("texels");
        for light_name in ["lobby", "park", "studio"] {
            let lights = shipped::lights().expect("lights").truncated(9).entries;
            let mut light = lights.into_iter().find(|one| one.name == light_name).expect("a light");
            let sources = shipped::sources().expect("sources");
            let sources = sources.iter().find(|one| one.name == light_name).expect("sources");
            let sources = sources.first(SOURCES);
            highlights::take_out(&mut light.rgb, 9, sources);
            let reference = reference(&mut shader, &light, &texels, sources);
            let numbers =
                |channel: &Vec<f64>| channel.iter().map(|&one| one as f32).collect::<Vec<f32>>();
            let of_runtime = sources.iter().map(source).collect::<Result<Vec<_>, _>>();
            let lit = (Rgb::from(light.rgb.each_ref().map(numbers)), of_runtime.expect("sources"));
            for ((most, _), all) in MEDIANS.iter().zip(&mut all) {
                let packed = Packed::of(&texels, *most).expect("a packed object");
                let object = Object::new(&packed.bytes).expect("an object");
                assert!(packed.regions.len() <= *most);
                assert_eq!(object.pixels().count(), texels.pixels.len());
                assert!(packed.bytes.len() <= 8 * texels.pixels.len(), "{name}");
                let floats = drawn(&object, &lit, reference.1);
                let integers = drawn_q15(&object, &lit, reference.1);
                let [errors, of_integers] = errors(&texels, &reference, [&floats, &integers]);
                println!(
                    "{most} {name} {light_name}: {:.2} / {:.2}, integers {:.2} / {:.2}",
                    errors.mean, errors.p95, of_integers.mean, of_integers.p95
                );
                assert!(of_integers.mean < OF_INTEGERS, "{name} {light_name}");
                all.push(errors);
            }
        }
    }
    let mut off = Vec::new();
    for ((most, expected), errors) in MEDIANS.into_iter().zip(all) {
        let median = |of: fn(&Errors) -> f64| {
            let mut numbers: Vec<f64> = errors.iter().map(of).collect();
            numbers.sort_by(f64::total_cmp);
            (100.0 * numbers[numbers.len() / 2]).round() as u32
        };
        let found = [median(|one| one.mean), median(|one| one.p95)];
        println!("{most} regions at most: {found:?} hundredths");
        // Processors round differently.
        off.extend(found.iter().zip(expected).map(|(a, b)| a.abs_diff(b)));
    }
    assert!(off.iter().all(|&off| off <= 3), "{off:?}");
}
