//! The committed header is what cbindgen makes of the sources now.

mod header;

#[test]
fn the_header_is_current() {
    let (path, made) = (header::path(), header::text());
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        found == made,
        "{} is not what the sources give; make it again with `{}`",
        path.display(),
        header::COMMAND
    );
}
