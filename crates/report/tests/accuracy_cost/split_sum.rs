//! The baseline of `firmware/` that is counted as prefiltered maps with the split sum.

#[path = "../../../../firmware/programs/src/split_sum.rs"]
mod baseline;

use baseline::{SIDE, STEPS, SplitSum, WITHIN, place};
use eigenshade::Normal;
use eigenshade::lights::NineTerms;
use eigenshade_testing::fixtures::of_equal_areas;

/// Between 32 texels along a side, a function of direction that is linear in each component bends
/// by less than this share of its range; more at the equator, where the octahedron has an edge.
const OF_TEXELS: f32 = 0.02;

/// The direction of a place in the map, by the inverse formula.
fn direction([u, v]: [f32; 2]) -> [f32; 3] {
    let z = 1.0 - u.abs() - v.abs();
    let [x, y] =
        if z < 0.0 { [(1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v)] } else { [u, v] };
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|one| one / length)
}

/// The place of a texel, of which those of the border are folded back.
fn texel(row: usize, column: usize) -> [f32; 2] {
    let [u, v] = [column, row].map(|k| (2.0 * k as f32 - 1.0) / WITHIN as f32 - 1.0);
    // Across an edge, the octahedron goes on at the point mirrored along it.
    let [u, v] = if u.abs() > 1.0 { [u.signum() * (2.0 - u.abs()), -v] } else { [u, v] };
    if v.abs() > 1.0 { [-u, v.signum() * (2.0 - v.abs())] } else { [u, v] }
}

fn radiance([x, y, z]: [f32; 3]) -> f32 {
    1.5 + 0.5 * x - 0.3 * y + 0.4 * z
}

fn share(z: f32) -> f32 {
    0.9 - 0.5 * z
}

#[test]
fn the_counted_baseline_is_the_split_sum() {
    let mut texels = [0.0; SIDE * SIDE];
    for (k, to) in texels.iter_mut().enumerate() {
        *to = radiance(direction(texel(k / SIDE, k % SIDE)));
    }
    let matte = NineTerms::new([0.4, 0.1, 0.2, -0.1, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let reflected = std::array::from_fn(|k| share(k as f32 / (STEPS - 1) as f32));
    let formula = SplitSum { radiance: texels, reflected, matte };
    let mut normals = of_equal_areas(1000);
    normals.extend([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.6, 0.8, 0.0]]);
    let mut largest = 0.0_f32;
    for [x, y, z] in normals.into_iter().map(|normal| normal.map(|one| one as f32)) {
        let normal = Normal::new(x, y, z).expect("a normal");
        let mirror = [2.0 * x * z, 2.0 * y * z, 2.0 * z * z - 1.0];
        let back = direction(place(mirror));
        let apart = |k: usize| (back[k] - mirror[k]).abs();
        assert!((0..3).all(|k| apart(k) < 1e-5), "{mirror:?} {back:?}");
        let expected = share(z) * radiance(mirror) + (1.0 - share(z)) * matte.shade(normal);
        largest = largest.max((formula.shade(normal) - expected).abs());
    }
    println!("{largest}");
    assert!(largest < OF_TEXELS, "{largest}");
}
