//! Every tolerance of the project's tests, one line each, with its reason. A tolerance is at most
//! ten times the largest error that its tests measure. Four kinds may be wider: tolerances of random
//! tests, which have to hold in the worst case; of results that are exact on some hosts and rounded
//! on others; the last digits of a page or a file; and thresholds, which are no errors.
#![allow(dead_code, reason = "each test takes the tolerances that it needs")]

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
/// Midpoint rule of a smooth map, of its largest coefficient: this times (degree / height)².
pub const MAP_DEGREE_SQUARED: f64 = 0.1;
/// Midpoint rule of a cosine lobe at height 128, of its largest coefficient: the kink at its rim.
pub const MAP_KINK: f64 = 2e-4;
/// Files with 8 bits a mantissa: truncated, a texel is up to 1/128 too dark, half of it on average.
pub const MAP_RGBE: f64 = 4e-3;
/// Files of half floats: 11 bits, each texel rounded to nearest.
pub const MAP_HALF: f64 = 5e-4;
/// Files of 32-bit floats: 24 bits, each texel rounded to nearest.
pub const MAP_FLOAT: f64 = 6e-8;
/// The direct sum against quadrature, of the peak: roundings of some thousand terms.
pub const DIRECT_SUM: f64 = 4e-14;
/// All components in f32 against the direct sum, of the peak: 2^-24 times the
/// some thirty roundings of a pixel.
pub const POLYNOMIAL_F32: f64 = 2e-6;
/// UᵀMU of the first hundred components: a cut-off of 1e-10 leaves 1e-13 of them.
pub const ORTHONORMAL_MODES: f64 = 4e-14;
/// WᵀW of all components: orthogonal factors of 40 columns.
pub const ORTHONORMAL_NODES: f64 = 2e-14;
/// Eigenvalues of +m and -m, of the largest: the same numbers by another way.
pub const EQUAL_EIGENVALUES: f64 = 2e-15;
/// Mean residual energy against the eigenvalues' tail, relative, and the share of
/// the whole down to which it is compared: roundings of the whole, seen beside its tail.
pub const RESIDUAL_ENERGY: f64 = 5e-13;
/// See [`RESIDUAL_ENERGY`].
pub const RESIDUAL_FLOOR: f64 = 1e-10;

/// Scattering modes (8) up to order 12 under exact quadrature: some thousand roundings.
pub const ORTHONORMAL_SCATTERING: f64 = 1e-13;
/// A BRDF in range and fully measured comes back, of its largest coefficient: the
/// small term of the fit moves the weakest by (1e-5 condition)².
pub const RECOVERED_MATERIAL: f64 = 2e-8;
/// Rms relative error of order 7 on the sintered PTFE of NIST: 1.07 % by NIST's
/// own coefficients, the rest is noise and order.
pub const PTFE_RELATIVE: f64 = 0.011;
/// Median |Xb - y| / |y| of the CUReT fits at order 7: 8.3 % when held in range.
pub const CURET_RESIDUAL: f64 = 0.09;
/// Residual of order 7 on a lobe of 20 degrees measured to 60: what the order cannot follow.
pub const LOBE_RESIDUAL: f64 = 0.03;
/// Residual of more coefficients than measurements: what holding the fit in range costs.
pub const FREE_RESIDUAL: f64 = 0.005;
/// b_00^0 of a matte surface measured without error, relative: the square of the fit's small term.
pub const MATTE_FIT: f64 = 1e-8;
/// Figures of fits, recorded with six decimals.
pub const RECORDED_FIGURE: f64 = 1e-6;
/// All components in f64 against the direct sum, of the peak: the rank's cut-off of 1e-10,
/// amplified by no more than their number. Effects and suns measure 1e-8 to 3e-8, other scenes less.
pub const ALL_COMPONENTS: f64 = 1e-7;
/// The same over the images of the shipped database, among which are the sharpest.
pub const ALL_COMPONENTS_SHIPPED: f64 = 3e-7;
/// The same of databases of few modes, none of which is near the cut-off: rounding.
pub const ALL_COMPONENTS_FEW: f64 = 2e-13;
/// The same of databases and irradiances that go through files.
pub const ALL_COMPONENTS_FEW_FILES: f64 = 2e-12;
/// The same of two lights whose exposures are 1e-6 apart: the one component has 1e-12 of the
/// variance, which is all that is known of it.
pub const ALL_COMPONENTS_ALIKE: f64 = 1e-6;
/// The same in f32: some ten roundings of 6e-8 that count, of the hundred in each sum.
pub const ALL_COMPONENTS_F32: f64 = 2e-6;
/// What all components in f32 and f64 are off the direct sum at 9, 7; 12, 12; 16, 16; 24, 24 and
/// 32, 32, of the peak: in f32 a few roundings of each of three steps, in f64 the rank's cut-off of
/// 1e-10, which the sharpest lobes amplify, and look-ups, which end 2^-22 short of the pole.
pub const ALL_COMPONENTS_AT: [[f64; 2]; 5] =
    [[2e-6, 5e-6], [1e-5, 5e-6], [1e-5, 5e-6], [2e-5, 1e-5], [2e-5, 1e-5]];
/// The same at degree 16 and order 12: the powers of 2z - 1 cancel, in the weakest profiles 1e5 to 1.
pub const ALL_COMPONENTS_F32_HIGH: f64 = 6e-6;
/// An eigenimage whose polynomial has an even and an odd half of ten terms, of its largest value:
/// its powers of u cancel, up to (1 + √2)^10 = 6,700 to one, and are rounded to 2^-24.
pub const HALVES_F32: f64 = 4e-4;
/// The same, rounded to 2^-53, after what the table's series was rounded to.
pub const HALVES_F64: f64 = 2e-12;
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
/// A product in exact modes comes back: some hundred roundings.
pub const READ_RANK_ONE: f64 = 2e-15;
/// d of an image without noise, and the image of its light, of the largest: polynomials of 1e-12,
/// times a condition of some hundreds.
pub const READ_NOISELESS: f64 = 1e-9;
/// d of an image and its normals in 16 bits against those in 8 bits of sRGB and exact, of the
/// largest: half a step of 2^-16 in normals, steeper at the rim.
pub const READ_SIXTEEN_BITS: f64 = 5e-4;
/// Singular values that least squares leave out, of the largest, where none is meant to be: the
/// condition is some tens.
pub const READ_CUT_OFF: f64 = 1e-12;
/// Energy beside the largest singular value, of its square, by which a matrix is no product.
pub const READ_NO_PRODUCT: f64 = 1e-3;
/// Share of the energy, or rms, that least squares leave of an image that its components make:
/// roundings of files of full digits, and profiles that end at 1e-12.
pub const READ_RESIDUAL: f64 = 3e-15;
/// The same where one pixel of 400 shows something else: more than this.
pub const READ_SPOILT: f64 = 1e-6;
/// Rms that the posterior mean leaves of a flat grey of 1/2: rounding.
pub const READ_FLAT: f64 = 2e-15;
/// Share of the energy that 50 components leave of a picture in 8 bits: 3 % in amplitude.
pub const READ_PICTURE: f64 = 1e-3;
/// Figures of a report of two digits, as a logarithm: a unit of the last digit, doubled.
pub const REPORT: f64 = 0.2;
/// Those of images that nothing damages, as a logarithm: rounding amplified, which hosts do
/// differently.
pub const REPORT_ROUNDING: f64 = 1.5;
/// The general way on the sphere's own normals: profiles of one part in 1e3 of the strongest
/// component are determined to 1e-13 or so; the rest is margin.
pub const GENERAL_SPHERE: f64 = 1e-10;
/// Singular values of an object's pictures, of the largest: two ways of summing the same
/// modes.
pub const GENERAL_EIGENVALUES: f64 = 2e-13;
/// Eigenimages over an object's normals, times the weaker one's share in a picture: modes whose
/// images are below 1e-13 of the largest are left out of them.
pub const GENERAL_ORTHONORMAL: f64 = 1e-13;
/// Pictures of any object with all components in f64 against the direct sum, of the peak
/// over the whole hemisphere: singular values below 1e-12 are cut off.
pub const GENERAL_PICTURES: f64 = 1e-9;
/// Second moments of light turned about the vertical axis, of the largest: exact sums.
pub const MOMENTS: f64 = 2e-14;
/// Eigenvalues of one mesh read two ways, of the largest: the same facets in f64.
pub const SAME_MESH: f64 = 1e-14;
/// The same where corners are f32.
pub const SAME_MESH_F32: f64 = 4e-7;
/// Eigenvalues of a sphere from a normal map of 64 x 64, of the largest: its rim is jagged, a
/// pixel is 3 % of the radius.
pub const NORMAL_MAP: f64 = 0.03;
/// Eigenvalues over normals of 16 bits, of the largest.
pub const SIXTEEN_BITS: f64 = 3e-5;
/// Eigenvalues of a density that is linear between 401 slants, of the largest. Chords of a cosine are
/// too low by the same share everywhere, which normalization removes; the rest falls with the fourth
/// power of the step of 4e-3.
pub const TABULATED_DENSITY: f64 = 9e-11;
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

/// Components that show in pictures, as singular values of the largest: well above the roundings of
/// [`GENERAL_EIGENVALUES`].
pub const GENERAL_SEEN: f64 = 1e-9;
/// What changes a result on purpose changes it by more than this: far above any rounding.
pub const NO_ACCIDENT: f64 = 1e-3;
/// Pictures under a light turned with its normals against those as they were, of the peak: sums of
/// 25 terms, and angles of 16 digits.
pub const ROTATED_LIGHT: f64 = 2e-15;

/// D(Q) D(R) against D(QR) to degree 64, of the largest coefficient, and harmonics turned by D: sums
/// of 129 terms, each with the error of [`SPECIAL_HIGH`].
pub const TURNED: f64 = 1e-12;
/// UᵀMU of the first hundred components at degree 32 and order 32: a cut-off of 1e-10 leaves 1e-13
/// of them, sums of sixty thousand modes the rest.
pub const ORTHONORMAL_HIGH: f64 = 1e-13;
/// Singular values of A beyond the exact rank, of the largest: some roundings of sums of 47 nodes.
pub const BEYOND_RANK: f64 = 3e-16;
/// The weakest eigenvalue that is a component, of the largest: the square of the scene's cut-off.
pub const WEAKEST: f64 = 1e-20;
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
/// Products of a pixel at 2^-100 in f32 that are subnormal, of those that are not 0: the highest terms are 1e-7
/// of the strongest, and t and n_x are small somewhere: 0.7 %.
pub const SUBNORMAL_PRODUCTS: f64 = 0.02;
/// Coefficients at 2^-100 in f32 that are subnormal, of all components: those weaker than 1e-8 of the
/// strongest, in amplitude.
pub const SUBNORMAL_COMPONENTS: f64 = 0.5;
/// Coefficients that `light` writes, of the largest: nine digits.
pub const WRITTEN_DIGITS: f64 = 5e-9;
/// UᵀMU over the cut-off: U has been divided by singular values down to it, each with the rounding
/// of its matrix.
pub const ORTHONORMAL_ROUNDING: f64 = 1e-15;
/// |d|² + residual against the energy, relative: the orthonormality of W, twice, and polynomials
/// that end at 1e-13.
pub const PARSEVAL: f64 = 2e-14;
/// Shares of the Lambertian modes' variance against the closed form: sums of ten numbers.
pub const LAMBERTIAN_SHARES: f64 = 2e-15;
/// Errors of representation and of partial sums, over nodes against pixels, of the image's
/// energy: 36 intervals in cos α are exact, the rest is roundings of some thousand terms.
pub const FIGURE_ERROR: f64 = 2e-13;
/// The rms of a residual over a picture's pixels against that over quadrature nodes, relative:
/// 176 pixels across, those of the rim, where it is largest, covered in part and shaded as the rim.
pub const PIXEL_ERROR: f64 = 0.05;
/// A mean over the rotations of a light against (38), relative: roundings of some thousand terms.
pub const MEAN_OVER_ROTATIONS: f64 = 1e-13;
/// Irradiances in a list of six digits, of the peak: half a unit of the last, and sums that are off
/// by 1e-10.
pub const LISTED: f64 = 6e-6;
/// Pixels at degree 16 to 32 in f64, of the peak, from light and material on, against components at
/// the nodes: 6e-11 at 16, 3e-6 at 32, where those of the weakest components, 1e-10 of the largest,
/// are rounding divided by the roots of small weights. Against the direct sum, 5e-8.
pub const HIGH_PIXELS: f64 = 1e-5;
/// The same in f32: some ten roundings of 6e-8 in each of transfer, relighting, collapse and pixel.
pub const HIGH_PIXELS_F32: f64 = 2e-5;

/// BRDF models by three cosines against the literature's vectors, relative: α² = 1e-4 under
/// cancellation of 1 - (n h)² near the mirror leaves twelve digits of sixteen.
pub const BRDF_MODEL: f64 = 1e-10;
/// The ABC model by three cosines against its printed formula, relative: 1 - cos θ_h by the
/// vectors loses up to four digits.
pub const ABC_MODEL: f64 = 1e-11;
/// Its directional albedo by 400 midpoints an angle against 1000 x 180, relative.
pub const ABC_ALBEDO: f64 = 1e-5;
/// Coefficients of a matte material at order 64: sums of some 1e7 roundings, and normal
/// equations of condition 1e4.
pub const MATTE_PROJECTION: f64 = 2e-12;
/// Coefficients with twice the nodes, of the largest: 20^-12 and less but for the lobe of 1e-3 rad
/// at grazing angles.
pub const PROJECTION_NODES: f64 = 4e-8;
/// The same without cosines: f grows without bound to the last panel before π/2.
pub const PROJECTION_NODES_GRAZING: f64 = 4e-7;
/// Coefficients against 400 midpoints an angle, of the largest: midpoints are off by 1/400² and,
/// where f grows, by ten times that.
pub const PROJECTION_MIDPOINT: f64 = 1e-4;
/// Energy left out against 64 midpoints in azimuth, relative: a small difference, half of it at
/// grazing angles.
pub const LEFT_OUT_MIDPOINT: f64 = 0.005;
/// A tabulated lobe of 9 degrees between the centres of bins, relative: linear interpolation over a
/// degree in θ_d and up to two in θ_h.
pub const MERL_VALUE: f64 = 0.01;
/// Coefficients of the same table, of the largest: the last centre is half a degree from grazing,
/// beyond which the table is constant and the formula grows.
pub const MERL_PROJECTION: f64 = 0.01;
/// A tabulated BRDF of a constant, or with light and view exchanged, relative: weighted means of
/// eight numbers.
pub const MERL_ROUNDING: f64 = 3e-15;
/// A matte sphere under radiance 1 on 128 x 64 texels, relative: the horizon cuts texels of three
/// degrees, where the cosine is that of their centre.
pub const DIRECT_WHITE: f64 = 1e-3;
/// Irradiance by texels against midpoints in the normal's frame, relative: 800 midpoints meet the
/// edges of a window thrice as bright as the sky to 1/800 of each angle.
pub const DIRECT_FRAMES: f64 = 5e-3;
/// Texels in parts against parts four times as fine, rms of the peak, for lobes of 0.01 rad and more
/// on texels of 0.0123: a tenth of what degree 24 leaves at such a lobe.
pub const DIRECT_PARTS: f64 = 1e-3;
/// An error's figure by other normals and nodes, relative: 320 normals, for lobes of 0.04 rad 2,000,
/// sample it to some per cent, and their peak, at the rim or a window, is that of the nearest.
pub const ERROR_FIGURE: f64 = 0.1;

/// One rounding to f32, relative.
pub const ROUNDING_F32: f64 = 6.1e-8;
/// Roots in f32 by Newton's method, relative: a few roundings.
pub const SINGLE_ROOT: f64 = 2e-7;
/// Sines and cosines in f32 to 1,000 rad: roundings of a polynomial and of the angle's rest.
pub const SINGLE_ANGLE: f64 = 1e-7;
/// Roots in f32 from a table of 64, relative: two steps of Newton's method leave two roundings.
pub const TABLED_ROOT: f64 = 1.1e-7;
/// Sines and cosines in f32 to 1,000 rad from a table of 33: roundings of its numbers, of the sum and of the angle's
/// rest.
pub const TABLED_ANGLE: f64 = 8e-8;
/// `micromath`'s roots, relative: the exponent halved, its bits as a straight line.
pub const MICROMATH_ROOT: f64 = 0.061;
/// Its reciprocal roots, relative: the same line with a better offset.
pub const MICROMATH_INVERSE_ROOT: f64 = 0.035;
/// Its sines and cosines within 10 rad: two parabolas.
pub const MICROMATH_ANGLE: f64 = 1.1e-3;

/// Baked maps of N texels a side: N, rms of bilinear and of nearest look-ups, of the peak, each of the
/// median image and of the worst: bilinear falls by four where nearest falls by two.
pub const BAKED: [(usize, [f64; 2], [f64; 2]); 3] = [
    (32, [4e-4, 2e-3], [1.2e-2, 3e-2]),
    (64, [1e-4, 5e-4], [6e-3, 1.5e-2]),
    (128, [2.5e-5, 1.3e-4], [3e-3, 7e-3]),
];
/// What integers may add to that: three roundings to 2^-15, and normals of 2^-16.
pub const BAKED_INTEGERS: f64 = 4e-5;
/// Map coordinates from Q15 normals, in units of 2^-15: their own rounding and that of the
/// quotient, whose scale is cut to 2^-16.
pub const MAP_POINT_Q15: f64 = 1.3;

/// Look-ups with so many knots: knots, rms of linear and of cubic ones, of the peak, each of the median
/// image and of the worst: linear falls by four, cubic by sixteen at best, down to the rounding of f32.
pub const LOOKUP: [(usize, [f64; 2], [f64; 2]); 4] = [
    (16, [6e-4, 5e-3], [7e-5, 8e-4]),
    (32, [1.4e-4, 1.1e-3], [6e-6, 7e-5]),
    (64, [3.5e-5, 2.6e-4], [7e-7, 8e-6]),
    (128, [8e-6, 6.5e-5], [1.2e-7, 1e-6]),
];

/// A light of degree 9 turned in f32, of its largest coefficient: nine steps of a recurrence, and
/// sums of 19 products.
pub const TURNED_F32: f64 = 2e-6;
/// The same turned and turned back.
pub const TURNED_BACK_F32: f64 = 1e-6;

/// A factor of a window in f32: a sine, a division, two squares.
pub const WINDOW_F32: f64 = 5e-7;
/// How far a point of light to degree 9 goes below zero through a window of width 10, of its peak; without
/// one it is 0.13 or more.
pub const WINDOW_RINGING: f64 = 0.01;

/// Area of facets that nothing hides, in a picture of a few units: the same products, in another
/// order.
pub const WHOLE_FACETS: f64 = 2e-15;
/// Area seen of facets partly hidden, of the longer side of the box times the length of their
/// outlines and cuts: the diagonal of a sample of 1/1024, which is the bound; errors of both signs
/// leave a fiftieth of it.
pub const VISIBLE_AREA: f64 = 1.4 / 1024.0;
/// A torus of 200 x 100 facets against the smooth one, of its picture: chords of a circle of 100,
/// (2π/100)²/6, and of 200; samples where it hides itself.
pub const FACETED_TORUS: f64 = 1.5e-3;
/// Moments of visible normals against 200 x 200 rays, of the picture: edges of length
/// some tens in 200, their errors of both signs.
pub const RAYS: f64 = 3e-3;
/// Slivers that are all cut alike, of their area: sixteen points stand for each, a tenth
/// of its area apart at most.
pub const SLIVERS_ALIKE: f64 = 0.1;
/// Slivers cut along a diagonal, of their area: the errors of each one's points sum to nothing
/// over its length, and the cut is 1.4 long, with a sample of 2/1024 in width.
pub const SLIVERS: f64 = 4e-4;
/// Signal to error of f32 over the database, in decibels, and of its worst pair: 24 bits
/// are 150, and polynomials are trimmed to 1e-7, 140.
pub const F32_ALL: f64 = 130.0;
/// See [`F32_ALL`]; d of a dark image is small beside its addends.
pub const F32_WORST: f64 = 120.0;
/// Signal to error of mantissas of 31 bits: polynomials are trimmed to 1e-8, 160.
pub const Q31_ALL: f64 = 140.0;
/// See [`Q31_ALL`].
pub const Q31_WORST: f64 = 115.0;
/// Signal to error of mantissas of 15 bits: 96 less what a pixel of 17 bits loses to its
/// headroom (docs/formats.md) and to 13 polynomials' rounding.
pub const Q15_ALL: f64 = 80.0;
/// See [`Q15_ALL`]; a narrow peak has little energy for its height.
pub const Q15_WORST: f64 = 65.0;
/// Signal to error of one component over the database: the addends of UᵀM cancel, to a
/// thirtieth in the weakest.
pub const Q15_COMPONENT: f64 = 64.0;
/// Figures in decibels on a page are rounded to a tenth; a fused target moves f32 by
/// less than the other half.
pub const DECIBELS_STATED: f64 = 0.1;
/// Figures of the shipped components against those of all, relative: what 250 leave out hardly shows
/// beside what the degree does.
pub const ERROR_OF_COMPONENTS: f64 = 0.01;
/// Median error over the maps at degree 12 for rough materials, of the peak: what is promised of
/// them.
pub const ERROR_WHERE_ROUGH: f64 = 0.01;
/// Sums of the shares of a disc's rings: 1, and the mean cosine by midpoints 0.02 apart.
pub const RING_SHARES: f64 = 4e-14;
/// See [`RING_SHARES`]: a quarter of the square of the step.
pub const RING_MIDPOINTS: f64 = 1e-4;
/// Squared length of a unit normal: some roundings.
pub const UNIT_LENGTH: f64 = 1e-15;
/// Projection and synthesis of the first components of an object, made alone or with all, of the largest number: the
/// same sums in another order, which is the same order and so the same bits on some hosts.
pub const PREFIX: f64 = 1e-13;
/// U over modes of them: divided by singular values down to the cut-off of 8e-11, which few pictures call for.
pub const PREFIX_MODES: f64 = 1e-11;
/// Images over an object by d against the direct sum, in amplitude, of |L| |b|: modes whose images over the sphere are below
/// 1e-13 are in no span, at one normal of the rim they are a thousand times that, and an image has a tenth
/// of them; 1.5e-13 was the most in a thousand random objects. What the rank's cut-off takes comes on top.
pub const OBJECT_PARSEVAL: f64 = 1e-12;
/// d from pixels in mantissas of 15 bits, of the largest: the images of weak components are trimmed to
/// 1e-5 over their share of the database's rms, some 1e-3 in the weakest.
pub const ESTIMATE_Q15: f64 = 5e-3;
/// The same in 31 bits, trimmed to 1e-8.
pub const ESTIMATE_Q31: f64 = 1e-6;
/// d of any light and material, of what its addends could be, all of the largest size and of one
/// sign: some roundings of 24 bits, of addends far smaller.
pub const ANY_D_F32: f64 = 2e-8;
/// See [`ANY_D_F32`]: light, material, Ĉ, S, factors and T are each rounded to 15 bits of the largest
/// of their row.
pub const ANY_D_Q15: f64 = 2e-5;
/// See [`ANY_D_Q15`], with 16 bits more.
pub const ANY_D_Q31: f64 = 3e-10;
/// d has 30 bits of its largest component, and rounds twice.
pub const ANY_D_COMMON: f64 = 2e-9;
/// A pixel of any coefficients against f64 on the same mantissas, of the range of 17 bits: (n_x + i
/// n_y)^m has 14, and each step of some fifty rounds by one unit.
pub const ANY_PIXEL_Q15: f64 = 3e-4;
/// See [`ANY_PIXEL_Q15`]: 30 bits, of which weights and (n_x + i n_y)^m have as many.
pub const ANY_PIXEL_Q31: f64 = 5e-7;
/// A pixel of d in f32, of the sizes of all its terms: roundings of 24 bits.
pub const ANY_PIXEL_F32: f64 = 1e-6;
/// A pixel of d, of the sizes of all its terms: 15 bits, and what is trimmed of the polynomials.
pub const ANY_IMAGE_Q15: f64 = 1e-3;
/// See [`ANY_IMAGE_Q15`]: less is trimmed.
pub const ANY_IMAGE_Q31: f64 = 1e-6;

/// d from a wire file in f32, of the largest: 2^-24 times some twenty roundings.
pub const WIRE_F32: f32 = 1e-6;
/// d from a wire file in 15 bits, of the largest: a few roundings of 2^-15.
pub const WIRE_Q15: f32 = 2e-4;
/// d from a wire file in 31 bits, of the largest: the comparison itself is in f32.
pub const WIRE_Q31: f32 = 2e-7;
/// Statics in f32 of a table that another host made, of the largest of their kind: 2^-23,
/// a rounding the other way.
pub const STATICS: f32 = 1.2e-7;
/// Images of forty components in f32 against direct quadrature, of the peak: what the other
/// components have.
pub const OWN_TABLE_F32: f64 = 2e-6;
/// The same in 15 bits: 65 dB and more below the image, at a single normal.
pub const OWN_TABLE_Q15: f64 = 6e-4;

/// Ways of `shade` to a pixel, all components of a scene of degree 4 and order 3 against the direct sum, rms of
/// the largest irradiance of all: what each leaves of so smooth images; cubics come down to the rounding of f32.
pub const WAYS: [(&str, f64); 7] = [
    ("--method table --knots 32 --interpolation linear", 1.5e-5),
    ("--method table --knots 128 --interpolation linear", 8e-7),
    ("--method table --knots 128 --interpolation cubic", 1e-7),
    ("--method baked --size 32 --interpolation linear", 1.2e-4),
    ("--method baked --size 64 --interpolation linear", 2.5e-5),
    ("--method baked --size 128 --interpolation linear", 7e-6),
    ("--method baked --size 64 --interpolation nearest", 3e-3),
];
/// Cubics through 48 knots, of the largest irradiance of four normals: the fourth power of 1/48, 2e-7, times some fourth
/// derivative, and roundings of f32; twice what was measured, 1e-6 at degree 17.
pub const SAMPLED_CUBIC: f32 = 2e-6;
/// The same of an object's image: it is summed over the whole span, whose weakest polynomials are steep
/// and cancel; twice what was measured.
pub const SAMPLED_CUBIC_OBJECT: f32 = 5e-4;

/// Rms error of the firmware's full scene over the rms peak: what its components and terms are
/// chosen for.
pub const FULL_SCENE: f64 = 1e-4;
/// `shade` in mantissas of 31 bits, all components against the direct sum, rms of the largest irradiance:
/// polynomials trimmed to 1e-8 of the database's rms.
pub const SHADED_Q31: f64 = 3e-8;
/// The same in 15 bits: 68 dB, as the worst pair of the shipped set; what is shaded is not the worst.
pub const SHADED_Q15: f64 = 2e-4;
/// A headroom on a page is rounded to a hundredth.
pub const HEADROOM_STATED: f64 = 0.006;
/// A figure that a page gives with two digits, relative: half a unit of the second is at
/// most a twentieth.
pub const STATED: f64 = 0.051;
/// The same of what f32 rounds, which is another half where multiplication and addition are fused.
pub const STATED_ROUNDING: f64 = 0.5;
/// A scene within a tolerance against the sum component by component, both in f32, of the
/// peak: some hundred roundings of 6e-8 of numbers a few times the peak, and as many in
/// turning powers into orthogonal polynomials and back.
pub const ECONOMY_ROUNDING: f64 = 4e-7;
/// Such a scene's error in f64 beyond its bound, of the bound: they are equal where all
/// components stay, but for some hundred roundings, 1e-14.
pub const ECONOMY_PARSEVAL: f64 = 1e-12;
/// The same of series whose recurrences are rounded to f32, 6e-8: polynomials are as orthogonal.
pub const ECONOMY_RECURRENCES: f64 = 1e-7;
/// A scene of a matte under light of degree 2 within 1e-3 of the peak against the nine-term
/// formula, of the peak: what is left out has no part in nine terms, so what remains is the
/// table's own error at 50 components, 1e-5 found.
pub const NINE_TERMS: f64 = 3e-5;
/// What the bound of such a scene is at most, in the median, in errors: it is exact but for
/// components that are left out, of which terms that are left out take a part along.
pub const ECONOMY_MEDIAN: f64 = 1.1;
/// The same of the images of a set in one shape, most of which are off by less than they may be:
/// their bounds are of what they lack all the same.
pub const ECONOMY_SET_MEDIAN: f64 = 1.1;
/// Products of a pixel within a tolerance, over the fewest that any lengths need: in the mean, and of
/// any image. Terms go at few prices, and none comes back.
pub const ECONOMY_FEWEST: [f64; 2] = [1.02, 1.25];
/// A bound against its parts, and what components are said to leave out against the sum of their
/// squares, of the bound: roundings of f32 of sums of some hundred squares.
pub const ECONOMY_PARTS: f64 = 2e-6;
/// By which factor the floor of such a scene is off what the table's components lack: in the
/// median, of nine images of ten, of all. The last fifth of the coefficients stands for those that
/// are missing, which fall off as fast in one image as in another, but for one or the other.
pub const ECONOMY_FLOOR: [f64; 3] = [1.1, 2.0, 4.0];
/// The largest of its 41 pixels, of the largest of some 3,100 others, 2 and 6 degrees apart: an
/// image of degree 9 changes by no more between them.
pub const ECONOMY_PEAK: f64 = 1.02;
/// An image's error at 600 normals over the bound that `shade --tolerance` prints: both errors and
/// peaks of so few normals are off by a few hundredths.
pub const PRINTED_BOUND: f64 = 1.05;
/// Largest error of the channels of twelve images that `shade --tolerance` made, of the tolerance,
/// at 600 normals for both the error and the peak: 0.9 to 1.
pub const SHADED_WITHIN: [f64; 2] = [0.8, 1.02];

// What the naive ways of `tests/stability` have to be off by, or their cases are none.

/// R_n^m to order 64 by its factorial sum, of values up to 1: terms up to 1e23, of which sixteen digits are
/// right.
pub const NAIVE_FACTORIALS: f64 = 1.0;
/// Profiles of some 30 terms by powers, of their largest value: the powers' coefficients are up to
/// (1 + √2)^30 = 3e11 times the series', and 1e-16 of that is rounded; a tenth of it.
pub const NAIVE_POWERS: f64 = 1e-6;
/// A third angle in the light alone, of the peak: the light is another one, by some per cent.
pub const NAIVE_FRAME: f64 = 0.01;
/// Share of M's computed eigenvalues that are negative: nine tenths of them are zero up to rounding, of
/// either sign.
pub const NAIVE_NEGATIVE: f64 = 0.25;
/// Share of M^(-1/2) that is NaN: one negative eigenvalue spoils its whole block.
pub const NAIVE_NOT_A_NUMBER: f64 = 0.99;
/// UᵀMU by the roots of the eigenvalues' sizes: rounding that is divided by itself is of order 1.
pub const NAIVE_ROOT: f64 = 0.1;
/// Blocks whose rank at 1e-17 is more than the exact one: one at least counts rounding.
pub const NAIVE_RANK: f64 = 1.0;
/// WᵀW by eigenvectors of squares: an image of 1e-9 has a square of 1e-18, far below the rounding of the largest,
/// 1e-16; divided by its root it leans on the others.
pub const NAIVE_SQUARES: f64 = 1e-8;
/// A slant of 1e-9 from acos(z), relative: 1 - 5e-19 is 1, and acos(1) is 0.
pub const NAIVE_SLANT: f64 = 0.5;
/// A row from pole to pole weighed with sin θ at its middle: π/2 for 1, 57 % too much.
pub const NAIVE_ROWS: f64 = 0.5;
/// Pictures of normals whose weights span twelve decades by eigenvectors of squares, of the peak: noise
/// below 1e-8 of the largest singular value, over weights whose roots are down to 1e-6.
pub const NAIVE_PICTURES: f64 = 1e-3;
/// Facets of `degenerate.obj` whose cross product has no length: those with two corners alike, and
/// those on a line of two digits.
pub const NAIVE_FACETS: f64 = 5.0;
/// d by a plain sum of a million pixels in f32, of the largest d: an addition near its end loses up to 6e-8 of the
/// sum, and runs of pixels lose alike: 1e-5, of which a fifth is asked for.
pub const NAIVE_SUM: f64 = 2e-6;
/// Components whose order and sign are compared: some 240 have eigenvalues above 1e-24 of the largest.
pub const LEAST_COMPARED: f64 = 200.0;

// What `docs/reading.md` says of its figures: those said in whole per cent are within half of one.

/// The posterior mean on half a disc with noise, of the peak, median and worst: 5 to 8 %, 29 %.
pub const READ_HALF_NOISY: [f64; 2] = [0.085, 0.295];
/// The same without noise, by all components: 1.0 %, 9 %.
pub const READ_HALF_NOISELESS: [f64; 2] = [0.0105, 0.095];
/// Least squares there with noise: 40 % and more.
pub const READ_HALF_SQUARES: f64 = 0.4;
/// Least squares over the posterior mean there: a third at most is what "only the posterior mean is
/// of use" means.
pub const READ_STATISTICS: f64 = 3.0;
/// The scalar product on 64 pixels without noise: 2 to 3 %, worst images included.
pub const READ_PRODUCT: std::ops::Range<f64> = 0.02..0.04;
/// Least squares over the posterior mean on a whole disc with 1 % noise and all components: "they fit
/// the noise".
pub const READ_NOISE_FITTED: f64 = 20.0;
/// d of half a disc by 50 components: 17 % with noise, and 24 % without, for what they leave is not
/// white, as the posterior mean takes it to be.
pub const READ_NOT_WHITE: [f64; 2] = [0.175, 0.235];
/// The light to degree 2 at 1 % noise, median: 14 %, and 8 % of a known material.
pub const READ_LIGHT: [f64; 2] = [0.145, 0.085];
/// The same from the product in the posterior modes: a third.
pub const READ_LIGHT_BY_PRODUCT: f64 = 0.34;
/// The light to degree 2 from the product in the least-norm modes, the least median: 0.73, most of it is
/// lost.
pub const READ_LEAST_NORM: f64 = 0.725;

// What `docs/paper.md` says of its figures.

/// An error of a partial sum, over its bound: below this it would tell nothing of it.
pub const BOUND_AT_WORK: f64 = 0.01;
/// What a partial sum leaves out at a pixel, of the peak: far above [`DIRECT_SUM`], so that a sum of all
/// terms is found out.
pub const LEFT_OUT: f64 = 1e-5;
/// Share of the Lambertian modes' variance beyond degree 2, at most, and beyond degree 1, at least: 0.744 %
/// and 12.5 %.
pub const PAPER_LAMBERTIAN: [f64; 2] = [0.01, 0.1];
/// Share of the variance beyond the paper's cuts: 0.7 to 0.75 %.
pub const PAPER_LEFT_OUT: std::ops::Range<f64> = 0.0069..0.0075;
/// Beyond one degree less, so many times as much: "some four times that".
pub const PAPER_ONE_DEGREE: f64 = 4.0;
/// Mean errors by standard over those by image-centred PCA: 1.000 to 1.025.
pub const PAPER_ALIKE: std::ops::Range<f64> = 0.999..1.03;
/// With three components, of which the constant is one of one only: so many times and more.
pub const PAPER_UNLIKE: f64 = 2.0;
/// Errors of the mattest material with five components and with ten: 7.91 %, and far less.
pub const PAPER_PLASTER: [f64; 2] = [0.1, 0.02];
/// Errors of velvet with five and eight components, at least, and nine, at most: 25.9 %, the step that component 8
/// makes, and 6.66 %.
pub const PAPER_VELVET: [f64; 3] = [0.2, 0.15, 0.07];
/// Errors of leather with 20 components, at least, and 30 and 50, at most: 1 % takes 26, and 50 leave
/// 0.102 %.
pub const PAPER_LEATHER: [f64; 3] = [0.015, 0.01, 0.0011];
/// Leather's brightest point, of the truth, with 10 and 30 components at most, and 50 at least: 83.2, 88.0 and
/// 96.4 %.
pub const PAPER_HIGHLIGHT: [f64; 3] = [0.85, 0.9, 0.95];
/// Errors of leather and velvet with ten components: 3.63 and 1.51 %, the shading is there.
pub const PAPER_SHADING: [f64; 2] = [0.05, 0.02];
/// The most over the least error of five components among lights, 19, over that among materials.
pub const PAPER_LIGHT_MATTERS: f64 = 3.0;
/// Rank correlation of that error with light from the front: -0.78.
pub const PAPER_CORRELATION: std::ops::Range<f64> = -0.9..-0.7;
/// Median error of the direct sum of 1,000 modes: 2.17 %.
pub const PAPER_SELECTED: std::ops::Range<f64> = 0.02..0.03;
/// Its worst: 57.7 %.
pub const PAPER_SELECTED_WORST: f64 = 0.5;
/// What all components of the 1,000 modes' basis leave of the images of all modes: 0.0141 % on average.
pub const PAPER_FLOOR: f64 = 2e-4;
/// Mean errors by the 1,000 modes' basis over those by all, to ten components: two per cent more at most.
pub const PAPER_SELECTED_FEW: f64 = 1.02;
/// The same with fifty: 0.121 % for 0.0799 %.
pub const PAPER_SELECTED_MANY: f64 = 1.4;
/// The uncorrelated sum is no bound: the share of images whose error exceeds it, 10.3 % and more, and how
/// many times the worst does.
pub const PAPER_NO_BOUND: [f64; 2] = [0.1, 1.3];
/// The bound over the plain triangle inequality: half and less.
pub const PAPER_TRIANGLE: f64 = 0.5;
/// The largest energy of a rotation, over the mean of all: "only on average" shows.
pub const PAPER_SINGLE_ROTATION: f64 = 1.2;
/// The bound of a rendered sphere, of its accuracy: one term less would be above it, and no term is a
/// twentieth of it.
pub const PAPER_BOUND_USED: f64 = 0.95;
/// Least product of a component and itself from another run, of unit length both; of another
/// or its negative it is near 0 or -1.
pub const SAME_COMPONENT: f64 = 0.5;

/// Posterior deviations over those of least squares, less one, at noises of 1e-3, 1e-6 and 1e-9: half the
/// noise's variance over the prior's, 6e-3 at the first, falls with its square, to rounding.
pub const READ_DEVIATIONS: [f64; 3] = [1e-2, 1e-8, 1e-11];
/// Derivatives of the error by L and b where the turns settle, of the largest L: roots of the 1e-14 by which
/// the error still falls.
pub const READ_RANK_ONE_SLOPE: f64 = 3e-7;
/// All components and noise of 1 and 5 %: the least squares' median image is off by so many times the posterior
/// mean's and more, 1.4 and 1.7.
pub const READ_SHRUNK_MEDIAN: f64 = 1.3;
/// The posterior mean's worst image over the least squares' at 1 and 5 %: 2.2 and 1.4 times.
pub const READ_SHRUNK_WORST: [std::ops::Range<f64>; 2] = [2.0..2.5, 1.3..1.6];
/// Least squares of 218 components on a disc of 64 pixels, of the noise: √(218 / 3000) is 0.27; 0.26 to 0.29.
pub const READ_QUARTER: [f64; 2] = [0.24, 0.31];

/// Factor by which a figure on the page of hard cases may differ from one measured now: errors
/// are a few last bits of what a host's library and vector width make of them.
pub const PAGE_FACTOR: f64 = 8.0;
/// Errors on that page below this may be nothing on another host.
pub const PAGE_ROUNDING: f64 = 1e-13;

/// Gloss tells the error at ten components: a rank correlation of 0.91 over 61 materials.
pub const PAPER_GLOSS: f64 = 0.85;
/// The share of standard PCA's first component that is constant over the sphere: most, not all.
pub const PAPER_FIRST_CONSTANT: std::ops::Range<f64> = 0.9..1.0;
/// Of 61 materials those within 10 % over all rotations, with five and six components: 32 and 44.
pub const PAPER_ROTATED_WITHIN: [usize; 2] = [31, 40];
/// What six components leave of velvet over all rotations.
pub const PAPER_ROTATED_VELVET: f64 = 0.15;
/// The ninth eigenimage stands at the rim, at least so much of its square in the outer tenth of the
/// disc, and has at most so much of the constant.
pub const PAPER_RIM: [f64; 2] = [0.3, 1e-6];
/// The least product of an eigenimage of all modes and that of the 1,000, of the first eleven.
pub const PAPER_PRODUCT: f64 = 0.99;
/// Of the discs, the share beyond the colours' end, at most, and how near the middle, radius, at least.
pub const PAPER_BEYOND: [f64; 2] = [0.01, 0.95];

/// The documented factors of degree 9 at widths 20 and 10: "20 %" to five points, "nearly nothing".
pub const WINDOW_STATED: [f64; 2] = [0.05, 1e-3];
/// A texel in integers is the nearest: half a unit, and what f32 rounds of 15 bits.
pub const TEXEL_ROUNDED: f32 = 0.501;
/// Texels of tens met 1e-6 inward of the rim.
pub const RIM_INWARD: f32 = 1e-4;
/// A quarter turn brings an axis to the next, not to its negative or the third.
pub const QUARTER_TURN: f64 = 0.999;
/// A polar integral of degree 9 and order 7 that is not zero, far above its rounding.
pub const COUPLES: f64 = 1e-4;
/// Pictures of effects, summed, against the picture of all, of the peak: rounding. docs/method.md
/// promises 1e-12.
pub const SUM_OF_EFFECTS: f64 = 9e-15;
/// An object's table of some effects against the direct sum over their modes, of the peak: the
/// rank's cut-off of 1e-10, amplified as far as six normals see the modes.
pub const OBJECT_OF_EFFECTS: f64 = 1e-10;
/// Tables of some effects in integers against f64, of the peak: seen 2e-7 and 6e-4.
pub const EFFECTS_Q31: f64 = 6e-7;
/// See [`EFFECTS_Q31`].
pub const EFFECTS_Q15: f64 = 2e-3;

/// An error that is rounding, of what the page of peers states for it: their sums run in the order
/// of the processor's width, ours with fused products or without.
pub const PEERS_ROUNDING: f64 = 3.0;

// What `experiments accuracy-cost --check` allows, and what its tests ask of its files.

/// An error of a setting, relative: hosts round differently, and rounding may end a polynomial a term
/// earlier or later, which moves the error of one cut short by a per cent.
pub const COST_ERROR: f64 = 0.02;
/// The same in any case: errors below that are roundings of f32, which fused multiplications halve.
pub const COST_ROUNDING: f64 = 1e-6;
/// Bytes, relative: such a term in all profiles of an azimuth.
pub const COST_BYTES: f64 = 0.02;
/// A fitted exponent of bytes, beside that of theory: lower powers are still there at the largest
/// sizes, (24 / 2 + 1)² of the order; and azimuths grow as the root of the components, so that rows of
/// 10 - |m| numbers shrink from 8 to 5 over three octaves, which is 0.23.
pub const COST_EXPONENT: f64 = 0.3;
/// The rms of a setting's error on other normals, relative: a thousand rings' normals against two
/// thousand spread evenly, with an error that stands at the rim.
pub const COST_NORMALS: f64 = 0.05;
/// Root mean square errors over 24 random rotations of each of seven lights and 150 normals, over
/// those of all rotations and normals, either way: 4 % at most of errors that are known.
pub const CHOICE_SAMPLED: f64 = 1.1;
/// The real error of a table that is chosen for a tolerance, of it, at least: the triangle
/// inequality for orders, and whole components; 0.797 with five.
pub const CHOICE_USED: f64 = 0.75;
/// What components leave against what is said of them: the same eigenvalues.
pub const CHOICE_SAID: f64 = 1e-9;
/// A pixel of a Lambertian scene under light of degree 2, over one by the nine-term formula: the
/// promise; 50 of 50 instructions on a Cortex-M0, 26 of 26 on a Cortex-M4F.
pub const OF_NINE_TERMS: f64 = 1.1;
/// A pixel of a typical scene at 1e-3, in nine-term pixels of nine multiply-adds: the promise; 15.6
/// on a Cortex-M0, 11.5 on a Cortex-M4F.
pub const TYPICAL_OF_NINE_TERMS: f64 = 16.0;
/// The nine-term formula in f64 against the integral of harmonics of degree 2: rounding of a few
/// dozen sums of numbers below 1.
pub const NINE_TERMS_F64: f64 = 1e-15;
/// The same in integers, of the sum of its coefficients' sizes: six roundings to 14 bits of that
/// sum, 5.2e-5 found, and to 30, 8.2e-10.
pub const NINE_TERMS_Q15: f64 = 6e-5;
/// See [`NINE_TERMS_Q15`].
pub const NINE_TERMS_Q31: f64 = 1e-9;
/// A scene of degree 2 in f32 against the nine-term formula in f64, of the peak: rounding of ten
/// sums.
pub const SAME_AS_NINE_TERMS: f64 = 1e-6;
/// Pictures of effects against sums over modes by hand, of the peak: rounding of 3,704 products.
pub const EFFECT_BY_HAND: f64 = 2e-14;
/// Figures of the page of the ablation have two digits, the last of which may be rounded either
/// way.
pub const ABLATION_PAGE: f64 = 0.1;
/// Errors on that page below this are roundings of f32, another number on another host.
pub const ABLATION_ROUNDING: f64 = 1e-6;
/// Counts in the settings' file, of four digits, against those of the firmware, relative: half of the
/// last digit of 1,000.
pub const COUNTED: f64 = 5e-4;
/// Words that a program holds besides a setting's folded material, d and scene: lengths and exponents
/// of each, and in 15 bits the room of a row that is padded.
pub const HELD_WORDS: f64 = 16.0;

/// Normals of 8 bits scaled to length 1: median rms, worst rms and worst pixel, of the peak. A
/// direction is off by up to 0.4 % of a radian, where images change by a few peaks in a radian.
pub const EIGHT_BITS: [f64; 3] = [2e-3, 4e-3, 3e-2];
/// The same as they are, rms of the peak of the worst pair.
pub const NAIVE_EIGHT_BITS: f64 = 2.5e-3;
/// Normals behind the rim taken as they are, times the rim's value: z = -0.01, and -0.1.
pub const NAIVE_BEHIND: [f64; 2] = [1.01, 1.5];
/// A normal that is laid on the rim: an image's slope times a rounding of f32.
pub const LAID_ON_RIM: f64 = 5e-6;
/// A sun in f32, rms of the peak: as of any light.
pub const SUN_F32: f64 = 1e-6;
/// The same in Q15: the worst pair's 68 dB.
pub const SUN_Q15: f64 = 4e-4;
/// A bound holds but for rounding, of images of some thousand times the error.
pub const SUN_BOUND: f64 = 1.0001;
/// A sun through maps of 64 x 64, baked in floats and in integers: [`BAKED`] of the worst, twice.
pub const SUN_BAKED: [f64; 2] = [1e-3, 1e-3];
/// How far a light of one direction, to degree 9, goes below zero, of the peak.
pub const RINGING: f64 = 5e-2;
/// Its least value by f32, Q15, within 1e-2 (rms), and maps of 64 x 64 in floats and integers, off
/// by this of the peak.
pub const DELTA: [f64; 5] = [1e-6, 1e-3, 0.1, 1e-3, 1e-3];
/// A thousand plain products in f32: roundings that add.
pub const NAIVE_DRIFT: f64 = 5e-6;
/// RRᵀ of any rotation in f32: sixteen roundings, and those of the sum itself.
pub const ORTHONORMAL_F32: f64 = 1.2e-6;
/// A thousand turns in f32: by their product, one by one, and the energy. An angle's rounding a
/// thousand times.
pub const DRIFT: [f64; 3] = [3e-5, 3e-5, 3e-5];
/// Matrices within 1e-3 of a rotation, as they are given.
pub const NAIVE_ALMOST: f64 = 9e-4;
/// Energy of a degree of a light turned in f32.
pub const ALMOST_ENERGY: f64 = 1e-6;
/// A mean of equal pixels: d has 31 bits.
pub const HALF_WEIGHT: f64 = 1e-8;
/// Energy of a light of any moderate numbers that was turned in f32.
pub const TURNED_ENERGY: f64 = 5e-6;
/// Look-ups of 8 knots and maps of 2 x 2 against their polynomials, of Σ |d|: the largest |U| is
/// some 10, and that of a polynomial continued beyond the rim ten times that.
pub const LARGEST_IMAGE: f64 = 100.0;
