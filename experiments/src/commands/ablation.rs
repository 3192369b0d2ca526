//! `experiments ablation`: the cost and the contribution of each effect.

use super::page;
use super::purpose::Purpose;
use clap::Args;
use eigenshade_model::error::Result;
use experiments::ablation::{compare, page as ablation, speed};

/// Cost and contribution of each effect, docs/ablation.md; times are not compared
#[derive(Args, Debug)]
pub struct Ablation {
    #[command(flatten)]
    purpose: Purpose,
}

impl Ablation {
    pub fn run(self) -> Result<()> {
        let parts = ablation::parts(|scene| match scene {
            Some(scene) => vec![speed::of_scene(scene)],
            None => speed::of_changes().to_vec(),
        });
        page::insert_or_compare(&self.purpose, &parts, ablation::COMMAND, compare::compare)
    }
}
