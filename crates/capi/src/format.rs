//! The operations that each number format has, in three channels.

use crate::boundary::{Input, Place, Plain};
use crate::constants::SOURCES;
use crate::status::Status;
use eigenshade::object::{DiscPixel, NormalPixel, ObjectCoefficients, Region, ShadowedObject};
use eigenshade::screen::{AnyNormal, Linear};
use eigenshade::{Effect, Error, Highlights, Rgb, Source};

/// A light or a material that was checked, and where it lies.
pub(crate) struct Read<T> {
    pub(crate) value: Rgb<T>,
    pub(crate) places: [Place; 7],
}

/// A format in which C has pictures.
pub(crate) trait Format: Plain + Copy + 'static {
    /// A light, a material and a transfer in C.
    type Light: Plain;
    type Material: Plain;
    type Transfer: Plain;
    /// The same in the runtime.
    type OfLight<'a>: Copy;
    type OfMaterial<'a>: Copy + PartialEq;
    /// Memory of C for a modified light, for a computed material and for a picture.
    type LightBuffer: Plain;
    type MaterialBuffer: Plain;
    type PictureBuffer: Plain + 'static;
    /// The polynomials of a picture in three channels.
    type Scene: Plain + 'static;
    /// The highlights of small sources.
    type Highlights: 'static;
    type Normal: Copy + AnyNormal;
    /// One channel of a pixel, and three of them for C.
    type Channel: Copy;
    type Irradiance: Plain;
    /// The factor of an irradiance, in three channels.
    type Exposure: Copy;
    /// A component of a quaternion, a cosine or a sine.
    type Angle: Plain;
    /// Three baked maps of the same size, and one of their numbers.
    type Baked: Plain + 'static;
    type Texel: Plain + 'static;

    fn light(light: &Self::Light) -> Result<Read<Self::OfLight<'_>>, Status>;
    /// Whether all coefficients of a light are finite.
    fn check(light: Rgb<Self::OfLight<'_>>) -> Result<(), Status>;
    fn material(material: &Self::Material) -> Result<Read<Self::OfMaterial<'_>>, Status>;

    /// Writes a transfer.
    fn transfer(material: Rgb<Self::OfMaterial<'_>>, to: &mut Self::Transfer)
    -> Result<(), Status>;

    /// Relights and collapses.
    fn relight(
        transfer: &Self::Transfer,
        light: Rgb<Self::OfLight<'_>>,
        to: &mut Self::Scene,
    ) -> Result<(), Status>;

    /// Transfers, relights and collapses, with the memory of one channel of a transfer.
    fn scene(
        light: Rgb<Self::OfLight<'_>>,
        material: Rgb<Self::OfMaterial<'_>>,
        to: &mut Self::Scene,
    ) -> Result<(), Status>;

    /// Turns a light by a quaternion x, y, z, w. The result points to `buffer`.
    fn turn(
        from: Rgb<Self::OfLight<'_>>,
        quaternion: &[Self::Angle; 4],
        buffer: &mut Self::LightBuffer,
    ) -> Result<Self::Light, Status>;

    /// Turns a light about the view axis by a cosine and a sine. The result points to `buffer`.
    fn turn_about_view(
        from: Rgb<Self::OfLight<'_>>,
        angle: &[Self::Angle; 2],
        buffer: &mut Self::LightBuffer,
    ) -> Result<Self::Light, Status>;

    /// A light without sources. The result points to `buffer`.
    fn residual(
        from: Rgb<Self::OfLight<'_>>,
        sources: &[Source],
        buffer: &mut Self::LightBuffer,
    ) -> Result<Self::Light, Status>;

    /// A light with only its coefficients of an effect. The result points to `buffer`.
    fn mask_light(
        from: Rgb<Self::OfLight<'_>>,
        effect: Effect,
        buffer: &mut Self::LightBuffer,
    ) -> Self::Light;

    /// A material with only its coefficients of an effect. The result points to `buffer`.
    fn mask_material(
        from: Rgb<Self::OfMaterial<'_>>,
        effect: Effect,
        buffer: &mut Self::MaterialBuffer,
    ) -> Self::Material;

    /// A glTF material. The result points to `buffer`.
    fn metallic_roughness(
        base_color: &[Self; 3],
        metallic: Self,
        roughness: Self,
        buffer: &mut Self::MaterialBuffer,
    ) -> Result<Self::Material, Status>;

    /// The tinted and the plain material of a region. The results point to `buffer`.
    fn materials(
        region: &Region,
        buffer: &mut Self::MaterialBuffer,
    ) -> Result<[Self::Material; 2], Status>;

    /// The coefficients of an object with shadows, which an error does not change.
    fn object_coefficients(
        object: &ShadowedObject<'_>,
        light: Rgb<Self::OfLight<'_>>,
        to: &mut Rgb<ObjectCoefficients>,
    ) -> Result<(), Error>;

    /// Memory for a light.
    const LIGHT_BUFFER: Self::LightBuffer;

    /// Highlights for a scene.
    fn highlights(
        of: &Highlights<SOURCES>,
        scene: &Self::Scene,
    ) -> Result<Self::Highlights, Status>;

    /// Adds highlights to the irradiance of a scene.
    fn add(
        highlights: &Self::Highlights,
        irradiance: Rgb<Self::Channel>,
        normal: Self::Normal,
    ) -> Rgb<Self::Channel>;

    fn normal(x: Self, y: Self, z: Self) -> Result<Self::Normal, Status>;
    fn of_disc(pixel: DiscPixel) -> Self::Normal;
    fn of_normal_map(pixel: NormalPixel) -> Self::Normal;
    fn shade(scene: &Self::Scene, normal: Self::Normal) -> Rgb<Self::Channel>;

    /// A normal and its mirror images.
    fn mirrored(normal: Self::Normal) -> [Self::Normal; 4];
    /// The irradiances of these.
    fn shade_mirrored(scene: &Self::Scene, normal: Self::Normal) -> [Rgb<Self::Channel>; 4];

    /// The exponents of a scene, 0 in `f32`.
    fn exponents(scene: &Self::Scene) -> [i32; 3];
    /// An irradiance for C.
    fn irradiance(of: Rgb<Self::Channel>, exponents: [i32; 3]) -> Self::Irradiance;
    /// What exposes irradiances with these exponents.
    fn exposure(exposure: f32, exponents: [i32; 3]) -> Result<Self::Exposure, Error>;
    fn exposed(irradiance: Rgb<Self::Channel>, exposure: Self::Exposure) -> Rgb<Linear>;

    /// Bakes three scenes in `f32`. Returns the exponents of the channels, 0 in `f32`.
    fn bake(
        scene: Rgb<eigenshade::Scene<'_, &[f32]>>,
        size: usize,
        texels: Rgb<&mut [Self::Texel]>,
    ) -> Result<[i32; 3], Status>;
    fn baked(
        size: usize,
        texels: *const Self::Texel,
        length: usize,
        exponents: [i32; 3],
    ) -> Self::Baked;
    /// Size, texels, their number and exponents.
    fn maps(baked: &Self::Baked) -> (usize, Input<Self::Texel>, usize, [i32; 3]);
    /// A look-up in maps of this size and these exponents.
    fn look_up(
        size: usize,
        texels: Rgb<&[Self::Texel]>,
        exponents: [i32; 3],
    ) -> Result<impl Fn(Self::Normal) -> Rgb<Self::Channel>, Status>;
}
