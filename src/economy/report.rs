//! The tolerance requested, and a report of the result.

/// The allowed error of an image, root mean square over a sphere's normals, relative to the image
/// of all components. The error of the components themselves is additional: see [`Economy::floor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tolerance<S> {
    /// A fraction of the image's peak, above 0. For a channel of a color, a fraction of the largest
    /// peak of all channels.
    OfPeak(S),
    /// Decibels below the peak; 20 dB are a tenth.
    Decibels(u8),
    /// An irradiance, above 0.
    Irradiance(S),
}

/// The cost of a scene, and bounds on its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Economy<S> {
    /// Number of leading components that suffice: a scene made from these alone also stays within
    /// the bound. The scene itself uses all components, which costs a pixel nothing.
    pub components: usize,
    /// Number of azimuths |m|, from 0 to the highest that is left.
    pub azimuths: usize,
    /// Number of terms of all polynomials. A pixel costs one multiplication for each term except
    /// the first of each polynomial, and 4m - 2 for azimuths up to m.
    pub terms: usize,
    /// Upper bound on the difference from the image of all components, root mean square over a
    /// sphere's normals, apart from rounding. Its square is the sum of the squares of the next two
    /// fields.
    pub bound: S,
    /// Upper bound on the part of the difference that comes from leaving out the components beyond
    /// [`components`](Self::components).
    pub left_out_by_components: S,
    /// The part of the difference that comes from the azimuths and terms that are left out.
    pub left_out_by_terms: S,
    /// An estimate of the error of the image due to the table's limited number of components, root
    /// mean square over a sphere's normals: the root of the sum of the squares of the last fifth of
    /// the coefficients. A tolerance below it is met only relative to the image of all components.
    ///
    /// For unseen materials under the shipped lights, with the shipped table, the estimate matches
    /// the error in the median. It is within a factor of 2 for nine images in ten, and within a
    /// factor of 4 for all.
    pub floor: S,
    /// The largest of 41 pixels of the image, which is at most its peak. If the image is a channel
    /// of a color, the largest of all channels.
    pub peak: S,
}
