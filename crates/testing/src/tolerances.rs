//! Tolerances shared by the tests of several files, each with its reason. All other tolerances are
//! next to the tests that use them.
//!
//! A tolerance is at most ten times the largest error that its tests measure. Four kinds may be
//! wider: tolerances of random tests, which must hold in the worst case; tolerances of results that
//! are exact on some hosts and rounded on others; the last digits of a page or a file; and
//! thresholds, which are not errors.

// Special functions and rotations

/// Special functions up to degree 9: a few hundred roundings of numbers of order one.
pub const SPECIAL_LOW: f64 = 3e-14;

/// Special functions up to degree 64: about 64 recurrence steps whose errors add up, each an ulp of
/// values up to 5.
pub const SPECIAL_HIGH: f64 = 5e-13;

/// N_l^q C_lo^q up to degree and order 64: 90 positive weights that sum to 1, and harmonics whose
/// errors average out.
pub const POLAR_INTEGRAL: f64 = 2e-15;

/// D(Q) D(R) against D(QR) to degree 64, relative to the largest coefficient, and harmonics rotated
/// by D: sums of 129 terms, each with the error of [`SPECIAL_HIGH`].
pub const TURNED: f64 = 1e-12;

// Lights and materials

/// Projection of a map, separable against texel by texel, relative to the largest coefficient:
/// roundings of about 1e5 terms, and of one rotation.
pub const LIGHT_PROJECTION: f64 = 3e-13;

/// A map with a sun against explicit sums of degree 16, relative to the largest coefficient: at the
/// sun's height the terms of the explicit sums are up to a hundred times the sum, with a hundred
/// roundings.
pub const SUN: f64 = 3e-14;

/// A map of 8192 x 4096 with f32 texels, relative to the largest coefficient: roundings of 6e-8,
/// which average out, and the midpoint rule's (1/4096)².
pub const LARGE_MAP: f64 = 1e-7;

/// Coefficients that the command `light` writes, relative to the largest: nine digits.
pub const WRITTEN_DIGITS: f64 = 5e-9;

/// Coefficients of a matte material at order 64: sums of about 1e7 roundings, and normal equations
/// with a condition number of 1e4.
pub const MATTE_PROJECTION: f64 = 2e-12;

/// Figures of fits, recorded with six decimals.
pub const RECORDED_FIGURE: f64 = 1e-6;

/// Second moments of weighted lights, relative to the largest: exact sums.
pub const MOMENTS: f64 = 2e-14;

// The direct sum

/// The direct sum against quadrature, relative to the peak: roundings of about a thousand terms.
pub const DIRECT_SUM: f64 = 4e-14;

/// The largest |I| on one grid of normals against that on another, relative: the grids are a few
/// degrees apart.
pub const PEAK_GRID: f64 = 0.01;

// Tables

/// UᵀMU of the first hundred components: a cutoff of 1e-10 leaves 1e-13 of them.
pub const ORTHONORMAL_MODES: f64 = 4e-14;

/// UᵀMU of the first hundred components at degree 32 and order 32: a cutoff of 1e-10 leaves 1e-13
/// of them, and sums of sixty thousand modes add the rest.
pub const ORTHONORMAL_HIGH: f64 = 1e-13;

/// WᵀW of all components: orthogonal factors of 40 columns.
pub const ORTHONORMAL_NODES: f64 = 2e-14;

/// UᵀMU, divided by the cutoff: U has been divided by singular values down to the cutoff, and each
/// of them has the rounding of its matrix.
pub const ORTHONORMAL_ROUNDING: f64 = 1e-15;

/// Singular values of a matrix constructed to have known ones, relative to the largest: accurate to
/// the last bits.
pub const SINGULAR_VALUE: f64 = 1e-14;

/// Singular values of A beyond the exact rank, relative to the largest: a few roundings of sums of
/// 47 nodes.
pub const BEYOND_RANK: f64 = 3e-16;

/// Eigenvalues after every input changes by an ulp, relative to the largest: 1e-16 times the terms
/// of a sum.
pub const EIGENVALUE_ULP: f64 = 3e-15;

/// A variance of 1e-12 of the squared mean, relative: exposures 1e-6 apart are known to 1e-10.
pub const SMALL_VARIANCE: f64 = 2e-9;

/// Mean residual energy against the tail of the eigenvalues, relative, and the share of the total
/// energy down to which it is compared: roundings of the total, relative to its tail.
pub const RESIDUAL_ENERGY: f64 = 5e-13;

/// Share of M's computed eigenvalues that are negative: nine tenths of them are zero up to
/// rounding, with either sign.
pub const NAIVE_NEGATIVE: f64 = 0.25;

/// UᵀMU with the roots of the eigenvalues' absolute values: rounding divided by itself is of order
/// 1.
pub const NAIVE_ROOT: f64 = 0.1;

// Projection and images in floats

/// d = UᵀMc in f64 by the host's short sums against dense rows, relative to the largest d: sums
/// of about a thousand roundings.
pub const DENSE_PROJECTION: f64 = 2e-14;

/// All components in f64 against the direct sum, relative to the peak: the rank cutoff of 1e-10,
/// amplified by at most the number of components. Effects and suns measure 1e-8 to 3e-8, other
/// scenes less.
pub const ALL_COMPONENTS: f64 = 1e-7;

/// As [`ALL_COMPONENTS`], over the images of the shipped database, which include the sharpest ones.
pub const ALL_COMPONENTS_SHIPPED: f64 = 3e-7;

/// As [`ALL_COMPONENTS`], for databases with few modes, none of which is near the cutoff: rounding.
pub const ALL_COMPONENTS_FEW: f64 = 2e-13;

/// As [`ALL_COMPONENTS`], in f32: about ten significant roundings of 6e-8, of the hundred in each
/// sum.
pub const ALL_COMPONENTS_F32: f64 = 2e-6;

/// All components in f32 against the direct sum, relative to the peak: 2^-24 times the roughly
/// thirty roundings of a pixel.
pub const POLYNOMIAL_F32: f64 = 2e-6;

/// One f32 result by two orders of summation, relative to the largest: about twenty roundings.
pub const SAME_SUM_F32: f32 = 1e-6;

/// d of coefficients at 2^-100 in f32, scaled back, relative to the largest d: products below 1e-8
/// of it are denormal and lose up to 1e-15 of it; a sum has about a thousand of them.
pub const SCALED_F32: f64 = 6e-13;

/// Pixels at degree 16 to 32 in f64, computed from light and material, against components at the
/// nodes, relative to the peak: 6e-11 at degree 16, 3e-6 at degree 32. There the weakest components
/// at the nodes, 1e-10 of the largest, are rounding errors divided by the roots of small weights.
/// The error against the direct sum is 5e-8.
pub const HIGH_PIXELS: f64 = 1e-5;

/// As [`HIGH_PIXELS`], in f32: about ten roundings of 6e-8 in each of transfer, relighting,
/// collapse and pixel.
pub const HIGH_PIXELS_F32: f64 = 2e-5;

/// A scene within a tolerance against the sum component by component, both in f32, relative to the
/// peak: about a hundred roundings of 6e-8 of numbers a few times the peak, and as many in
/// converting powers to orthogonal polynomials and back.
pub const TRUNCATION_ROUNDING: f64 = 4e-7;

/// The largest of a scene's 41 pixels, relative to the largest of about 3,100 others, 2 and 6
/// degrees apart: an image of degree 9 changes by no more between them.
pub const TRUNCATION_PEAK: f64 = 1.02;

/// 8-bit normals scaled to length 1: median rms, worst rms and worst pixel, relative to the peak. A
/// direction is off by up to 0.4 % of a radian, and images change by a few peaks per radian.
pub const EIGHT_BITS: [f64; 3] = [2e-3, 4e-3, 3e-2];

/// The least value of an image under light from a single direction: its deviation, relative to the
/// peak, by f32, by Q15, within a tolerance of 1e-2 (rms), and by maps of 64 x 64 in floats and in
/// integers.
pub const DELTA: [f64; 5] = [1e-6, 1e-3, 0.1, 1e-3, 1e-3];

/// A thousand rotations in f32: by their product, one by one, and the energy. Each is a thousand
/// roundings of an angle.
pub const DRIFT: [f64; 3] = [3e-5, 3e-5, 3e-5];

// Images in integers

/// Signal-to-error ratio of 15-bit mantissas for the worst pair, in dB: a narrow peak has little
/// energy for its height.
pub const Q15_WORST: f64 = 65.0;

/// `shade` with 15-bit mantissas, all components against the direct sum, rms relative to the
/// largest irradiance: 68 dB, like the worst pair of the shipped set; the pair here is
/// not the worst.
pub const SHADED_Q15: f64 = 2e-4;

// Objects

/// Normals and weights of facets with two-digit corners: about ten roundings.
pub const FACETS: f64 = 3e-16;

/// d by a compensated sum of a million pixels in f32, relative to the largest d: eigenimages
/// accurate to 3e-7, whose errors average out, and two roundings.
pub const MILLION_PIXELS: f64 = 1.5e-7;

/// Exact sums over the million pixels against d, relative to the largest d: 3550 pixels of the rim
/// are half inside and half outside, the root of that number is 6e-5 of all pixels, and images at
/// the rim are several times their mean.
pub const RASTER: f64 = 1e-3;

// Reading of images

/// d by the reduced rows against dense least squares over the pixels, relative to the largest:
/// about a thousand roundings, times a condition number of a few tens.
pub const READ_LEAST_SQUARES: f64 = 1e-13;

/// Posterior mean, deviations, light and evidence against dense formulas over the pixels: the dense
/// deviations are roots of differences of numbers 1e4 times as large.
pub const READ_POSTERIOR: f64 = 1e-9;

/// V_d against the runtime's projections of every harmonic: sums of about a thousand roundings.
pub const READ_PRIOR: f64 = 2e-14;

/// The image of modes against the image of the components that they come from, relative to the
/// peak: the rank cutoff of 1e-10, in mode coefficients a few times as large as the light's.
pub const READ_MODES: f64 = 1e-9;

/// Singular values that least squares discard, relative to the largest, in tests where none should
/// be discarded: the condition number is a few tens.
pub const READ_CUT_OFF: f64 = 1e-12;

// Recorded figures, and thresholds

/// A figure that is recorded with two digits, relative: half a unit of the second digit is at
/// most a twentieth.
pub const RECORDED: f64 = 0.051;

/// Figures that a report gives with two digits, as a logarithm: twice a unit of the last digit.
pub const REPORT: f64 = 0.2;

/// Sums over the rings of a disc: the shares sum to 1, and the mean cosine is by midpoints 0.02
/// apart.
pub const RING_SHARES: f64 = 4e-14;

/// A deliberate change alters a result by more than this, which is far above any rounding.
pub const NO_ACCIDENT: f64 = 1e-3;
