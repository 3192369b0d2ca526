//! The shipped lights and materials by name. A program contains only the presets that it names.
//!
//! ```
//! # #[cfg(feature = "baked")] {
//! use eigenshade::presets::light::PARK;
//! use eigenshade::presets::material::GOLD_METALLIC_PAINT;
//! use eigenshade::{Normal, sphere};
//!
//! let scene = sphere::color::scene(PARK, GOLD_METALLIC_PAINT)?;
//! let color = scene.shade(Normal::new(0.0, 0.6, 0.8)?);
//! assert!(color.r > color.b);
//! # }
//! # Ok::<(), eigenshade::Error>(())
//! ```
//!
//! The build script reads the CSV files in `tables/inputs`: all lights, the materials in color, and
//! sintered PTFE. The program's command `eigenshade list` prints the names of these presets and of
//! 61 more gray materials in lower case.

use crate::color::Rgb;
use crate::known_table::checked;

/// A light of degree 9 in three channels: 1,200 bytes.
pub type Light = Rgb<crate::Light<'static>>;

/// A material of order 7 in three channels: 480 bytes, or 160 if it is gray.
pub type Material = Rgb<crate::Material<'static>>;

/// Captured light, by the names of its environment maps.
///
/// `tables/README.md` has the sources of the maps.
#[expect(clippy::approx_constant, reason = "numbers of a file")]
pub mod light {
    use super::{Light, checked};
    use crate::color::Rgb;
    include!(concat!(env!("OUT_DIR"), "/preset_lights.rs"));

    /// The same lights in integers, quantized by the compiler: 612 bytes each.
    pub mod q15 {
        use super::checked;
        use crate::color::Rgb;
        use crate::q15;
        use crate::q15::{Q15, quantized_light};

        /// A light of degree 9 in three channels.
        pub type Light = Rgb<q15::Light<'static>>;

        include!(concat!(env!("OUT_DIR"), "/preset_lights_q15.rs"));
    }
}

/// Real materials in color.
///
/// The materials are the published fits of J. Low, J. Kronander, A. Ynnerman and J. Unger, "BRDF
/// Models for Accurate and Efficient Rendering of Glossy Surfaces", ACM Transactions on Graphics
/// 31, 2012, to the MERL measurements, and one standard of NIST's, a matte white. Order 7 cannot
/// represent sharp gloss: chrome looks like a blurred and ringing version of itself. The fits are
/// attenuated by a window of width 40, which makes their pictures ring less. Each constant states
/// the screen error of its pictures against direct integration; `docs/accuracy.md` describes the
/// measurement.
pub mod material {
    use super::{Material, checked};
    use crate::color::Rgb;
    include!(concat!(env!("OUT_DIR"), "/preset_materials.rs"));

    /// The same materials in integers, quantized by the compiler: 264 bytes, or 88 if it is gray.
    pub mod q15 {
        use super::checked;
        use crate::color::Rgb;
        use crate::q15;
        use crate::q15::MaterialBuffer;

        /// A material of order 7 in three channels.
        pub type Material = Rgb<q15::Material<'static>>;

        include!(concat!(env!("OUT_DIR"), "/preset_materials_q15.rs"));
    }
}

/// Up to 16 small sources of the captured lights that have maps, 28 bytes each, in the order of
/// their worth: the first n are the set of n. [`Highlights`](crate::Highlights) shade the sources,
/// and [`Gloss::fewest_sources`](crate::Gloss::fewest_sources) returns the number that a material
/// needs.
///
/// ```
/// # #[cfg(feature = "baked")] {
/// use eigenshade::presets::{gloss, light::STUDIO, material::GOLD_METALLIC_PAINT, sources};
/// use eigenshade::{Buffer, Highlights, Normal, Rotation, sphere};
///
/// let gold = gloss::GOLD_METALLIC_PAINT;
/// let count = gold.fewest_sources(&sources::errors::STUDIO, 0.02).unwrap_or(8);
/// let (lamps, _) = sources::STUDIO.split_at(count);
/// let rest = STUDIO.residual::<100>(lamps)?;
/// let scene = sphere::color::scene(rest.lights()?, GOLD_METALLIC_PAINT)?;
/// let highlights = Highlights::<16>::new(&gold, lamps)?;
///
/// let normal = Normal::new(-0.5, 0.4, 0.768)?;
/// let color = scene.shade(normal) + highlights.shade(normal);
/// assert!(color.r > color.b);
///
/// // A light that turns: its rest and its sources turn.
/// let turn = Rotation::from_quaternion([0.0, 0.3, 0.0, 1.0])?;
/// let rest = rest.lights()?.turned::<100>(&turn)?;
/// let scene = sphere::color::scene(rest.lights()?, GOLD_METALLIC_PAINT)?;
/// let mut lamps = Buffer::<_, 16>::from_slice(lamps).unwrap_or_default();
/// lamps.iter_mut().for_each(|lamp| *lamp = lamp.turned(turn));
/// let highlights = Highlights::<16>::new(&gold, &lamps)?;
/// assert_ne!(scene.shade(normal) + highlights.shade(normal), color);
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
pub mod sources {
    use crate::source::Source;

    /// Errors of six metals: see [`Gloss::fewest_sources`](crate::Gloss::fewest_sources).
    pub type Errors = [f32; 6];

    include!(concat!(env!("OUT_DIR"), "/preset_sources.rs"));
}

/// The gloss of the materials in color: a GGX lobe over a matte base, fitted to each.
///
/// [`Gloss::needs_sources`](crate::Gloss::needs_sources) is true for materials whose pictures
/// sources improve. Each constant states how far its lobe is off.
#[expect(clippy::approx_constant, reason = "numbers of a file")]
pub mod gloss {
    use crate::gloss::Gloss;
    include!(concat!(env!("OUT_DIR"), "/preset_gloss.rs"));
}
