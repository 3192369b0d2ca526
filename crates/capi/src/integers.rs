//! In integers: mantissas of 15 bits, for machines without a float unit.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::constants::SOURCES;
use crate::format::{Format, Read};
use crate::quantize::{pointing, quantized, stored_lights, stored_materials};
use crate::records_q15::{
    BakedQ15, CoefficientsQ15, ColorLightQ15, ColorMaterialQ15, IrradianceQ15, LightBufferQ15,
    LightQ15, MaterialBufferQ15, MaterialQ15, PictureQ15, TransferQ15, WorkspaceQ15,
};
use crate::status::{Status, light_shape, material_shape};
use crate::table::q15::{PROFILES, SCENE, TRANSFER, WORKSPACE};
use crate::table::{self, COMPONENTS, LIGHT};
use eigenshade::object::{DiscPixel, NormalPixel, ObjectCoefficients, Region, ShadowedObject};
use eigenshade::q15::kernels::Mirrored;
use eigenshade::q15::{
    self, BakedMap, Basis, Exposure, Highlights, Light, MapPoint, Material, Normal, Parts,
    Rotation, Transfer,
};
use eigenshade::screen::Linear;
use eigenshade::specialized::{by_image, checked};
use eigenshade::{Effect, Error, Q15, Rgb, Source};

/// The basis without the factors of transfers: a program whose transfers are computed beforehand
/// links no factors.
static RELIGHT_ONLY: Basis<'static> = checked(Basis::new(Parts {
    polar: &[],
    polar_exponents: &[],
    factors: &[],
    factor_exponents: &[],
    ..*table::q15::BASIS.parts()
}));

/// The polynomials of a picture.
#[repr(C)]
pub(crate) struct Scene {
    terms: [[i32; SCENE]; 3],
    exponents: [i32; 3],
}

// SAFETY: consists of numbers.
unsafe impl Plain for Scene {}

/// A light, and where its mantissas lie.
fn light(from: &LightQ15) -> Result<(Light<'_>, Place), Status> {
    light_shape(from.degree, from.length)?;
    // SAFETY: C promises `length` mantissas.
    let mantissas = unsafe { Input(from.mantissas).array(from.length) }?;
    Ok((Light::new(from.exponent, mantissas)?, Place::of(mantissas)))
}

/// A material, and where its mantissas and exponents lie.
fn material(from: &MaterialQ15) -> Result<(Material<'_>, [Place; 2]), Status> {
    material_shape(from.order, from.length)?;
    if from.exponents_length != from.order + 1 {
        return Err(Status::MaterialLength);
    }
    // SAFETY: C promises `length` mantissas.
    let mantissas = unsafe { Input(from.mantissas).array(from.length) }?;
    // SAFETY: C promises `exponents_length` exponents.
    let exponents = unsafe { Input(from.exponents).array(from.exponents_length) }?;
    Ok((Material::new(exponents, mantissas)?, [Place::of(mantissas), Place::of(exponents)]))
}

/// Relights one channel. Returns the exponent of d.
#[inline(always)]
fn relit(
    transfer: (&[Q15; TRANSFER], &[i16; PROFILES]),
    light: &Light<'_>,
    d: &mut [i32; COMPONENTS],
) -> Result<i32, Status> {
    let transfer = Transfer::new(transfer.0, transfer.1);
    Ok(RELIGHT_ONLY.relight_into(&transfer, light, d)?)
}

/// Relights and collapses one channel. Returns the exponent of its polynomials.
fn lit(
    transfer: (&[Q15; TRANSFER], &[i16; PROFILES]),
    light: &Light<'_>,
    to: &mut [i32; SCENE],
) -> Result<i32, Status> {
    let mut d = [0; COMPONENTS];
    let exponent = relit(transfer, light, &mut d)?;
    Ok(RELIGHT_ONLY.collapse_into(&d, exponent, to)?.exponent())
}

/// Writes the transfer of one channel.
fn transferred(
    material: &Material<'_>,
    workspace: &mut [i32; WORKSPACE],
    numbers: &mut [Q15; TRANSFER],
    exponents: &mut [i16; PROFILES],
) -> Result<(), Status> {
    Ok(table::q15::BASIS.transfer_into(material, workspace, numbers, exponents)?)
}

pub(crate) fn project(
    from: &Input<LightQ15>,
    on: &Input<MaterialQ15>,
    workspace: &Output<WorkspaceQ15>,
    coefficients: &Output<CoefficientsQ15>,
) -> Result<(), Status> {
    let (from, on) = (from.value()?, on.value()?);
    let (light, of_light) = light(from)?;
    let (material, [of_mantissas, of_exponents]) = material(on)?;
    let written = [workspace.place(), coefficients.place()];
    let read = [Place::of(from), of_light, Place::of(on), of_mantissas, of_exponents];
    disjoint(&written, &read)?;
    // SAFETY: nothing overlaps.
    let (workspace, to) = unsafe { (workspace.zeroed()?, coefficients.zeroed()?) };
    let WorkspaceQ15 { numbers, transfer, exponents } = workspace;
    transferred(&material, numbers, transfer, exponents)?;
    to.exponent = relit((transfer, exponents), &light, &mut to.mantissas)?;
    Ok(())
}

/// The irradiances of a normal and its mirror images in one channel.
// As below.
#[inline(never)]
fn images(terms: &[i32; SCENE], mirrored: &Mirrored) -> [i32; 4] {
    table::q15::mirrored_terms(terms, mirrored)
}

/// The irradiance in one channel, times 2 to the negative exponent, with every size a constant.
// Shared by all that shades.
#[inline(never)]
fn irradiance(terms: &[i32; SCENE], normal: Normal) -> i32 {
    table::q15::shade_terms(terms, normal)
}

impl Format for Q15 {
    type Light = ColorLightQ15;
    type Material = ColorMaterialQ15;
    type Transfer = TransferQ15;
    type OfLight<'a> = Light<'a>;
    type OfMaterial<'a> = Material<'a>;
    type LightBuffer = LightBufferQ15;
    type MaterialBuffer = MaterialBufferQ15;
    type PictureBuffer = PictureQ15;
    type Scene = Scene;
    type Highlights = Highlights<Rgb<i32>, SOURCES>;
    type Normal = Normal;
    type Channel = i32;
    type Irradiance = IrradianceQ15;
    type Exposure = Rgb<Exposure>;
    type Angle = i32;
    type Baked = BakedQ15;
    type Texel = i16;

    fn light(from: &ColorLightQ15) -> Result<Read<Light<'_>>, Status> {
        let ((r, of_r), (g, of_g), (b, of_b)) = (light(&from.r)?, light(&from.g)?, light(&from.b)?);
        let none = Place::default();
        let places = [Place::of(from), of_r, of_g, of_b, none, none, none];
        Ok(Read { value: Rgb::new(r, g, b), places })
    }

    fn check(_: Rgb<Light<'_>>) -> Result<(), Status> {
        Ok(())
    }

    fn material(from: &ColorMaterialQ15) -> Result<Read<Material<'_>>, Status> {
        let ((r, [r_m, r_e]), (g, [g_m, g_e]), (b, [b_m, b_e])) =
            (material(&from.r)?, material(&from.g)?, material(&from.b)?);
        let places = [Place::of(from), r_m, r_e, g_m, g_e, b_m, b_e];
        Ok(Read { value: Rgb::new(r, g, b), places })
    }

    fn transfer(material: Rgb<Material<'_>>, to: &mut TransferQ15) -> Result<(), Status> {
        let TransferQ15 { numbers: [r, g, b], exponents: [of_r, of_g, of_b] } = to;
        let mut workspace = [0; WORKSPACE];
        transferred(&material.r, &mut workspace, r, of_r)?;
        if material.as_gray().is_some() {
            (*g, *b, *of_g, *of_b) = (*r, *r, *of_r, *of_r);
            return Ok(());
        }
        transferred(&material.g, &mut workspace, g, of_g)?;
        transferred(&material.b, &mut workspace, b, of_b)
    }

    fn relight(
        transfer: &TransferQ15,
        light: Rgb<Light<'_>>,
        to: &mut Scene,
    ) -> Result<(), Status> {
        let lights: [_; 3] = light.into();
        let transfers = transfer.numbers.iter().zip(&transfer.exponents);
        let channels = to.terms.iter_mut().zip(&mut to.exponents);
        for ((transfer, light), (terms, exponent)) in transfers.zip(&lights).zip(channels) {
            *exponent = lit(transfer, light, terms)?;
        }
        Ok(())
    }

    fn scene(
        light: Rgb<Light<'_>>,
        material: Rgb<Material<'_>>,
        to: &mut Scene,
    ) -> Result<(), Status> {
        let (mut numbers, mut exponents) = ([Q15(0); TRANSFER], [0; PROFILES]);
        let gray = material.as_gray().is_some();
        let inputs = <[_; 3]>::from(light.zip(material));
        let channels = to.terms.iter_mut().zip(&mut to.exponents);
        for (channel, ((light, material), (terms, exponent))) in
            inputs.iter().zip(channels).enumerate()
        {
            if channel == 0 || !gray {
                transferred(material, &mut [0; WORKSPACE], &mut numbers, &mut exponents)?;
            }
            *exponent = lit((&numbers, &exponents), light, terms)?;
        }
        Ok(())
    }

    fn turn(
        from: Rgb<Light<'_>>,
        quaternion: &[i32; 4],
        buffer: &mut LightBufferQ15,
    ) -> Result<ColorLightQ15, Status> {
        let rotation = Rotation::from_quaternion(*quaternion)?;
        let mantissas = Rgb::from(buffer.mantissas.each_mut()).map(<[Q15; LIGHT]>::as_mut_slice);
        let exponents = from.turn_into(&rotation, mantissas)?;
        let channels = Rgb::from(buffer.mantissas.each_ref()).zip(from).zip(exponents);
        let channels =
            channels.map(|((to, from), exponent)| pointing(to, from.mantissas().len(), exponent));
        Ok(ColorLightQ15 { r: channels.r, g: channels.g, b: channels.b })
    }

    fn turn_about_view(
        from: Rgb<Light<'_>>,
        angle: &[i32; 2],
        buffer: &mut LightBufferQ15,
    ) -> Result<ColorLightQ15, Status> {
        let mut turned = Rgb::default();
        from.turn_about_view_into::<LIGHT>(*angle, &mut turned)?;
        stored_lights(&turned, buffer)
    }

    fn residual(
        from: Rgb<Light<'_>>,
        sources: &[Source],
        buffer: &mut LightBufferQ15,
    ) -> Result<ColorLightQ15, Status> {
        let mut numbers = [[0.0; LIGHT]; 3];
        let lights = Rgb::from(numbers.each_mut()).zip(from).try_map(|(to, from)| {
            let unit = unit(from.exponent());
            let mantissas = from.mantissas();
            to.iter_mut().zip(mantissas).for_each(|(to, from)| *to = from.get() as f32 * unit);
            let to = to.get(..mantissas.len()).ok_or(Status::Internal)?;
            Ok::<_, Status>(eigenshade::Light::new(to)?)
        })?;
        quantized(&lights.residual::<LIGHT>(sources)?, buffer)
    }

    fn mask_light(
        from: Rgb<Light<'_>>,
        effect: Effect,
        buffer: &mut LightBufferQ15,
    ) -> ColorLightQ15 {
        let channels = Rgb::from(buffer.mantissas.each_mut()).zip(from).map(|(to, from)| {
            let mantissas = from.mantissas();
            to.iter_mut().zip(mantissas).for_each(|(to, &from)| *to = from);
            effect.mask_light(to);
            pointing(to, mantissas.len(), from.exponent())
        });
        ColorLightQ15 { r: channels.r, g: channels.g, b: channels.b }
    }

    fn mask_material(
        from: Rgb<Material<'_>>,
        effect: Effect,
        buffer: &mut MaterialBufferQ15,
    ) -> ColorMaterialQ15 {
        stored_materials(from, buffer, |mantissas| effect.mask_material(mantissas))
    }

    fn metallic_roughness(
        base_color: &[Self; 3],
        metallic: Self,
        roughness: Self,
        buffer: &mut MaterialBufferQ15,
    ) -> Result<ColorMaterialQ15, Status> {
        let found = q15::Material::metallic_roughness(*base_color, metallic, roughness)?;
        Ok(stored_materials(found.materials()?, buffer, |_| ()))
    }

    fn materials(
        region: &Region,
        buffer: &mut MaterialBufferQ15,
    ) -> Result<[ColorMaterialQ15; 2], Status> {
        let [tinted, plain] = region.materials_q15()?;
        let (tinted, plain) = (tinted.material()?, plain.material()?);
        let ColorMaterialQ15 { r, g, .. } =
            stored_materials(Rgb::new(tinted, plain, plain), buffer, |_| ());
        Ok([r, g].map(|one| ColorMaterialQ15 { r: one, g: one, b: one }))
    }

    fn object_coefficients(
        object: &ShadowedObject<'_>,
        light: Rgb<Self::OfLight<'_>>,
        to: &mut Rgb<ObjectCoefficients>,
    ) -> Result<(), Error> {
        object.coefficients_q15_into(light, to)
    }

    const LIGHT_BUFFER: LightBufferQ15 = LightBufferQ15 { mantissas: [[Q15(0); LIGHT]; 3] };

    fn highlights(
        of: &eigenshade::Highlights<SOURCES>,
        scene: &Scene,
    ) -> Result<Highlights<Rgb<i32>, SOURCES>, Status> {
        Ok(Highlights::quantize(of, scene.exponents.into())?)
    }

    #[inline]
    fn add(
        highlights: &Highlights<Rgb<i32>, SOURCES>,
        irradiance: Rgb<i32>,
        normal: Normal,
    ) -> Rgb<i32> {
        highlights.add(irradiance, normal)
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

    #[inline]
    fn shade(scene: &Scene, normal: Normal) -> Rgb<i32> {
        Rgb::from(scene.terms.each_ref()).map(|terms| irradiance(terms, normal))
    }

    fn mirrored(normal: Normal) -> [Normal; 4] {
        normal.mirrored()
    }

    fn shade_mirrored(scene: &Scene, normal: Normal) -> [Rgb<i32>; 4] {
        let mirrored = Mirrored::new(normal);
        by_image(Rgb::from(scene.terms.each_ref()).map(|terms| images(terms, &mirrored)))
    }

    fn exponents(scene: &Scene) -> [i32; 3] {
        scene.exponents
    }

    fn irradiance(Rgb { r, g, b }: Rgb<i32>, exponents: [i32; 3]) -> IrradianceQ15 {
        IrradianceQ15 { r, g, b, exponents }
    }

    fn exposure(exposure: f32, exponents: [i32; 3]) -> Result<Rgb<Exposure>, Error> {
        Rgb::from(exponents).try_map(|exponent| Exposure::new(exposure, exponent))
    }

    #[inline]
    fn exposed(irradiance: Rgb<i32>, exposure: Rgb<Exposure>) -> Rgb<Linear> {
        exposure.of(irradiance)
    }

    fn bake(
        scene: Rgb<eigenshade::Scene<'_, &[f32]>>,
        size: usize,
        texels: Rgb<&mut [i16]>,
    ) -> Result<[i32; 3], Status> {
        let baked = scene.bake_integers_into(size, texels)?;
        Ok(baked.map(|map| map.exponent()).into())
    }

    fn baked(size: usize, texels: *const i16, length: usize, exponents: [i32; 3]) -> BakedQ15 {
        BakedQ15 { size, length, texels, exponents }
    }

    fn maps(baked: &BakedQ15) -> (usize, Input<i16>, usize, [i32; 3]) {
        (baked.size, Input(baked.texels), baked.length, baked.exponents)
    }

    fn look_up(
        size: usize,
        texels: Rgb<&[i16]>,
        exponents: [i32; 3],
    ) -> Result<impl Fn(Normal) -> Rgb<i32>, Status> {
        let maps = texels
            .zip(Rgb::from(exponents))
            .try_map(|(texels, exponent)| BakedMap::new(size, exponent, texels))?;
        Ok(move |normal| maps.bilinear(MapPoint::of(normal)))
    }
}

/// 2^exponent for the exponents of lights with 15 bits of mantissa.
fn unit(exponent: i32) -> f32 {
    let (mut unit, by) = (1.0_f32, if exponent < 0 { 0.5 } else { 2.0 });
    for _ in 0..exponent.unsigned_abs() {
        unit *= by;
    }
    unit
}
