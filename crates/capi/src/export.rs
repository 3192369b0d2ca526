//! The names of functions in C.

/// Exports functions of this module in one format as `eigenshade_FUNCTION_FORMAT`, and lists their
/// declarations in C for the test of the header.
macro_rules! export {
    (
        $declarations:ident $format:literal
        $($function:ident($($argument:ident: $type:ty),*))*
    ) => {
        // In a block, because the functions of the formats have the same names in Rust.
        const _: () = {
            $(
                #[unsafe(export_name = concat!("eigenshade_", stringify!($function), "_", $format))]
                extern "C" fn $function($($argument: $type),*) -> Status {
                    self::$function($($argument),*).into()
                }
            )*
        };

        #[cfg(test)]
        pub(crate) fn $declarations() -> std::vec::Vec<std::string::String> {
            use crate::header::Declared;
            std::vec![$({
                let arguments = [$(<$type>::declare(stringify!($argument))),*].join(", ");
                let name = concat!("eigenshade_", stringify!($function), "_", $format);
                std::format!("eigenshade_status {name}({arguments});")
            }),*]
        }
    };
}
pub(crate) use export;
