//! In float: `f32`, for machines with a float unit.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::constants::{MATERIAL_BUFFER, METALLIC_ROUGHNESS_ORDER, SOURCES};
use crate::format::{Format, Read};
use crate::records_f32::{
    BakedF32, CoefficientsF32, ColorLightF32, ColorMaterialF32, IrradianceF32, LightBufferF32,
    LightF32, MaterialBufferF32, MaterialF32, PictureF32, TransferF32, WorkspaceF32,
};
use crate::status::{Status, light_shape, material_shape};
use crate::table::{self, COMPONENTS, LIGHT, SCENE, TRANSFER, WORKSPACE};
use eigenshade::object::{
    BakedMap, DiscPixel, MapPoint, NormalPixel, ObjectCoefficients, Region, ShadowedObject,
};
use eigenshade::screen::{Exposure, Linear};
use eigenshade::specialized::{Mirrored, by_image, checked};
use eigenshade::wire::Parts;
use eigenshade::{
    Basis, Effect, Error, Highlights, Light, Material, Normal, Rgb, Rotation, Source,
};
use eigenshade_table::material;

/// The basis without the factors of transfers: a program whose transfers are computed beforehand
/// links no factors.
static RELIGHT_ONLY: Basis<'static> =
    checked(Basis::new(Parts { polar: &[], factors: &[], ..*table::BASIS.parts() }));

/// The polynomials of a picture.
#[repr(transparent)]
pub(crate) struct Scene([[f32; SCENE]; 3]);

// SAFETY: consists of numbers.
unsafe impl Plain for Scene {}

impl Scene {
    /// The scenes, for steps that the runtime alone has.
    pub(crate) fn view(&self) -> Result<Rgb<eigenshade::Scene<'_, &[f32]>>, Status> {
        Rgb::from(self.0.each_ref()).try_map(|terms| Ok(RELIGHT_ONLY.scene(&terms[..])?))
    }
}

/// A light, and where its coefficients lie.
fn light(from: &LightF32) -> Result<(Light<'_>, Place), Status> {
    light_shape(from.degree, from.length)?;
    // SAFETY: C promises `length` coefficients.
    let coefficients = unsafe { Input(from.coefficients).array(from.length) }?;
    Ok((Light::from_finite(coefficients)?, Place::of(coefficients)))
}

/// A material, and where its coefficients lie.
fn material(from: &MaterialF32) -> Result<(Material<'_>, Place), Status> {
    material_shape(from.order, from.length)?;
    // SAFETY: C promises `length` coefficients.
    let coefficients = unsafe { Input(from.coefficients).array(from.length) }?;
    Ok((Material::new(coefficients)?, Place::of(coefficients)))
}

/// Relights and collapses one channel.
fn lit(transfer: &[f32; TRANSFER], light: &Light<'_>, to: &mut [f32; SCENE]) -> Result<(), Status> {
    let mut d = [0.0; COMPONENTS];
    RELIGHT_ONLY.relight_into(transfer, light, &mut d)?;
    RELIGHT_ONLY.collapse_into(&d, &mut to[..])?;
    Ok(())
}

/// Writes the transfer of one channel.
fn transferred(material: &Material<'_>, to: &mut [f32; TRANSFER]) -> Result<(), Status> {
    Ok(table::BASIS.transfer_into(material, &mut [0.0; WORKSPACE], to)?)
}

/// A light of C whose coefficients are the first ones of these.
fn light_in(numbers: &[f32; LIGHT], length: usize) -> LightF32 {
    let degree = length.isqrt().saturating_sub(1);
    LightF32 { degree, length, coefficients: numbers.as_ptr() }
}

/// A material of C whose coefficients are the first ones of these.
fn material_in(numbers: &[f32; MATERIAL_BUFFER], order: usize) -> MaterialF32 {
    MaterialF32 { order, length: material::count(order), coefficients: numbers.as_ptr() }
}

/// Stores modified lights.
fn stored<B: AsRef<[f32]>>(modified: &Rgb<B>, buffer: &mut LightBufferF32) -> ColorLightF32 {
    let channels =
        Rgb::from(buffer.numbers.each_mut()).zip(modified.each_ref()).map(|(to, from)| {
            let from = from.as_ref();
            to.iter_mut().zip(from).for_each(|(to, &from)| *to = from);
            light_in(to, from.len())
        });
    ColorLightF32 { r: channels.r, g: channels.g, b: channels.b }
}

/// Stores materials by coefficients and order, and modifies them.
fn stored_materials(
    from: Rgb<(&[f32], usize)>,
    buffer: &mut MaterialBufferF32,
    modify: impl Fn(&mut [f32; MATERIAL_BUFFER]),
) -> ColorMaterialF32 {
    let channels = Rgb::from(buffer.numbers.each_mut()).zip(from);
    let channels = channels.map(|(to, (from, order))| {
        to.iter_mut().zip(from).for_each(|(to, &from)| *to = from);
        modify(to);
        material_in(to, order)
    });
    ColorMaterialF32 { r: channels.r, g: channels.g, b: channels.b }
}

pub(crate) fn project(
    from: &Input<LightF32>,
    on: &Input<MaterialF32>,
    workspace: &Output<WorkspaceF32>,
    coefficients: &Output<CoefficientsF32>,
) -> Result<(), Status> {
    let (from, on) = (from.value()?, on.value()?);
    let ((light, of_light), (material, of_material)) = (light(from)?, material(on)?);
    let written = [workspace.place(), coefficients.place()];
    disjoint(&written, &[Place::of(from), of_light, Place::of(on), of_material])?;
    // SAFETY: nothing overlaps.
    let (workspace, to) = unsafe { (workspace.zeroed()?, coefficients.zeroed()?) };
    let (workspace, to) = (&mut workspace.numbers, &mut to.numbers);
    Ok(table::BASIS.project_into(&light, &material, workspace, to)?)
}

impl Format for f32 {
    type Light = ColorLightF32;
    type Material = ColorMaterialF32;
    type Transfer = TransferF32;
    type OfLight<'a> = Light<'a>;
    type OfMaterial<'a> = Material<'a>;
    type LightBuffer = LightBufferF32;
    type MaterialBuffer = MaterialBufferF32;
    type PictureBuffer = PictureF32;
    type Scene = Scene;
    type Highlights = Highlights<SOURCES>;
    type Normal = Normal;
    type Channel = f32;
    type Irradiance = IrradianceF32;
    type Exposure = Exposure;
    type Angle = f32;
    type Baked = BakedF32;
    type Texel = f32;

    fn light(from: &ColorLightF32) -> Result<Read<Light<'_>>, Status> {
        let ((r, of_r), (g, of_g), (b, of_b)) = (light(&from.r)?, light(&from.g)?, light(&from.b)?);
        let none = Place::default();
        let places = [Place::of(from), of_r, of_g, of_b, none, none, none];
        Ok(Read { value: Rgb::new(r, g, b), places })
    }

    fn check(light: Rgb<Light<'_>>) -> Result<(), Status> {
        let finite = |light: &Light<'_>| light.coefficients().iter().all(|one| one.is_finite());
        if <[_; 3]>::from(light).iter().all(finite) { Ok(()) } else { Err(Status::NotFinite) }
    }

    fn material(from: &ColorMaterialF32) -> Result<Read<Material<'_>>, Status> {
        let ((r, of_r), (g, of_g), (b, of_b)) =
            (material(&from.r)?, material(&from.g)?, material(&from.b)?);
        let none = Place::default();
        let places = [Place::of(from), of_r, of_g, of_b, none, none, none];
        Ok(Read { value: Rgb::new(r, g, b), places })
    }

    fn transfer(material: Rgb<Material<'_>>, to: &mut TransferF32) -> Result<(), Status> {
        let [r, g, b] = &mut to.numbers;
        transferred(&material.r, r)?;
        if material.as_gray().is_some() {
            (*g, *b) = (*r, *r);
            return Ok(());
        }
        transferred(&material.g, g)?;
        transferred(&material.b, b)
    }

    fn relight(
        transfer: &TransferF32,
        light: Rgb<Light<'_>>,
        to: &mut Scene,
    ) -> Result<(), Status> {
        let lights: [_; 3] = light.into();
        let channels = transfer.numbers.iter().zip(&lights).zip(&mut to.0);
        channels.into_iter().try_for_each(|((transfer, light), to)| lit(transfer, light, to))
    }

    fn scene(
        light: Rgb<Light<'_>>,
        material: Rgb<Material<'_>>,
        to: &mut Scene,
    ) -> Result<(), Status> {
        let mut transfer = [0.0; TRANSFER];
        let gray = material.as_gray().is_some();
        let (lights, materials): ([_; 3], [_; 3]) = (light.into(), material.into());
        for (channel, ((light, material), to)) in
            lights.iter().zip(&materials).zip(&mut to.0).enumerate()
        {
            if channel == 0 || !gray {
                transferred(material, &mut transfer)?;
            }
            lit(&transfer, light, to)?;
        }
        Ok(())
    }

    fn turn(
        from: Rgb<Light<'_>>,
        quaternion: &[f32; 4],
        buffer: &mut LightBufferF32,
    ) -> Result<ColorLightF32, Status> {
        let rotation = Rotation::from_quaternion(*quaternion)?;
        Ok(stored(&from.turned::<LIGHT>(&rotation)?, buffer))
    }

    fn turn_about_view(
        from: Rgb<Light<'_>>,
        angle: &[f32; 2],
        buffer: &mut LightBufferF32,
    ) -> Result<ColorLightF32, Status> {
        Ok(stored(&from.turned_about_view::<LIGHT>(*angle)?, buffer))
    }

    fn residual(
        from: Rgb<Light<'_>>,
        sources: &[Source],
        buffer: &mut LightBufferF32,
    ) -> Result<ColorLightF32, Status> {
        Ok(stored(&from.residual::<LIGHT>(sources)?, buffer))
    }

    fn mask_light(
        from: Rgb<Light<'_>>,
        effect: Effect,
        buffer: &mut LightBufferF32,
    ) -> ColorLightF32 {
        let channels = Rgb::from(buffer.numbers.each_mut()).zip(from).map(|(to, from)| {
            let from = from.coefficients();
            to.iter_mut().zip(from).for_each(|(to, &from)| *to = from);
            effect.mask_light(to);
            light_in(to, from.len())
        });
        ColorLightF32 { r: channels.r, g: channels.g, b: channels.b }
    }

    fn mask_material(
        from: Rgb<Material<'_>>,
        effect: Effect,
        buffer: &mut MaterialBufferF32,
    ) -> ColorMaterialF32 {
        let from = from.map(|from| (from.coefficients(), from.order()));
        stored_materials(from, buffer, |to| effect.mask_material(to))
    }

    fn metallic_roughness(
        base_color: &[f32; 3],
        metallic: f32,
        roughness: f32,
        buffer: &mut MaterialBufferF32,
    ) -> Result<ColorMaterialF32, Status> {
        let found = Material::metallic_roughness(*base_color, metallic, roughness)?;
        let found = found.each_ref().map(|from| (&**from, METALLIC_ROUGHNESS_ORDER));
        Ok(stored_materials(found, buffer, |_| ()))
    }

    fn materials(
        region: &Region,
        buffer: &mut MaterialBufferF32,
    ) -> Result<[ColorMaterialF32; 2], Status> {
        let parts = region.materials()?;
        let [tinted, plain] = parts.each_ref().map(|from| (&**from, METALLIC_ROUGHNESS_ORDER));
        let ColorMaterialF32 { r, g, .. } =
            stored_materials(Rgb::new(tinted, plain, plain), buffer, |_| ());
        Ok([r, g].map(|one| ColorMaterialF32 { r: one, g: one, b: one }))
    }

    fn object_coefficients(
        object: &ShadowedObject<'_>,
        light: Rgb<Self::OfLight<'_>>,
        to: &mut Rgb<ObjectCoefficients>,
    ) -> Result<(), Error> {
        *to = object.coefficients(light)?;
        Ok(())
    }

    const LIGHT_BUFFER: LightBufferF32 = LightBufferF32 { numbers: [[0.0; LIGHT]; 3] };

    fn highlights(of: &Highlights<SOURCES>, _: &Scene) -> Result<Highlights<SOURCES>, Status> {
        Ok(of.clone())
    }

    #[inline]
    fn add(highlights: &Highlights<SOURCES>, irradiance: Rgb<f32>, normal: Normal) -> Rgb<f32> {
        irradiance + highlights.shade(normal)
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

    #[inline]
    fn shade(scene: &Scene, normal: Normal) -> Rgb<f32> {
        Rgb::from(scene.0.each_ref()).map(|terms| irradiance(terms, normal))
    }

    fn mirrored(normal: Normal) -> [Normal; 4] {
        normal.mirrored()
    }

    fn shade_mirrored(scene: &Scene, normal: Normal) -> [Rgb<f32>; 4] {
        let mirrored = Mirrored::new(normal);
        by_image(Rgb::from(scene.0.each_ref()).map(|terms| images(terms, &mirrored)))
    }

    fn exponents(_: &Scene) -> [i32; 3] {
        [0; 3]
    }

    fn irradiance(Rgb { r, g, b }: Rgb<f32>, _: [i32; 3]) -> IrradianceF32 {
        IrradianceF32 { r, g, b }
    }

    fn exposure(exposure: f32, _: [i32; 3]) -> Result<Exposure, Error> {
        Exposure::new(exposure)
    }

    #[inline]
    fn exposed(irradiance: Rgb<f32>, exposure: Exposure) -> Rgb<Linear> {
        exposure.of(irradiance).map(Linear::from)
    }

    fn bake(
        scene: Rgb<eigenshade::Scene<'_, &[f32]>>,
        size: usize,
        texels: Rgb<&mut [f32]>,
    ) -> Result<[i32; 3], Status> {
        scene.zip(texels).try_map(|(scene, texels)| scene.bake_into(size, texels))?;
        Ok([0; 3])
    }

    fn baked(size: usize, texels: *const f32, length: usize, _: [i32; 3]) -> BakedF32 {
        BakedF32 { size, length, texels }
    }

    fn maps(baked: &BakedF32) -> (usize, Input<f32>, usize, [i32; 3]) {
        (baked.size, Input(baked.texels), baked.length, [0; 3])
    }

    fn look_up(
        size: usize,
        texels: Rgb<&[f32]>,
        _: [i32; 3],
    ) -> Result<impl Fn(Normal) -> Rgb<f32>, Status> {
        let maps = texels.try_map(|texels| BakedMap::new(size, texels))?;
        Ok(move |normal| maps.bilinear(MapPoint::of(normal)))
    }
}

/// The irradiances of a normal and its mirror images in one channel.
// As below.
#[inline(never)]
fn images(terms: &[f32; SCENE], mirrored: &Mirrored) -> [f32; 4] {
    table::mirrored_terms(terms, mirrored)
}

/// The irradiance in one channel, with every size a constant.
// Shared by all that shades.
#[inline(never)]
fn irradiance(terms: &[f32; SCENE], normal: Normal) -> f32 {
    table::shade_terms(terms, normal)
}
