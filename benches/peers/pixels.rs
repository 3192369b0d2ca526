//! Pixels: of measured materials and of a white matte, against the nine-term formula, which is
//! exact on the matte to degree 2, and against a dense product over the paper's 1,000 modes.

use crate::dense::{Dense, FAER, NALGEBRA};
use crate::projection::{Modes, PAIRS, dot, single};
use crate::view::{View, reference};
use crate::{Method, rows};
use eigenshade::{Normals, sphere};
use eigenshade_benches::sheet::Row;
use eigenshade_benches::shipped::{Axes, Pair, Shipped, full, within};
use eigenshade_model::reference::DirectSum;
use std::hint::black_box;

/// Pixels of a picture.
const PIXELS: usize = 4096;

/// The images of some pairs.
struct Images<'a> {
    view: &'a View,
    picture: &'a Axes,
    references: Vec<Vec<f64>>,
}

impl<'a> Images<'a> {
    /// A method that draws the image of a number for normals.
    fn method(
        &self,
        name: &'static str,
        has_best_albedo: bool,
        draw: impl Fn(usize, Normals<'_>, &mut [f32]) + 'a,
    ) -> Method<'a> {
        let error = |(k, reference): (usize, &Vec<f64>)| {
            let image = self.view.drawn(|normals, out| draw(k, normals, out));
            if has_best_albedo {
                self.view.error_with_best_albedo(reference, &image)
            } else {
                self.view.error(reference, &image)
            }
        };
        let errors = self.references.iter().enumerate().map(error).collect();
        let (picture, count) = (self.picture, self.references.len());
        let mut out = vec![0.0; PIXELS];
        let run = move || {
            let normals = picture.normals();
            (0..count).for_each(|k| draw(k, black_box(normals), black_box(&mut out)));
        };
        Method::new(name, run, errors)
    }

    fn full(&self, pairs: &[Pair]) -> Method<'a> {
        let scenes: Vec<_> = pairs.iter().map(|pair| full(&pair.project())).collect();
        self.method("full scene", false, move |k, normals, out| {
            scenes[k].shade_slice(normals, out).expect("room");
        })
    }

    fn within(&self, name: &'static str, share: f32, pairs: &[Pair]) -> Method<'a> {
        let scenes: Vec<_> = pairs.iter().map(|pair| within(&pair.project(), share).0).collect();
        self.method(name, false, move |k, normals, out| {
            scenes[k].shade_slice(normals, out).expect("room");
        })
    }

    fn nine_terms(&self, has_best_albedo: bool, pairs: &[Pair]) -> Method<'a> {
        let formulas: Vec<_> = pairs.iter().map(Pair::nine_terms).collect();
        self.method("nine-term formula", has_best_albedo, move |k, normals, out| {
            formulas[k].shade_slice(normals, out).expect("room");
        })
    }
}

pub fn compare(timed: bool) -> Vec<Row> {
    let (view, picture, shipped) = (View::new(), Axes::spread(PIXELS), Shipped::read());
    let sum = DirectSum::new(sphere::DEGREE, sphere::ORDER);
    let at = view.modes(&sum);
    let images = |pairs: &[Pair]| {
        let reference = |pair: &Pair| reference(&at, &pair.light, &pair.material);
        let references = pairs.iter().map(reference).collect();
        Images { view: &view, picture: &picture, references }
    };

    let pairs = shipped.pairs(PAIRS);
    let measured = images(&pairs);
    let modes = Modes::read();
    let c: Vec<Vec<f64>> = pairs.iter().map(|pair| modes.kept(&modes.coefficients(pair))).collect();
    let values = |normal| -> Vec<f64> {
        let at = sum.at(normal);
        modes.selected().map(|(l, m, o, p, q)| at.value(l, m, o, p, q)).collect()
    };
    let seen: Vec<Vec<f64>> = view.normals.iter().map(|&normal| values(normal)).collect();
    let of_selected = |(c, reference): (&Vec<f64>, &Vec<f64>)| {
        let image: Vec<f64> = seen.iter().map(|row| dot(row, c)).collect();
        view.error(reference, &image)
    };
    let held: Vec<Vec<f32>> = if timed {
        picture.each().map(|normal| single(&values(normal))).collect()
    } else {
        vec![vec![0.0]]
    };
    let (dense, by) = (Dense::new(&held), single(&c[0]));
    let product = |way: usize| {
        let (dense, by, mut out) = (&dense, &by, vec![0.0; PIXELS]);
        Box::new(move || dense.multiply(way, by, &mut out)) as Box<dyn FnMut()>
    };
    let selected = Method {
        name: "dense product of 1,000 modes",
        forms: FAER.into_iter().chain(NALGEBRA).map(product).collect(),
        part: 1.0 / PAIRS as f64,
        errors: c.iter().zip(&measured.references).map(of_selected).collect(),
    };
    let methods = vec![
        measured.full(&pairs),
        measured.within("scene within 1e-3", 1e-3, &pairs),
        measured.within("scene within 1e-2", 1e-2, &pairs),
        measured.nine_terms(true, &pairs),
        selected,
    ];
    let mut found = rows("a pixel of a measured material", methods, timed);

    for (degree, comparison) in [
        (2, "a pixel of a white matte, light to degree 2"),
        (sphere::DEGREE, "a pixel of a white matte, light to degree 9"),
    ] {
        let pairs = shipped.on_matte(degree);
        let matte = images(&pairs);
        let methods = vec![
            matte.within("scene within 1e-3", 1e-3, &pairs),
            matte.within("scene within 1e-2", 1e-2, &pairs),
            matte.nine_terms(false, &pairs),
        ];
        found.extend(rows(comparison, methods, timed));
    }
    found
}
