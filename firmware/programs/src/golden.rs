//! The golden vectors of `tests/golden/sphere.csv`, as statics in modules `f32` and `q15`.

/// A light on a material, and the expected results. Only integer formats use the exponents.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S: 'static, A: 'static> {
    /// Coefficients of the light, and their exponent.
    pub light: &'static Light<S>,
    /// Coefficients of the material, and their exponents.
    pub material: &'static Material<S>,
    /// Coefficients of the image, and their exponent.
    pub d: (&'static [A], i32),
    /// Irradiances of the normals, and their exponent.
    pub irradiance: (&'static [A], i32),
}

/// Coefficients of a light, and their exponent.
pub type Light<S> = (&'static [S], i32);
/// Coefficients of a material, and the exponents of each o.
pub type Material<S> = (&'static [S], &'static [i8]);

include!(concat!(env!("OUT_DIR"), "/golden.rs"));

/// The number of right answers, and of all.
#[derive(Clone, Copy, Debug)]
pub struct Tally {
    right: u32,
    all: u32,
}

impl Tally {
    /// Counts an answer.
    pub fn count(&mut self, is_right: bool) {
        self.right += u32::from(is_right);
        self.all += 1;
    }
}

/// Compares all pairs and prints how many answers are right. Ends the program if one is not.
pub fn compare_all<P>(
    pairs: &[P],
    compare: impl Fn(&P, &mut Tally) -> Result<(), eigenshade::Error>,
) {
    let mut tally = Tally { right: 0, all: 0 };
    for pair in pairs {
        if compare(pair, &mut tally).is_err() {
            board::exit(false);
        }
    }
    board::print("golden");
    board::print_u32(tally.right);
    board::print(" of");
    board::print_u32(tally.all);
    board::print("\n");
    if tally.right != tally.all {
        board::exit(false);
    }
}
