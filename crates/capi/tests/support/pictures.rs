//! The pictures of `example/color.c` as the runtime draws them: `name,checksum` in lines, and the
//! irradiances that it prints.

use eigenshade::object::{Disc, NormalMap};
use eigenshade::presets::{gloss, light, material, sources};
use eigenshade::q15::{self, Rotation};
use eigenshade::screen::{Display, Linear, Nodes, Palette, Pixel, Target, Tone};
use eigenshade::{Effect, Error, Gloss, Highlights, Light, Q15, Rgb, Source, sphere};
use std::fmt::Write as _;

#[path = "objects.rs"]
pub mod objects;

#[path = "shadowed.rs"]
mod shadowed;

#[path = "textured.rs"]
mod textured;

const SIDE: usize = 48;
const MAP: usize = 16;
const BAKED: usize = 32;
const LIGHT: usize = sphere::LIGHT;

/// The irradiance of a normal, as exposed.
type Shade<'s> = &'s dyn Fn(q15::Normal) -> Rgb<Linear>;

fn disc(display: &Display, shade: Shade<'_>) -> Result<Vec<u16>, Error> {
    let mut picture = vec![0; SIDE * SIDE];
    let mut target = Target::new(&mut picture, SIDE)?;
    for pixel in Disc::new(SIDE)? {
        pixel.put(&mut target, display.rgb565(shade(pixel.normal_q15())));
    }
    Ok(picture)
}

fn of_map(codes: &[u8], display: &Display, shade: Shade<'_>) -> Result<Vec<u16>, Error> {
    let mut picture = vec![0; SIDE * SIDE];
    let mut target = Target::new(&mut picture, SIDE)?;
    for pixel in NormalMap::new(MAP, MAP, codes)?.pixels() {
        pixel.put(&mut target, display.rgb565(shade(pixel.normal_q15())));
    }
    Ok(picture)
}

/// The codes of a sphere.
fn sphere_codes() -> Result<Vec<[u8; 2]>, Error> {
    let mut codes = vec![NormalMap::BACKGROUND; SIDE * SIDE];
    NormalMap::sphere(SIDE, &mut codes)?;
    Ok(codes)
}

/// An encoding of pixels.
trait Encoding: Pixel + Copy {
    /// Bytes from a row to the next.
    const STRIDE: usize;
    /// What is there before.
    const BELOW: Self;
    fn bytes(self) -> Vec<u8>;
    fn encoded(display: &Display, color: Rgb<Linear>) -> Self;
}

impl Encoding for u16 {
    const STRIDE: usize = 88;
    const BELOW: Self = 0x5a5a;
    fn bytes(self) -> Vec<u8> {
        self.to_ne_bytes().into()
    }
    fn encoded(display: &Display, color: Rgb<Linear>) -> Self {
        display.rgb565(color)
    }
}

impl Encoding for [u8; 2] {
    const STRIDE: usize = 91;
    const BELOW: Self = [0x5a; 2];
    fn bytes(self) -> Vec<u8> {
        self.into()
    }
    fn encoded(display: &Display, color: Rgb<Linear>) -> Self {
        display.rgb565(color).to_be_bytes()
    }
}

impl Encoding for [u8; 3] {
    const STRIDE: usize = 133;
    const BELOW: Self = [0x5a; 3];
    fn bytes(self) -> Vec<u8> {
        self.into()
    }
    fn encoded(display: &Display, color: Rgb<Linear>) -> Self {
        display.rgb888(color).into()
    }
}

impl Encoding for [u8; 4] {
    const STRIDE: usize = 174;
    const BELOW: Self = [0x5a; 4];
    fn bytes(self) -> Vec<u8> {
        self.into()
    }
    fn encoded(display: &Display, color: Rgb<Linear>) -> Self {
        let Rgb { r, g, b } = display.rgb888(color);
        [r, g, b, u8::MAX]
    }
}

/// The windows that `check_targets` draws into, in one encoding.
fn targets<P: Encoding>(lines: &mut String) -> Result<(), Error> {
    const WIDTH: usize = 40;
    let display = Display::new(Tone::Filmic);
    let scene = sphere::q15::color::scene(light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT)?;
    let exposure = scene.exposure_by_factor(1.5)?;
    let exposed = |normal| exposure.of(scene.shade(normal));
    let mut palette = Palette::default();
    palette.fill_mirrored(&Nodes::ALL, &display, |normal: q15::Normal| {
        scene.shade_mirrored(normal).map(|irradiance| exposure.of(irradiance))
    });
    let codes = sphere_codes()?;
    let map = NormalMap::new(SIDE, SIDE, codes.as_flattened())?;
    for [x, y] in [[-5, -20], [20, -7], [-31, 3], [2, 11]] {
        for way in 0..4 {
            let mut pixels = [P::BELOW; WIDTH * 30];
            let mut target = Target::new(&mut pixels, WIDTH)?;
            let mut target = target.at(x, y);
            match way {
                0 => Disc::new(SIDE)?.for_each(|pixel| {
                    pixel.put(&mut target, P::encoded(&display, exposed(pixel.normal_q15())));
                }),
                1 => map.pixels().for_each(|pixel| {
                    pixel.put(&mut target, P::encoded(&display, exposed(pixel.normal_q15())));
                }),
                2 => palette.draw(&map, &mut target),
                _ => palette.dithered().draw(&map, &mut target),
            }
            // With what is between the rows.
            let rows = pixels.chunks(WIDTH).flat_map(|row| {
                let mut bytes: Vec<u8> = row.iter().flat_map(|pixel| pixel.bytes()).collect();
                bytes.resize(P::STRIDE, 0x5a);
                bytes
            });
            let _ = writeln!(lines, "target,{}", checksum(rows));
        }
    }
    Ok(())
}

fn masked(from: &[Q15], mask: impl Fn(&mut [Q15])) -> Vec<Q15> {
    let mut numbers = from.to_vec();
    mask(&mut numbers);
    numbers
}

/// The part of a picture that is diffuse.
fn diffuse(
    light: Rgb<q15::Light<'_>>,
    material: Rgb<q15::Material<'_>>,
) -> Result<sphere::q15::color::Scene, Error> {
    let of_light =
        light.map(|light| masked(light.mantissas(), |all| Effect::Diffuse.mask_light(all)));
    let of_material = material
        .map(|material| masked(material.mantissas(), |all| Effect::Diffuse.mask_material(all)));
    let light = of_light
        .each_ref()
        .zip(light)
        .try_map(|(numbers, light)| q15::Light::new(light.exponent(), numbers))?;
    let material = of_material
        .each_ref()
        .zip(material)
        .try_map(|(numbers, material)| q15::Material::new(material.exponents(), numbers))?;
    sphere::q15::color::scene(light, material)
}

/// FNV-1a of bytes.
fn checksum(bytes: impl IntoIterator<Item = u8>) -> u32 {
    let step = |sum: u32, byte| (sum ^ u32::from(byte)).wrapping_mul(16_777_619);
    bytes.into_iter().fold(2_166_136_261, step)
}

/// A source as C has it, rounded once more.
fn as_in_c(from: &Source) -> Result<Source, Error> {
    Source::new(from.direction(), from.energy(), from.spread())
}

/// The first sources of the lobby.
fn lobby_sources() -> Result<[Source; 4], Error> {
    let mut sources = [sources::LOBBY[0]; 4];
    for (to, from) in sources.iter_mut().zip(&sources::LOBBY) {
        *to = as_in_c(from)?;
    }
    Ok(sources)
}

/// The lobby without sources, which are taken out of the light in integers.
fn rest<'a>(
    sources: &[Source],
    mantissas: &'a mut [[Q15; LIGHT]; 3],
) -> Result<Rgb<q15::Light<'a>>, Error> {
    let floats = light::q15::LOBBY.map(|light| {
        let unit = 2.0_f32.powi(light.exponent());
        light.mantissas().iter().map(|mantissa| mantissa.get() as f32 * unit).collect::<Vec<_>>()
    });
    let floats = floats.each_ref().try_map(|numbers| Light::new(numbers))?;
    let rest = floats.residual::<LIGHT>(sources)?;
    let [r, g, b] = mantissas;
    Ok(Rgb::new(
        q15::Light::quantize(&rest.r, r)?,
        q15::Light::quantize(&rest.g, g)?,
        q15::Light::quantize(&rest.b, b)?,
    ))
}

/// The lines.
pub fn lines() -> Result<String, Error> {
    let filmic = Display::new(Tone::Filmic);
    let linear = Display::new(Tone::Linear);
    let reinhard = Display::new(Tone::Reinhard);
    let mut state = 1_u32;
    let codes: Vec<u8> = (0..2 * MAP * MAP)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        })
        .collect();
    let lobby = light::q15::LOBBY;
    let gold = sphere::q15::color::transfer(material::q15::GOLD_METALLIC_PAINT)?;
    let relit = |light: Rgb<q15::Light<'_>>| sphere::q15::color::relight(&gold, light);
    let exposed = |scene: &sphere::q15::color::Scene, exposure: f32| {
        let exposure = scene.exposure_by_factor(exposure)?;
        let scene = scene.clone();
        Ok::<_, Error>(move |normal| exposure.of(scene.shade(normal)))
    };

    let mut pictures = Vec::new();
    let mut draw = |name, scene: &sphere::q15::color::Scene| {
        pictures.push((name, disc(&filmic, &exposed(scene, 1.5)?)?));
        Ok::<_, Error>(())
    };
    draw("scene", &relit(lobby)?)?;
    draw("relit", &relit(light::q15::PARK)?)?;
    draw("diffuse", &diffuse(lobby, material::q15::GOLD_METALLIC_PAINT)?)?;
    let turned = lobby.turned::<LIGHT>(&Rotation::from_quaternion([1, -2, 3, 4])?)?;
    draw("turned", &relit(turned.lights()?)?)?;
    let turned = lobby.turned_about_view::<LIGHT>([3, 4])?;
    let scene = relit(turned.lights()?)?;
    draw("turned about the view", &scene)?;
    pictures.push(("normal map", of_map(&codes, &reinhard, &exposed(&scene, 0.7)?)?));
    let sphere_codes = sphere_codes()?;
    let map = NormalMap::new(SIDE, SIDE, sphere_codes.as_flattened())?;
    let mut palette = Palette::default();
    let exposure = scene.exposure_by_factor(1.5)?;
    palette.fill_mirrored(&Nodes::ALL, &filmic, |normal: q15::Normal| {
        scene.shade_mirrored(normal).map(|irradiance| exposure.of(irradiance))
    });
    let mut picture = vec![0; SIDE * SIDE];
    palette.draw(&map, &mut Target::new(&mut picture, SIDE)?);
    pictures.push(("palette", picture));

    let sources = lobby_sources()?;
    // Gloss as C has it, rounded once more.
    let of_gold = gloss::GOLD_METALLIC_PAINT;
    let [reflectance, grazing] = [of_gold.reflectance(), of_gold.grazing()].map(Into::into);
    let of_gold = Gloss::new(of_gold.alpha().sqrt(), reflectance, of_gold.albedo().into())?
        .with_grazing(grazing)?;
    let mut mantissas = [[Q15(0); LIGHT]; 3];
    let rest = rest(&sources, &mut mantissas)?;
    let highlights_of = |scene: &sphere::q15::color::Scene, sources: &[Source]| {
        let highlights = Highlights::<4>::new(&of_gold, sources)?;
        let exponents = scene.each_ref().map(|channel| channel.exponent());
        q15::Highlights::<_, 4>::quantize(&highlights, exponents)
    };
    let glossy = |scene: &sphere::q15::color::Scene, sources: &[Source]| {
        let highlights = highlights_of(scene, sources)?;
        let (scene, exposure) = (scene.clone(), scene.exposure_by_factor(1.0)?);
        Ok::<_, Error>(move |normal| exposure.of(highlights.add(scene.shade(normal), normal)))
    };
    let scene = relit(rest)?;
    pictures.push(("highlights", disc(&linear, &glossy(&scene, &sources)?)?));
    let (highlights, exposure) = (highlights_of(&scene, &sources)?, scene.exposure_by_factor(1.0)?);
    let mut palette = Palette::default();
    palette.fill_mirrored(&map.nodes(), &linear, |normal: q15::Normal| {
        let mut images = normal.mirrored().into_iter();
        scene.shade_mirrored(normal).map(|irradiance| {
            let image = images.next().unwrap_or(normal);
            exposure.of(highlights.add(irradiance, image))
        })
    });
    let mut picture = vec![0; SIDE * SIDE];
    palette.dithered().draw(&map, &mut Target::new(&mut picture, SIDE)?);
    pictures.push(("palette of highlights", picture));
    let turned = rest.turned::<LIGHT>(&Rotation::from_quaternion([1, -2, 3, 4])?)?;
    let by = eigenshade::Rotation::from_quaternion([1.0, -2.0, 3.0, 4.0])?;
    let mut turned_sources = sources;
    for to in &mut turned_sources {
        // C gives what it turned as a source.
        *to = as_in_c(&to.turned(by))?;
    }
    let shade = glossy(&relit(turned.lights()?)?, &turned_sources)?;
    pictures.push(("turned highlights", of_map(&codes, &linear, &shade)?));

    let number = |x: f32| Q15((x * 32_767.0) as i16);
    let copper = [0.93, 0.5, 0.25].map(number);
    let copper = q15::Material::metallic_roughness(copper, number(0.75), number(0.5))?;
    let gray = material::q15::PTFE_633NM;
    for (name, material) in [("glTF", copper.materials()?), ("gray", gray)] {
        let scene = sphere::q15::color::scene(lobby, material)?;
        pictures.push((name, disc(&filmic, &exposed(&scene, 1.5)?)?));
        if name == "gray" {
            let shade = exposed(&scene, 1.5)?;
            pictures.push(("gray normal map", of_map(&codes, &filmic, &shade)?));
        }
    }

    let red = sphere::color::scene(light::LOBBY, material::DARK_RED_PAINT)?;
    let texels = [0; BAKED * BAKED];
    let baked = red.bake_integers_into(BAKED, Rgb::gray(texels))?;
    let exposure = baked.exposure_by_factor(1.5)?;
    let look_up = |normal| exposure.of(baked.bilinear(q15::MapPoint::of(normal)));
    pictures.push(("baked", disc(&linear, &look_up)?));
    pictures.push(("baked normal map", of_map(&codes, &filmic, &look_up)?));

    let mut lines = String::new();
    for (name, picture) in pictures {
        // Writing to a string cannot fail.
        let bytes = picture.iter().flat_map(|pixel| pixel.to_le_bytes());
        let _ = writeln!(lines, "{name},{}", checksum(bytes));
    }
    targets::<u16>(&mut lines)?;
    targets::<[u8; 2]>(&mut lines)?;
    targets::<[u8; 3]>(&mut lines)?;
    targets::<[u8; 4]>(&mut lines)?;
    let normal = q15::Normal::from_unit(Q15(0), Q15(19_661), Q15(26_214))?;
    let scene = sphere::q15::color::scene(lobby, material::q15::DARK_RED_PAINT)?;
    let lamp = [0.0, 0.6, 0.8];
    let lamp = Source::new(lamp, [0.5, 0.4, 0.3], 0.03)?;
    let copper = Gloss::metallic_roughness([0.93, 0.5, 0.25], 1.0, 0.3)?;
    let highlights = Highlights::<1>::new(&copper, &[lamp])?;
    let exponents = scene.each_ref().map(|channel| channel.exponent());
    let highlights = q15::Highlights::<_, 1>::quantize(&highlights, exponents)?;
    let half = q15::Normal::from_unit(Q15(0), Q15(10_362), Q15(31_086))?;
    let glossy = highlights.add(scene.shade(half), half);
    for found in [scene.shade(normal), baked.bilinear(q15::MapPoint::of(normal)), glossy] {
        for irradiance in <[i32; 3]>::from(found) {
            let _ = writeln!(lines, "shade,{}", irradiance.cast_unsigned());
        }
    }
    textured::lines(&mut lines)?;
    shadowed::lines(&mut lines)?;
    Ok(lines)
}
