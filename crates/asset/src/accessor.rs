//! Numbers in the buffers of glTF: accessors of every type, also quantized and sparse.

use eigenshade_model::error::{Error, Result};
use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::{Accessor, buffer};

/// The error for a broken file.
pub(crate) fn broken(what: impl Into<String>) -> Error {
    Error::new(what, "export the object again as glTF 2.0")
}

/// The buffers of a file.
pub(crate) struct Accessors<'a> {
    pub(crate) buffers: &'a [Vec<u8>],
}

/// Elements of `size` bytes, `stride` bytes apart.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    size: usize,
}

impl<'a> Elements<'a> {
    fn at(&self, number: usize) -> &'a [u8] {
        // Checked by `Accessors::elements`.
        let start = number * self.stride;
        self.bytes.get(start..start + self.size).unwrap_or_default()
    }
}

impl<'a> Accessors<'a> {
    /// The bytes of a view.
    pub(crate) fn view(&self, view: &buffer::View<'_>) -> Result<&'a [u8]> {
        let bytes = self.buffers.get(view.buffer().index()).map(Vec::as_slice);
        let end = view.offset().checked_add(view.length());
        let part = bytes.zip(end).and_then(|(bytes, end)| bytes.get(view.offset()..end));
        part.ok_or_else(|| broken(format!("its view {} is beyond its buffer", view.index())))
    }

    fn elements(
        &self,
        view: &buffer::View<'_>,
        [offset, count, size]: [usize; 3],
    ) -> Result<Elements<'a>> {
        let bytes = self.view(view)?;
        let stride = view.stride().unwrap_or(size);
        let end = count.saturating_sub(1).checked_mul(stride);
        let end = end.and_then(|end| end.checked_add(size)?.checked_add(offset));
        if stride < size || end.is_none_or(|end| count > 0 && end > bytes.len()) {
            return Err(broken(format!("{count} elements are beyond its view {}", view.index())));
        }
        Ok(Elements { bytes: bytes.get(offset..).unwrap_or_default(), stride, size })
    }

    /// The elements of an accessor, with `N` numbers each: as they are, or from 0 or -1 to 1 if they
    /// are normalized integers.
    pub(crate) fn numbers<const N: usize>(&self, accessor: &Accessor<'_>) -> Result<Vec<[f32; N]>> {
        let found = match accessor.dimensions() {
            Dimensions::Scalar => 1,
            Dimensions::Vec2 => 2,
            Dimensions::Vec3 => 3,
            Dimensions::Vec4 => 4,
            Dimensions::Mat4 => 16,
            _ => 0,
        };
        if found != N {
            return Err(broken(format!("accessor {} has other dimensions", accessor.index())));
        }
        let kind = accessor.data_type();
        let width = kind.size();
        let number = |bytes: &[u8]| match accessor.normalized() {
            true => normalized(kind, bytes),
            false => plain(kind, bytes),
        };
        let element = |bytes: &[u8]| {
            let mut all = [0.0; N];
            for (value, bytes) in all.iter_mut().zip(bytes.chunks_exact(width)) {
                *value = number(bytes);
            }
            all
        };
        let (count, size) = (accessor.count(), N * width);
        let mut all = match accessor.view() {
            Some(view) => {
                let elements = self.elements(&view, [accessor.offset(), count, size])?;
                (0..count).map(|number| element(elements.at(number))).collect()
            }
            None if count as u64 <= MOST => vec![[0.0; N]; count],
            None => return Err(broken(format!("accessor {} is too large", accessor.index()))),
        };
        if let Some(sparse) = accessor.sparse() {
            let (indices, values, changed) = (sparse.indices(), sparse.values(), sparse.count());
            let kind = match indices.index_type() {
                IndexType::U8 => DataType::U8,
                IndexType::U16 => DataType::U16,
                IndexType::U32 => DataType::U32,
            };
            let places =
                self.elements(&indices.view(), [indices.offset(), changed, kind.size()])?;
            let values = self.elements(&values.view(), [values.offset(), changed, size])?;
            for change in 0..changed {
                let place = whole(kind, places.at(change));
                let value = all.get_mut(place as usize);
                *value.ok_or_else(|| broken("a sparse index is beyond its accessor"))? =
                    element(values.at(change));
            }
        }
        Ok(all)
    }

    /// The whole numbers of an accessor.
    pub(crate) fn indices(&self, accessor: &Accessor<'_>) -> Result<Vec<u32>> {
        let kind = accessor.data_type();
        let is_index = matches!(kind, DataType::U8 | DataType::U16 | DataType::U32);
        match accessor.view() {
            Some(view) if is_index && accessor.dimensions() == Dimensions::Scalar => {
                let (count, size) = (accessor.count(), kind.size());
                let elements = self.elements(&view, [accessor.offset(), count, size])?;
                Ok((0..count).map(|number| whole(kind, elements.at(number))).collect())
            }
            _ => Err(broken(format!("accessor {} holds no indices", accessor.index()))),
        }
    }
}

/// The most elements that take no bytes.
const MOST: u64 = 1 << 22;

fn whole(kind: DataType, bytes: &[u8]) -> u32 {
    match (kind, bytes) {
        (DataType::U8, [a]) => u32::from(*a),
        (DataType::U16, [a, b]) => u32::from(u16::from_le_bytes([*a, *b])),
        (DataType::U32, [a, b, c, d]) => u32::from_le_bytes([*a, *b, *c, *d]),
        _ => 0,
    }
}

fn plain(kind: DataType, bytes: &[u8]) -> f32 {
    match (kind, bytes) {
        (DataType::F32, [a, b, c, d]) => f32::from_le_bytes([*a, *b, *c, *d]),
        (DataType::I8, [a]) => f32::from(a.cast_signed()),
        (DataType::I16, [a, b]) => f32::from(i16::from_le_bytes([*a, *b])),
        _ => whole(kind, bytes) as f32,
    }
}

fn normalized(kind: DataType, bytes: &[u8]) -> f32 {
    let full = match kind {
        DataType::I8 => 127.0,
        DataType::U8 => 255.0,
        DataType::I16 => 32767.0,
        DataType::U16 => 65535.0,
        DataType::U32 => u32::MAX as f32,
        DataType::F32 => 1.0,
    };
    (plain(kind, bytes) / full).max(if kind == DataType::F32 { f32::NEG_INFINITY } else { -1.0 })
}
