//! Small sources of a light: how many it has, the metals by which their errors are measured, and the
//! smoothest lobe that shows them.

/// The most sources of a light.
pub const MAX_SOURCES: usize = 32;

/// The most sources of a light that is shipped.
pub const SHIPPED_SOURCES: usize = 16;

/// The reflectance of dielectrics at normal incidence, as in glTF.
pub const DIELECTRIC: f64 = 0.04;

/// The least roughness of a lobe. Lobes lose more digits the narrower they are, and Q15 has room for
/// 1/α² up to 2^16.
pub const SMOOTHEST: f64 = 0.065;

/// The roughness from which on harmonics of degree 9 show highlights as well as sources do.
pub const MATTE: f64 = 0.6;

/// The roughness of the materials whose errors are measured.
pub const ROUGHNESS: [f64; 6] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];

/// Products of a pixel in color for one source: 3 of its cosine, 11 of the lobe, 4 of masking, 6 in
/// color, and 7 of a root.
pub const PRODUCTS: usize = 3 + 11 + 4 + 6 + 7;
