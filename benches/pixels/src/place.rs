//! Numbers that start a cache line, and where a page is divided so that what is written does not
//! look like what is read: processors compare the low twelve bits of an address first.

/// Bytes of a cache line.
const LINE: usize = 64;
/// Bytes after which those bits come again.
const PAGE: usize = 4096;

/// So many numbers.
pub struct Placed {
    numbers: Vec<f32>,
    first: usize,
    count: usize,
}

impl Placed {
    /// Zeros; `quarter`, 0 to 3, says where in a page they begin.
    pub fn zeros(count: usize, quarter: usize) -> Self {
        let numbers = vec![0.0; count + PAGE / size_of::<f32>()];
        let wanted = quarter * PAGE / 4 + quarter * LINE;
        let to_go = (wanted + PAGE - numbers.as_ptr().addr() % PAGE) % PAGE;
        Self { first: to_go / size_of::<f32>(), numbers, count }
    }

    /// All of them.
    pub fn all(&self) -> &[f32] {
        &self.numbers[self.first..][..self.count]
    }

    /// All of them, to be written.
    pub fn all_mut(&mut self) -> &mut [f32] {
        &mut self.numbers[self.first..][..self.count]
    }
}
