//! What holds for every object under every statistics of the light.

use crate::samples::{Sample, Shape, samples, shapes, strangers};
use crate::sphere::{off_affine, squares};
use crate::{config, tolerances};
use eigenshade_generator::basis::moments::LightStatistics;
use eigenshade_generator::basis::span::Span;
use eigenshade_generator::basis::{gram, moments};
use eigenshade_generator::object::geometry::WeightedNormals;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::database::Named;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::selection::Kept;
use eigenshade_table::scene::LightRotation;
use eigenshade_table::{Table, mode};
use eigenshade_testing::fixtures::Projector;
use eigenshade_testing::largest;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::{self, Pictures, eigenvalues, modes, table};
use nalgebra::DMatrix;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Images over an object by d against the direct sum, in amplitude, of |L| |b|: modes whose images
/// over the sphere are below 1e-13 are in no span, at one normal of the rim they are a thousand
/// times that, and an image has a tenth of them; 1.5e-13 was the most in a thousand random objects.
/// The part that the rank's cut-off removes comes on top.
const OBJECT_PARSEVAL: f64 = 1e-12;

/// A small scene of the sample, with its selection of modes, whose light turns like this, and the
/// normals of an object.
pub fn of_object(
    sample: &Sample,
    shape: &Shape,
    rotation: LightRotation,
) -> (Sample, Loaded, WeightedNormals) {
    let (degree, order) = (sample.degree % 5, sample.order % 5);
    // Fewer than there are, of most degrees and orders.
    let modes = sample.modes % 300;
    let small = Sample { degree, order, modes, spread: sample.spread.min(8.0), ..sample.clone() };
    let mut loaded = small.scene();
    loaded.scene.light.rotation = rotation;
    let listed = shape.normals(degree, &mut Numbers(sample.seed ^ 7));
    (small, loaded, listed)
}

fn rotations() -> impl Strategy<Value = LightRotation> {
    use LightRotation::{Any, None, Vertical};
    prop_oneof![Just(Any), Just(None), Just(Vertical)]
}

/// An upper bound of what the cut-offs take of the pictures: modes below `rank_cutoff` of
/// the largest singular value, over the object and over the span.
fn cut(loaded: &Loaded, listed: &WeightedNormals, modes: &DMatrix<f64>) -> f64 {
    let gram = gram::of_sphere(loaded.lights.degree, loaded.materials.order);
    let span = Span::new(&gram, &Kept { selection: vec![] });
    let span = span.expect("finite");
    let shown = span.factor(listed).norm_l2();
    let cutoff = loaded.scene.basis.rank_cutoff;
    (cutoff + tolerances::ORTHONORMAL_ROUNDING) * (modes.norm() + shown * span.largest())
}

/// The root of the trace of V_c.
fn size(loaded: &Loaded) -> f64 {
    let scene = &loaded.scene;
    let weights = moments::equal(loaded.lights.entries.len());
    let light =
        LightStatistics::new(&loaded.lights, scene.light.normalize, scene.light.rotation, &weights);
    let of_light: f64 = light.expect("positive").second.iter().flatten().map(|v| v * v).sum();
    let of_materials: f64 =
        loaded.materials.entries.iter().flat_map(Named::luminance).map(|b| b * b).sum();
    (of_light * of_materials / loaded.materials.entries.len() as f64).sqrt()
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// U over modes: a row a mode in the order of [`Pictures::modes`], a column an eigenimage.
fn over_modes(table: &Table) -> DMatrix<f64> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let places = modes(degree, order);
    let general = table.general.as_ref().expect("a general table");
    let mut u = DMatrix::zeros(places.len(), general.eigenvalues.len());
    for (f, function) in table.components.iter().enumerate() {
        let profile = &table.profiles[function.profile];
        let sign = if function.order < 0 && function.order % 2 != 0 { -1.0 } else { 1.0 };
        let indices = mode::indices(degree, order, profile.azimuth);
        for ((l, o, p, q), value) in indices.zip(&profile.modes) {
            let at = (l, function.order as isize, o, p, q);
            let row = places.iter().position(|place| *place == at).expect("a mode");
            for i in 0..u.ncols() {
                u[(row, i)] += sign * value * general.modes[i * table.components.len() + f];
            }
        }
    }
    u
}

/// |d|² + residual against Σ w (I - mean)² over an object's normals, which is cᵀMc where there is no mean
/// image.
#[derive(Clone, Copy, Debug)]
pub struct Energy {
    /// Their difference.
    pub apart: f64,
    /// The larger of |d|² and the energy.
    pub scale: f64,
    /// |L| |b|, and that of the mean image that was subtracted.
    size: f64,
    cutoff: f64,
}

impl Energy {
    /// What amplitudes that are right to a share of `size` leave.
    pub fn allowed(&self) -> f64 {
        let amplitude = (OBJECT_PARSEVAL + self.cutoff) * self.size;
        amplitude * (self.scale.sqrt() + amplitude)
    }

    pub fn holds(&self) -> bool {
        self.apart <= self.allowed()
    }
}

/// Those of a pair that is not of the database, and of one that is.
pub fn energies(sample: &Sample, shape: &Shape, rotation: LightRotation) -> [Energy; 2] {
    let (small, loaded, listed) = of_object(&sample.whole(), shape, rotation);
    let table = table(&loaded, &listed);
    let ([stranger, _], [other, _]) = strangers(&small);
    let of_database =
        (loaded.lights.entries[0].luminance(), loaded.materials.entries[0].luminance());
    [(stranger, other), of_database].map(|(light, on)| {
        let [kept, residual, about_mean] =
            squares(&table, [&light, &on], listed.normals(), listed.weights());
        let of_mean = if small.standard { size(&loaded) } else { 0.0 };
        Energy {
            apart: (kept + residual - about_mean).abs(),
            scale: about_mean.max(kept),
            size: norm(&light) * norm(&on) + of_mean,
            cutoff: loaded.scene.basis.rank_cutoff,
        }
    })
}

/// How far a table of a share of the components is from the beginning of the whole one, of the
/// largest number: its projection, its synthesis, and U over modes. Eigenvalues are the same.
pub fn prefix(sample: &Sample, shape: &Shape, rotation: LightRotation, share: f64) -> [f64; 3] {
    let (_, mut loaded, listed) = of_object(sample, shape, rotation);
    let all = table(&loaded, &listed);
    let count = 1 + (share * all.count() as f64) as usize;
    loaded.scene.basis.components = Some(count);
    let few = table(&loaded, &listed);
    assert_eq!(few.count(), count.min(all.count()));
    let [a, b] = [&few, &all].map(|table| table.general.as_ref().expect("general"));
    assert_eq!(&a.eigenvalues[..], &b.eigenvalues[..few.count()]);
    assert!(eigenvalues(&all).is_sorted_by(|a, b| a >= b));
    // The same sums, in the order that a matrix of another size asks for.
    [(&a.projection, &b.projection), (&a.synthesis, &b.synthesis), (&a.modes, &b.modes)].map(
        |(a, b)| {
            let apart = largest(a.iter().zip(b).map(|(a, b)| a - b));
            if apart > 0.0 { apart / largest(a.iter().copied()) } else { 0.0 }
        },
    )
}

proptest! {
    #![proptest_config(config())]

    /// UᵀMU = I, and Σ w U_i U_j over the normals, by the runtime.
    #[test]
    fn eigenimages_are_orthonormal(
        sample in samples(), shape in shapes(), rotation in rotations()
    ) {
        let (small, loaded, listed) = of_object(&sample, &shape, rotation);
        // A density is hundreds of normals, and every mode is summed at each.
        prop_assume!(!matches!(shape, Shape::Slants(_)));
        let table = table(&loaded, &listed);
        let pictures = Pictures::new(&loaded, &listed);
        let modes = pictures.modes(small.degree, small.order);
        let cut = cut(&loaded, &listed, &modes);
        let size = size(&loaded);
        // How much of each eigenimage the cut-offs may take.
        let general = table.general.as_ref().expect("a general table");
        let lost: Vec<f64> = general
            .eigenvalues
            .iter()
            .map(|value| value.map_or(4.0 * cut, |value| cut * size / value.sqrt()))
            .collect();
        let by_modes = &modes * over_modes(&table);
        // Without the mean image, beside which an eigenimage may be nothing.
        let mut bare = table.clone();
        if let Some(general) = &mut bare.general {
            general.mean.clear();
            general.mean_coefficients.clear();
        }
        let projector = Projector::new(&bare);
        let mut seen = by_modes.clone();
        for i in 0..seen.ncols() {
            for (k, value) in projector.eigenimage(i, &pictures.normals).iter().enumerate() {
                seen[(k, i)] = pictures.weights[k].sqrt() * value;
            }
        }
        for (images, of) in [(by_modes, "U over modes"), (seen, "pixels")] {
            let products = images.tr_mul(&images);
            for i in 0..products.nrows() {
                for j in 0..=i {
                    let off = (products[(i, j)] - f64::from(u8::from(i == j))).abs();
                    let allowed = lost[i] + lost[j]
                        + tolerances::ORTHONORMAL_ROUNDING / loaded.scene.basis.rank_cutoff
                        + tolerances::ORTHONORMAL_NODES;
                    prop_assert!(off <= allowed, "{of}: {off:e} of {allowed:e} at {i}, {j}");
                }
            }
        }
    }

    /// |d|² + residual = Σ w (I - mean)².
    #[test]
    fn energy_over_an_object_is_kept_or_left(
        sample in samples(), shape in shapes(), rotation in rotations()
    ) {
        for energy in energies(&sample, &shape, rotation) {
            prop_assert!(energy.holds(), "{energy:?}");
        }
    }

    /// Affine, for the mean image is subtracted: weights sum to 1.
    #[test]
    fn projection_over_an_object_is_linear(
        sample in samples(), shape in shapes(), rotation in rotations(), weight in -3.0f64..3.0
    ) {
        let (small, loaded, listed) = of_object(&sample, &shape, rotation);
        let projector = Projector::new(&table(&loaded, &listed));
        let strangers = strangers(&small);
        let ([light, _], [_, on]) = &strangers;
        // A mean image that is far brighter than the strangers is subtracted from each.
        let mean = largest(projector.project(&vec![0.0; light.len()], on));
        let apart = off_affine(&projector, strangers, weight, mean);
        prop_assert!(apart <= tolerances::DENSE_PROJECTION, "{apart:e}");
    }

    /// Fewer components are the first of more.
    #[test]
    fn fewer_components_of_an_object_are_a_prefix(
        sample in samples(), shape in shapes(), rotation in rotations(), share in 0.0f64..1.0
    ) {
        // U is divided by singular values down to the cut-off.
        let rounding = tolerances::ORTHONORMAL_NODES + tolerances::ORTHONORMAL_ROUNDING / sample.cutoff;
        let apart = prefix(&sample, &shape, rotation, share);
        prop_assert!(largest(apart) <= rounding, "{apart:?} of {rounding:e}");
    }

    /// A coarser cut-off moves singular values of the pictures by no more than it takes of them.
    #[test]
    fn a_coarser_cutoff_of_an_object_takes_what_it_says(
        sample in samples(), shape in shapes(), rotation in rotations(), coarser in 0.0f64..4.0
    ) {
        prop_assume!(!matches!(shape, Shape::Slants(_)));
        let (small, loaded, listed) = of_object(&sample, &shape, rotation);
        let fine = table(&loaded, &listed);
        let mut coarse = loaded.clone();
        // Beyond, the constant image may be lost, which is refused.
        coarse.scene.basis.rank_cutoff = (sample.cutoff * 10f64.powf(coarser)).min(1e-5);
        let modes = Pictures::new(&loaded, &listed).modes(small.degree, small.order);
        let allowed = size(&loaded) * (cut(&loaded, &listed, &modes) + cut(&coarse, &listed, &modes));
        let coarse = table(&coarse, &listed);
        let (fine, coarse) = (eigenvalues(&fine), eigenvalues(&coarse));
        let count = fine.len().max(coarse.len());
        let root = |values: &[f64], k: usize| values.get(k).copied().unwrap_or(0.0).sqrt();
        let apart = largest((0..count).map(|k| root(&fine, k) - root(&coarse, k)));
        prop_assert!(apart <= allowed, "{apart:e} of {allowed:e}");
    }

    /// Object and light turned about the view, statistics and all: the same eigenvalues.
    #[test]
    fn an_object_and_its_light_turn_together(
        sample in samples(), shape in shapes(), angle in -PI..PI
    ) {
        prop_assume!(!matches!(shape, Shape::Slants(_)));
        let (small, loaded, listed) = of_object(&sample, &shape, LightRotation::None);
        let turn = Rotation { alpha: 0.0, beta: angle, gamma: 0.0 };
        let mut turned = loaded.clone();
        for light in &mut turned.lights.entries {
            light.rgb = light.rgb.each_ref().map(|channel| turn.turn(small.degree, channel));
        }
        let (sine, cosine) = angle.sin_cos();
        let with = |&[x, y, z]: &[f64; 3]| [cosine * x - sine * y, sine * x + cosine * y, z];
        let normals = listed.normals().iter().map(with).zip(listed.weights().iter().copied());
        let before = eigenvalues(&table(&loaded, &listed));
        let after = eigenvalues(&table(&turned, &pictures::listed(normals)));
        let apart = pictures::apart(&after, &before);
        // Of what is constant but for rounding, nothing is left to compare.
        let size = size(&loaded).powi(2);
        let scale = largest(before.iter().copied());
        prop_assert!(apart * scale <= tolerances::FLAT_EIGENVALUES * scale + tolerances::ORTHONORMAL_NODES * size,
            "{apart:e} of {scale:e}");
    }
}
