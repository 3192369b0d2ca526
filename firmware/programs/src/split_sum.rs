//! Baseline: a pixel as engines draw environments, by a prefiltered map and the split sum (B.
//! Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 courses), in one channel.
//!
//! The form is a cheap one. The map is octahedral, so a direction becomes a place in it by a
//! division and without trigonometry. It is prefiltered for the roughness of the material: engines
//! interpolate between two maps of a stack, which reads eight texels instead of four. The texels of
//! its border repeat others, so that no neighbor is sought across an edge. The scale and the bias
//! of the split sum are multiplied with the reflectances of the material beforehand, in a table by
//! n_z.

use eigenshade::Normal;
use eigenshade::lights::NineTerms;

/// Texels along a side of the map, with those of the border.
pub const SIDE: usize = WITHIN + 2;
/// Texels along a side without them.
pub const WITHIN: usize = 32;
/// Values of the table by n_z, from 0 to 1.
pub const STEPS: usize = 33;

/// The texels of a map, row by row.
pub type Texels = [f32; SIDE * SIDE];

/// A map, and a material.
#[derive(Clone, Debug)]
pub struct SplitSum {
    /// The prefiltered radiance.
    pub radiance: Texels,
    /// The share of white light that the lobe reflects.
    pub reflected: [f32; STEPS],
    /// The rest of the light on the matte base.
    pub matte: NineTerms,
}

impl SplitSum {
    /// The irradiance of a normal; the camera looks along z.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> f32 {
        let [x, y, z] = normal.components();
        // The mirror direction of the view.
        let twice = z + z;
        let radiance = look_up(&self.radiance, [twice * x, twice * y, twice * z - 1.0]);
        let place = z * (STEPS - 1) as f32;
        let step = (place as usize).min(STEPS - 2);
        let [below, above] = chunk(&self.reflected, step);
        let reflected = below + (place - step as f32) * (above - below);
        let matte = self.matte.shade(normal);
        matte + reflected * (radiance - matte)
    }
}

/// The place of a direction in a map: the octahedron |x| + |y| + |z| = 1, its lower half folded
/// outward, from -1 to 1.
#[must_use]
pub fn place([x, y, z]: [f32; 3]) -> [f32; 2] {
    let scale = 1.0 / (x.abs() + y.abs() + z.abs());
    let [u, v] = [x * scale, y * scale];
    if z < 0.0 { [(1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v)] } else { [u, v] }
}

/// Interpolates between four texels.
#[inline]
#[must_use]
pub fn look_up(texels: &Texels, direction: [f32; 3]) -> f32 {
    const HALF: f32 = 0.5 * WITHIN as f32;
    let [column, row] = place(direction).map(|along| along * HALF + (HALF + 0.5));
    let (left, above) = (column as usize, row as usize);
    let [across, down] = [column - left as f32, row - above as f32];
    let square: [f32; SIDE + 2] = chunk(texels, above * SIDE + left);
    let [a, b, .., c, d] = square;
    let [above, below] = [a + across * (b - a), c + across * (d - c)];
    above + down * (below - above)
}

/// `N` numbers from a place on: the last ones if it is too far.
#[inline]
fn chunk<const N: usize, const L: usize>(numbers: &[f32; L], place: usize) -> [f32; N] {
    let chunk = numbers.get(place..).and_then(<[f32]>::first_chunk);
    *chunk.or(numbers.last_chunk()).unwrap_or(&[0.0; N])
}
