//! The wire format: tables as bytes that the runtime reads where they lie.
//!
//! `tables/README.md` has it byte by byte. What is here is what its writer, in
//! `eigenshade-table`, and its reader, in `eigenshade`, agree on.

/// The first bytes of every wire file.
pub const LABEL: [u8; 8] = *b"EIGSWIRE";

/// The number that stands behind the label in the byte order of all that follows.
pub const MARK: u32 = 0x0102_0304;

/// The version of wire files.
pub const VERSION: u16 = 1;

/// A file, and each of its sections, starts at a multiple of so many bytes.
pub const ALIGNMENT: usize = 4;

/// Bytes of the header: label, mark, version, format, length, shape.
pub const HEADER: usize = 32;

/// Bytes of a section's entry behind the header: where it starts, how long it is.
pub const ENTRY: usize = 8;

/// Bytes of the checksum, which are a file's last.
pub const CHECKSUM: usize = 4;

/// The largest degree and order of a wire file: with these no size overflows 32 bits.
pub const MOST: usize = 256;

/// Where the numbers of the header stand.
pub mod place {
    /// u32: [`MARK`](super::MARK).
    pub const MARK: usize = 8;
    /// u16: the version.
    pub const VERSION: usize = 12;
    /// u16: a number of [`format`](super::format).
    pub const FORMAT: usize = 14;
    /// u32: bytes of the whole file.
    pub const LENGTH: usize = 16;
    /// u16: largest degree l of the light.
    pub const DEGREE: usize = 20;
    /// u16: largest order o of the BRDF.
    pub const ORDER: usize = 22;
    /// u16: number of components, of the span where there are eigenimages besides.
    pub const COMPONENTS: usize = 24;
    /// u16: number of eigenimages over the span; 0 where the components are the
    /// eigenimages.
    pub const IMAGES: usize = 26;
    /// u16: number of sections.
    pub const SECTIONS: usize = 28;
    /// u16: the bits of the effects that the table is for.
    pub const EFFECTS: usize = 30;
}

/// Number formats.
pub mod format {
    /// Numbers are `f32`.
    pub const F32: u16 = 1;
    /// Numbers are mantissas of 15 bits.
    pub const Q15: u16 = 2;
    /// Numbers are mantissas of 31 bits.
    pub const Q31: u16 = 3;
}

/// Sections of floats that every file has; of those behind them the last that are empty are left
/// out.
pub const ALWAYS: usize = 15;

/// The sections of floats, by their place in the file.
pub const FLOATS: [&str; 17] = [
    "profiles",
    "passes",
    "slots",
    "couplings",
    "lengths",
    "polar",
    "factors",
    "terms",
    "mean",
    "mean coefficients",
    "selection",
    "projection",
    "synthesis",
    "span mean",
    "image mean",
    "ambient",
    "recurrences",
];

/// The sections of integers, by their place in the file.
pub const INTEGERS: [&str; 7] =
    ["profiles", "lengths", "polar", "polar exponents", "factors", "factor exponents", "terms"];
