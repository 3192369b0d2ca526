//! Tolerances that tests of several files share, each with its reason; all others are beside the
//! tests that use them. A tolerance is at most ten times the largest error that its tests measure.
//! Four kinds may be wider: tolerances of random tests, which have to hold in the worst case; of
//! results that are exact on some hosts and rounded on others; the last digits of a page or a file;
//! and thresholds, which are no errors.

/// Special functions up to degree 9: a few hundred roundings of numbers of order one.
pub const SPECIAL_LOW: f64 = 3e-14;

/// Special functions up to degree 64: some 64 recurrence steps whose errors add, each of an ulp of
/// values up to 5.
pub const SPECIAL_HIGH: f64 = 5e-13;

/// N_l^q C_lo^q up to degree and order 64: 90 positive weights that sum to 1, harmonics whose errors
/// average out.
pub const POLAR_INTEGRAL: f64 = 2e-15;

/// Projection of a map, separable against texel by texel, of the largest coefficient: roundings of
/// some 1e5 terms, and of one rotation.
pub const LIGHT_PROJECTION: f64 = 3e-13;

/// The direct sum against quadrature, of the peak: roundings of some thousand terms.
pub const DIRECT_SUM: f64 = 4e-14;

/// All components in f32 against the direct sum, of the peak: 2^-24 times the
/// some thirty roundings of a pixel.
pub const POLYNOMIAL_F32: f64 = 2e-6;

/// UᵀMU of the first hundred components: a cut-off of 1e-10 leaves 1e-13 of them.
pub const ORTHONORMAL_MODES: f64 = 4e-14;

/// WᵀW of all components: orthogonal factors of 40 columns.
pub const ORTHONORMAL_NODES: f64 = 2e-14;

/// Mean residual energy against the eigenvalues' tail, relative, and the share of
/// the whole down to which it is compared: roundings of the whole, seen beside its tail.
pub const RESIDUAL_ENERGY: f64 = 5e-13;

/// Figures of fits, recorded with six decimals.
pub const RECORDED_FIGURE: f64 = 1e-6;

/// All components in f64 against the direct sum, of the peak: the rank's cut-off of 1e-10,
/// amplified by no more than their number. Effects and suns measure 1e-8 to 3e-8, other scenes less.
pub const ALL_COMPONENTS: f64 = 1e-7;

/// The same over the images of the shipped database, among which are the sharpest.
pub const ALL_COMPONENTS_SHIPPED: f64 = 3e-7;

/// The same of databases of few modes, none of which is near the cut-off: rounding.
pub const ALL_COMPONENTS_FEW: f64 = 2e-13;

/// The same in f32: some ten roundings of 6e-8 that count, of the hundred in each sum.
pub const ALL_COMPONENTS_F32: f64 = 2e-6;

/// d = UᵀMc in f64 by the runtime's short sums against dense rows, of the largest d: sums of some
/// thousand roundings.
pub const DENSE_PROJECTION: f64 = 2e-14;

/// The largest |I| on one grid of normals against that on another, relative: both are a few degrees
/// apart.
pub const PEAK_GRID: f64 = 0.01;

/// One f32 result by two orders of summation, of the largest: some twenty roundings.
pub const SAME_SUM_F32: f32 = 1e-6;

/// d by the reduced rows against dense least squares over the pixels, of the largest: some
/// thousand roundings, times a condition of some tens.
pub const READ_LEAST_SQUARES: f64 = 1e-13;

/// Posterior mean, deviations, light and evidence against dense formulas over the pixels: the
/// dense deviations are roots of differences of numbers 1e4 times as large.
pub const READ_POSTERIOR: f64 = 1e-9;

/// V_d against the runtime's projections of every harmonic: sums of some thousand roundings.
pub const READ_PRIOR: f64 = 2e-14;

/// The image of modes against that of the components they come from, of the peak: the rank's
/// cut-off of 1e-10 in mode coefficients a few times as large as the light's.
pub const READ_MODES: f64 = 1e-9;

/// d of an image without noise, and the image of its light, of the largest: polynomials of 1e-12,
/// times a condition of some hundreds.
pub const READ_NOISELESS: f64 = 1e-9;

/// Singular values that least squares leave out, of the largest, where none is meant to be: the
/// condition is some tens.
pub const READ_CUT_OFF: f64 = 1e-12;

/// Share of the energy, or rms, that least squares leave of an image that its components make:
/// roundings of files of full digits, and profiles that end at 1e-12.
pub const READ_RESIDUAL: f64 = 3e-15;

/// Figures of a report of two digits, as a logarithm: a unit of the last digit, doubled.
pub const REPORT: f64 = 0.2;

/// The general way on the sphere's own normals: profiles of one part in 1e3 of the strongest
/// component are determined to 1e-13 or so; the rest is margin.
pub const GENERAL_SPHERE: f64 = 1e-10;

/// Pictures of any object with all components in f64 against the direct sum, of the peak
/// over the whole hemisphere: singular values below 1e-12 are cut off.
pub const GENERAL_PICTURES: f64 = 1e-9;

/// Second moments of light turned about the vertical axis, of the largest: exact sums.
pub const MOMENTS: f64 = 2e-14;

/// The same where corners are f32.
pub const SAME_MESH_F32: f64 = 4e-7;

/// Pictures of normals that weigh 1e-12 of others, of the peak: their images are cut off with the
/// rank, at 1e-10 of what weighs 1, the root of their weight 1e-6 above that, and a third at most of what is
/// cut off is in one of them.
pub const LIGHTEST_NORMALS: f64 = 3e-5;

/// The same, each times the root of its weight over the heaviest's: what is cut off, at 1e-10, in ten
/// times as many directions as count.
pub const WEIGHTED_PICTURES: f64 = 1e-10;

/// Eigenvalues of flat objects against those of their pictures, of the largest: modes whose images over the
/// sphere are below 1e-13 are left out, and at the rim alone they are a thousand times that.
pub const FLAT_EIGENVALUES: f64 = 5e-11;

/// Pictures of flat objects, of their own peak: what is cut off, at 1e-10, over the root of the weight of
/// one normal of a hundred.
pub const FLAT_PICTURES: f64 = 1e-9;

/// Normals and weights of facets with corners of two digits: some ten roundings.
pub const FACETS: f64 = 3e-16;

/// What changes a result on purpose changes it by more than this: far above any rounding.
pub const NO_ACCIDENT: f64 = 1e-3;

/// D(Q) D(R) against D(QR) to degree 64, of the largest coefficient, and harmonics turned by D: sums
/// of 129 terms, each with the error of [`SPECIAL_HIGH`].
pub const TURNED: f64 = 1e-12;

/// UᵀMU of the first hundred components at degree 32 and order 32: a cut-off of 1e-10 leaves 1e-13
/// of them, sums of sixty thousand modes the rest.
pub const ORTHONORMAL_HIGH: f64 = 1e-13;

/// Singular values of A beyond the exact rank, of the largest: some roundings of sums of 47 nodes.
pub const BEYOND_RANK: f64 = 3e-16;

/// Eigenvalues after every input is moved by an ulp, of the largest: 1e-16 times the terms of a sum.
pub const EIGENVALUE_ULP: f64 = 3e-15;

/// Singular values that are known by design, of the largest: those of a matrix to the last bits.
pub const SINGULAR_VALUE: f64 = 1e-14;

/// A variance of 1e-12 of the squared mean, relative: exposures 1e-6 apart are known to 1e-10.
pub const SMALL_VARIANCE: f64 = 2e-9;

/// A map with a sun against explicit sums of degree 16, of the largest coefficient: the terms of those
/// are up to a hundred times their sum at the sun's height, and a hundred roundings.
pub const SUN: f64 = 3e-14;

/// A map of 8192 x 4096 with texels in f32, of the largest coefficient: roundings of 6e-8, which
/// average out, and the midpoint rule's (1/4096)².
pub const LARGE_MAP: f64 = 1e-7;

/// d by a compensated sum of a million pixels in f32, of the largest d: eigenimages to 3e-7, whose
/// errors average out, and two roundings.
pub const MILLION_PIXELS: f64 = 5e-7;

/// Exact sums over the million pixels against d, of the largest d: 3550 pixels of the rim are half in, half
/// out, and the root of that number is 6e-5 of all; at the rim images are several times their mean.
pub const RASTER: f64 = 1e-3;

/// d of coefficients at 2^-100 in f32, scaled back, of the largest d: products below 1e-8 of it are
/// denormal and lose up to 1e-15 of it, some thousand of them in a sum.
pub const SCALED_F32: f64 = 6e-13;

/// Coefficients that `light` writes, of the largest: nine digits.
pub const WRITTEN_DIGITS: f64 = 5e-9;

/// UᵀMU over the cut-off: U has been divided by singular values down to it, each with the rounding
/// of its matrix.
pub const ORTHONORMAL_ROUNDING: f64 = 1e-15;

/// Pixels at degree 16 to 32 in f64, of the peak, from light and material on, against components at
/// the nodes: 6e-11 at 16, 3e-6 at 32, where those of the weakest components, 1e-10 of the largest,
/// are rounding divided by the roots of small weights. Against the direct sum, 5e-8.
pub const HIGH_PIXELS: f64 = 1e-5;

/// The same in f32: some ten roundings of 6e-8 in each of transfer, relighting, collapse and pixel.
pub const HIGH_PIXELS_F32: f64 = 2e-5;

/// Coefficients of a matte material at order 64: sums of some 1e7 roundings, and normal
/// equations of condition 1e4.
pub const MATTE_PROJECTION: f64 = 2e-12;

/// An error's figure by other normals and nodes, relative: 320 normals, for lobes of 0.04 rad 2,000,
/// sample it to some per cent, and their peak, at the rim or a window, is that of the nearest.
pub const ERROR_FIGURE: f64 = 0.1;

/// Signal to error of mantissas of 31 bits for the worst pair.
pub const Q31_WORST: f64 = 115.0;

/// Signal to error of mantissas of 15 bits for the worst pair: a narrow peak has little energy for its height.
pub const Q15_WORST: f64 = 65.0;

/// Sums of the shares of a disc's rings: 1, and the mean cosine by midpoints 0.02 apart.
pub const RING_SHARES: f64 = 4e-14;

/// `shade` in mantissas of 31 bits, all components against the direct sum, rms of the largest irradiance:
/// polynomials trimmed to 1e-8 of the database's rms.
pub const SHADED_Q31: f64 = 3e-8;

/// The same in 15 bits: 68 dB, as the worst pair of the shipped set; what is shaded is not the worst.
pub const SHADED_Q15: f64 = 2e-4;

/// A figure that a page gives with two digits, relative: half a unit of the second is at
/// most a twentieth.
pub const STATED: f64 = 0.051;

/// A scene within a tolerance against the sum component by component, both in f32, of the
/// peak: some hundred roundings of 6e-8 of numbers a few times the peak, and as many in
/// turning powers into orthogonal polynomials and back.
pub const ECONOMY_ROUNDING: f64 = 4e-7;

/// The largest of its 41 pixels, of the largest of some 3,100 others, 2 and 6 degrees apart: an
/// image of degree 9 changes by no more between them.
pub const ECONOMY_PEAK: f64 = 1.02;

/// Share of M's computed eigenvalues that are negative: nine tenths of them are zero up to rounding, of
/// either sign.
pub const NAIVE_NEGATIVE: f64 = 0.25;

/// UᵀMU by the roots of the eigenvalues' sizes: rounding that is divided by itself is of order 1.
pub const NAIVE_ROOT: f64 = 0.1;

/// A pixel of a Lambertian scene under light of degree 2, over one by the nine-term formula: the
/// promise; 50 of 50 instructions on a Cortex-M0, 26 of 26 on a Cortex-M4F.
pub const OF_NINE_TERMS: f64 = 1.1;

/// A pixel of a typical scene at 1e-3, in nine-term pixels of nine multiply-adds: the promise; 15.6
/// on a Cortex-M0, 11.5 on a Cortex-M4F.
pub const TYPICAL_OF_NINE_TERMS: f64 = 16.0;

/// Normals of 8 bits scaled to length 1: median rms, worst rms and worst pixel, of the peak. A
/// direction is off by up to 0.4 % of a radian, where images change by a few peaks in a radian.
pub const EIGHT_BITS: [f64; 3] = [2e-3, 4e-3, 3e-2];

/// Its least value by f32, Q15, within 1e-2 (rms), and maps of 64 x 64 in floats and integers, off
/// by this of the peak.
pub const DELTA: [f64; 5] = [1e-6, 1e-3, 0.1, 1e-3, 1e-3];

/// A thousand turns in f32: by their product, one by one, and the energy. An angle's rounding a
/// thousand times.
pub const DRIFT: [f64; 3] = [3e-5, 3e-5, 3e-5];
