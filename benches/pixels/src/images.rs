//! Images of which polynomials are shaded: whole, or as a tolerance leaves them.

use crate::inputs::{coefficients, database, lights};
use crate::limit::necessary;
use eigenshade::{Scene, Tolerance, sphere};

/// A white matte, f = 1/π.
const WHITE: [f32; 1] = [2.0];

/// Name in docs/performance.md of the image for which the nine-term formula is exact.
pub const MATTE: &str = "matte, light of degree 2, within 1e-3";

/// A scene of the shipped table, of which lengths.
pub type Shown<'l> = Scene<'l, [f32; sphere::SCENE]>;

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
}

impl Image {
    fn new(name: impl Into<String>, d: &[f32], share: Option<f32>) -> Self {
        let mut room = [0; 16];
        let (_, lengths) = scene(d, share, &mut room);
        Self { name: name.into(), d: d.to_vec(), share, lengths }
    }

    /// Multiply-adds that a pixel of it cannot do without.
    pub fn necessary(&self) -> usize {
        necessary(&self.lengths)
    }
}

/// The scene of coefficients within a share of the peak, and its polynomials' lengths.
pub fn scene<'l>(d: &[f32], share: Option<f32>, lengths: &'l mut [u16]) -> (Shown<'l>, Vec<u16>) {
    let room = [0.0; sphere::SCENE];
    let Some(share) = share else {
        let scene = sphere::BASIS.collapse_into(d, room).expect("sizes");
        let lengths = sphere::BASIS.parts().lengths.iter().copied();
        return (scene, lengths.take_while(|&length| length > 0).collect());
    };
    let found = sphere::BASIS.collapse_within(d, Tolerance::OfPeak(share), lengths, room);
    let (scene, economy) = found.expect("sizes");
    // The scene borrows them.
    let mut copy = [0; 16];
    let room = [0.0; sphere::SCENE];
    sphere::BASIS.collapse_within(d, Tolerance::OfPeak(share), &mut copy, room).expect("sizes");
    (scene, copy[..economy.azimuths].to_vec())
}

/// The images of the page.
pub fn all() -> Vec<Image> {
    let database = database();
    let mut images = vec![Image::new("full scene", &database[database.len() / 2], None)];
    for share in [1e-4, 1e-3, 1e-2] {
        let name = format!("median image within {share:e}");
        images.push(of_cost(database.iter().map(|d| Image::new(&name, d, Some(share))), 0.5));
    }
    let lights = lights();
    for (which, place) in [("least", 0.0), ("median", 0.5), ("most", 1.0)] {
        let name = format!("matte within 1e-2, {which}");
        let mattes = lights.iter().map(|light| coefficients(light, &WHITE));
        images.push(of_cost(mattes.map(|d| Image::new(&name, &d, Some(1e-2))), place));
    }
    let light: Vec<f32> = (0..9).map(|k| 3.5 / (1.0 + k as f32)).collect();
    let matte = coefficients(&light, &WHITE);
    images.push(Image::new(MATTE, &matte, Some(1e-3)));
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
