//! Times of each path, the least of interleaved rounds, so that what another program on the machine
//! took is not in them; and instructions of a pixel and of a call, counted by callgrind: the same
//! in every run.

use crate::color::{Colored, WAYS};
use crate::images::{Image, LONG_NAMES, long_scene, long_terms, scene};
use crate::inputs::{CALLS, CallInputs, NINE, NINE_TERMS, PIXELS, irradiances, normals};
use crate::limit::{CHAINS, INSTRUCTIONS, LANES, multiply_adds};
use eigenshade::{BakedMap, MapPoint, NineTerms, Normal, Normals, Scene, sphere};
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

const ROUNDS: usize = 401;
const REPEATS: usize = 400;

/// A path, and what was found.
pub struct Path {
    /// Name in docs/performance.md.
    pub name: String,
    /// Terms of its polynomials, by azimuth.
    pub lengths: Vec<u16>,
    /// Multiply-adds that a pixel or a call cannot do without.
    pub necessary: usize,
    /// Of what takes one number an instruction there is no limit here.
    pub vectors: bool,
    pub pixels: bool,
    /// Nanoseconds of a pixel or a call, or the instructions in which it does all.
    pub found: f64,
}

impl Path {
    /// Calls that make no pixels.
    fn calls(name: impl Into<String>, necessary: usize) -> Self {
        let (name, lengths, found) = (name.into(), Vec::new(), f64::INFINITY);
        Self { name, lengths, necessary, vectors: true, pixels: false, found }
    }

    fn pixels(name: impl Into<String>, necessary: usize) -> Self {
        Self { pixels: true, ..Self::calls(name, necessary) }
    }

    fn nine_terms() -> Self {
        Self::pixels(NINE, NineTerms::MULTIPLY_ADDS)
    }

    fn image(image: &Image) -> Self {
        let lengths = image.lengths.clone();
        Self { lengths, ..Self::pixels(&image.name, image.necessary()) }
    }

    fn colored(image: &Image, how: &str) -> Self {
        Self::pixels(format!("{}, {how}", image.name), 3 * image.necessary())
    }

    fn long(name: &str) -> Self {
        let (lengths, necessary) = long_terms();
        Self { lengths, ..Self::pixels(name, necessary) }
    }

    /// Nanoseconds of its multiply-adds, where there is a limit.
    pub fn nanoseconds(&self, multiply_add: f64) -> Option<f64> {
        self.vectors.then(|| self.necessary as f64 * multiply_add / LANES as f64)
    }

    /// Instructions that it cannot do without.
    pub fn instructions(&self) -> f64 {
        (self.necessary * INSTRUCTIONS) as f64 / LANES as f64
    }
}

struct Way {
    path: Path,
    run: Box<dyn FnMut()>,
}

impl Way {
    fn new(path: Path, run: impl FnMut() + 'static) -> Self {
        Self { path, run: Box::new(run) }
    }

    fn round(&mut self) {
        let (repeats, each) = if self.path.pixels { (4, PIXELS) } else { (500, 1) };
        let start = Instant::now();
        for _ in 0..repeats {
            (self.run)();
        }
        let found = 1e9 * start.elapsed().as_secs_f64() / (repeats * each) as f64;
        self.path.found = self.path.found.min(found);
    }
}

fn limit<const N: usize>() -> Way {
    Way::new(Path::calls("limit", REPEATS * N), || {
        black_box(multiply_adds::<N>(black_box(REPEATS), black_box(0.3), black_box(0.5)));
    })
}

/// The formula of nine terms for all normals.
fn nine_terms(normals: Normals<'static>) -> impl FnMut() {
    let out = irradiances();
    move || {
        let formula = black_box(&NINE_TERMS);
        formula.shade_slice(black_box(normals), black_box(&mut *out)).expect("one length");
    }
}

/// A scene for all normals.
fn shading<B: AsRef<[f32]> + 'static>(
    scene: Scene<'static, B>,
    normals: Normals<'static>,
) -> impl FnMut() {
    let out = irradiances();
    move || {
        let scene = black_box(&scene);
        scene.shade_slice(black_box(normals), black_box(&mut *out)).expect("one length");
    }
}

/// The images that are drawn in color, each in all ways.
fn colored(images: &[Image]) -> impl Iterator<Item = (&Image, &'static str)> {
    let images = images.iter().filter(|image| image.in_color);
    images.flat_map(|image| WAYS.map(|how| (image, how)))
}

/// Times all paths, the formula of nine terms first, and a multiply-add of [`LANES`] numbers at
/// once, in nanoseconds.
pub fn timed(images: &[Image]) -> (Vec<Path>, f64) {
    let normals = normals();
    let each: Vec<Normal> = normals.iter().collect();
    let full = sphere::BASIS.collapse_into(&images[0].d, [0.0; sphere::SCENE]).expect("sizes");
    let baked: BakedMap<Vec<f32>> = full.bake_into(64, vec![0.0; 64 * 64]).expect("sizes");
    let inputs: &CallInputs = Box::leak(Box::new(CallInputs::new()));
    let by_texels = irradiances();

    let mut ways = vec![
        limit::<{ CHAINS[0] * LANES }>(),
        limit::<{ CHAINS[1] * LANES }>(),
        limit::<{ CHAINS[2] * LANES }>(),
        limit::<{ CHAINS[3] * LANES }>(),
        Way::new(Path::nine_terms(), nine_terms(normals)),
    ];
    for image in images {
        let (scene, _) = scene(&image.d, image.share);
        ways.push(Way::new(Path::image(image), shading(scene, normals)));
    }
    for (image, how) in colored(images) {
        let mut colored = Colored::new(image, how);
        ways.push(Way::new(Path::colored(image, how), move || colored.draw(normals)));
    }
    let [long, _] = LONG_NAMES;
    ways.push(Way::new(Path::long(long), shading(long_scene(long), normals)));
    let look_up = Path { vectors: false, ..Path::pixels("baked, 64 x 64, bilinear", 9) };
    ways.push(Way::new(look_up, move || {
        for (out, &normal) in by_texels.iter_mut().zip(black_box(&each)) {
            *out = baked.bilinear(MapPoint::of(normal));
        }
        black_box(&*by_texels);
    }));
    for (which, (name, necessary)) in CALLS.into_iter().enumerate() {
        ways.push(Way::new(Path::calls(name, necessary), move || inputs.call(which)));
    }
    for _ in 0..ROUNDS {
        ways.iter_mut().for_each(Way::round);
    }
    let mut paths = ways.into_iter().map(|way| way.path);
    let of_one = |path: Path| path.found * LANES as f64 / path.necessary as f64;
    let multiply_add = paths.by_ref().take(CHAINS.len()).map(of_one).fold(f64::INFINITY, f64::min);
    (paths.collect(), multiply_add)
}

/// Counts the instructions of the formula of nine terms, all images, and calls.
pub fn counted(images: &[Image]) -> Vec<Path> {
    let mut paths = vec![(Path::nine_terms(), vec![NINE.to_owned()])];
    paths.extend(images.iter().map(|image| (Path::image(image), image.arguments())));
    paths.extend(colored(images).map(|(image, how)| {
        let arguments = [vec![how.to_owned()], image.arguments()].concat();
        (Path::colored(image, how), arguments)
    }));
    paths.extend(LONG_NAMES.map(|name| (Path::long(name), vec![name.to_owned()])));
    paths.extend(
        CALLS.map(|(name, necessary)| (Path::calls(name, necessary), vec![name.to_owned()])),
    );
    let count = |(path, arguments): (Path, Vec<String>)| Path {
        found: instructions(path.pixels, &arguments),
        ..path
    };
    paths.into_iter().map(count).collect()
}

/// The first argument of a program under callgrind; a number of pictures or calls and what they are
/// of follow.
pub const SHADE: &str = "shade";

/// Instructions of a pixel of one picture, or of one of several calls, without those that set up.
/// Entering the loop adds less than half an instruction a call, which rounding removes.
fn instructions(pixels: bool, what: &[String]) -> f64 {
    let times = if pixels { 1 } else { CALLED };
    let program = std::env::current_exe().expect("this program");
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(format!("--toggle-collect=*{REPEATED}*"))
        .arg(program)
        .args([SHADE, &times.to_string()])
        .args(what)
        .output()
        .expect("valgrind: install it");
    let log = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "callgrind failed: {log}");
    let line = log.lines().find_map(|line| line.split_once("Collected :"));
    let (_, number) = line.unwrap_or_else(|| panic!("callgrind printed no count: {log}"));
    let number: f64 = number.trim().parse().expect("a count");
    assert!(number > 0.0, "callgrind did not find {REPEATED}");
    if pixels { number / PIXELS as f64 } else { (number / times as f64).round() }
}

/// The name of the function in which instructions are counted.
const REPEATED: &str = "counted_by_callgrind";
/// How often a call is counted.
const CALLED: usize = 50;

#[inline(never)]
fn counted_by_callgrind(times: usize, mut run: impl FnMut()) {
    for _ in 0..times {
        run();
    }
}

/// The program that runs under callgrind.
pub fn shade(mut arguments: impl Iterator<Item = String>) {
    let times: usize = arguments.next().and_then(|text| text.parse().ok()).expect("a number");
    let what = arguments.next().expect("a tolerance");
    if let Some(which) = CALLS.iter().position(|(name, _)| *name == what) {
        let inputs = CallInputs::new();
        return counted_by_callgrind(times, || inputs.call(which));
    }
    let normals = normals();
    if what == NINE {
        return counted_by_callgrind(times, nine_terms(normals));
    }
    if LONG_NAMES.contains(&&*what) {
        return counted_by_callgrind(times, shading(long_scene(&what), normals));
    }
    if let Some(how) = WAYS.into_iter().find(|how| *how == what) {
        let share = arguments.next().expect("a tolerance");
        let mut colored = Colored::new(&Image::parsed(&share, arguments), how);
        return counted_by_callgrind(times, || colored.draw(normals));
    }
    let image = Image::parsed(&what, arguments);
    counted_by_callgrind(times, shading(scene(&image.d, image.share).0, normals));
}
