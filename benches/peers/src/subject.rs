//! Pairs of light and material made ready for pixels: by the formula of nine terms, as a full
//! scene, and as scenes within a tolerance.

use crate::report::{Way, median_and_worst};
use crate::shipped::{Pair, View};
use eigenshade::{NineTerms, Normals, Scene, Tolerance, sphere};
use eigenshade_model::reference::Modes;
use std::hint::black_box;

/// Tolerances, of the peak.
pub const WITHIN: [f32; 2] = [1e-3, 1e-2];

/// What scenes within the tolerances borrow.
pub type Lengths = [[u16; 16]; WITHIN.len()];

/// A pair's scenes and true image.
pub struct Subject<'l> {
    pub nine_terms: NineTerms,
    pub full: sphere::Scene,
    pub within: Vec<Scene<'l, [f32; sphere::SCENE]>>,
    pub reference: Vec<f64>,
}

/// One for each pair; `lengths` has a place for each.
pub fn subjects<'l>(
    pairs: &[Pair],
    modes: &[Modes<'_>],
    lengths: &'l mut [Lengths],
) -> Vec<Subject<'l>> {
    let subject = |(pair, lengths): (&Pair, &'l mut Lengths)| {
        let d = pair.project();
        let scene = |(share, lengths): (f32, &'l mut [u16; 16])| {
            let (share, room) = (Tolerance::OfPeak(share), [0.0; sphere::SCENE]);
            sphere::BASIS.collapse_within(&d, share, lengths, room).expect("it fits").0
        };
        Subject {
            nine_terms: pair.nine_terms(),
            full: sphere::collapse(&d).expect("it fits"),
            within: WITHIN.into_iter().zip(lengths).map(scene).collect(),
            reference: View::image(modes, pair),
        }
    };
    pairs.iter().zip(lengths).map(subject).collect()
}

/// A picture's normals and room for its pixels.
pub struct Picture {
    axes: [Vec<f32>; 3],
}

impl Picture {
    /// Of normals over the visible hemisphere.
    pub fn new(pixels: usize) -> Self {
        let normal = |k: usize| {
            let z = (k as f64 + 0.5) / pixels as f64;
            let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
            [sine * tilt.cos(), sine * tilt.sin(), z].map(|value| value as f32)
        };
        let axes = std::array::from_fn(|axis| (0..pixels).map(|k| normal(k)[axis]).collect());
        Self { axes }
    }

    pub fn axes(&self) -> [&[f32]; 3] {
        std::array::from_fn(|axis| &self.axes[axis][..])
    }

    fn normals(&self) -> Normals<'_> {
        let [x, y, z] = self.axes();
        Normals::new(x, y, z).expect("one length")
    }

    fn out(&self) -> Vec<f32> {
        vec![0.0; self.axes[0].len()]
    }

    /// The formula of nine terms of the round's subject.
    pub fn nine_terms<'a>(&'a self, subjects: &'a [Subject<'_>]) -> Way<'a> {
        let mut out = self.out();
        Way::new(move |round| {
            let formula = &subjects[round % subjects.len()].nine_terms;
            let normals = black_box(self.normals());
            black_box(formula).shade_slice(normals, black_box(&mut out)).expect("room");
        })
    }

    /// The scene that `of` takes of the round's subject.
    pub fn shade<'a, B: AsRef<[f32]> + 'a>(
        &'a self,
        subjects: &'a [Subject<'a>],
        of: impl Fn(&'a Subject<'a>) -> &'a Scene<'a, B> + 'a,
    ) -> Way<'a> {
        let mut out = self.out();
        Way::new(move |round| {
            let scene = of(&subjects[round % subjects.len()]);
            let normals = black_box(self.normals());
            black_box(scene).shade_slice(normals, black_box(&mut out)).expect("room");
        })
    }
}

/// Errors of an image of each subject, of the peak: median and worst.
pub fn errors<'l>(
    view: &View,
    subjects: &[Subject<'l>],
    image: impl Fn(usize, &Subject<'l>) -> Vec<f64>,
) -> Vec<Option<f64>> {
    let error =
        |(k, subject): (usize, &Subject<'l>)| view.error(&subject.reference, &image(k, subject));
    let errors: Vec<f64> = subjects.iter().enumerate().map(error).collect();
    median_and_worst(&errors).to_vec()
}

/// The formula's image.
pub fn nine_terms_image(view: &View, subject: &Subject<'_>) -> Vec<f64> {
    let axes: [Vec<f32>; 3] =
        [0, 1, 2].map(|axis| view.normals.iter().map(|normal| normal[axis] as f32).collect());
    let mut image = vec![0.0; view.normals.len()];
    let normals = Normals::new(&axes[0], &axes[1], &axes[2]).expect("one length");
    subject.nine_terms.shade_slice(normals, &mut image).expect("room");
    image.into_iter().map(f64::from).collect()
}
