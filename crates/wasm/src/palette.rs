//! Pictures of smooth objects from a palette, which has the displayed colors of nodes of a map of
//! normals: pixels are interpolated where these are nearly even, and shaded elsewhere.
//!
//! The palette of the runtime is for displays of 16 bits. Its normals have two bytes, and 24 bits
//! show their steps of 0.7 degrees as a mosaic. Here a point of the map has 32 bits in each axis.
//!
//! The map has equal areas: the point (u, v) in the unit circle, r from its center, is the normal
//! (u s, v s, s² - 1) with s² = 2 - r².

use crate::pixels::{AXES, DISPLAYS, IRRADIANCE, PIXELS, colors, shaded};
use eigenshade::Rgb;
use eigenshade::screen::Exposure;
use eigenshade_wasm_setup::shared::{NORMALS, Shared};

/// Intervals between nodes from the center of the map to its edge.
const HALF: usize = 32;
/// Nodes along each axis of the map, from -1 to 1.
const SIDE: usize = 2 * HALF + 1;
/// Bits of a point's way between two nodes.
const WAY: u32 = 31 - HALF.ilog2();

/// The largest sum of second differences along both axes at a smooth node, in levels of 255. An
/// eighth of it is the error between nodes on a parabola.
const LARGEST: f32 = 8.0;

/// Points to draw: all u and all v, in units of 2^-31.
#[unsafe(export_name = "points")]
static POINTS: Shared<[[i32; NORMALS]; 2]> = Shared::new([[0; NORMALS]; 2]);
/// The s of these points.
#[unsafe(export_name = "scales")]
static SCALES: Shared<[f32; NORMALS]> = Shared::new([0.0; NORMALS]);

/// A node's displayed color in levels of 255, plus one half, and [`SMOOTH`] or 0.
type Node = [f32; 4];
/// Row by row, from -1 on.
static NODES: Shared<[Node; SIDE * SIDE]> = Shared::new([[0.0; 4]; SIDE * SIDE]);
/// The opacity of a smooth node, so that pixels between four of them are opaque.
const SMOOTH: f32 = 255.0;
/// A node beyond the circle: its neighbors in the circle are not smooth.
const BEYOND: Node = [1e6, 1e6, 1e6, 0.0];

/// Sets `count` nodes from number `first` on to the present irradiances, exposed, by the tone curve
/// of this number. A normal that points away stands for a node beyond the circle. Returns `count`,
/// or 0 if there are not as many nodes or no such curve, or the exposure is not above 0.
#[unsafe(no_mangle)]
extern "C" fn nodes(first: usize, count: usize, exposure: f32, tone: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (nodes, [_, _, z], planes) =
        unsafe { (NODES.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
    let (Some(display), Ok(exposure)) = (DISPLAYS.get(tone), Exposure::new(exposure)) else {
        return 0;
    };
    let nodes = nodes.get_mut(first..).and_then(|rest| rest.get_mut(..count));
    let (Some(nodes), Some(z)) = (nodes, z.get(..count)) else { return 0 };
    for ((node, color), &z) in nodes.iter_mut().zip(colors(planes)).zip(z) {
        let level = |x: f32| f32::from(display.encode(x.into())) * (255.0 / 65_535.0) + 0.5;
        let Rgb { r, g, b } = exposure.of(color).map(level);
        *node = if z < 0.0 { BEYOND } else { [r, g, b, 0.0] };
    }
    count
}

/// Finds the smooth nodes, once all are set. Returns their number.
#[unsafe(no_mangle)]
extern "C" fn smooth() -> usize {
    // SAFETY: once, and no other function runs.
    let nodes = unsafe { NODES.borrow() };
    let mut count = 0;
    // The circle has one node each in the first row and in the last one.
    for at in SIDE..SIDE * (SIDE - 1) {
        if is_smooth(nodes, at) {
            nodes.iter_mut().skip(at).take(1).for_each(|[.., opacity]| *opacity = SMOOTH);
            count += 1;
        }
    }
    count
}

/// Whether a node of the circle has nearly the mean color of the two neighbors along each axis.
fn is_smooth(nodes: &[Node; SIDE * SIDE], at: usize) -> bool {
    let [below, left, node, right, above] =
        [at - SIDE, at - 1, at, at + 1, at + SIDE].map(|at| nodes.get(at));
    let (Some(below), Some(left), Some(node)) = (below, left, node) else { return false };
    let (Some(right), Some(above)) = (right, above) else { return false };
    let second = |a: f32, b: f32, c: f32| (a + c - 2.0 * b).abs();
    let channels = below.iter().zip(left).zip(node).zip(right).zip(above).take(3);
    channels
        .map(|((((&below, &left), &node), &right), &above)| {
            second(below, node, above) + second(left, node, right)
        })
        .all(|sum| sum <= LARGEST)
        && node < &BEYOND
}

/// Draws the first `count` points: those between four smooth nodes from the palette, if
/// `interpolates` is not 0, and the others by the scene, the exposure and the tone curve, which
/// have to be those of the palette. Returns `count`, or 0 if it is too large, there is no such
/// curve, or the exposure is not above 0.
#[unsafe(no_mangle)]
extern "C" fn draw(count: usize, exposure: f32, tone: usize, interpolates: u32) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (nodes, [u, v], scales, pixels, axes, planes) = unsafe {
        (
            NODES.borrow(),
            POINTS.borrow(),
            SCALES.borrow(),
            PIXELS.borrow(),
            AXES.borrow(),
            IRRADIANCE.borrow(),
        )
    };
    let (Some(display), Ok(exposure)) = (DISPLAYS.get(tone), Exposure::new(exposure)) else {
        return 0;
    };
    let Some(pixels) = pixels.get_mut(..count) else { return 0 };
    let points = u.iter().zip(&*v).map(|(&u, &v)| [u, v]);
    for (pixel, point) in pixels.iter_mut().zip(points.clone()) {
        *pixel = if interpolates == 0 { [0; 4] } else { interpolated(nodes, point) };
    }
    let [x, y, z] = &mut *axes;
    let mut normals = x.iter_mut().zip(y).zip(z);
    let mut rough = 0;
    for (pixel, (point, &s)) in pixels.iter().zip(points.zip(&*scales)) {
        if is_rough(pixel)
            && let Some(((x, y), z)) = normals.next()
        {
            let unit = s * const { 1.0 / (1_u32 << 31) as f32 };
            [*x, *y] = point.map(|along| along as f32 * unit);
            *z = (s * s - 1.0).max(0.0);
            rough += 1;
        }
    }
    if shaded(rough, axes, planes).is_none() {
        return 0;
    }
    let rough = pixels.iter_mut().filter(|pixel| is_rough(pixel));
    for (pixel, color) in rough.zip(colors(planes)) {
        let Rgb { r, g, b } = display.rgb888(exposure.of(color));
        *pixel = [r, g, b, u8::MAX];
    }
    count
}

/// Whether a pixel is not opaque.
fn is_rough(&[.., opacity]: &[u8; 4]) -> bool {
    opacity != u8::MAX
}

/// The pixel of a point, opaque if the four nodes around it are smooth.
#[inline(always)]
fn interpolated(nodes: &[Node; SIDE * SIDE], point: [i32; 2]) -> [u8; 4] {
    let [column, row] = point.map(|along| ((along >> WAY) + HALF as i32) as usize);
    let around = nodes.get(row * SIDE + column..).and_then(|rest| rest.first_chunk());
    let Some([a, b, .., c, d]) = around.map(|around: &[_; SIDE + 2]| around) else { return [0; 4] };
    let unit = const { 1.0 / (1 << WAY) as f32 };
    let [across, up] = point.map(|along| (along & ((1 << WAY) - 1)) as f32 * unit);
    let between = |a: Node, b: Node, way: f32| {
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (a, b);
        [a0 + (b0 - a0) * way, a1 + (b1 - a1) * way, a2 + (b2 - a2) * way, a3 + (b3 - a3) * way]
    };
    between(between(*a, *b, across), between(*c, *d, across), up).map(|level| level as i32 as u8)
}
