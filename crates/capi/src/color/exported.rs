//! The functions in color, in each format.
#![expect(unsafe_code, reason = "exported symbols")]

use super::format::{Channels, Format};
use super::glossy::{GlossyF32, GlossyQ15, Source, color_residual};
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
use crate::boundary::{Input, Output};
use crate::export::export;
use crate::float;
use crate::status::Status;
use eigenshade::{Display, Q15};

type Lights<F> = Channels<<F as Format>::Light>;
type Materials<F> = Channels<<F as Format>::Material>;
type Transfers<F> = Channels<<F as Format>::Transfer>;
type Scenes<F> = Channels<<F as Format>::Scene>;
type Angle<F> = <F as Format>::Angle;
type Baked<F> = <F as Format>::Baked;

macro_rules! exported {
    ($declarations:ident $format:literal $number:ty, $glossy:ty) => {
        export! { $declarations $format
            color_scene<$number>(
                light: Input<Lights<$number>>, material: Input<Materials<$number>>,
                scene: Output<Scenes<$number>>
            )
            color_transfer<$number>(
                material: Input<Materials<$number>>, transfer: Output<Transfers<$number>>
            )
            color_relight<$number>(
                transfer: Input<Transfers<$number>>, light: Input<Lights<$number>>,
                scene: Output<Scenes<$number>>
            )
            color_shade<$number>(
                scene: Input<Scenes<$number>>, x: $number, y: $number, z: $number,
                irradiance: Output<[<$number as Format>::Irradiance; 3]>
            )
            color_turn<$number>(
                from: Input<Lights<$number>>, quaternion: Input<[Angle<$number>; 4]>,
                buffer: Output<<$number as Format>::LightBuffer>, to: Output<Lights<$number>>
            )
            color_turn_about_view<$number>(
                from: Input<Lights<$number>>, cosine_and_sine: Input<[Angle<$number>; 2]>,
                buffer: Output<<$number as Format>::LightBuffer>, to: Output<Lights<$number>>
            )
            color_metallic_roughness<$number>(
                base_color: Input<[$number; 3]>, metallic: $number, roughness: $number,
                buffer: Output<<$number as Format>::MaterialBuffer>, to: Output<Materials<$number>>
            )
            color_disc_row<$number>(
                scene: Input<Scenes<$number>>, diameter: usize, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_normal_map_row<$number>(
                scene: Input<Scenes<$number>>, map: Input<NormalMap>, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_bake<$number>(
                scene: Input<Channels<float::Scene>>, size: usize,
                texels: Output<<$number as Format>::Texel>, length: usize,
                baked: Output<Baked<$number>>
            )
            color_baked_shade<$number>(
                baked: Input<Baked<$number>>, x: $number, y: $number, z: $number,
                irradiance: Output<[<$number as Format>::Irradiance; 3]>
            )
            color_baked_disc_row<$number>(
                baked: Input<Baked<$number>>, diameter: usize, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_baked_normal_map_row<$number>(
                baked: Input<Baked<$number>>, map: Input<NormalMap>, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_residual<$number>(
                from: Input<Channels<float::Light>>, sources: Input<Source>, count: usize,
                buffer: Output<<$number as Format>::LightBuffer>, to: Output<Lights<$number>>
            )
            color_glossy_shade<$number>(
                glossy: Input<$glossy>, x: $number, y: $number, z: $number,
                irradiance: Output<[<$number as Format>::Irradiance; 3]>
            )
            color_glossy_disc_row<$number>(
                glossy: Input<$glossy>, diameter: usize, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
            color_glossy_normal_map_row<$number>(
                glossy: Input<$glossy>, map: Input<NormalMap>, row: usize, exposure: f32,
                display: Input<Display>, pixels: Output<u16>, length: usize
            )
        }
    };
}

exported!(f32_functions "f32" f32, GlossyF32);
exported!(q15_functions "q15" Q15, GlossyQ15);
