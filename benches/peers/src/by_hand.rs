//! A small dense matrix times a vector by hand, in loops that a compiler makes vectors of.

/// Numbers in a vector of the target.
const LANES: usize = if cfg!(target_feature = "avx512f") {
    16
} else if cfg!(target_feature = "avx") {
    8
} else {
    4
};

/// Rows whose sums are taken at once.
const ROWS: usize = 4;

/// So many numbers and zeros, to whole vectors.
pub const fn padded(count: usize) -> usize {
    count.next_multiple_of(LANES)
}

/// A matrix of `K` rows or fewer, `padded`.
pub struct ByHand<const K: usize> {
    columns: Vec<[f32; K]>,
    /// Row by row, in groups of [`ROWS`], each row of whole vectors.
    rows: Vec<[Vec<[f32; LANES]>; ROWS]>,
}

impl<const K: usize> ByHand<K> {
    /// Of rows of one length.
    pub fn new(rows: &[Vec<f32>]) -> Self {
        let number = |row: usize, column: usize| {
            rows.get(row).and_then(|row| row.get(column)).copied().unwrap_or(0.0)
        };
        let length = rows[0].len();
        let columns = (0..length).map(|column| std::array::from_fn(|row| number(row, column)));
        let vectors = |row: usize| {
            let vector = |k: usize| std::array::from_fn(|lane| number(row, LANES * k + lane));
            (0..length.div_ceil(LANES)).map(vector).collect()
        };
        let group = |first: usize| std::array::from_fn(|row| vectors(ROWS * first + row));
        Self {
            columns: columns.collect(),
            rows: (0..rows.len().div_ceil(ROWS)).map(group).collect(),
        }
    }

    /// The product, a column after the other: all sums at once. What is beyond the rows is 0.
    #[inline(never)]
    pub fn by_columns(&self, by: &[f32]) -> [f32; K] {
        let mut sums = [0.0; K];
        for (column, &by) in self.columns.iter().zip(by) {
            for (sum, &number) in sums.iter_mut().zip(column) {
                *sum = add_product(*sum, number, by);
            }
        }
        sums
    }

    /// The product, [`ROWS`] rows after the others. `by` is [`padded`].
    #[inline(never)]
    pub fn by_rows(&self, by: &[f32]) -> [f32; K] {
        let (by, _) = by.as_chunks::<LANES>();
        let mut products = [0.0; K];
        for (to, rows) in products.chunks_mut(ROWS).zip(&self.rows) {
            let mut sums = [[0.0; LANES]; ROWS];
            let [a, b, c, d] = rows;
            for ((((by, a), b), c), d) in by.iter().zip(a).zip(b).zip(c).zip(d) {
                for (sums, row) in sums.iter_mut().zip([a, b, c, d]) {
                    for ((sum, &number), &by) in sums.iter_mut().zip(row).zip(by) {
                        *sum = add_product(*sum, number, by);
                    }
                }
            }
            for (to, sums) in to.iter_mut().zip(sums) {
                *to = sums.iter().sum();
            }
        }
        products
    }
}

/// sum + a b, fused where the target fuses.
#[inline(always)]
fn add_product(sum: f32, a: f32, b: f32) -> f32 {
    if cfg!(target_feature = "fma") { a.mul_add(b, sum) } else { sum + a * b }
}
