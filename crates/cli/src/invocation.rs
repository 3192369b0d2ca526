//! The command that made a file, for the file's first line.

/// `eigenshade` and its arguments as they were given; those with blanks in them
/// in quotation marks.
#[must_use]
pub fn command_line() -> String {
    let arguments = std::env::args_os().skip(1);
    let arguments = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once("eigenshade".to_owned()).chain(arguments).collect::<Vec<_>>().join(" ")
}

fn quoted(argument: &str) -> String {
    if argument.is_empty() || argument.contains(char::is_whitespace) {
        format!("{argument:?}")
    } else {
        argument.to_owned()
    }
}
