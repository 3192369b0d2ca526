//! Which nodes of a palette an object needs.

use crate::normal_code::NormalCode;

/// Nodes along each axis, from code -128 to 128.
pub(crate) const SIDE: usize = 33;

/// The nodes of a [`Palette`](crate::screen::Palette) that an object needs.
///
/// ```
/// use eigenshade::Normal;
/// use eigenshade::object::NormalMap;
/// use eigenshade::screen::Nodes;
///
/// let codes = NormalMap::code(Normal::new(0.0, 0.3, 0.9)?);
/// let map = NormalMap::new(1, 1, &codes)?;
/// assert_eq!(map.nodes().count(), 4);
/// assert_eq!(Nodes::ALL.count(), 921);
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Nodes(pub(crate) [u64; SIDE]);

/// The nodes of these codes, such as those of [`NormalMap::nodes`](crate::object::NormalMap::nodes).
impl FromIterator<NormalCode> for Nodes {
    fn from_iter<I: IntoIterator<Item = NormalCode>>(codes: I) -> Self {
        let mut nodes = Self([0; SIDE]);
        for code in codes {
            let ([column, row], _) = code.cell();
            nodes.0.iter_mut().skip(row).take(2).for_each(|row| *row |= 3 << column);
        }
        nodes
    }
}

impl Nodes {
    /// The nodes of every normal. A picture of a sphere needs fewer: 803 at 240 x 240 pixels.
    pub const ALL: Self = all();

    /// The number of nodes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.iter().map(|row| row.count_ones() as usize).sum()
    }
}

#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
const fn all() -> Nodes {
    let (mut nodes, mut row) = ([0; SIDE], 0);
    while row < SIDE - 1 {
        let mut column = 0;
        while column < SIDE - 1 {
            if NormalCode::inside([nearest(column), nearest(row)]).is_some() {
                nodes[row] |= 3 << column;
                nodes[row + 1] |= 3 << column;
            }
            column += 1;
        }
        row += 1;
    }
    Nodes(nodes)
}

/// Of the eight codes after a node, the one nearest to zero.
const fn nearest(node: usize) -> u8 {
    let first = (8 * node) as u8 ^ 0x80;
    if first < 0x80 { first } else { first + 7 }
}
