//! What the command says that it chose, what it keeps as asked, and what it refuses.

use crate::support::{Folder, assert_fails, lights, materials, repository, scene};
use eigenshade_index::material;
use eigenshade_table::decode;

/// The small scene with a tolerance, and these lines of `[basis]`.
fn folder(tolerance: &str, basis: &str) -> Folder {
    let folder = Folder::new();
    folder.write("lights.csv", lights(6, 3));
    folder.write("materials.csv", materials(5, 4));
    let text = scene("image-centered", 1, "[]").replace("degree = 4", "degree = 6");
    let text = text.replace("order = 3", "order = 5");
    let text = text.replace("components = 1\n", &format!("tolerance = {tolerance}\n{basis}"));
    folder.write("scene.toml", text);
    folder
}

/// What `basis` says on standard error.
fn said(folder: &Folder) -> Vec<String> {
    let output = folder.run("basis --scene scene.toml --out b.bin");
    let text = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(0), "{text}");
    text.lines().map(str::to_owned).collect()
}

#[test]
fn basis_says_what_it_chose_and_why() {
    for tolerance in ["0.3", "0.05", "1e-3"] {
        let folder = folder(tolerance, "");
        let lines = said(&folder);
        println!("{lines:#?}");
        let table = decode(&std::fs::read(folder.path("b.bin")).unwrap()).unwrap();
        let (degree, order) = (table.gram.degree, table.gram.order);
        let (count, of) = (table.components.len(), table.spectrum.len());
        assert_eq!(lines.len(), 5);
        for (line, start) in lines.iter().zip([
            format!("degree {degree} of 6"),
            format!("order {order} of 5"),
            format!("components {count} of {of}"),
            "polynomial terms ".to_owned(),
            "in all at most ".to_owned(),
        ]) {
            assert!(line.starts_with(&start), "{line}: {start}");
        }
        let manifest = folder.read("b.manifest.csv");
        for row in [format!("degree,{degree},"), format!("order,{order},")] {
            assert!(manifest.lines().any(|line| line.starts_with(&row)), "{row}");
        }
        let info = folder.ok("info b.bin");
        let value = |what: &str| {
            let line = info.lines().find(|line| line.split_whitespace().next() == Some(what));
            line.and_then(|line| line.split_whitespace().last().map(str::to_owned))
        };
        assert_eq!(value("degree"), Some(degree.to_string()));
        assert_eq!(value("order"), Some(order.to_string()));
        folder.ok("basis --scene scene.toml --check b.bin");
        folder
            .ok("shade b.bin --lights lights.csv --materials materials.csv --normals normals.csv");
    }
    let coarse = folder("0.3", "");
    said(&coarse);
    let table = decode(&std::fs::read(coarse.path("b.bin")).unwrap()).unwrap();
    assert!(table.gram.degree < 6 && table.gram.order < 5, "nothing was chosen");
}

/// The page on the method has what the program says of the shipped databases.
#[test]
fn the_page_says_what_basis_says() {
    let folder = Folder::new();
    let read = |name: &str| std::fs::read_to_string(repository().join(name)).expect("a text");
    let inputs = repository().join("tables/inputs");
    let text = read("tables/sphere.toml").replace("components = 50", "tolerance = 1e-2");
    let text = text.replace("inputs/", &format!("{}/", inputs.to_str().expect("UTF-8")));
    folder.write("scene.toml", text);
    let lines = said(&folder).join("\n");
    assert!(read("docs/method.md").contains(&format!("```text\n{lines}\n```")), "{lines}");
}

/// Where the degree and the order stay as the scene has them, it is said; the components
/// are chosen all the same.
#[test]
fn degree_and_order_stay_where_they_are_not_chosen() {
    let selection = folder("0.05", "modes = 60\n");
    let object = folder("0.05", "");
    let text = object.read("scene.toml").replace("\"sphere\"", "\"normals.csv\"");
    object.write("scene.toml", text);
    let as_captured = folder("0.05", "");
    let text = as_captured.read("scene.toml").replace("\"any\"", "\"none\"");
    as_captured.write("scene.toml", text);
    let black = folder("0.05", "");
    black.write("materials.csv", "name,o,p,q,value\n".to_owned() + &zeros());
    for (folder, why) in
        [(&selection, "modes"), (&object, "spheres"), (&as_captured, "freely"), (&black, "black")]
    {
        let lines = said(folder);
        println!("{lines:#?}");
        assert!(lines[0].starts_with("degree and order as asked: ") && lines[0].contains(why));
        assert!(lines[1].starts_with("components "), "{}", lines[1]);
        let table = decode(&std::fs::read(folder.path("b.bin")).unwrap()).unwrap();
        assert_eq!([table.gram.degree, table.gram.order], [6, 5]);
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

fn zeros() -> String {
    let row = |(o, p, q)| format!("black,{o},{p},{q},0\n");
    material::indices(5).map(row).collect()
}

/// A cut-off that leaves more out than the tolerance.
#[test]
fn a_tolerance_that_is_not_met_is_refused() {
    let cut = folder("1e-3", "rank_cutoff = 0.3\n");
    assert_fails(&cut, "basis --scene scene.toml --out b.bin", &["basis.tolerance", "rank_cutoff"]);
    for wrong in ["0.0", "1.0", "-1e-3", "nan"] {
        let bad = folder(wrong, "");
        assert_fails(&bad, "basis --scene scene.toml --out b.bin", &["basis.tolerance"]);
    }
}

/// A table of transfers, and one of a set of effects that leaves ambient apart.
#[test]
fn stores_and_effects_choose_too() {
    for basis in [
        "store = \"materials\"\n",
        "store = \"projection\"\n",
        "[effects]\nuse = [\"ambient\"]\n",
        "[effects]\nuse = [\"gloss\"]\n",
        "[effects]\nuse = [\"ambient\", \"diffuse\"]\n",
    ] {
        let folder = folder("0.02", "");
        let text = folder.read("scene.toml") + basis;
        folder.write("scene.toml", text);
        println!("{basis}{:#?}", said(&folder));
        folder.ok("basis --scene scene.toml --check b.bin");
        folder.ok("info b.bin");
    }
}
