//! The operations in color that each number format has.

use super::glossy::SOURCES;
use super::picture::Picture;
use crate::boundary::{Input, Place, Plain};
use crate::float;
use crate::status::Status;
use eigenshade::{DiscPixel, Error, Highlights, Linear, NormalPixel, Rgb, Source};
use eigenshade_table::material;

/// The order of glTF materials, and their coefficients.
pub(crate) const ORDER: usize = 7;
pub(crate) const MATERIAL: usize = material::count(ORDER);

/// Three channels of anything.
#[repr(transparent)]
pub(crate) struct Channels<T>(pub(crate) [T; 3]);

// SAFETY: consists of plain values.
#[expect(unsafe_code, reason = "any bytes are channels if any bytes are one channel")]
unsafe impl<T: Plain> Plain for Channels<T> {}

/// A format in which C has color.
pub(crate) trait Format: Plain + Copy {
    type Light: Plain;
    type Material: Plain;
    type Transfer: Plain + Clone;
    type Scene: Plain;
    /// Three baked maps of the same size.
    type Baked: Plain + Picture<Self>;
    type Texel: Plain + Copy;
    /// One channel of a pixel.
    type Irradiance: Plain + Copy;
    type Normal: Copy;
    /// A factor of an irradiance.
    type Exposure: Copy;
    /// Numbers of a modified light in three channels.
    type LightBuffer: Plain;
    /// Numbers of a computed material in three channels.
    type MaterialBuffer: Plain;
    /// A component of a quaternion, a cosine or a sine.
    type Angle: Plain;
    /// The highlights of small sources.
    type Highlights;

    /// Checks a light, and says where it lies.
    fn light(light: &Self::Light) -> Result<[Place; 2], Status>;

    /// Checks a material, and says where it lies.
    fn material(material: &Self::Material) -> Result<[Place; 3], Status>;

    /// Whether both are the same numbers in memory.
    fn same(one: &Self::Material, other: &Self::Material) -> bool;

    /// A transfer to be overwritten.
    const NO_TRANSFER: Self::Transfer;

    fn transfer(material: &Self::Material, to: &mut Self::Transfer) -> Result<(), Status>;

    /// Relights and collapses one channel.
    fn relight(
        transfer: &Self::Transfer,
        light: &Self::Light,
        to: &mut Self::Scene,
    ) -> Result<(), Status>;

    /// Turns a light by a quaternion x, y, z, w. The result points to `numbers`.
    fn turn(
        from: &[Self::Light; 3],
        quaternion: &[Self::Angle; 4],
        numbers: &mut Self::LightBuffer,
    ) -> Result<[Self::Light; 3], Status>;

    /// Turns a light about the view axis by a cosine and a sine. The result points to `numbers`.
    fn turn_about_view(
        from: &[Self::Light; 3],
        angle: &[Self::Angle; 2],
        numbers: &mut Self::LightBuffer,
    ) -> Result<[Self::Light; 3], Status>;

    /// A light in `f32` without sources. The result points to `numbers`.
    fn residual(
        from: &[float::Light; 3],
        sources: &[Source],
        numbers: &mut Self::LightBuffer,
    ) -> Result<[Self::Light; 3], Status>;

    /// Highlights for a scene with these exponents.
    fn highlights(of: Highlights<SOURCES>, exponents: [i32; 3])
    -> Result<Self::Highlights, Status>;

    /// Adds highlights to the irradiance of a scene.
    fn add(
        highlights: &Self::Highlights,
        irradiance: [Self::Irradiance; 3],
        normal: Self::Normal,
    ) -> [Self::Irradiance; 3];

    /// A glTF material. The result points to `numbers`.
    fn metallic_roughness(
        base_color: &[Self; 3],
        metallic: Self,
        roughness: Self,
        numbers: &mut Self::MaterialBuffer,
    ) -> Result<[Self::Material; 3], Status>;

    fn normal(x: Self, y: Self, z: Self) -> Result<Self::Normal, Status>;
    fn of_disc(pixel: DiscPixel) -> Self::Normal;
    fn of_normal_map(pixel: NormalPixel) -> Self::Normal;
    /// Refuses a scene that was never computed.
    fn check(scene: &Self::Scene) -> Result<(), Status>;
    fn shade(scene: &Self::Scene, normal: Self::Normal) -> Result<Self::Irradiance, Status>;

    /// Bakes three scenes in `f32`. Returns the exponents of the channels, 0 in `f32`.
    fn bake(
        scene: &[float::Scene; 3],
        size: usize,
        texels: [&mut [Self::Texel]; 3],
    ) -> Result<[i32; 3], Status>;
    fn baked(
        size: usize,
        texels: Input<Self::Texel>,
        length: usize,
        exponents: [i32; 3],
    ) -> Self::Baked;

    /// The exponent of a scene, 0 in `f32`.
    fn exponent(scene: &Self::Scene) -> i32;
    /// What exposes an irradiance times 2^-`exponent`.
    fn exposure(exposure: f32, exponent: i32) -> Result<Self::Exposure, Error>;
    fn exposed(irradiance: Self::Irradiance, exposure: Self::Exposure) -> Linear;
}

/// Where three lights or materials lie, once all of them are checked.
pub(crate) fn places<T, const N: usize>(
    channels: &Channels<T>,
    check: impl Fn(&T) -> Result<[Place; N], Status>,
) -> Result<[[Place; N]; 3], Status> {
    let [r, g, b] = &channels.0;
    Ok([check(r)?, check(g)?, check(b)?])
}

/// The texels of each channel of baked maps, and where all lies.
#[expect(unsafe_code, reason = "memory of C")]
pub(crate) fn baked_texels<T: Plain>(
    record: Place,
    size: usize,
    texels: &Input<T>,
    length: usize,
) -> Result<(Rgb<&[T]>, [Place; 4]), Status> {
    check_size(size, length)?;
    // SAFETY: C promises `length` texels.
    let texels = unsafe { texels.array(length) }?;
    let of_texels = Place::of(texels);
    Ok((thirds(texels)?, [record, of_texels, of_texels, of_texels]))
}

/// Checks the size of three baked maps, and the number of their texels.
pub(crate) fn check_size(size: usize, length: usize) -> Result<(), Status> {
    // The size is checked first, so that nothing wraps.
    if (2..=4096).contains(&size) && length == 3 * size * size {
        Ok(())
    } else {
        Err(Status::Baked)
    }
}

/// The texels of each channel.
fn thirds<T>(texels: &[T]) -> Result<Rgb<&[T]>, Status> {
    let third = texels.len() / 3;
    let (r, rest) = texels.split_at_checked(third).ok_or(Status::Internal)?;
    let (g, b) = rest.split_at_checked(third).ok_or(Status::Internal)?;
    Ok(Rgb::new(r, g, b))
}

/// The texels of each channel, to be written.
pub(crate) fn thirds_mut<T>(texels: &mut [T]) -> Result<[&mut [T]; 3], Status> {
    let third = texels.len() / 3;
    let (r, rest) = texels.split_at_mut_checked(third).ok_or(Status::Internal)?;
    let (g, b) = rest.split_at_mut_checked(third).ok_or(Status::Internal)?;
    Ok([r, g, b])
}
