//! A pixel of a white matte, against the formula of nine terms, which was made for it.

use crate::interleaved::ratios;
use crate::pixels::PIXELS;
use crate::report::{Row, Table, standing};
use crate::shipped::{Shipped, View};
use crate::subject::{Lengths, Picture, WITHIN, errors, nine_terms_image, subjects};
use eigenshade::sphere;
use eigenshade_model::truth::Truth;

/// Degrees of the light: what the formula takes, and what the table does.
const DEGREES: [usize; 2] = [2, sphere::DEGREE];
/// A multiple of the number of lights.
const ROUNDS: usize = 104;

/// The comparison; times only if `measured`.
pub fn table(shipped: &Shipped, measured: bool) -> Table {
    let view = View::new();
    let truth = Truth::new(sphere::DEGREE, sphere::ORDER);
    let at = view.modes(&truth);
    let mut lengths: Vec<Vec<Lengths>> =
        DEGREES.map(|_| vec![Lengths::default(); shipped.lights.len()]).into();
    let sets: Vec<_> = DEGREES
        .into_iter()
        .zip(&mut lengths)
        .map(|(degree, lengths)| subjects(&shipped.on_matte(degree), &at, lengths))
        .collect();
    let picture = Picture::new(PIXELS);
    let ratios = measured.then(|| {
        let mut ways = Vec::new();
        for set in &sets {
            ways.push(picture.nine_terms(set));
            ways.push(picture.shade(set, |subject| &subject.within[0]));
            ways.push(picture.shade(set, |subject| &subject.within[1]));
            ways.push(picture.shade(set, |subject| &subject.full));
        }
        ratios(ROUNDS, &mut ways)
    });

    let mut table = Table {
        title: "A pixel of a white matte",
        note: format!(
            "As above, of f = 1/π under the {} shipped lights: to degree 2, which is all that the formula takes, and to degree {}. Its \
             coefficients are exact.",
            shipped.lights.len(),
            sphere::DEGREE
        ),
        heads: ["time of nine terms", "who is ahead", "rms error", "at worst"]
            .map(String::from)
            .to_vec(),
        rows: Vec::new(),
    };
    for ((degree, set), first) in DEGREES.into_iter().zip(&sets).zip([0, 4]) {
        let ratio = |k: usize| ratios.as_ref().map(|ratios| ratios[first + k]);
        let mut row = |way: String, ratio: Option<f64>, is_ours: bool, errors: Vec<Option<f64>>| {
            let way = format!("{way}, light to degree {degree}");
            let ahead = |ratio: f64| standing("the scene", "the formula", 1.0 / ratio);
            let standing = ratio.filter(|_| is_ours).map_or(String::new(), ahead);
            table.rows.push(Row { way, ratio, standing, errors });
        };
        let of_nine = errors(&view, set, |_, subject| nine_terms_image(&view, subject));
        row("nine terms".into(), ratio(0), false, of_nine);
        for (k, share) in WITHIN.into_iter().enumerate().rev() {
            let of_scene = errors(&view, set, |_, subject| view.shade(&subject.within[k]));
            row(format!("scene within {share:e}"), ratio(1 + k), true, of_scene);
        }
        let of_full = errors(&view, set, |_, subject| view.shade(&subject.full));
        row("full scene".into(), ratio(3), true, of_full);
    }
    table
}
