//! Wire files: written, told, refused.

use crate::support::{self, Folder, assert_fails, scene};
use std::fs;

#[test]
fn pack_writes_what_info_tells() {
    let folder = Folder::with_table();
    for format in ["f32", "q15", "q31"] {
        let said = folder.ok(&format!("pack b.bin --format {format} --out w.esw"));
        let bytes = fs::read(folder.path("w.esw")).unwrap();
        assert!(bytes.starts_with(b"EIGSWIRE"));
        let length = eigenshade_cli::output::number::grouped(bytes.len());
        let (bytes, error) = said.split_once('\n').expect("two lines");
        assert_eq!(bytes, format!("bytes        {length}"));
        assert!(error.starts_with("error        ") && error.contains("of the peak"), "{error}");
        let told = folder.ok("info w.esw");
        for line in [
            "wire version             1".to_owned(),
            format!("format                   {format}"),
            format!("degree                   {}", support::DEGREE),
            format!("order                    {}", support::ORDER),
            format!("file                     {length:>9} bytes"),
        ] {
            assert!(told.lines().any(|found| found == line), "no `{line}` in {told}");
        }
    }
}

#[test]
fn what_has_no_wire_file_is_refused() {
    let folder = Folder::with_table();
    folder.write("scene.toml", scene("standard", 10, "[]"));
    folder.ok("basis --scene scene.toml --out mean.bin");
    folder.ok("pack mean.bin --out w.esw");
    for format in ["q15", "q31"] {
        let arguments = format!("pack mean.bin --format {format} --out v.esw");
        assert_fails(&folder, &arguments, &["mean.bin: ", "mean image", "image-centered"]);
    }
    let stored = scene("image-centered", 10, "[]") + "store = \"materials\"\n";
    folder.write("scene.toml", stored);
    folder.ok("basis --scene scene.toml --out folded.bin");
    assert_fails(
        &folder,
        "pack folded.bin --out v.esw",
        &["folded.bin: ", "store = \"projection\""],
    );
    assert_fails(&folder, "pack scene.toml --out v.esw", &["not an eigenshade table"]);
    assert_fails(&folder, "pack b.bin --out none/v.esw", &["none/v.esw", "folder exists"]);
}

#[test]
fn damaged_wire_files_are_refused() {
    let folder = Folder::with_table();
    folder.ok("pack b.bin --out w.esw");
    let bytes = fs::read(folder.path("w.esw")).unwrap();
    folder.write("short.esw", &bytes[..200]);
    assert_fails(&folder, "info short.esw", &["short.esw: ", "200 found", "take all"]);
    let mut damaged = bytes;
    damaged[300] ^= 1;
    folder.write("damaged.esw", &damaged);
    assert_fails(&folder, "info damaged.esw", &["damaged.esw: ", "checksum"]);
    folder.ok("pack b.bin --big-endian --out big.esw");
    assert_fails(&folder, "info big.esw", &["big.esw: ", "byte order", "--big-endian"]);
}
