//! The example of a watch: its dial, its relief, its frames in integers, and in floats.
#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

#[path = "../examples/watch/face.rs"]
mod face;
#[path = "../examples/watch/picture.rs"]
mod picture;
#[path = "../examples/watch/relief.rs"]
mod relief;

use eigenshade::object::NormalMap;
use eigenshade::presets::{light, material};
use eigenshade::screen::{Display, Exposure, Target, Tone};
use eigenshade::{Normal, sphere};
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU24};
use embedded_graphics::prelude::*;

const FACES: [&face::Face; 2] = [&face::SMALL, &face::LARGE];

#[test]
fn the_dial_is_as_described() {
    for face in FACES {
        let committed = |map: NormalMap<'_>| {
            map.pixels()
                .map(|pixel| (pixel.index(), pixel.coverage(), pixel.code().bytes()))
                .collect::<Vec<_>>()
        };
        let made = relief::dial(face);
        let side = face.size as usize;
        let made = NormalMap::new(side, side, made.as_flattened()).unwrap();
        assert_eq!(committed(face.dial().unwrap()), committed(made));
    }
}

/// The relief covers a disc, to a fifth of a pixel of the rim, and the dial has every pixel that the
/// relief does not cover whole.
#[test]
fn the_relief_covers_what_the_dial_leaves_out() {
    for face in FACES {
        let (relief, side) = (face.relief().unwrap(), face.relief as usize);
        assert_eq!((relief.width(), relief.height()), (side, side));
        let mut covered = vec![[0; 3]; side * side];
        let white = vec![[255; 3]; relief.codes()];
        relief.draw(&white, &mut Target::new(&mut covered, side).unwrap());
        let radius = 0.5 * (side - 1) as f64;
        let dial = relief::dial(face);
        let first = (face.size as usize - side) / 2;
        for (index, [coverage, ..]) in covered.into_iter().enumerate() {
            let [x, y] = [index % side, index / side];
            let distance = (x as f64 - radius).hypot(y as f64 - radius);
            let expected = (radius - distance + 0.5).clamp(0.0, 1.0);
            assert!((f64::from(coverage) / 255.0 - expected).abs() < 0.2, "{x} {y}: {coverage}");
            let code = dial[(first + y) * face.size as usize + first + x];
            assert!(coverage == 255 || code != NormalMap::BACKGROUND, "{x} {y}: {coverage}");
        }
    }
}

/// Far from the hands the relief has the colors of a sphere, at the normals of its mesh; beside
/// them it is darker.
#[test]
fn the_relief_is_that_of_the_mesh_with_shadows() {
    static DISPLAY: Display = Display::new(Tone::Linear);
    let scene = sphere::color::scene(light::HALL, material::GOLD_METALLIC_PAINT).unwrap();
    let exposure = Exposure::new(1.0).unwrap();
    let mesh = Quad::all(&relief::mesh());
    for face in FACES {
        let (relief, side) = (face.relief().unwrap(), face.relief as usize);
        let mut colors = vec![[0; 3]; relief.codes()];
        let d = relief.coefficients(light::HALL).unwrap();
        relief.colors(&d, exposure, &DISPLAY, &mut colors).unwrap();
        let mut found = vec![[0; 3]; side * side];
        relief.draw(&colors, &mut Target::new(&mut found, side).unwrap());
        let seen = seen(&mesh, side);
        let (high, low): (Vec<_>, Vec<_>) =
            seen.into_iter().flatten().partition(|(_, quad)| quad.middle[2] > 2.0);
        let (mut far, mut beside) = (Vec::new(), Vec::new());
        for (place, Quad { middle: [x, y, _], normal: [u, v, w] }) in low {
            let to_hand =
                high.iter().map(|(_, hand)| (hand.middle[0] - x).hypot(hand.middle[1] - y));
            let to_hand = to_hand.fold(f64::INFINITY, f64::min);
            let normal = Normal::new(u, v, w).unwrap();
            let convex = DISPLAY.rgb888(exposure.of(scene.shade(normal)));
            let darker = f64::from(convex.g) - f64::from(found[place][1]);
            match to_hand {
                12.0.. if x.hypot(y) < 32.0 => far.push(darker),
                0.0..2.0 => beside.push(darker),
                _ => {}
            }
        }
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len() as f64;
        let rms = |all: &[f64]| (all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64).sqrt();
        // Steps of 255. Petals hide light from each other as well.
        let (far, beside) = ((far.len(), mean(&far), rms(&far)), (beside.len(), mean(&beside)));
        assert!(far.0 > 1_000 && (0.0..4.0).contains(&far.1) && far.2 < 10.0, "{side}: {far:?}");
        assert!(beside.0 > 100 && beside.1 > 12.0, "{side}: {beside:?}");
    }
}

/// A cell of a mesh.
#[derive(Clone, Copy)]
struct Quad {
    middle: [f64; 3],
    normal: [f32; 3],
}

impl Quad {
    /// Those of an OBJ file.
    fn all(text: &str) -> Vec<Self> {
        let numbers = |line: &str| -> Vec<f64> {
            line.split(' ').skip(1).map(|word| word.parse().unwrap()).collect()
        };
        let lines = |word: &'static str| text.lines().filter(move |line| line.starts_with(word));
        let corners: Vec<Vec<f64>> = lines("v ").map(numbers).collect();
        let quad = |line: &str| {
            let [a, b, c, d] = numbers(line)
                .try_into()
                .map(|all: [f64; 4]| all.map(|k| &corners[k as usize - 1]))
                .unwrap();
            let [[x, y, z], [u, v, w]] =
                [(a, c), (b, d)].map(|(from, to)| [0, 1, 2].map(|axis| to[axis] - from[axis]));
            Self {
                middle: [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis] + d[axis]) / 4.0),
                normal: [y * w - z * v, z * u - x * w, x * v - y * u].map(|along| along as f32),
            }
        };
        lines("f ").map(quad).collect()
    }
}

/// The highest cell in the middle of each pixel, if there is one, and the pixel.
fn seen(mesh: &[Quad], side: usize) -> Vec<Option<(usize, Quad)>> {
    let mut seen: Vec<Option<(usize, Quad)>> = vec![None; side * side];
    let scale = (side - 1) as f64 / (2.0 * relief::RADIUS);
    for quad in mesh {
        let [x, y, z] = quad.middle;
        let [column, row] = [x, -y].map(|along| scale * along + 0.5 * (side - 1) as f64);
        if [column, row].iter().all(|along| (along - along.round()).abs() < 0.25) {
            let place = row.round() as usize * side + column.round() as usize;
            if seen[place].is_none_or(|(_, other)| other.middle[2] < z) {
                seen[place] = Some((place, *quad));
            }
        }
    }
    seen
}

#[test]
fn frames_in_integers_are_the_same_on_every_machine() {
    for (face, expected) in FACES.into_iter().zip(face::CHECKSUMS) {
        let (mut watch, mut panel) = (face::integers::watch(face).unwrap(), face::Panel::new(face));
        for frame in (0..face::FRAMES).step_by(6) {
            face::integers::relight(frame, &mut watch).unwrap();
            let Ok(()) = watch.draw(&mut panel);
        }
        assert_eq!(panel.checksum, expected, "{}: {:#x}", face.size, panel.checksum);
    }
}

#[test]
fn the_picture_in_the_documentation_has_these_frames() {
    let picture = std::io::Cursor::new(include_bytes!("../../../docs/watch.png"));
    let mut picture = png::Decoder::new(picture).read_info().unwrap();
    assert_eq!(picture.info().size(), (picture::SIDE, picture::SIDE));
    let frames = picture.info().animation_control.unwrap().num_frames;
    assert_eq!(frames, (face::FRAMES / picture::STEP).cast_unsigned());
    let mut found = vec![0; picture.output_buffer_size().unwrap()];
    for frame in (0..face::FRAMES).step_by(picture::STEP as usize) {
        picture.next_frame(&mut found).unwrap();
        let expected = picture::rgb(frame).unwrap();
        assert_eq!(found.len(), expected.len());
        // A step of five bits, where floats round the other way.
        let off = found.iter().zip(&expected).filter(|(a, b)| a.abs_diff(**b) > 9).count();
        let changed = found.iter().zip(&expected).filter(|(a, b)| a != b).count();
        assert!(off == 0 && changed <= found.len() / 1_000, "frame {frame}: {off}, {changed}");
    }
}

#[test]
fn frames_in_integers_are_those_in_floats() {
    const SIDE: usize = face::LARGE.size as usize;
    const BYTES: usize = buffer_size::<Rgb888>(SIDE, SIDE);
    type Screen = Framebuffer<Rgb888, RawU24, LittleEndian, SIDE, SIDE, BYTES>;
    let mut integers = face::integers::watch(&face::LARGE).unwrap();
    let mut floats = face::floats::watch(&face::LARGE).unwrap();
    for frame in [0, 7, 20] {
        let mut displays = [(); 2].map(|()| Screen::new());
        let [of_integers, of_floats] = &mut displays;
        face::integers::relight(frame, &mut integers).unwrap();
        let Ok(()) = integers.draw(of_integers);
        face::floats::relight(frame, &mut floats).unwrap();
        let Ok(()) = floats.draw(of_floats);
        let (mut off, mut lit) = (0, 0);
        for place in of_floats.bounding_box().points() {
            let [a, b] = displays.each_ref().map(|display| display.pixel(place).unwrap());
            let steps = [(a.r(), b.r()), (a.g(), b.g()), (a.b(), b.b())];
            lit += usize::from(b != Rgb888::BLACK);
            off += usize::from(steps.iter().any(|(a, b)| a.abs_diff(*b) > 3));
        }
        // Half of the square and more is drawn; dark pixels are steep in sRGB.
        assert!(lit > 32_000 && off < lit / 100, "frame {frame}: {off} of {lit}");
    }
}
