//! Pixels in Node: our WebAssembly module against three.js. `node/three.mjs` measures; its
//! scenes and their reference images come from here.

use crate::report::{Table, median_and_worst, standing};
use crate::shipped::{Shipped, View, root, white_matte};
use eigenshade_model::database::Named;
use eigenshade_model::reference::Modes;
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::io::Write;
use std::process::{Command, Stdio};

/// Pairs of measured materials.
const PAIRS: usize = 16;

/// What Node is asked.
#[derive(Serialize)]
struct Task {
    measured: bool,
    /// x, y and z of each normal, with its weight in squares.
    normals: Vec<[f64; 3]>,
    weights: Vec<f64>,
    mattes: Vec<Case>,
    measured_materials: Vec<Case>,
}

/// A picture in color.
#[derive(Serialize)]
struct Case {
    light: [Vec<f64>; 3],
    material: [Vec<f64>; 3],
    reference: [Vec<f64>; 3],
}

/// What it answers.
#[derive(Deserialize)]
struct Answer {
    ways: Vec<Way>,
}

#[derive(Deserialize)]
struct Way {
    name: String,
    /// Of `getIrradianceAt`.
    ratio: Option<f64>,
    is_ours: bool,
    /// Of each case, rms of the peak.
    mattes: Vec<f64>,
    measured_materials: Vec<f64>,
}

impl Case {
    fn new(light: &Named, material: [Vec<f64>; 3], at: &[Modes<'_>]) -> Self {
        let light = light.rgb.clone();
        let image = |channel: usize| -> Vec<f64> {
            let value = |modes: &Modes<'_>| {
                modes.irradiance(&light[channel], &modes.scatter(&material[channel]))
            };
            at.iter().map(value).collect()
        };
        Self { reference: [0, 1, 2].map(image), light, material }
    }
}

/// The comparison; times only if `measured`.
pub fn table(shipped: &Shipped, measured: bool) -> Result<Table, Box<dyn Error>> {
    let view = View::new();
    let at = view.modes();
    let matte = |light: &Named| Case::new(light, [0, 1, 2].map(|_| white_matte()), &at);
    let mattes = shipped.lights.iter().map(matte).collect();
    let sample = shipped.sample(PAIRS);
    let measured_materials =
        sample.map(|(light, material)| Case::new(light, material.rgb.clone(), &at)).collect();
    let (normals, weights) = (view.normals.clone(), view.weights.clone());
    let answer = asked(&Task { measured, normals, weights, mattes, measured_materials })?;

    let mut table = Table::new(
        "A pixel in Node",
        &[
            "time relative to three.js",
            "who is ahead",
            "matte: rms error",
            "worst",
            "measured: rms error",
            "worst",
        ],
    );
    for way in answer.ways {
        let factor = way.ratio.filter(|_| way.is_ours).map(|ratio| 1.0 / ratio);
        let standing = standing(&way.name, "three.js", factor);
        let errors = [way.mattes, way.measured_materials].map(|of| median_and_worst(&of));
        table.row(way.name, way.ratio, standing, errors.concat());
    }
    Ok(table)
}

fn asked(task: &Task) -> Result<Answer, Box<dyn Error>> {
    let script = root().join("benches/peers/node/three.mjs");
    let mut node = Command::new("node")
        .arg(script)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| format!("node: {error}; install Node 20 or later"))?;
    let mut input = node.stdin.take().ok_or("node takes no input")?;
    let text = serde_json::to_vec(task)?;
    // A script that failed has said why by itself.
    let written = input.write_all(&text);
    drop(input);
    let output = node.wait_with_output()?;
    if !output.status.success() {
        return Err("benches/peers/node/three.mjs failed, see above".into());
    }
    written?;
    Ok(serde_json::from_slice(&output.stdout)?)
}
