//! The programs of the README, as the README has them.

use eigenshade::Error;
use eigenshade::screen::Target;

include!("readme/checksum.rs");

type Draw = fn(&mut Target<'_>) -> Result<(), Error>;

mod gold {
    include!("readme/gold.rs");
    pub const DRAW: super::Draw = draw;
}
mod gold_q15 {
    include!("readme/gold_q15.rs");
    pub const DRAW: super::Draw = draw;
}

/// The README has the first program above, and the second differs in a few words. In floats and in
/// integers they draw the same sphere to a step of each channel, in integers with the same bits on
/// every machine.
#[test]
fn the_readme_draws_a_gold_sphere() {
    let readme = include_str!("../README.md");
    let program = include_str!("readme/gold.rs");
    assert!(readme.contains(&format!("```rust\n{program}```")), "{program}");
    let mut words = program.to_owned();
    for word in ["light", "material", "sphere"] {
        words = words.replace(&format!("{word}::"), &format!("{word}::q15::"));
    }
    assert_eq!(words.replace(".normal(", ".normal_q15("), include_str!("readme/gold_q15.rs"));
    let (mut floats, mut integers) = ([0; 240 * 240], [0; 240 * 240]);
    gold::DRAW(&mut Target::new(&mut floats, 240).unwrap()).unwrap();
    gold_q15::DRAW(&mut Target::new(&mut integers, 240).unwrap()).unwrap();
    let channels = |pixel: u16| [pixel >> 11, (pixel >> 5) & 63, pixel & 31];
    for (&float, &integer) in floats.iter().zip(&integers) {
        let pairs = channels(float).into_iter().zip(channels(integer));
        assert!(pairs.into_iter().all(|(a, b)| a.abs_diff(b) <= 1), "{float:x} {integer:x}");
    }
    let bytes: Vec<u8> = integers.iter().flat_map(|pixel| pixel.to_le_bytes()).collect();
    assert_eq!(crc32fast::hash(&bytes), CHECKSUM);
}

/// The programs in C and JavaScript are those of the packages' pages, whose tests run them.
#[test]
fn programs_in_other_languages_are_the_packages() {
    let readme = include_str!("../README.md");
    let pages = [
        ("c", include_str!("../crates/capi/README.md")),
        ("html", include_str!("../packages/eigenshade/README.md")),
    ];
    for (language, page) in pages {
        let first = |page: &'static str| {
            let (_, rest) = page.split_once(&format!("```{language}\n")).expect("a program");
            rest.split_once("```").expect("its end").0
        };
        assert_eq!(first(readme), first(page), "{language}");
    }
}
