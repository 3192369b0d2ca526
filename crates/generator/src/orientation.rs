//! How the rows of a file lie in the picture that it shows.

use exif::{In, Reader, Tag};

/// A turn by right angles, with or without a reflection: the file's rows become columns or not,
/// then left and right, and top and bottom, are exchanged or not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Orientation {
    /// Whether the rows of the file are columns of the picture.
    pub transposed: bool,
    /// Whether the first of the picture's columns is at the right.
    pub from_right: bool,
    /// Whether the first of the picture's rows is at the bottom.
    pub from_bottom: bool,
}

impl Orientation {
    /// The orientation that a block of EXIF data states, if it is another than that of the file.
    /// Data that cannot be read state none, as they do to a viewer.
    #[must_use]
    pub fn of_exif(data: &[u8]) -> Option<Self> {
        let exif = Reader::new().read_raw(data.to_vec()).ok()?;
        let code = exif.get_field(Tag::Orientation, In::PRIMARY)?.value.get_uint(0)?;
        let of = |transposed, from_right, from_bottom| Self { transposed, from_right, from_bottom };
        Some(match code {
            2 => of(false, true, false),
            3 => of(false, true, true),
            4 => of(false, false, true),
            5 => of(true, false, false),
            6 => of(true, true, false),
            7 => of(true, true, true),
            8 => of(true, false, true),
            _ => return None,
        })
    }

    /// Width and height of the picture, of those of the file, or the other way round.
    #[must_use]
    pub fn size(self, [width, height]: [usize; 2]) -> [usize; 2] {
        if self.transposed { [height, width] } else { [width, height] }
    }

    /// Where the pixel of this column and row of the file is in a picture of this size, row by row.
    #[must_use]
    pub fn place(self, [column, row]: [usize; 2], [width, height]: [usize; 2]) -> usize {
        let [x, y] = self.size([column, row]);
        let x = if self.from_right { width - 1 - x } else { x };
        let y = if self.from_bottom { height - 1 - y } else { y };
        y * width + x
    }

    /// The pixels of a file of this width and height, row by row, as the picture has them.
    #[must_use]
    pub fn picture<T: Copy>(self, pixels: Vec<T>, size: [usize; 2]) -> Vec<T> {
        if self == Self::default() {
            return pixels;
        }
        let mut picture = pixels.clone();
        for (number, pixel) in pixels.iter().enumerate() {
            let place = [number % size[0], number / size[0]];
            picture[self.place(place, self.size(size))] = *pixel;
        }
        picture
    }
}
