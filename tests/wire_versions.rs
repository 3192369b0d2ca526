//! Wire files are read, wherever they lie, and give what they gave when they were made.

use crate::wire_files as files;
use eigenshade::wire::{WireError, aligned};
use eigenshade::{Basis, GeneralBasis, Q15, Q31, quantized};
use files::{
    EFFECTS, GENERAL, INTEGERS_15, INTEGERS_31, LONG, MEAN, SPHERE, TURNED, TURNED_15, assert_same,
    facing_15, facing_31, floats, general, integers, room,
};

/// d from a wire file in f32, of the largest: 2^-24 times some twenty roundings.
const WIRE_F32: f32 = 1e-6;

/// d from a wire file in 15 bits, of the largest: a few roundings of 2^-15.
const WIRE_Q15: f32 = 2e-4;

/// d from a wire file in 31 bits, of the largest: the comparison itself is in f32.
const WIRE_Q31: f32 = 2e-7;

#[test]
fn tables_of_all_effects_are_read() {
    for (table, bytes) in [("sphere", &SPHERE.0), ("mean", &MEAN.0)] {
        let basis = Basis::<f32>::from_bytes(bytes).expect("a wire file");
        assert_same(table, &floats(&basis).0, WIRE_F32);
    }
    let basis = GeneralBasis::<f32>::from_bytes(&GENERAL.0).expect("a wire file");
    assert_same("general", &general(&basis), WIRE_F32);
    let basis = quantized::Basis::<Q15>::from_bytes(&INTEGERS_15.0).expect("a wire file");
    assert_same("sphere", &integers(&basis, facing_15()), WIRE_Q15);
    let basis = quantized::Basis::<Q31>::from_bytes(&INTEGERS_31.0).expect("a wire file");
    assert_same("sphere", &integers(&basis, facing_31()), WIRE_Q31);
}

#[test]
fn tables_of_some_effects_are_read() {
    for (table, bytes) in [("effects", &EFFECTS.0), ("turned", &TURNED.0)] {
        let basis = Basis::<f32>::from_bytes(bytes).expect("a wire file");
        assert!(!basis.effects().is_all());
        assert_same(table, &floats(&basis).0, WIRE_F32);
    }
    let basis = quantized::Basis::<Q15>::from_bytes(&TURNED_15.0).expect("a wire file");
    assert!(!basis.effects().is_all());
    assert_same("turned", &integers(&basis, facing_15()), WIRE_Q15);
}

/// The last number is an irradiance.
#[test]
fn polynomials_in_two_halves_are_read() {
    let basis = Basis::<f32>::from_bytes(&LONG.0).expect("a wire file");
    assert!(basis.parts().lengths.iter().any(|length| (17..=32).contains(length)));
    let (mut found, irradiance) = floats(&basis);
    found.push(irradiance);
    assert_same("long", &found, WIRE_F32);
}

/// At every place but multiples of four, and put right.
#[test]
fn alignment_is_asked_for() {
    let mut places = vec![0_u32; SPHERE.0.len() / 4 + 1];
    for beyond in 1..4 {
        let bytes: Vec<u8> = [&vec![0; beyond], &SPHERE.0, &vec![0; 4 - beyond]].concat();
        let bytes = aligned(&bytes, &mut places).expect("room");
        let refused = Basis::<f32>::from_bytes(&bytes[beyond..]).expect_err("not aligned");
        assert_eq!(refused, WireError::Alignment { beyond });
        assert!(refused.to_string().contains("wire::aligned"));
        let mut room = room(&SPHERE.0);
        let copied = aligned(&bytes[beyond..][..SPHERE.0.len()], &mut room).expect("room");
        assert!(Basis::<f32>::from_bytes(copied).is_ok());
    }
}
