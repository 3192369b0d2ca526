//! What the page of the paper's figures says, in words and with "holds", on the shipped
//! data.

mod averages;
mod statements;
mod words;

use eigenshade_table::scene::Criterion;
use experiments::paper::error::Errors;
use experiments::paper::study::{Modes, Study, Trial};
use indicatif::ProgressBar;
use std::sync::OnceLock;

fn study() -> &'static (Study, Vec<Trial>) {
    static STUDY: OnceLock<(Study, Vec<Trial>)> = OnceLock::new();
    STUDY.get_or_init(|| {
        let study = Study::new(&ProgressBar::hidden()).expect("the shipped data");
        let trials = study.trials(&ProgressBar::hidden());
        (study, trials)
    })
}

fn errors() -> &'static Errors {
    static ERRORS: OnceLock<Errors> = OnceLock::new();
    ERRORS.get_or_init(|| Errors::new(&study().0, &study().1))
}

fn of(material: &str) -> &'static [f64] {
    let errors = errors().of_material(material, Criterion::ImageCentered, Modes::All);
    assert!(errors.len() > 100, "{material}");
    errors
}
