//! Coefficients and normals as text: what is written reads back to the last
//! bit, and every fault is named with its file, its line and a remedy.

use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::coefficient_csv::{
    read_lights, read_materials, write_lights, write_materials,
};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::read_normals;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// A folder with the file `in.csv`.
fn file(text: impl AsRef<[u8]>) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("in.csv");
    fs::write(&path, text).unwrap();
    (folder, path)
}

fn lights(text: impl AsRef<[u8]>, degree: Option<usize>) -> Result<Lights> {
    let (_folder, path) = file(text);
    read_lights(path, degree)
}

fn materials(text: &str, order: Option<usize>) -> Result<Materials> {
    let (_folder, path) = file(text);
    read_materials(path, order)
}

fn normals(text: &str) -> Result<Vec<[f64; 3]>> {
    let (_folder, path) = file(text);
    read_normals(path)
}

/// The message from the file's name on: `in.csv:3: ...; remedy`.
fn message<T: std::fmt::Debug>(result: Result<T>) -> String {
    let text = result.unwrap_err().to_string();
    assert!(!text.contains('\n'), "one line: {text}");
    text[text.find("in.csv").unwrap()..].to_owned()
}

fn assert_starts(text: &str, start: &str) {
    assert!(text.starts_with(start), "`{text}` is not `{start}...`");
    let (_, remedy) = text.rsplit_once("; ").unwrap();
    assert!(!remedy.is_empty());
}

const DEGREE_1: &str = "\
# made by hand
name,l,m,r,g,b
a,0,0,1,2,3
a,1,-1,4,5,6
a,1,0,7,8,9
a,1,1,10,11,12
";

#[test]
fn lights_are_read() {
    let read = lights(DEGREE_1, None).unwrap();
    assert_eq!(read.degree, 1);
    assert_eq!(read.entries.len(), 1);
    assert_eq!(read.entries[0].name, "a");
    assert_eq!(read.entries[0].rgb[1], [2.0, 5.0, 8.0, 11.0]);
    assert_eq!(lights(DEGREE_1, Some(1)).unwrap(), read);
    assert_eq!(lights(DEGREE_1, Some(0)).unwrap(), read.truncated(0));
}

#[test]
fn columns_and_rows_stand_in_any_order() {
    let read = lights(
        "\u{feff}note,value , m,l,name\r\n\r\nx,4,1,1,a\r\n,1,0,0,a\r\n# b\r\n,3,0,1,a\r\n,2,-1,1,a",
        None,
    )
    .unwrap();
    let gray = vec![1.0, 2.0, 3.0, 4.0];
    assert_eq!(read.entries[0].rgb, [gray.clone(), gray.clone(), gray]);
}

#[test]
fn a_lower_degree_needs_no_more_than_its_own_rows() {
    let text = format!("{DEGREE_1}b,0,0,1,1,1\n");
    assert_eq!(lights(&text, Some(0)).unwrap().entries.len(), 2);
    assert_starts(
        &message(lights(&text, None)),
        "in.csv:7: the light `b`, which begins here, has no row l = 1, m = -1; add",
    );
}

#[test]
fn materials_are_read() {
    let text = "name,o,p,q,value\nm,0,0,0,0.5\nm,1,1,1,-1e-2\nm,2,0,0,3\nm,2,2,0,4\nm,2,2,2,5\n";
    let read = materials(text, None).unwrap();
    assert_eq!(read.order, 2);
    assert_eq!(read.entries[0].rgb[2], [0.5, -0.01, 3.0, 4.0, 5.0]);
    assert_eq!(materials(text, Some(1)).unwrap(), read.truncated(1));
    assert_starts(
        &message(materials(&text.replace("m,2,2,0,4\n", ""), None)),
        "in.csv:2: the material `m`, which begins here, has no row o = 2, p = 2, q = 0; add",
    );
    for index in ["1,1,0", "2,1,1", "1,2,0", "2,2,3", "-1,-1,-1", "2,0,2", "1000000000,0,0"] {
        let text = format!("name,o,p,q,value\nm,{index},1\n");
        assert_starts(&message(materials(&text, None)), "in.csv:2: no material has o = ");
    }
}

#[test]
fn what_is_written_reads_back_to_the_last_bit() {
    let awkward = [0.1, -1.0 / 3.0, f64::MIN_POSITIVE / 8.0, -f64::MAX];
    let shifted = awkward.map(|v| v * 0.7);
    let color = Named {
        name: "#1, \"quoted\"".to_owned(),
        rgb: [awkward.to_vec(), shifted.to_vec(), awkward.to_vec()],
    };
    let gray =
        Named { name: "b".to_owned(), rgb: [awkward.to_vec(), awkward.to_vec(), awkward.to_vec()] };
    for (entries, header) in
        [(vec![gray.clone()], "name,l,m,value"), (vec![color, gray], "name,l,m,r,g,b")]
    {
        let lights_in = Lights { degree: 1, entries };
        let mut text = Vec::new();
        write_lights(&lights_in, &mut text).unwrap();
        assert!(text.starts_with(header.as_bytes()));
        assert_eq!(lights(text, None).unwrap(), lights_in);
    }
    let materials_in = Materials {
        order: 1,
        entries: vec![Named {
            name: "m".to_owned(),
            rgb: [vec![0.1, 1e-30], vec![1e21, 0.25], vec![-0.0, 5e-324]],
        }],
    };
    let mut text = Vec::new();
    write_materials(&materials_in, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    assert_eq!(text, "name,o,p,q,r,g,b\nm,0,0,0,0.1,1e21,-0\nm,1,1,1,1e-30,0.25,5e-324\n");
    assert_eq!(materials(&text, None).unwrap(), materials_in);
}

#[test]
fn what_could_not_be_read_back_is_not_written() {
    let light = |values: Vec<f64>| Lights {
        degree: 0,
        entries: vec![Named {
            name: "a".to_owned(),
            rgb: [values.clone(), values.clone(), values],
        }],
    };
    let refused = |lights| write_lights(&lights, &mut Vec::new()).unwrap_err().to_string();
    assert!(refused(light(vec![f64::NAN])).contains("not finite at l = 0, m = 0;"));
    assert!(refused(light(vec![1.0, 2.0])).contains("is not of degree 0;"));
}

#[test]
fn every_fault_of_a_row_has_its_line() {
    let with = |row: &str| format!("{DEGREE_1}\n# b follows\n{row}\nb,1,0,1,1,1\n");
    for (row, start) in [
        ("a,1,0,1,1,1", "in.csv:9: the light `a` has this index twice; "),
        ("b,1,2,1,1,1", "in.csv:9: no light has l = 1, m = 2; a valid index has "),
        ("b,1,-2,1,1,1", "in.csv:9: no light has l = 1, m = -2; "),
        ("b,-1,0,1,1,1", "in.csv:9: no light has l = -1, m = 0; "),
        ("b,1000000000,0,1,1,1", "in.csv:9: no light has l = 1000000000, m = 0; "),
        ("b,1,-9223372036854775808,1,1,1", "in.csv:9: no light has "),
        (
            "b,99999999999999999999,0,1,1,1",
            "in.csv:9: `99999999999999999999` is not a whole number; ",
        ),
        ("b,1.5,0,1,1,1", "in.csv:9: `1.5` is not a whole number; "),
        ("b,,0,1,1,1", "in.csv:9: `` is not a whole number; "),
        ("b,1,1,1,NaN,1", "in.csv:9: `NaN` is not a finite number; "),
        ("b,1,1,1,1,-inf", "in.csv:9: `-inf` is not a finite number; "),
        ("b,1,1,1e999,1,1", "in.csv:9: `1e999` is not a finite number; "),
        ("b,1,1,1,x,1", "in.csv:9: `x` is not a number; "),
        ("b,1,1,1,\"0,5\",1", "in.csv:9: `0,5` is not a number; "),
        ("b,1,1,1,,1", "in.csv:9: `` is not a number; "),
        (",1,1,1,1,1", "in.csv:9: the name is empty; "),
        ("b,1,1,1,1", "in.csv:9: the header has 6 fields, but this row has 5; "),
        ("b,1,1,1,1,1,1", "in.csv:9: the header has 6 fields, but this row has 7; "),
    ] {
        assert_starts(&message(lights(with(row), None)), start);
        let crlf = with(row).replace('\n', "\r\n");
        assert_starts(&message(lights(crlf, None)), start);
    }
    let mut binary = with("b,1,1,1,1,1").into_bytes();
    let place = binary.windows(4).position(|four| four == b"b,1,").unwrap();
    binary[place] = 0xff;
    assert_starts(&message(lights(binary, None)), "in.csv:9: it is not UTF-8 text; ");
}

#[test]
fn one_distant_index_allocates_nothing() {
    assert_starts(
        &message(lights("name,l,m,value\na,1024,0,1\n", None)),
        "in.csv:2: the light `a`, which begins here, has no row l = 0, m = 0; ",
    );
}

#[test]
fn files_without_lights_are_refused() {
    for (text, start) in [
        ("", "in.csv: it is empty; "),
        ("# only this\n", "in.csv: it is empty; "),
        ("name,l,m,r,g,b\n", "in.csv: it contains no light; "),
        ("# c\nname,l,m,r,g\na,0,0,1,1\n", "in.csv:2: its header is `name,l,m,r,g`; "),
        ("name,o,p,q,value\na,0,0,0,1\n", "in.csv:1: its header is "),
        ("l,m,value\n0,0,1\n", "in.csv:1: its header is "),
        ("a,0,0,1\n", "in.csv:1: its header is "),
        ("name,l,order,r,g,b\n", "in.csv:1: its header is "),
        ("name,l,m,r,r,b\n", "in.csv:1: column 5 has the same name as an earlier one, `r`; "),
        ("name,l,m,r,g,b,value\n", "in.csv:1: it has the columns `value` and `r`; "),
    ] {
        assert_starts(&message(lights(text, None)), start);
    }
    assert_starts(
        &message(lights(DEGREE_1, Some(2))),
        "in.csv: it has degree 1, but degree 2 is needed; ",
    );
    let folder = TempDir::new().unwrap();
    let missing = read_lights(folder.path().join("in.csv"), None);
    assert_starts(&message(missing), "in.csv: ");
    assert!(read_lights(folder.path(), None).is_err());
}

#[test]
fn normals_are_normalized_and_laid_on_the_rim() {
    let text = "x,y,z\n0,0,2\n3,-4,0\n1e308,0,0\n0,1e-320,0\n3,4,-0.004\n6e-301,-8e-301,0\n";
    let read = normals(text).unwrap();
    let expected = [
        [0.0, 0.0, 1.0],
        [0.6, -0.8, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.6, 0.8, 0.0],
        [0.6, -0.8, 0.0],
    ];
    for (read, expected) in read.iter().flatten().zip(expected.iter().flatten()) {
        assert!((read - expected).abs() <= 4.0 * f64::EPSILON);
    }
    assert_eq!(read[4][2], 0.0);
}

#[test]
fn normals_that_cannot_be_seen_are_refused() {
    for (row, start) in [
        ("0,0,0", "in.csv:3: the normal has no direction; "),
        ("0,0,-1", "in.csv:3: the normal points away from the camera, z = -1.000000"),
        ("1,0,-0.0011", "in.csv:3: the normal points away from the camera, z = -0.001100"),
        ("inf,0,1", "in.csv:3: `inf` is not a finite number; "),
        ("0,0,nan", "in.csv:3: `nan` is not a finite number; "),
        ("0,0,up", "in.csv:3: `up` is not a number; "),
        ("0,0", "in.csv:3: the header has 3 fields, but this row has 2; "),
    ] {
        let text = format!("x,y,z\n0,0,1\n{row}\n");
        assert_starts(&message(normals(&text)), start);
    }
    assert_starts(&message(normals("x,y,z\n")), "in.csv: it contains no normal; ");
    assert_starts(&message(normals("x,y\n0,0\n")), "in.csv:1: its header is `x,y`; ");
    assert_starts(&message(normals("")), "in.csv: it is empty; ");
}

/// Text that is in no file is read like a file, and errors name it as the caller does.
#[test]
fn texts_read_as_files() {
    let lights =
        read_lights(InputFile::of_text("name,l,m,value\na,0,0,2.5\n", "there.csv"), None).unwrap();
    assert_eq!((lights.degree, &lights.entries[0].rgb[1]), (0, &vec![2.5]));
    let error = read_lights(InputFile::of_text("name,l,m,value\na,0,1,2.5\n", "there.csv"), None)
        .unwrap_err();
    assert!(error.to_string().starts_with("there.csv:2: "), "{error}");
    let error =
        read_materials(InputFile::of_text("name,o,p,q,value\n", "here.csv"), None).unwrap_err();
    assert!(error.to_string().starts_with("here.csv: it contains no material"), "{error}");
}
