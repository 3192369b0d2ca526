//! The command that made a file, for the file's first line.

/// `eigenshade` and its arguments as given. Arguments that contain blanks or control characters are
/// quoted.
#[must_use]
pub fn command_line() -> String {
    let arguments = std::env::args_os().skip(1);
    let arguments = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once("eigenshade".to_owned()).chain(arguments).collect::<Vec<_>>().join(" ")
}

fn quoted(argument: &str) -> String {
    let is_odd = |letter: char| letter.is_whitespace() || letter.is_control();
    if argument.is_empty() || argument.contains(is_odd) {
        format!("{argument:?}")
    } else {
        argument.to_owned()
    }
}
