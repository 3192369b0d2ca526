//! Small sources of a light: how many a set has, and the metals by which its errors are measured.

/// The most sources of a set.
pub const MAX_SOURCES: usize = 32;

/// The most sources of each set that is shipped.
pub const SETS: [usize; 5] = [1, 2, 4, 8, LARGEST_SET];

/// The most sources of the largest set that is shipped.
pub const LARGEST_SET: usize = 16;

/// The roughness of the metals whose errors a set has.
pub const ROUGHNESS: [f64; 6] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
