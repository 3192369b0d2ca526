//! What C sees: structures and functions.

/// Declares structures of C. Tests list their definitions.
macro_rules! records {
    ($($name:ident = $in_c:literal $($format:ty)?: $($field:ident: $type:ty),*;)*) => {$(
        #[derive(Clone)]
        #[repr(C)]
        pub(crate) struct $name {
            $(pub(crate) $field: $type),*
        }

        // SAFETY: all of its fields are plain.
        unsafe impl Plain for $name where $($type: Plain),* {}

        #[cfg(test)]
        impl crate::header::Declared for $name
        where
            $($type: crate::header::Declared),*
        {
            fn declare(name: &str) -> std::string::String {
                let of_format: &[&str] = &[$("_", <$format as crate::export::Format>::NAME)?];
                std::format!("struct eigenshade_{}{}_t {name}", $in_c, of_format.concat())
            }

            fn define() -> std::string::String {
                crate::header::structure::<Self>(&[$(<$type>::declare(stringify!($field))),*])
            }
        }
    )*};
}
pub(crate) use records;

/// Exports functions of this module in one format as `eigenshade_FUNCTION_FORMAT`, those of a
/// generic function for the type in brackets. Tests list their declarations and the structures that
/// these need.
macro_rules! export {
    (
        $declarations:ident $format:literal
        $($function:ident $(<$type_of_format:ty>)? ($($argument:ident: $type:ty),*))*
    ) => {
        // In a block, because the functions of the formats have the same names in Rust.
        const _: () = {
            $(
                #[unsafe(export_name = concat!("eigenshade_", stringify!($function), "_", $format))]
                extern "C" fn $function($($argument: $type),*) -> Status {
                    self::$function$(::<$type_of_format>)?($($argument),*).into()
                }
            )*
        };

        #[cfg(test)]
        pub(crate) fn $declarations() -> std::vec::Vec<std::string::String> {
            use crate::header::Declared;
            std::vec![$(
                $(<$type>::define(),)*
                crate::header::function(
                    concat!(stringify!($function), "_", $format),
                    &[$(<$type>::declare(stringify!($argument))),*],
                ),
            )*]
        }
    };
}
pub(crate) use export;

/// A number format, with the end of the names of its functions.
#[cfg(test)]
pub(crate) trait Format {
    const NAME: &'static str;
}

#[cfg(test)]
impl Format for f32 {
    const NAME: &'static str = "f32";
}

#[cfg(test)]
impl Format for eigenshade::Q15 {
    const NAME: &'static str = "q15";
}
