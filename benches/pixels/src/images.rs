//! Images whose polynomials are shaded: all terms, or as many as a tolerance needs; and a full
//! scene of the table `pbr`, whose polynomials are too long for powers of t, also as series in
//! orthogonal polynomials, the form of the high azimuths of tables of degree 16 and more.

use crate::inputs::{coefficients, database, lights};
use crate::limit::necessary;
use eigenshade::wire::aligned;
use eigenshade::{Basis, Parts, Scene, Tolerance, Truncation, sphere};
use eigenshade_table::wire::{Endian, NumberFormat, encode};
use std::path::Path;

/// A white matte, f = 1/π.
const WHITE: [f32; 1] = [2.0];

/// Name in docs/performance.md of the image for which the nine-term formula is exact.
pub const MATTE: &str = "matte, light of degree 2, within 1e-3";

/// A scene of the shipped table.
pub type Shown = Scene<'static, [f32; sphere::SCENE]>;

/// What an image is of, and how near it is to be.
pub struct Image {
    /// Name in docs/performance.md.
    pub name: String,
    /// Its eigenimages' coefficients.
    pub d: Vec<f32>,
    /// The tolerance, a share of the peak; none of all terms.
    pub share: Option<f32>,
    /// Terms of its polynomials, by azimuth.
    pub lengths: Vec<u16>,
    /// Whether it is drawn in color too.
    pub in_color: bool,
}

impl Image {
    fn new(name: impl Into<String>, d: &[f32], share: Option<f32>) -> Self {
        let (_, lengths) = scene(d, share);
        Self { name: name.into(), d: d.to_vec(), share, lengths, in_color: false }
    }

    /// For [`parsed`](Self::parsed).
    pub fn arguments(&self) -> Vec<String> {
        let share = self.share.map_or_else(|| "all".to_owned(), |share| share.to_string());
        std::iter::once(share).chain(self.d.iter().map(ToString::to_string)).collect()
    }

    /// The image of a tolerance and coefficients.
    pub fn parsed(share: &str, d: impl Iterator<Item = String>) -> Self {
        let d: Vec<f32> = d.map(|text| text.parse().expect("a coefficient")).collect();
        Self::new("", &d, share.parse().ok())
    }

    /// Multiply-adds that a pixel of it cannot do without.
    pub fn necessary(&self) -> usize {
        necessary(&self.lengths)
    }
}

/// The scene of coefficients within a share of the peak, which is kept to the end, and the lengths
/// of its polynomials.
pub fn scene(d: &[f32], share: Option<f32>) -> (Shown, Vec<u16>) {
    let mut room = [0.0; sphere::SCENE];
    let Some(share) = share else {
        let scene = sphere::BASIS.collapse_into(d, room).expect("sizes");
        return (scene, used(sphere::BASIS.parts().lengths));
    };
    let (tolerance, lengths) = (Tolerance::OfPeak(share), Vec::leak(vec![0; 16]));
    let mut reports = [Truncation::default()];
    let shape =
        sphere::BASIS.collapse_set_within(&[d], 1, tolerance, lengths, &mut room, &mut reports);
    let shape = shape.expect("sizes");
    (shape.scene(room).expect("sizes"), shape.lengths[..shape.azimuths()].to_vec())
}

/// The lengths of the azimuths that have terms.
fn used(lengths: &[u16]) -> Vec<u16> {
    lengths.iter().copied().take_while(|&length| length > 0).collect()
}

/// The images of the page.
pub fn all() -> Vec<Image> {
    let database = database();
    let full = Image::new("full scene", &database[database.len() / 2], None);
    let mut images = vec![Image { in_color: true, ..full }];
    for share in [1e-4, 1e-3, 1e-2] {
        let name = format!("median image within {share:e}");
        let median = of_cost(database.iter().map(|d| Image::new(&name, d, Some(share))), 0.5);
        images.push(Image { in_color: share == 1e-2, ..median });
    }
    let lights = lights();
    for (which, place) in [("least", 0.0), ("median", 0.5), ("most", 1.0)] {
        let name = format!("matte within 1e-2, {which}");
        let mattes = lights.iter().map(|light| coefficients(light, &WHITE));
        images.push(of_cost(mattes.map(|d| Image::new(&name, &d, Some(1e-2))), place));
    }
    let light: Vec<f32> = (0..9).map(|k| 3.5 / (1.0 + k as f32)).collect();
    let matte = coefficients(&light, &WHITE);
    images.push(Image { in_color: true, ..Image::new(MATTE, &matte, Some(1e-3)) });
    let ambient = coefficients(&[3.5], &WHITE);
    images.push(Image::new("matte, ambient light, within 1e-3", &ambient, Some(1e-3)));
    images
}

/// That of images sorted by cost: 0 the cheapest, 1 the dearest.
fn of_cost(images: impl Iterator<Item = Image>, place: f64) -> Image {
    let mut images: Vec<_> = images.collect();
    images.sort_by_key(Image::necessary);
    images.swap_remove(((images.len() - 1) as f64 * place).round() as usize)
}

/// Names in docs/performance.md of the scene as even and odd halves, and of the same as series.
pub const LONG_NAMES: [&str; 2] = ["full scene of `pbr`", "the same as series"];

/// The scene of the table's first component, in the named form. The time of a pixel does not depend
/// on the numbers, so the series use made-up recurrences.
pub fn long_scene(name: &str) -> Scene<'static, Vec<f32>> {
    let mut basis = basis();
    if name == LONG_NAMES[1] {
        let lengths = basis.parts().lengths;
        let longest = usize::from(lengths.iter().copied().max().expect("azimuths"));
        let recurrences = Vec::leak(vec![[0.0, 0.25]; longest * lengths.len()]);
        basis = Basis::new(Parts { recurrences, ..*basis.parts() }).expect("the same shape");
    }
    basis.collapse_into(&[1.0], vec![0.0; basis.scene_len()]).expect("sizes")
}

/// Terms of its polynomials, by azimuth, and the multiply-adds that a pixel cannot do without in
/// halves.
pub fn long_terms() -> (Vec<u16>, usize) {
    let lengths = used(basis().parts().lengths);
    let necessary = necessary(&lengths);
    (lengths, necessary)
}

/// The table, packed; its bytes are needed to the end.
fn basis() -> Basis<'static> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tables/pbr.bin");
    let table = eigenshade_table::decode(&std::fs::read(path).expect("the shipped table"));
    let bytes =
        encode(&table.expect("a table"), NumberFormat::F32, Endian::Little).expect("a sphere's");
    let room = Vec::leak(vec![0; bytes.len().div_ceil(4)]);
    Basis::from_bytes(aligned(&bytes, room).expect("room")).expect("a wire file")
}
