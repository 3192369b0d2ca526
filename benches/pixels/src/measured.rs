//! Times of each path, the least of interleaved rounds, so that what another program on the machine
//! took is not in them; and instructions of a pixel and of a call, counted by callgrind: the same
//! in every run.

use crate::color::{Colored, WAYS};
use crate::images::{Image, LONG_NAMES, long_scene, long_terms, scene};
use crate::inputs::{CALLS, CallInputs, NINE, NINE_TERMS, PIXELS, Placed, irradiances, normals};
use crate::limit::{CHAINS, INSTRUCTIONS, LANES, multiply_adds};
use eigenshade::{BakedMap, MapPoint, NineTerms, Normal, Normals, sphere};
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

const ROUNDS: usize = 401;
const REPEATS: usize = 400;

/// What was timed.
pub struct Time {
    /// Name in docs/performance.md.
    pub name: String,
    /// Terms of its polynomials, by azimuth.
    pub lengths: Vec<u16>,
    /// Multiply-adds of a pixel, or of a call of what makes none.
    pub necessary: usize,
    /// Of what takes one number an instruction there is no limit here.
    pub vectors: bool,
    /// Nanoseconds of a pixel or a call.
    pub found: f64,
    /// Whether it makes pixels.
    pub pixels: bool,
}

impl Time {
    /// Nanoseconds of its multiply-adds, where there is a limit.
    pub fn limit(&self, multiply_add: f64) -> Option<f64> {
        self.vectors.then(|| self.necessary as f64 * multiply_add / LANES as f64)
    }
}

/// Times, and nanoseconds of a multiply-add of [`LANES`] numbers at once.
pub struct Times {
    /// The formula of nine terms first.
    pub ways: Vec<Time>,
    /// See there.
    pub multiply_add: f64,
}

struct Way<'a> {
    time: Time,
    run: Box<dyn FnMut() + 'a>,
}

impl<'a> Way<'a> {
    fn new(name: &str, necessary: usize, run: impl FnMut() + 'a) -> Self {
        let (name, run) = (name.to_owned(), Box::new(run));
        let (lengths, found) = (Vec::new(), f64::INFINITY);
        let time = Time { name, lengths, necessary, vectors: true, found, pixels: false };
        Self { time, run }
    }

    fn pixels(mut self) -> Self {
        self.time.pixels = true;
        self
    }

    fn one_by_one(mut self) -> Self {
        self.time.vectors = false;
        self
    }

    /// One round.
    fn round(&mut self) {
        let (repeats, each) = if self.time.pixels { (4, PIXELS) } else { (500, 1) };
        let start = Instant::now();
        for _ in 0..repeats {
            (self.run)();
        }
        let found = 1e9 * start.elapsed().as_secs_f64() / (repeats * each) as f64;
        self.time.found = self.time.found.min(found);
    }
}

fn limit<'a, const N: usize>() -> Way<'a> {
    Way::new("limit", REPEATS * N, || {
        black_box(multiply_adds::<N>(black_box(REPEATS), black_box(0.3), black_box(0.5)));
    })
}

/// Times all paths.
pub fn timed(images: &[Image]) -> Times {
    let xyz = normals();
    let axes = xyz.each_ref().map(Placed::all);
    let slices = Normals::new(axes[0], axes[1], axes[2]).expect("one length");
    let each: Vec<_> = (0..PIXELS)
        .map(|k| Normal::new(axes[0][k], axes[1][k], axes[2][k]).expect("visible"))
        .collect();
    let image = &images[0].d;
    let full = sphere::BASIS.collapse_into(image, [0.0; sphere::SCENE]).expect("sizes");
    let baked: BakedMap<f32, Vec<f32>> = full.bake_into(64, vec![0.0; 64 * 64]).expect("sizes");
    let inputs = CallInputs::new();

    let mut rooms = vec![[0; 16]; images.len()];
    let [mut nine, mut by_texels] = [(); 2].map(|()| irradiances());
    let mut ways = vec![
        limit::<{ CHAINS[0] * LANES }>(),
        limit::<{ CHAINS[1] * LANES }>(),
        limit::<{ CHAINS[2] * LANES }>(),
        limit::<{ CHAINS[3] * LANES }>(),
        Way::new(NINE, NineTerms::<f32>::MULTIPLY_ADDS, || {
            let out = black_box(nine.all_mut());
            black_box(&NINE_TERMS).shade_slice(black_box(slices), out).expect("one length");
        })
        .pixels(),
    ];
    for (image, room) in images.iter().zip(&mut rooms) {
        let (scene, lengths) = scene(&image.d, image.share, room);
        let mut out = irradiances();
        let way = Way::new(&image.name, image.necessary(), move || {
            let scene = black_box(&scene);
            scene.shade_slice(black_box(slices), black_box(out.all_mut())).expect("one length");
        });
        let mut way = way.pixels();
        way.time.lengths = lengths;
        ways.push(way);
    }
    for image in images.iter().filter(|image| image.in_color) {
        for how in WAYS {
            let mut colored = Colored::new(image, how);
            let draw = move || colored.draw(slices);
            let way = Way::new(&image.colored(how), 3 * image.necessary(), draw);
            ways.push(way.pixels());
        }
    }
    let (lengths, necessary) = long_terms();
    let scene = long_scene(LONG_NAMES[0]);
    let mut out = irradiances();
    let mut way = Way::new(LONG_NAMES[0], necessary, move || {
        let scene = black_box(&scene);
        scene.shade_slice(black_box(slices), black_box(out.all_mut())).expect("one length");
    })
    .pixels();
    way.time.lengths = lengths;
    ways.push(way);
    let look_up = Way::new("baked, 64 x 64, bilinear", 9, || {
        for (out, &normal) in by_texels.all_mut().iter_mut().zip(black_box(&each)) {
            *out = baked.bilinear(MapPoint::of(normal));
        }
        black_box(by_texels.all());
    });
    ways.push(look_up.pixels().one_by_one());
    for (which, (name, necessary)) in CALLS.into_iter().enumerate() {
        let inputs = &inputs;
        ways.push(Way::new(name, necessary, move || inputs.call(which)));
    }
    for _ in 0..ROUNDS {
        ways.iter_mut().for_each(Way::round);
    }
    let mut times = ways.into_iter().map(|way| way.time);
    let of_one = |time: Time| time.found * LANES as f64 / time.necessary as f64;
    let multiply_add = times.by_ref().take(CHAINS.len()).map(of_one).fold(f64::INFINITY, f64::min);
    Times { ways: times.collect(), multiply_add }
}

/// The first argument of a program under callgrind; a tolerance and coefficients follow.
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
        counts.push(Count {
            name: image.name.clone(),
            lengths: image.lengths.clone(),
            necessary: image.necessary(),
            found: of_a_pixel(&image.arguments()),
        });
    }
    for image in images.iter().filter(|image| image.in_color) {
        for how in WAYS {
            let arguments = [vec![how.to_owned()], image.arguments()].concat();
            counts.push(Count {
                name: image.colored(how),
                lengths: Vec::new(),
                necessary: 3 * image.necessary(),
                found: of_a_pixel(&arguments),
            });
        }
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

/// Instructions of a pixel.
fn of_a_pixel(what: &[String]) -> f64 {
    instructions(1, what) / PIXELS as f64
}

/// Instructions of one call. Entering the loop adds less than half an instruction a call, which
/// rounding removes.
fn of_one(what: &[String]) -> f64 {
    instructions(CALLED, what).round()
}

/// Instructions of one of several pictures or calls, without those that set up.
fn instructions(times: usize, what: &[String]) -> f64 {
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
    number / times as f64
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

/// The program that runs under callgrind: a number of pictures of one image, or of calls.
pub fn shade(mut arguments: impl Iterator<Item = String>) {
    let times: usize = arguments.next().and_then(|text| text.parse().ok()).expect("a number");
    let what = arguments.next().expect("a tolerance");
    if let Some(which) = CALLS.iter().position(|(name, _)| *name == what) {
        let inputs = CallInputs::new();
        return counted_by_callgrind(times, || inputs.call(which));
    }
    let xyz = normals();
    let [x, y, z] = xyz.each_ref().map(Placed::all);
    let mut room = irradiances();
    let out = room.all_mut();
    let normals = Normals::new(x, y, z).expect("one length");
    if what == NINE {
        return counted_by_callgrind(times, || {
            let formula = black_box(&NINE_TERMS);
            formula.shade_slice(black_box(normals), black_box(&mut *out)).expect("lengths");
        });
    }
    if LONG_NAMES.contains(&&*what) {
        let scene = long_scene(&what);
        return counted_by_callgrind(times, || {
            let scene = black_box(&scene);
            scene.shade_slice(black_box(normals), black_box(&mut *out)).expect("lengths");
        });
    }
    if let Some(how) = WAYS.into_iter().find(|how| *how == what) {
        let share = arguments.next().expect("a tolerance");
        let mut colored = Colored::new(&Image::parsed(&share, arguments), how);
        return counted_by_callgrind(times, || colored.draw(normals));
    }
    let image = Image::parsed(&what, arguments);
    let mut lengths = [0; 16];
    let (scene, _) = scene(&image.d, image.share, &mut lengths);
    counted_by_callgrind(times, || {
        black_box(&scene).shade_slice(black_box(normals), black_box(&mut *out)).expect("lengths");
    });
}
