//! Checks at compile time that `defmt` can log every public type.

use crate::bake::BakedMap;
use crate::basis::{Basis, Parts};
use crate::error::{Argument, Error};
use crate::estimate::Estimate;
use crate::index::effect::{Effect, Effects};
use crate::index::record::{Azimuth, Pass, ProfilePlace, Row, Run};
use crate::light::{Light, Window};
use crate::material::Material;
use crate::normal::{Normal, Normals};
use crate::q15;
use crate::rotation::Rotation;
use crate::scene::Scene;
use crate::shade::NegativePolicy;
use crate::transfer::Transfer;
use crate::truncation::{Shape, Tolerance, Truncation};
use crate::wire::{Aligned, Fault, Header, NumberFormat, WireError};

const fn can_be_logged<T: defmt::Format>() {}

const _: () = {
    type Buffer = crate::buffer::Buffer<f32, 8>;
    can_be_logged::<(Light<'_>, Material<'_>, Normal, Normals<'_>)>();
    can_be_logged::<(Basis<'_>, Parts<'_>)>();
    can_be_logged::<(Azimuth, Pass, ProfilePlace, Row, Run, Error, Argument, Effect, Effects)>();
    can_be_logged::<(Transfer<8>, Estimate<'_, 8>, Scene<'_, Buffer>)>();
    can_be_logged::<(BakedMap<Buffer>, q15::BakedMap<&[i16]>)>();
    can_be_logged::<(Tolerance, Truncation, Shape<'_>, Fault, WireError)>();
    can_be_logged::<(NumberFormat, Header, Aligned<u8>)>();
    can_be_logged::<(q15::Basis<'_>, q15::Parts<'_>, q15::Profile)>();
    can_be_logged::<(q15::Light<'_>, q15::Material<'_>)>();
    can_be_logged::<(q15::Normal, q15::Coefficients<8>)>();
    can_be_logged::<(q15::Transfer<'_>, q15::Estimate<'_, 8>)>();
    can_be_logged::<(q15::MapPoint, Rotation, Window, NegativePolicy)>();
    can_be_logged::<(q15::Scene<'_, [i32; 8]>, q15::TransferBuffer<8, 8>)>();
};
