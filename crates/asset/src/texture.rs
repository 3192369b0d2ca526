//! Textures: their levels of half the size each, and look-ups in them.

use crate::asset::{Map, Wrap};
use crate::image::Image;
use eigenshade_model::srgb::linear;
use std::sync::LazyLock;

/// The longest side of a stored texture. A larger one is halved: a picture has at most 4096 samples
/// across.
const LONGEST: usize = 4096;

/// The meaning of a texture's channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A color in sRGB, and linear opacity.
    Color,
    /// Linear numbers.
    Numbers,
    /// Vectors in tangent space, each 2c - 1 of a channel c.
    Normals,
}

/// A texture with its levels.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    kind: Kind,
    /// From the largest to 1 x 1.
    levels: Vec<Image>,
}

/// The linear value of each code of sRGB in 16 bits.
static LINEAR: LazyLock<Vec<f32>> =
    LazyLock::new(|| (0..=u16::MAX).map(|code| linear(f64::from(code) / 65535.0) as f32).collect());

impl Texture {
    /// The levels of an image: each texel is the mean of up to four of the level before, in linear
    /// light.
    ///
    /// Normals are normalized, and stored as a direction and a length. The length of a mean is less
    /// than 1 where directions differ.
    #[must_use]
    pub fn new(mut image: Image, kind: Kind) -> Self {
        if kind == Kind::Normals {
            for pixel in &mut image.pixels {
                let [x, y, z, _] = pixel.map(|code| f64::from(code) / 32767.5 - 1.0);
                *pixel = code(kind, with_length([x, y, z].map(|c| c as f32), Some(1.0)));
            }
        }
        while image.size[0].max(image.size[1]) > LONGEST {
            image = halved(&image, kind);
        }
        let mut levels = vec![image];
        while let Some(last) = levels.last().filter(|last| last.size != [1, 1]) {
            let next = halved(last, kind);
            levels.push(next);
        }
        Self { kind, levels }
    }

    /// Texels across and down of the largest level.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.levels[0].size
    }

    /// The value at a place, over an area of 4^`level` texels: bilinear in the two nearest levels.
    /// For normals, a unit vector and the length of the mean.
    #[must_use]
    pub fn at(&self, place: [f32; 2], map: &Map, level: f32) -> [f32; 4] {
        let most = self.levels.len() - 1;
        let level = level.clamp(0.0, most as f32);
        let (first, share) = (level as usize, level.fract());
        let mut sum = self.bilinear(first, place, map.wrap);
        if share > 0.0 && first < most {
            let next = self.bilinear(first + 1, place, map.wrap);
            sum = mean([sum, next], [1.0 - share, share]);
        }
        match (self.kind, sum) {
            (Kind::Normals, [x, y, z, length]) => with_length([x, y, z], Some(length)),
            (_, sum) => sum,
        }
    }

    fn bilinear(&self, level: usize, place: [f32; 2], wrap: [Wrap; 2]) -> [f32; 4] {
        let Image { size, pixels } = &self.levels[level];
        let [columns, rows] = [0, 1].map(|axis| neighbors(place[axis], size[axis], wrap[axis]));
        let mut sum = [0.0; 4];
        for (row, tall) in rows {
            for (column, wide) in columns {
                let value = decoded(self.kind, pixels[row * size[0] + column]);
                sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += tall * wide * value);
            }
        }
        sum
    }
}

/// The two texels around a coordinate along one axis, with their weights.
fn neighbors(place: f32, size: usize, wrap: Wrap) -> [(usize, f32); 2] {
    let place = if place.is_finite() { f64::from(place) } else { 0.0 };
    let at = place * size as f64 - 0.5;
    let (low, share) = (at.floor(), (at - at.floor()) as f32);
    [(low, 1.0 - share), (low + 1.0, share)].map(|(texel, weight)| {
        let count = size as f64;
        let texel = match wrap {
            Wrap::Repeat => texel.rem_euclid(count),
            Wrap::Clamp => texel.clamp(0.0, count - 1.0),
            Wrap::Mirror => {
                let twice = texel.rem_euclid(2.0 * count);
                if twice < count { twice } else { 2.0 * count - 1.0 - twice }
            }
        };
        ((texel as usize).min(size - 1), weight)
    })
}

fn decoded(kind: Kind, texel: [u16; 4]) -> [f32; 4] {
    let [r, g, b, a] = texel.map(|code| f32::from(code) / 65535.0);
    match kind {
        Kind::Numbers => [r, g, b, a],
        Kind::Normals => [2.0 * r - 1.0, 2.0 * g - 1.0, 2.0 * b - 1.0, a],
        Kind::Color => {
            let [r, g, b, _] = texel.map(|code| LINEAR[usize::from(code)]);
            [r, g, b, a]
        }
    }
}

fn code(kind: Kind, [r, g, b, a]: [f32; 4]) -> [u16; 4] {
    let whole = |value: f32| (65535.0 * value).round() as u16;
    let srgb = |value: f32| match value {
        ..=0.003_130_8 => 12.92 * value,
        _ => 1.055 * value.powf(1.0 / 2.4) - 0.055,
    };
    match kind {
        Kind::Numbers => [r, g, b, a].map(whole),
        Kind::Normals => [0.5 * r + 0.5, 0.5 * g + 0.5, 0.5 * b + 0.5, a].map(whole),
        Kind::Color => [srgb(r), srgb(g), srgb(b), a].map(whole),
    }
}

/// A unit vector, up if it has no direction, and its length, or this one.
fn with_length([x, y, z]: [f32; 3], length: Option<f32>) -> [f32; 4] {
    let found = (x * x + y * y + z * z).sqrt();
    let length = length.unwrap_or(found);
    match found > 1e-3 {
        true => [x / found, y / found, z / found, length],
        false => [0.0, 0.0, 1.0, length],
    }
}

fn mean<const N: usize>(values: [[f32; 4]; N], weights: [f32; N]) -> [f32; 4] {
    let mut sum = [0.0; 4];
    for (value, weight) in values.iter().zip(weights) {
        sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += weight * value);
    }
    sum
}

/// The image in half its size, rounded up.
fn halved(image: &Image, kind: Kind) -> Image {
    let [width, height] = image.size;
    let size = image.size.map(|side| side.div_ceil(2));
    let mut pixels = Vec::with_capacity(size[0] * size[1]);
    for row in 0..size[1] {
        for column in 0..size[0] {
            let at = |right: usize, down: usize| {
                let place = |k: usize, side: usize| k.min(side - 1);
                let (row, column) =
                    (place(2 * row + down, height), place(2 * column + right, width));
                let texel = decoded(kind, image.pixels[row * width + column]);
                match (kind, texel) {
                    (Kind::Normals, [x, y, z, length]) => {
                        [length * x, length * y, length * z, length]
                    }
                    _ => texel,
                }
            };
            let sum = mean([at(0, 0), at(1, 0), at(0, 1), at(1, 1)], [0.25; 4]);
            let texel = match (kind, sum) {
                (Kind::Normals, [x, y, z, _]) => with_length([x, y, z], None),
                _ => sum,
            };
            pixels.push(code(kind, texel));
        }
    }
    Image { size, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(size: [usize; 2], texel: [u16; 4], kind: Kind) -> Texture {
        Texture::new(Image { size, pixels: vec![texel; size[0] * size[1]] }, kind)
    }

    /// The same at every place and level, to the last bit of a code.
    #[test]
    fn one_color_stays_itself() {
        for code in [0, 1, 54, 128, 200, 255] {
            let texture = uniform([7, 20], [257 * code; 4], Kind::Color);
            let expected = linear(f64::from(code) / 255.0) as f32;
            for level in [0.0, 0.4, 2.7, 9.0] {
                let found = texture.at([0.3, 7.8], &Map::plain(0), level);
                assert!((found[0] - expected).abs() <= 2e-7 * expected, "{found:?} {expected}");
            }
        }
    }

    /// Black and white texels have a mean of one half in linear light.
    #[test]
    fn levels_are_means_of_light() {
        let pixels = (0..64).map(|k| [[0, 65535][(k + k / 8) % 2]; 4]).collect();
        let texture = Texture::new(Image { size: [8, 8], pixels }, Kind::Color);
        let found = texture.at([0.4, 0.4], &Map::plain(0), 2.0);
        assert!((found[0] - 0.5).abs() < 1e-4, "{found:?}");
    }

    /// Normals that differ have a shorter mean; those that agree do not.
    #[test]
    fn means_of_normals_have_a_length() {
        let flat = uniform([4, 4], [32768, 32768, 65535, 65535], Kind::Normals);
        assert!(flat.at([0.5; 2], &Map::plain(0), 2.0)[3] > 0.99999);
        let tilted = |k: usize| [[6554, 32768, 58981, 0], [58981, 32768, 58981, 0]][k % 2];
        let image = Image { size: [4, 4], pixels: (0..16).map(tilted).collect() };
        let [x, _, z, length] =
            Texture::new(image, Kind::Normals).at([0.5; 2], &Map::plain(0), 2.0);
        assert!(x.abs() < 1e-3 && z > 0.999 && (length - 0.5_f32.sqrt()).abs() < 1e-3, "{length}");
    }

    #[test]
    fn edges_repeat_mirror_or_stay() {
        let image = Image { size: [2, 1], pixels: vec![[0; 4], [65535; 4]] };
        let texture = Texture::new(image, Kind::Numbers);
        for (wrap, place, expected) in [
            (Wrap::Repeat, 1.25, 0.0),
            (Wrap::Repeat, -0.25, 1.0),
            (Wrap::Mirror, 1.25, 1.0),
            (Wrap::Mirror, -0.25, 0.0),
            (Wrap::Clamp, 9.0, 1.0),
            (Wrap::Clamp, -9.0, 0.0),
            (Wrap::Repeat, f32::NAN, 0.5),
        ] {
            let map = Map { wrap: [wrap; 2], ..Map::plain(0) };
            assert_eq!(texture.at([place, 0.5], &map, 0.0)[0], expected, "{wrap:?} {place}");
        }
    }
}
