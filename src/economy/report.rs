//! What is asked for, and what was chosen.

/// What an image may be off that of all components, root mean square over a sphere's normals;
/// what the components lack comes besides, see [`Economy::floor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tolerance<S> {
    /// A share of the image's peak, above 0; of a colour's channel, of the largest peak of all
    /// channels.
    OfPeak(S),
    /// So many decibels below the peak; 20 are a tenth.
    Decibels(u8),
    /// An irradiance, above 0.
    Irradiance(S),
}

/// What was chosen, and what it costs at most.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Economy<S> {
    /// Number of leading components that suffice: a scene made from these alone also stays within
    /// the bound. The scene itself uses all components, which costs a pixel nothing.
    pub components: usize,
    /// Azimuths |m| from 0 on that are left.
    pub azimuths: usize,
    /// Terms of all polynomials: a pixel costs a multiplication for each but a polynomial's
    /// first, and 4m - 2 for azimuths up to m.
    pub terms: usize,
    /// At most so far is the image off that of all components, root mean square over a
    /// sphere's normals; rounding apart. Its square is the sum of the next two's.
    pub bound: S,
    /// So far at most if the components beyond [`components`](Self::components) are left out.
    pub left_out_by_components: S,
    /// So far for the azimuths and terms that are left out.
    pub left_out_by_terms: S,
    /// An estimate of what the table's components themselves lack of the image, root mean
    /// square over a sphere's normals: the root of the sum of the squares of the last fifth of
    /// the coefficients. A tolerance below it is met only against the image of all components.
    ///
    /// Of unseen materials under the shipped lights, with the shipped table, it is the error in
    /// the median, within a factor of 2 for nine images of ten, and within 4 for all.
    pub floor: S,
    /// The largest of 41 pixels of the image, at most its peak; of all channels, where the
    /// image is one of a colour.
    pub peak: S,
}
