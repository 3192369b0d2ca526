//! Instructions of a pixel and of a call, counted by callgrind: the same in every run.

use crate::images::{Image, LONG_NAMES, long_scene, long_terms, scene};
use crate::inputs::{CALLS, CallInputs, NINE, NINE_TERMS, PIXELS, Placed, irradiances, normals};
use crate::limit::{INSTRUCTIONS, LANES};
use eigenshade::{NineTerms, Normals};
use std::hint::black_box;
use std::process::Command;

/// What is asked of a program that runs under callgrind, before a tolerance and coefficients.
pub const SHADE: &str = "shade";

/// Instructions of a pixel or a call beside those that it cannot do without.
pub struct Count {
    /// What was counted.
    pub name: String,
    /// Terms of its polynomials, by azimuth.
    pub lengths: Vec<u16>,
    /// Multiply-adds that it cannot do without.
    pub necessary: usize,
    /// Instructions in which it does all.
    pub found: f64,
}

impl Count {
    /// Instructions that it cannot do without.
    pub fn limit(&self) -> f64 {
        (self.necessary * INSTRUCTIONS) as f64 / LANES as f64
    }

    /// How near it is to that.
    pub fn share(&self) -> f64 {
        self.limit() / self.found
    }
}

/// The formula of nine terms, all images, and calls.
pub fn counted(images: &[Image]) -> Vec<Count> {
    let mut counts = vec![Count {
        name: NINE.to_owned(),
        lengths: Vec::new(),
        necessary: NineTerms::<f32>::MULTIPLY_ADDS,
        found: of_a_pixel(&[NINE.to_owned()]),
    }];
    for image in images {
        let share = image.share.map_or_else(|| "all".to_owned(), |share| share.to_string());
        let arguments: Vec<_> =
            std::iter::once(share).chain(image.d.iter().map(ToString::to_string)).collect();
        counts.push(Count {
            name: image.name.clone(),
            lengths: image.lengths.clone(),
            necessary: image.necessary(),
            found: of_a_pixel(&arguments),
        });
    }
    let (lengths, necessary) = long_terms();
    for name in LONG_NAMES {
        let (name, lengths, found) =
            (name.to_owned(), lengths.clone(), of_a_pixel(&[name.to_owned()]));
        counts.push(Count { name, lengths, necessary, found });
    }
    for (name, necessary) in CALLS {
        let (name, found) = (name.to_owned(), of_one(&[name.to_owned()]));
        counts.push(Count { name, lengths: Vec::new(), necessary, found });
    }
    counts
}

/// Those of a pixel.
fn of_a_pixel(what: &[String]) -> f64 {
    of_one(what) / PIXELS as f64
}

/// Those of three pictures or calls less those of one: what sets up is in both.
fn of_one(what: &[String]) -> f64 {
    let [once, thrice] = [1, 3].map(|times| instructions(times, what) as f64);
    (thrice - once) / 2.0
}

fn instructions(times: usize, what: &[String]) -> u64 {
    let program = std::env::current_exe().expect("this program");
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args([SHADE, &times.to_string()])
        .args(what)
        .output()
        .expect("valgrind: install it");
    let log = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "callgrind failed: {log}");
    let line = log.lines().find_map(|line| line.split_once("Collected :"));
    let (_, number) = line.unwrap_or_else(|| panic!("callgrind printed no count: {log}"));
    number.trim().parse().expect("a count")
}

/// The program that runs under callgrind: a number of pictures of one image, or of calls.
pub fn shade(mut arguments: impl Iterator<Item = String>) {
    let times: usize = arguments.next().and_then(|text| text.parse().ok()).expect("a number");
    let what = arguments.next().expect("a tolerance");
    if let Some(which) = CALLS.iter().position(|(name, _)| *name == what) {
        let inputs = CallInputs::new();
        return (0..times).for_each(|_| inputs.call(which));
    }
    let d: Vec<f32> = arguments.map(|text| text.parse().expect("a coefficient")).collect();
    let xyz = normals();
    let [x, y, z] = xyz.each_ref().map(Placed::all);
    let mut room = irradiances();
    let out = room.all_mut();
    let normals = Normals::new(x, y, z).expect("one length");
    if what == NINE {
        for _ in 0..times {
            let formula = black_box(&NINE_TERMS);
            formula.shade_slice(black_box(normals), black_box(&mut *out)).expect("lengths");
        }
        return;
    }
    if LONG_NAMES.contains(&&*what) {
        let scene = long_scene(&what);
        for _ in 0..times {
            black_box(&scene)
                .shade_slice(black_box(normals), black_box(&mut *out))
                .expect("lengths");
        }
        return;
    }
    let mut lengths = [0; 16];
    let (scene, _) = scene(&d, what.parse().ok(), &mut lengths);
    for _ in 0..times {
        black_box(&scene).shade_slice(black_box(normals), black_box(&mut *out)).expect("lengths");
    }
}
