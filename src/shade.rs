//! Shading of many normals at a time, written so that the compiler vectorises it.

use crate::error::{Error, What};
use crate::normal::Normals;
use crate::polynomial;
use crate::scalar::Scalar;
use crate::scene::{Scene, argument, turned};

/// Normals in one block: as many as keep a target's vector registers busy.
const BLOCK: usize = if cfg!(target_feature = "avx512f") {
    64
} else if cfg!(target_feature = "avx2") {
    32
} else if cfg!(all(target_arch = "wasm32", not(target_feature = "simd128"))) {
    8
} else {
    16
};

impl<B> Scene<'_, B> {
    /// The irradiance of each normal, into `irradiance`.
    ///
    /// The sums are those of [`shade`](Self::shade) in the same order; the answers
    /// agree to the last bit.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` has one place for each normal.
    pub fn shade_slice<S: Scalar>(
        &self,
        normals: Normals<'_, S>,
        irradiance: &mut [S],
    ) -> Result<(), Error>
    where
        B: AsRef<[S]>,
    {
        Error::check(What::Normals, normals.len(), irradiance.len())?;
        let (x, x_rest) = normals.x.as_chunks::<BLOCK>();
        let (y, y_rest) = normals.y.as_chunks::<BLOCK>();
        let (z, z_rest) = normals.z.as_chunks::<BLOCK>();
        let (out, out_rest) = irradiance.as_chunks_mut::<BLOCK>();
        for (((x, y), z), out) in x.iter().zip(y).zip(z).zip(out) {
            *out = self.shade_block(x, y, z);
        }
        if !out_rest.is_empty() {
            let block = self.shade_block(&padded(x_rest), &padded(y_rest), &padded(z_rest));
            for (out, value) in out_rest.iter_mut().zip(block) {
                *out = value;
            }
        }
        Ok(())
    }

    #[inline]
    fn shade_block<S: Scalar>(&self, x: &[S; BLOCK], y: &[S; BLOCK], z: &[S; BLOCK]) -> [S; BLOCK]
    where
        B: AsRef<[S]>,
    {
        let t = z.map(argument);
        let (mut cosines, mut sines) = ([S::ONE; BLOCK], [S::ZERO; BLOCK]);
        let mut sums = [S::ZERO; BLOCK];
        for (plus, minus) in self.azimuths() {
            let plus = polynomial::values(plus, &t);
            let minus = polynomial::values(minus, &t);
            let around = cosines.iter_mut().zip(&mut sines).zip(x.iter().zip(y));
            let values = plus.iter().zip(&minus).zip(&mut sums);
            for (((cosine, sine), (&x, &y)), ((&plus, &minus), sum)) in around.zip(values) {
                *sum = sum.add_product(plus, *cosine).add_product(minus, *sine);
                (*cosine, *sine) = turned(*cosine, *sine, x, y);
            }
        }
        sums
    }
}

/// The rest of a slice, filled up to a block with zeros.
fn padded<S: Scalar>(rest: &[S]) -> [S; BLOCK] {
    let mut block = [S::ZERO; BLOCK];
    for (to, &from) in block.iter_mut().zip(rest) {
        *to = from;
    }
    block
}
