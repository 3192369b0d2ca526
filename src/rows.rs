//! Rows of records in a file: a table of where each begins, then the records.

/// The rows of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Rows<'a, const N: usize> {
    /// The first record of each row, and the number of all.
    starts: &'a [[u8; 4]],
    records: &'a [[u8; N]],
}

impl<'a, const N: usize> Rows<'a, N> {
    /// So many rows, at least one; `None` if bytes are missing. Bytes after them are ignored.
    pub(crate) const fn read(bytes: &'a [u8], height: u16) -> Option<Self> {
        let Some((starts, rest)) = bytes.split_at_checked((height as usize + 1) * 4) else {
            return None;
        };
        let starts: &[[u8; 4]] = starts.as_chunks().0;
        let [[0, 0, 0, 0], .., end] = starts else { return None };
        let records: &[[u8; N]] = rest.as_chunks().0;
        match records.split_at_checked(u32::from_le_bytes(*end) as usize) {
            Some((records, _)) => Some(Self { starts, records }),
            None => None,
        }
    }

    /// The records of a row; `None` beyond the last one, or if its end lies before its start.
    pub(crate) const fn get(&self, row: usize) -> Option<&'a [[u8; N]]> {
        let Some((_, [start, end, ..])) = self.starts.split_at_checked(row) else { return None };
        let end = u32::from_le_bytes(*end) as usize;
        let Some((records, _)) = self.records.split_at_checked(end) else { return None };
        match records.split_at_checked(u32::from_le_bytes(*start) as usize) {
            Some((_, records)) => Some(records),
            None => None,
        }
    }
}
