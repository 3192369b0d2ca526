//! The records of a table, each declared once as a list of fields.
//!
//! A record has a borrowed form, which the runtime reads, and an owned form, which the generator
//! fills. `visit` shows the arrays one by one to a writer of bytes or of Rust source, and `read`
//! takes them back in the same order.

pub mod floats;
pub mod integers;

pub use floats::{Pass, ProfilePlace, Row, Run};
pub use integers::{Profile, Q15};

use core::fmt::{self, Debug, Write};
use zerocopy::{FromBytes, Immutable, KnownLayout, TryFromBytes};

/// Marks a missing component.
pub const NONE: u16 = u16::MAX;

/// An element of an array of a record. The `Debug` of an item is a Rust expression wherever the
/// items of this module are in scope.
pub trait Item: Copy + Debug + TryFromBytes + KnownLayout + Immutable {
    /// Its type in Rust source.
    const TYPE: &'static str;
    /// Its numbers, in the order of its memory. A [`Word::Long`] is aligned to four bytes.
    fn words<F: FnMut(Word)>(self, to: &mut F);
}

/// A number of an [`Item`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// 8 bits.
    Byte(u8),
    /// 16 bits.
    Short(u16),
    /// 32 bits.
    Long(u32),
}

/// Takes the fields of a record.
pub trait Visitor {
    /// Takes a size.
    fn size(&mut self, _name: &'static str, _size: impl Size) {}
    /// Takes an array.
    fn array<T: Item>(&mut self, name: &'static str, items: &[T]);
}

/// Gives the arrays of a record.
pub trait Reader<'a> {
    /// Why an array cannot be given.
    type Error;
    /// The next array.
    ///
    /// # Errors
    ///
    /// If it does not consist of such items.
    fn array<T: Item>(&mut self) -> Result<&'a [T], Self::Error>;
}

/// A field of a record that is not an array.
pub trait Size: Copy {
    /// Writes it as a Rust expression.
    ///
    /// # Errors
    ///
    /// The error of `to`.
    fn write(self, to: &mut impl Write) -> fmt::Result;
}

impl Size for usize {
    fn write(self, to: &mut impl Write) -> fmt::Result {
        write!(to, "{self}")
    }
}

/// The words of numbers.
macro_rules! primitive {
    ($($type:ident $name:literal |$number:ident| $word:expr;)*) => {$(
        impl Item for $type {
            const TYPE: &'static str = $name;
            fn words<F: FnMut(Word)>(self, to: &mut F) {
                let $number = self;
                to($word);
            }
        }
    )*};
}
primitive! {
    u8 "u8" |number| Word::Byte(number);
    i8 "i8" |number| Word::Byte(number.cast_unsigned());
    bool "bool" |number| Word::Byte(number.into());
    u16 "u16" |number| Word::Short(number);
    i16 "i16" |number| Word::Short(number.cast_unsigned());
    u32 "u32" |number| Word::Long(number);
    i32 "i32" |number| Word::Long(number.cast_unsigned());
    f32 "f32" |number| Word::Long(number.to_bits());
    Q15 "eigenshade::specialized::record::Q15" |number| Word::Short(number.0.cast_unsigned());
}

impl Item for [f32; 2] {
    const TYPE: &'static str = "[f32; 2]";
    fn words<F: FnMut(Word)>(self, to: &mut F) {
        let [a, b] = self;
        a.words(to);
        b.words(to);
    }
}

/// A struct whose fields are items.
macro_rules! item {
    ($(#[$of:meta])* $Name:ident { $($(#[$doc:meta])* $field:ident: $kind:ty,)* }) => {
        $(#[$of])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, FromBytes, Immutable, KnownLayout)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[repr(C)]
        pub struct $Name { $($(#[$doc])* pub $field: $kind,)* }
        impl Item for $Name {
            const TYPE: &'static str = concat!("eigenshade::specialized::record::", stringify!($Name));
            fn words<F: FnMut(Word)>(self, to: &mut F) { $(self.$field.words(to);)* }
        }
    };
}
pub(crate) use item;

item! {
    /// Where the numbers of one |m| are.
    Azimuth {
        /// The number of the azimuth's first profile.
        first: u16,
        /// Number of profiles.
        profiles: u16,
        /// Position of the azimuth's polynomials in a scene: of +m, then of -m.
        start: u32,
        /// Position of the terms of the first profile.
        terms: u32,
        /// Number of rows of factors before the azimuth's own.
        rows: u32,
    }
}

impl Azimuth {
    /// Whether these are its numbers, in order.
    #[must_use]
    pub const fn is(&self, [first, profiles, start, terms, rows]: [usize; 5]) -> bool {
        self.first as usize == first
            && self.profiles as usize == profiles
            && self.start as usize == start
            && self.terms as usize == terms
            && self.rows as usize == rows
    }
}

/// A record of sizes and of arrays, borrowed and owned, in the order of a file. `S` is the number
/// format of the arrays `[S]`.
macro_rules! record {
    (
        $(#[$of:meta])* $path:literal $Parts:ident $Owned:ident
        sizes { $($(#[$of_size:meta])* $size:ident: $kind:ty,)* }
        arrays { $($(#[$doc:meta])* $array:ident: [$item:tt],)* }
    ) => {
        $(#[$of])*
        #[derive(Clone, Copy, Debug)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $Parts<'a, S> {
            $($(#[$of_size])* pub $size: $kind,)*
            $($(#[$doc])* pub $array: &'a [$item],)*
        }

        impl<'a, S: $crate::record::Item> $Parts<'a, S> {
            /// The record's name in Rust source.
            pub const PATH: &'static str = $path;
            /// The names of the arrays.
            pub const ARRAYS: &'static [&'static str] = &[$(stringify!($array)),*];

            /// Shows each field to `visitor`.
            pub fn visit(&self, visitor: &mut impl $crate::record::Visitor) {
                $(visitor.size(stringify!($size), self.$size);)*
                $(visitor.array(stringify!($array), self.$array);)*
            }

            /// Takes each array from `reader`.
            ///
            /// # Errors
            ///
            /// The error of the reader.
            pub fn read<R: $crate::record::Reader<'a>>(
                ($($size,)*): ($($kind,)*),
                reader: &mut R,
            ) -> Result<Self, R::Error> {
                Ok(Self { $($size,)* $($array: reader.array()?,)* })
            }
        }

        #[doc = concat!("The owned form of [`", stringify!($Parts), "`].")]
        #[cfg(feature = "alloc")]
        #[derive(Clone, Debug, PartialEq)]
        pub struct $Owned<S> {
            $($(#[$of_size])* pub $size: $kind,)*
            $($(#[$doc])* pub $array: alloc::vec::Vec<$item>,)*
        }

        #[cfg(feature = "alloc")]
        impl<S> $Owned<S> {
            /// The borrowed form.
            #[must_use]
            pub fn borrow(&self) -> $Parts<'_, S> {
                $Parts { $($size: self.$size,)* $($array: &self.$array,)* }
            }

            /// The same record with every number converted.
            #[must_use]
            pub fn convert<T>(&self, number: impl Fn(&S) -> T) -> $Owned<T> {
                $Owned {
                    $($size: self.$size,)*
                    $($array: record!(@convert self.$array, number, $item),)*
                }
            }
        }
    };
    (@convert $array:expr, $number:ident, S) => { $array.iter().map(&$number).collect() };
    (@convert $array:expr, $number:ident, $item:tt) => { $array.clone() };
}
pub(crate) use record;
