//! What `export` takes and refuses.

use crate::support::{Folder, assert_fails};

/// A light of a higher degree than the table's, for an object with shadows.
#[test]
fn a_light_has_the_degree_that_is_asked() {
    let folder = Folder::new();
    let found = folder.ok("export --lang js --light studio --degree 16");
    let lines = found.lines().filter(|line| line.ends_with(','));
    let numbers = lines.flat_map(|line| line.split(',')).filter_map(|one| one.trim().parse().ok());
    let lights = eigenshade_model::shipped::lights().expect("lights").truncated(16);
    let studio = lights.entries.iter().find(|light| light.name == "studio").expect("a light");
    let expected: Vec<f32> = studio.rgb.iter().flatten().map(|&one| one as f32).collect();
    assert_eq!(numbers.collect::<Vec<f32>>(), expected);
    folder.write("low.csv", "name,l,m,r,g,b\na,0,0,1,1,1\n");
    assert_fails(
        &folder,
        "export --lang rust --light low.csv --degree 1",
        &["low.csv: the light has degree 0, not 1", "light --degree"],
    );
}
