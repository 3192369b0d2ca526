//! Color in Q15.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::{Format, MATERIAL, ORDER, baked_texels};
use super::glossy::SOURCES;
use super::picture::{Opened, Picture, Shade};
use crate::boundary::{Input, Place, Plain};
use crate::export::records;
use crate::float;
use crate::integers::{self, Light, Material, Scene, Transfer};
use crate::status::Status;
use crate::table::{self, COMPONENTS, LIGHT};
use eigenshade::q15::{self, Exposure, Highlights, LightBuffer as Turned, Normal, Rotation};
use eigenshade::{DiscPixel, Error, Linear, NormalPixel, Q15, Rgb, Source};

/// The exponents of glTF materials.
const EXPONENTS: usize = ORDER + 1;

records! {
    LightBuffer = "color_light_buffer" Q15: mantissas: [[Q15; LIGHT]; 3];
    MaterialBuffer = "color_material_buffer" Q15:
        mantissas: [[Q15; MATERIAL]; 3], exponents: [[i8; EXPONENTS]; 3];
    Baked = "color_baked" Q15:
        size: usize, length: usize, texels: Input<i16>, exponents: [i32; 3];
}

/// The lights, for the runtime.
fn lights(from: &[Light; 3]) -> Result<Rgb<q15::Light<'_>>, Status> {
    Rgb::from(from.each_ref()).try_map(|light| Ok(light.view()?.0))
}

/// Stores turned lights of the same degrees.
fn stored(
    from: &[Light; 3],
    turned: &Rgb<Turned<LIGHT>>,
    numbers: &mut LightBuffer,
) -> Result<[Light; 3], Status> {
    let turned = turned.lights()?;
    let [r, g, b] = &mut numbers.mantissas;
    let store = |of: &Light, turned: q15::Light<'_>, to: &mut [Q15; LIGHT]| {
        to.iter_mut().zip(turned.mantissas()).for_each(|(to, &from)| *to = from);
        let (degree, length, exponent) = (of.degree, of.length, turned.exponent());
        Light { degree, length, mantissas: Input::to(&*to), exponent }
    };
    let [of_r, of_g, of_b] = from;
    Ok([store(of_r, turned.r, r), store(of_g, turned.g, g), store(of_b, turned.b, b)])
}

impl Format for Q15 {
    type Light = Light;
    type Material = Material;
    type Transfer = Transfer;
    type Scene = Scene;
    type Baked = Baked;
    type Texel = i16;
    type Irradiance = i32;
    type Normal = Normal;
    type Exposure = Exposure;
    type LightBuffer = LightBuffer;
    type MaterialBuffer = MaterialBuffer;
    type Angle = i32;
    type Highlights = Highlights<Rgb<i32>, SOURCES>;

    fn light(light: &Light) -> Result<[Place; 2], Status> {
        Ok(light.view()?.1)
    }

    fn material(material: &Material) -> Result<[Place; 3], Status> {
        Ok(material.view()?.1)
    }

    fn same(one: &Material, other: &Material) -> bool {
        one.order == other.order
            && one.mantissas.is(&other.mantissas)
            && one.exponents.is(&other.exponents)
    }

    const NO_TRANSFER: Transfer =
        Transfer { numbers: [Q15(0); table::q15::TRANSFER], exponents: [0; table::q15::PROFILES] };

    fn transfer(material: &Material, to: &mut Transfer) -> Result<(), Status> {
        integers::transferred(&material.view()?.0, &mut [0; table::q15::WORKSPACE], to)
    }

    fn relight(transfer: &Transfer, light: &Light, to: &mut Scene) -> Result<(), Status> {
        let mut d = integers::Coefficients { mantissas: [0; COMPONENTS], exponent: 0 };
        integers::relit(transfer, &light.view()?.0, &mut d)?;
        integers::collapsed(&d.mantissas, d.exponent, to)
    }

    fn turn(
        from: &[Light; 3],
        quaternion: &[i32; 4],
        numbers: &mut LightBuffer,
    ) -> Result<[Light; 3], Status> {
        let rotation = Rotation::from_quaternion(*quaternion)?;
        stored(from, &lights(from)?.turned::<LIGHT>(&rotation)?, numbers)
    }

    fn turn_about_view(
        from: &[Light; 3],
        angle: &[i32; 2],
        numbers: &mut LightBuffer,
    ) -> Result<[Light; 3], Status> {
        stored(from, &lights(from)?.turned_about_view::<LIGHT>(*angle)?, numbers)
    }

    fn residual(
        from: &[float::Light; 3],
        sources: &[Source],
        numbers: &mut LightBuffer,
    ) -> Result<[Light; 3], Status> {
        let rest = super::float::lights(from)?.residual::<LIGHT>(sources)?;
        let store = |of: &float::Light, rest: &[f32], to: &mut [Q15; LIGHT]| {
            let (degree, length) = (of.degree, of.length);
            let to = to.get_mut(..length).ok_or(Status::Internal)?;
            let exponent = q15::Light::quantize(rest, to)?.exponent();
            Ok::<_, Status>(Light { degree, length, mantissas: Input::to(&*to), exponent })
        };
        let ([of_r, of_g, of_b], [r, g, b]) = (from, &mut numbers.mantissas);
        Ok([store(of_r, &rest.r, r)?, store(of_g, &rest.g, g)?, store(of_b, &rest.b, b)?])
    }

    fn highlights(
        of: eigenshade::Highlights<SOURCES>,
        exponents: [i32; 3],
    ) -> Result<Highlights<Rgb<i32>, SOURCES>, Status> {
        Ok(Highlights::quantize(&of, exponents.into())?)
    }

    #[inline]
    fn add(
        highlights: &Highlights<Rgb<i32>, SOURCES>,
        irradiance: [i32; 3],
        normal: Normal,
    ) -> [i32; 3] {
        highlights.add(irradiance.into(), normal).into()
    }

    fn metallic_roughness(
        base_color: &[Self; 3],
        metallic: Self,
        roughness: Self,
        numbers: &mut MaterialBuffer,
    ) -> Result<[Material; 3], Status> {
        let found = q15::Material::metallic_roughness(*base_color, metallic, roughness)?;
        let found: [_; 3] = found.into();
        let MaterialBuffer { mantissas, exponents } = numbers;
        for ((mantissas, exponents), found) in mantissas.iter_mut().zip(&mut *exponents).zip(&found)
        {
            let found = found.material()?;
            mantissas.iter_mut().zip(found.mantissas()).for_each(|(to, &from)| *to = from);
            exponents.iter_mut().zip(found.exponents()).for_each(|(to, &from)| *to = from);
        }
        let ([r, g, b], [e_r, e_g, e_b]) = (mantissas.each_ref(), exponents.each_ref());
        Ok([(r, e_r), (g, e_g), (b, e_b)].map(|(mantissas, exponents)| Material {
            order: ORDER,
            length: MATERIAL,
            mantissas: Input::to(mantissas),
            exponents_length: EXPONENTS,
            exponents: Input::to(exponents),
        }))
    }

    fn normal(x: Self, y: Self, z: Self) -> Result<Normal, Status> {
        Ok(Normal::from_unit(x, y, z)?)
    }

    #[inline]
    fn of_disc(pixel: DiscPixel) -> Normal {
        pixel.normal_q15()
    }

    #[inline]
    fn of_normal_map(pixel: NormalPixel) -> Normal {
        pixel.normal_q15()
    }

    fn check(scene: &Scene) -> Result<(), Status> {
        scene.check()
    }

    #[inline]
    fn shade(scene: &Scene, normal: Normal) -> Result<i32, Status> {
        Ok(integers::irradiance(scene, normal))
    }

    fn bake(
        scene: &[float::Scene; 3],
        size: usize,
        texels: [&mut [i16]; 3],
    ) -> Result<[i32; 3], Status> {
        let mut exponents = [0; 3];
        for ((scene, texels), exponent) in scene.iter().zip(texels).zip(&mut exponents) {
            *exponent = float::view(scene)?.bake_integers_into(size, texels)?.exponent();
        }
        Ok(exponents)
    }

    fn baked(size: usize, texels: Input<i16>, length: usize, exponents: [i32; 3]) -> Baked {
        Baked { size, length, texels, exponents }
    }

    fn exponent(scene: &Scene) -> i32 {
        scene.exponent
    }

    fn exposure(exposure: f32, exponent: i32) -> Result<Exposure, Error> {
        Exposure::new(exposure, exponent)
    }

    #[inline]
    fn exposed(irradiance: i32, exposure: Exposure) -> Linear {
        exposure.of(irradiance)
    }
}

impl Picture<Q15> for Baked {
    fn open(&self) -> Result<Opened<impl Shade<Q15>>, Status> {
        let (texels, places) = baked_texels(Place::of(self), self.size, &self.texels, self.length)?;
        let maps = texels
            .zip(Rgb::from(self.exponents))
            .try_map(|(texels, exponent)| q15::BakedMap::new(self.size, exponent, texels))?;
        let shade = move |normal| Ok(maps.bilinear(q15::MapPoint::of(normal)).into());
        Ok(Opened { shade, exponents: self.exponents, places })
    }
}
