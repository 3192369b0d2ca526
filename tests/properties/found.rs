//! What the search found: each made a property fail as it was stated first.

use crate::objects::{Energy, energies, of_object, prefix};
use crate::samples::{Sample, Shape};
use eigenshade_generator::object::geometry::Geometry;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_table::scene::LightRotation;
use eigenshade_testing::largest;

/// Projection and synthesis of the first components of an object, made alone or with all, of the
/// largest number: the same sums in another order, which is the same order and so the same bits on
/// some hosts.
const PREFIX: f64 = 1e-13;

/// U over modes of them: divided by singular values down to the cut-off of 8e-11, which few
/// pictures call for.
const PREFIX_MODES: f64 = 1e-11;

/// A light, a material, and nothing odd about them.
const PLAIN: Sample = Sample {
    degree: 2,
    order: 2,
    lights: 1,
    materials: 1,
    seed: 0,
    spread: 0.0,
    empty: 0.0,
    standard: false,
    unit_ambient: false,
    cutoff: 1e-10,
    modes: 0,
    copies: None,
};

/// A table of fewer components is the beginning of one of more, but not to the last bits: products
/// of matrices of other sizes are summed in another order, and U over modes divides by
/// singular values down to the cut-off.
#[test]
fn a_prefix_at_a_cutoff_of_8e_11() {
    let sample = Sample {
        degree: 7,
        order: 3,
        lights: 3,
        materials: 2,
        seed: 3_831_731_077_815_532_656,
        spread: 1.036_676_335_429_227_3,
        empty: 0.835_783_940_812_641_3,
        unit_ambient: true,
        cutoff: 8.020_594_152_693_847e-11,
        ..PLAIN
    };
    let shape = Shape::Line(19, -1.630_021_054_556_980_4);
    let apart = prefix(&sample, &shape, LightRotation::None, 0.061_569_027_091_713_41);
    println!("projection, synthesis, U: {apart:?}");
    let [projection, synthesis, modes] = apart;
    assert!(projection <= PREFIX && synthesis <= PREFIX && modes <= PREFIX_MODES);
}

/// The energies of an image and of the mean image that was subtracted cancel: of what is left,
/// nothing need be right but against both.
#[test]
fn energy_of_an_image_that_is_the_mean() {
    let sample = Sample {
        degree: 0,
        order: 4,
        seed: 9_700_070_298_442_501_422,
        spread: 8.0,
        empty: 0.853_114_517_427_323,
        standard: true,
        cutoff: 8.943_863_905_684_213e-10,
        copies: Some(6.279_485_471_267_36e-15),
        ..PLAIN
    };
    assert_dark(&sample, &Shape::Line(7, 2.701_346_374_281_847_8));
}

/// A rim is where modes show that are nothing over the sphere, and where images are dark.
#[test]
fn energy_of_a_dark_rim() {
    let sample = Sample {
        lights: 3,
        seed: 441_869_589_936_860_732,
        spread: 52.924_476_592_021_24,
        standard: true,
        cutoff: 1e-5,
        ..PLAIN
    };
    assert_dark(&sample, &Shape::Rim(6));
}

/// |d|² + residual is off by more of the energy than a bright image allows, and by as little of its
/// coefficients as any.
fn assert_dark(sample: &Sample, shape: &Shape) {
    let found = energies(sample, shape, LightRotation::Any);
    found.iter().for_each(|energy| println!("{:e}, {:e} allowed", energy.apart, energy.allowed()));
    assert!(found.iter().all(Energy::holds));
    // Of its own energy it is off by more: nothing that has to be so elsewhere.
    println!("{:e}", largest(found.iter().map(|energy| energy.apart / energy.scale)));
}

/// The cut-off takes a part of the constant: refused, by its name.
#[test]
fn a_cutoff_that_takes_the_constant() {
    let sample =
        Sample { degree: 3, order: 1, seed: 381_324_519_401_728_109, cutoff: 0.019, ..PLAIN };
    let shape = Shape::Any(3, 5.524_482_675_697_389_5);
    let (_, loaded, listed) = of_object(&sample, &shape, LightRotation::Any);
    let refused = Loaded { geometry: Geometry::Listed(listed), ..loaded }.build();
    let message = refused.expect_err("a part of the constant").to_string();
    assert!(message.contains("rank_cutoff"), "{message}");
}
