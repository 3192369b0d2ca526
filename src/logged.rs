//! Checks at compile time that `defmt` can log every public type.

use crate::bake::{BakedMap, MapPoint};
use crate::bake_integer::IntegerMap;
use crate::basis::Basis;
use crate::error::{Argument, Error};
use crate::estimate::Estimate;
use crate::general::GeneralBasis;
use crate::index::effect::{Effect, Effects};
use crate::index::record::floats::{GeneralParts, Parts};
use crate::index::record::{Coupling, Pass, ProfilePlace, Row};
use crate::light::{Light, Window};
use crate::material::Material;
use crate::mathematics::{Libm, SinglePrecision};
use crate::normal::{Normal, Normals};
use crate::q15;
use crate::rotation::Rotation;
use crate::scene::{Scene, SceneBuffer};
use crate::shade::NegativePolicy;
use crate::transfer::Transfer;
use crate::truncation::{Shape, Tolerance, Truncation};
use crate::wire::{Aligned, Fault, Header, NumberFormat, WireError};

const fn can_be_logged<T: defmt::Format>() {}

const _: () = {
    type Buffer = SceneBuffer<f32, 8>;
    can_be_logged::<(Light<'_, f32>, Material<'_, f32>, Normal<f32>, Normals<'_, f32>)>();
    can_be_logged::<(Basis<'_, f32>, GeneralBasis<'_, f32>)>();
    can_be_logged::<(Parts<'_, f32>, GeneralParts<'_, f32>)>();
    can_be_logged::<(Coupling, Pass, ProfilePlace, Row, Error, Argument, Effect, Effects)>();
    can_be_logged::<(Transfer<f32, 8>, Estimate<'_, f32, 8>, Scene<'_, Buffer>)>();
    can_be_logged::<(BakedMap<f32, Buffer>, IntegerMap<&[i16]>)>();
    can_be_logged::<(Tolerance<f32>, Truncation<f32>, Shape<'_>, Fault, WireError)>();
    can_be_logged::<(NumberFormat, Header, Aligned<u8>)>();
    can_be_logged::<(q15::Basis<'_>, q15::Parts<'_>, q15::Profile)>();
    can_be_logged::<(q15::Light<'_>, q15::Material<'_>)>();
    can_be_logged::<(q15::Normal, q15::Coefficients<8>)>();
    can_be_logged::<(q15::Transfer<'_>, q15::Estimate<'_, 8>)>();
    can_be_logged::<(MapPoint<i16>, Rotation<f32>, Window<f32>, NegativePolicy)>();
    can_be_logged::<(q15::Scene<'_, [i32; 8]>, q15::TransferBuffer<8, 8>)>();
    can_be_logged::<(Libm, SinglePrecision)>();
    #[cfg(feature = "micromath")]
    can_be_logged::<crate::mathematics::Micromath>();
};
