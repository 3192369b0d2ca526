//! Color in `f32`.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::{Format, MATERIAL, ORDER, baked_texels};
use super::glossy::SOURCES;
use super::picture::{Opened, Picture, Shade};
use crate::boundary::{Input, Place, Plain};
use crate::export::records;
use crate::float::{self, Light, Material, Scene, Transfer};
use crate::status::Status;
use crate::table::{self, LIGHT};
use eigenshade::{
    BakedMap, DiscPixel, Error, Exposure, Highlights, Linear, MapPoint, Normal, NormalPixel, Rgb,
    Rotation, Source,
};

records! {
    LightBuffer = "color_light_buffer" f32: numbers: [[f32; LIGHT]; 3];
    MaterialBuffer = "color_material_buffer" f32: numbers: [[f32; MATERIAL]; 3];
    Baked = "color_baked" f32: size: usize, length: usize, texels: Input<f32>;
}

/// The lights, for the runtime.
pub(crate) fn lights(from: &[Light; 3]) -> Result<Rgb<eigenshade::Light<'_>>, Status> {
    Rgb::from(from.each_ref()).try_map(|light| Ok(light.view()?.0))
}

/// Stores modified lights of the same degrees.
fn stored<B: AsRef<[f32]>>(
    from: &[Light; 3],
    modified: Rgb<B>,
    numbers: &mut LightBuffer,
) -> [Light; 3] {
    let [r, g, b] = &mut numbers.numbers;
    let store = |(light, modified, to): (&Light, &B, &mut [f32; LIGHT])| {
        to.iter_mut().zip(modified.as_ref()).for_each(|(to, &from)| *to = from);
        Light { degree: light.degree, length: light.length, coefficients: Input::to(&*to) }
    };
    let [of_r, of_g, of_b] = from;
    [store((of_r, &modified.r, r)), store((of_g, &modified.g, g)), store((of_b, &modified.b, b))]
}

impl Format for f32 {
    type Light = Light;
    type Material = Material;
    type Transfer = Transfer;
    type Scene = Scene;
    type Baked = Baked;
    type Texel = f32;
    type Irradiance = f32;
    type Normal = Normal;
    type Exposure = Exposure;
    type LightBuffer = LightBuffer;
    type MaterialBuffer = MaterialBuffer;
    type Angle = f32;
    type Highlights = Highlights<SOURCES>;

    fn light(light: &Light) -> Result<[Place; 2], Status> {
        Ok(light.view()?.1)
    }

    fn material(material: &Material) -> Result<[Place; 3], Status> {
        let [of_record, of_numbers] = material.view()?.1;
        Ok([of_record, of_numbers, of_numbers])
    }

    fn same(one: &Material, other: &Material) -> bool {
        one.order == other.order && one.coefficients.is(&other.coefficients)
    }

    const NO_TRANSFER: Transfer = Transfer { numbers: [0.0; table::TRANSFER] };

    fn transfer(material: &Material, to: &mut Transfer) -> Result<(), Status> {
        float::transferred(&material.view()?.0, &mut [0.0; table::WORKSPACE], to)
    }

    fn relight(transfer: &Transfer, light: &Light, to: &mut Scene) -> Result<(), Status> {
        let mut d = [0.0; table::COMPONENTS];
        float::relit(transfer, &light.view()?.0, &mut d)?;
        float::collapsed(&d, to)
    }

    fn turn(
        from: &[Light; 3],
        quaternion: &[f32; 4],
        numbers: &mut LightBuffer,
    ) -> Result<[Light; 3], Status> {
        let rotation = Rotation::from_quaternion(*quaternion)?;
        Ok(stored(from, lights(from)?.turned::<LIGHT>(&rotation)?, numbers))
    }

    fn turn_about_view(
        from: &[Light; 3],
        angle: &[f32; 2],
        numbers: &mut LightBuffer,
    ) -> Result<[Light; 3], Status> {
        Ok(stored(from, lights(from)?.turned_about_view::<LIGHT>(*angle)?, numbers))
    }

    fn residual(
        from: &[Light; 3],
        sources: &[Source],
        numbers: &mut LightBuffer,
    ) -> Result<[Light; 3], Status> {
        let rest = lights(from)?.residual::<LIGHT>(sources)?;
        Ok(stored(from, rest, numbers))
    }

    fn highlights(of: Highlights<SOURCES>, _: [i32; 3]) -> Result<Highlights<SOURCES>, Status> {
        Ok(of)
    }

    #[inline]
    fn add(highlights: &Highlights<SOURCES>, [r, g, b]: [f32; 3], normal: Normal) -> [f32; 3] {
        let of = highlights.shade(normal);
        [r + of.r, g + of.g, b + of.b]
    }

    fn metallic_roughness(
        base_color: &[f32; 3],
        metallic: f32,
        roughness: f32,
        numbers: &mut MaterialBuffer,
    ) -> Result<[Material; 3], Status> {
        let found = eigenshade::Material::metallic_roughness(*base_color, metallic, roughness)?;
        let found: [_; 3] = found.into();
        for (to, from) in numbers.numbers.iter_mut().zip(&found) {
            to.iter_mut().zip(from.iter()).for_each(|(to, &from)| *to = from);
        }
        Ok(numbers.numbers.each_ref().map(|numbers| Material {
            order: ORDER,
            length: MATERIAL,
            coefficients: Input::to(numbers),
        }))
    }

    fn normal(x: f32, y: f32, z: f32) -> Result<Normal, Status> {
        Ok(Normal::new(x, y, z)?)
    }

    #[inline]
    fn of_disc(pixel: DiscPixel) -> Normal {
        pixel.normal()
    }

    #[inline]
    fn of_normal_map(pixel: NormalPixel) -> Normal {
        pixel.normal()
    }

    fn check(scene: &Scene) -> Result<(), Status> {
        scene.check()
    }

    #[inline]
    fn shade(scene: &Scene, normal: Normal) -> Result<f32, Status> {
        Ok(float::irradiance(scene, normal))
    }

    fn bake(scene: &[Scene; 3], size: usize, texels: [&mut [f32]; 3]) -> Result<[i32; 3], Status> {
        for (scene, texels) in scene.iter().zip(texels) {
            float::view(scene)?.bake_into(size, texels)?;
        }
        Ok([0; 3])
    }

    fn baked(size: usize, texels: Input<f32>, length: usize, _: [i32; 3]) -> Baked {
        Baked { size, length, texels }
    }

    fn exponent(_: &Scene) -> i32 {
        0
    }

    fn exposure(exposure: f32, _: i32) -> Result<Exposure, Error> {
        Exposure::new(exposure)
    }

    #[inline]
    fn exposed(irradiance: f32, exposure: Exposure) -> Linear {
        Linear::from(irradiance * exposure.factor())
    }
}

impl Picture<f32> for Baked {
    fn open(&self) -> Result<Opened<impl Shade<f32>>, Status> {
        let (texels, places) = baked_texels(Place::of(self), self.size, &self.texels, self.length)?;
        let maps = texels.try_map(|texels| BakedMap::new(self.size, texels))?;
        let shade = move |normal| Ok(maps.bilinear(MapPoint::of(normal)).into());
        Ok(Opened { shade, exponents: [0; 3], places })
    }
}
