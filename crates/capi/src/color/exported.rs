//! The functions in color, in each format.
#![expect(unsafe_code, reason = "exported symbols")]

use super::format::Channels;
use super::glossy::{GlossyF32, GlossyQ15, Source, color_residual};
use super::meter::{
    color_meter_disc_row, color_meter_disc_row as color_glossy_meter_disc_row,
    color_meter_normal_map_row, color_meter_normal_map_row as color_glossy_meter_normal_map_row,
};
use super::rows::{
    NormalMap, color_disc_row, color_disc_row as color_baked_disc_row,
    color_disc_row as color_glossy_disc_row, color_normal_map_row,
    color_normal_map_row as color_baked_normal_map_row,
    color_normal_map_row as color_glossy_normal_map_row,
};
use super::steps::{
    color_bake, color_metallic_roughness, color_relight, color_scene, color_shade,
    color_shade as color_baked_shade, color_shade as color_glossy_shade, color_transfer,
    color_turn, color_turn_about_view,
};
use super::{float as of_float, q15 as of_q15};
use crate::boundary::{Input, Output};
use crate::export::export;
use crate::status::Status;
use crate::{float, integers};
use eigenshade::{Display, Meter, Q15};

macro_rules! exported {
    (
        $declarations:ident $format:literal $number:ty, angle $angle:ty,
        irradiance $irradiance:ty, texel $texel:ty, buffers $buffers:ident,
        $light:ty, $material:ty, $transfer:ty, $scene:ty, $glossy:ty
    ) => {
        export! { $declarations $format
            color_scene<$number>(
                light: Input<Channels<$light>>, material: Input<Channels<$material>>,
                scene: Output<Channels<$scene>>
            )
            color_transfer<$number>(
                material: Input<Channels<$material>>, transfer: Output<Channels<$transfer>>
            )
            color_relight<$number>(
                transfer: Input<Channels<$transfer>>, light: Input<Channels<$light>>,
                scene: Output<Channels<$scene>>
            )
            color_shade<$number>(
                scene: Input<Channels<$scene>>, x: $number, y: $number, z: $number,
                irradiance: Output<[$irradiance; 3]>
            )
            color_turn<$number>(
                from: Input<Channels<$light>>, quaternion: Input<[$angle; 4]>,
                buffer: Output<$buffers::LightBuffer>, to: Output<Channels<$light>>
            )
            color_turn_about_view<$number>(
                from: Input<Channels<$light>>, cosine_and_sine: Input<[$angle; 2]>,
                buffer: Output<$buffers::LightBuffer>, to: Output<Channels<$light>>
            )
            color_metallic_roughness<$number>(
                base_color: Input<[$number; 3]>, metallic: $number, roughness: $number,
                buffer: Output<$buffers::MaterialBuffer>, to: Output<Channels<$material>>
            )
            color_disc_row<$number>(
                scene: Input<Channels<$scene>>, diameter: usize, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_normal_map_row<$number>(
                scene: Input<Channels<$scene>>, map: Input<NormalMap>, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_meter_disc_row<$number>(
                scene: Input<Channels<$scene>>, diameter: usize, row: usize, meter: Output<Meter>
            )
            color_meter_normal_map_row<$number>(
                scene: Input<Channels<$scene>>, map: Input<NormalMap>, row: usize,
                meter: Output<Meter>
            )
            color_bake<$number>(
                scene: Input<Channels<float::Scene>>, size: usize,
                texels: Output<$texel>, length: usize, baked: Output<$buffers::Baked>
            )
            color_baked_shade<$number>(
                baked: Input<$buffers::Baked>, x: $number, y: $number, z: $number,
                irradiance: Output<[$irradiance; 3]>
            )
            color_baked_disc_row<$number>(
                baked: Input<$buffers::Baked>, diameter: usize, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_baked_normal_map_row<$number>(
                baked: Input<$buffers::Baked>, map: Input<NormalMap>, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_residual<$number>(
                from: Input<Channels<float::Light>>, sources: Input<Source>, count: usize,
                buffer: Output<$buffers::LightBuffer>, to: Output<Channels<$light>>
            )
            color_glossy_shade<$number>(
                glossy: Input<$glossy>, x: $number, y: $number, z: $number,
                irradiance: Output<[$irradiance; 3]>
            )
            color_glossy_disc_row<$number>(
                glossy: Input<$glossy>, diameter: usize, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_glossy_normal_map_row<$number>(
                glossy: Input<$glossy>, map: Input<NormalMap>, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_glossy_meter_disc_row<$number>(
                glossy: Input<$glossy>, diameter: usize, row: usize, meter: Output<Meter>
            )
            color_glossy_meter_normal_map_row<$number>(
                glossy: Input<$glossy>, map: Input<NormalMap>, row: usize, meter: Output<Meter>
            )
        }
    };
}

exported!(
    f32_functions "f32" f32, angle f32, irradiance f32, texel f32, buffers of_float,
    float::Light, float::Material, float::Transfer, float::Scene, GlossyF32
);
exported!(
    q15_functions "q15" Q15, angle i32, irradiance i32, texel i16, buffers of_q15,
    integers::Light, integers::Material, integers::Transfer, integers::Scene,
    GlossyQ15
);
