//! Pixels in color in Node: our WebAssembly module against three.js. `three.mjs` draws and measures.

use crate::row;
use crate::view::{View, reference};
use eigenshade::sphere;
use eigenshade_benches::sheet::Row;
use eigenshade_benches::shipped::{Shipped, white_matte};
use eigenshade_model::reference::DirectSum;
use serde_json::{Value, json};
use std::io::Write;
use std::process::{Command, Stdio};

/// Pairs of measured materials.
const PAIRS: usize = 16;
/// Ours and three.js, in the order of the answer.
const METHODS: [&str; 2] = ["full scene by `Scene.shade`", "three.js"];

pub fn compare(timed: bool) -> Vec<Row> {
    let (view, shipped) = (View::new(), Shipped::read());
    let sum = DirectSum::new(sphere::DEGREE, sphere::ORDER);
    let at = view.modes(&sum);
    let matte = [(); 3].map(|()| white_matte());
    let mattes = shipped.lights.iter().map(|light| (&light.rgb, &matte));
    let measured = shipped.sample(PAIRS).map(|(light, material)| (&light.rgb, &material.rgb));
    let cases: Vec<_> = measured.chain(mattes).collect();
    let case = |(light, material): &(_, _)| json!({ "light": light, "material": material });
    let all = cases.iter().map(case).collect::<Value>();
    let mut answer = asked(&json!({ "timed": timed, "normals": view.normals, "cases": all }));
    let images: Vec<[Vec<f64>; 2]> =
        serde_json::from_value(answer["images"].take()).expect("images");
    let error = |case: usize, method: usize| {
        let (light, material) = cases[case];
        let channel = |c: usize| reference(&at, &light[c], &material[c]);
        let (reference, image) = ([0, 1, 2].map(channel).concat(), &images[case][method]);
        if case < PAIRS && method == 1 {
            return view.error_with_best_albedo(&reference, image);
        }
        view.error(&reference, image)
    };
    let time = |k: usize| Some(answer["times"][k].as_f64()? / answer["times"][0].as_f64()?);
    let mut rows = Vec::new();
    for (comparison, cases) in
        [("a measured material in Node", 0..PAIRS), ("a white matte in Node", PAIRS..cases.len())]
    {
        for (k, method) in METHODS.into_iter().enumerate() {
            let errors = cases.clone().map(|case| error(case, k)).collect();
            rows.push(row(comparison, method, time(k).filter(|_| cases.start == 0), errors));
        }
    }
    rows
}

/// The answer of three.mjs.
fn asked(task: &Value) -> Value {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/three.mjs");
    let mut node = Command::new("node")
        .arg(script)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("node: install Node 20 or later");
    let mut input = node.stdin.take().expect("a pipe");
    // A script that failed has said why by itself.
    let _ = input.write_all(&serde_json::to_vec(task).expect("numbers"));
    drop(input);
    let output = node.wait_with_output().expect("an answer");
    assert!(output.status.success(), "peers/three.mjs failed, see above");
    serde_json::from_slice(&output.stdout).expect("an answer")
}
