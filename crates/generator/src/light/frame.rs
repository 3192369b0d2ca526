//! Where other programs place the same map.
//!
//! Each program is taken with y up, and with a camera that looks along -z. All of them place the
//! map by a turn about y, none mirrors it.
//!
//! | | middle of an equirectangular map | to its right | source |
//! |---|---|---|---|
//! | this project | -z | +x | [`environment`](super::environment) |
//! | three.js | +x | +z | `equirectUv` of `ShaderChunk/common.glsl.js` |
//! | Blender | +x | +z | Cycles, `direction_to_equirectangular` of `kernel/camera/projection.h` |
//! | Mitsuba 3 | +z | -x | `uv_to_direction` of `emitters/envmap.cpp`, without `to_world` |
//! | OpenEXR | +z | -x | `LatLongMap::direction` of `ImfEnvmap.cpp` |
//! | Filament's cmgen | +z | -x | `equirectangularToCubemap` and `mirrorCubemap` of `CubemapUtils.cpp` |
//!
//! Blender's x right, y forward and z up are x, -z and y here, as in its export to glTF: the camera
//! is that of the front view, which looks along Blender's +y. three.js and cmgen read the six faces
//! of a cube in OpenGL's frame with x reversed, so that pz is +z and px is -x. OpenEXR puts the
//! centers, not the edges, of the first and last texels of a row at the same direction; that half
//! texel is not modeled.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::rotation::Rotation;
use std::f64::consts::{FRAC_PI_2, PI};

/// A program's placement of maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// This project's.
    Eigenshade,
    /// Of three.js.
    ThreeJs,
    /// Blender's, its z up turned to y up.
    Blender,
    /// Mitsuba's.
    Mitsuba,
    /// That of OpenEXR's latitude-longitude maps.
    OpenExr,
    /// That of Filament's cmgen.
    Filament,
}

impl Frame {
    /// The turn about y from the light of a map in the project's frame to this frame.
    ///
    /// # Errors
    ///
    /// For a cube, if the program does not read cubes of six faces.
    pub fn turn(self, is_cube: bool) -> Result<Rotation> {
        let alpha = match (self, is_cube) {
            (Self::Eigenshade, _) => 0.0,
            (Self::ThreeJs | Self::Blender, false) => -FRAC_PI_2,
            (Self::Mitsuba | Self::OpenExr, false)
            | (Self::ThreeJs, true)
            | (Self::Filament, _) => PI,
            (Self::Blender | Self::Mitsuba | Self::OpenExr, true) => {
                return Err(Error::new(
                    "this frame is defined for equirectangular maps, and the map is a cube",
                    "leave out --frame, or give `threejs`, `filament` or an equirectangular map",
                ));
            }
        };
        Ok(Rotation { alpha, beta: 0.0, gamma: 0.0 })
    }
}
