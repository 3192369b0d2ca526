//! Pixels of three channels: by one call, and by a call for each channel and a loop that writes the
//! three planes as pixels.

use crate::images::{Image, Shown, scene};
use crate::inputs::{PIXELS, irradiances};
use eigenshade::{Normals, Rgb};
use std::hint::black_box;

/// The two, as docs/performance.md calls them.
pub const WAYS: [&str; 2] = ["in color, one call", "in color, three calls and a loop"];

/// Pixels of an image, the same in all channels, in one of these ways.
pub struct Colored {
    way: &'static str,
    scene: Rgb<Shown>,
    planes: [&'static mut [f32]; 3],
    pixels: Vec<Rgb<f32>>,
}

impl Colored {
    /// An image, to be drawn in this way.
    pub fn new(image: &Image, way: &'static str) -> Self {
        let (scene, _) = scene(&image.d, image.share);
        let planes = [(); 3].map(|()| irradiances());
        Self { way, scene: Rgb::gray(scene), planes, pixels: vec![Rgb::gray(0.0); PIXELS] }
    }

    /// Draws it.
    pub fn draw(&mut self, normals: Normals<'_>) {
        let (scene, pixels) = (black_box(&self.scene), black_box(&mut self.pixels));
        if self.way == WAYS[0] {
            return scene.shade_slice(black_box(normals), pixels).expect("one length");
        }
        for (scene, plane) in [&scene.r, &scene.g, &scene.b].into_iter().zip(&mut self.planes) {
            scene.shade_slice(black_box(normals), plane).expect("one length");
        }
        let [r, g, b] = black_box(&self.planes).each_ref().map(|plane| plane.iter());
        for (pixel, ((&r, &g), &b)) in pixels.iter_mut().zip(r.zip(g).zip(b)) {
            *pixel = Rgb::new(r, g, b);
        }
    }
}
