//! `shader --sources`: the loop and the vectors that sources add. packages/eigenshade compares the
//! pictures in a browser.

use crate::shader::parts;
use crate::support::{DEGREE, Folder, ORDER, SOURCES, assert_fails};
use eigenshade::shader::{Shader, ShaderLanguage};
use eigenshade::{Argument, Error, Gloss, Highlights, Source};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader as Projector;
use eigenshade_table::{light, material};

/// Runs a test with the shader of scenes of the small table.
fn with_shader(test: impl Fn(Shader<'_>)) {
    let folder = Folder::with_table();
    let table = folder.table("b.bin");
    let owned = OwnedBasis::new(&table).expect("a table for f32");
    let mut projector = Projector::new(owned.basis().expect("a basis"), table.count());
    let (light, material) = (vec![1.0; light::count(DEGREE)], vec![1.0; material::count(ORDER)]);
    projector.project(&light, &material).expect("a scene");
    test(Shader::new(&projector.scene().expect("a scene")));
}

fn text_of(shader: &Shader<'_>, language: ShaderLanguage) -> String {
    let mut text = String::new();
    shader.write(language, &mut text).expect("text");
    text
}

/// A material with a gloss, narrow.
const MATERIAL: &str = "gold-metallic-paint2";

/// A folder with a table, lights, and two sources of `light-1` beside them.
fn folder_with_sources() -> Folder {
    let folder = Folder::with_table();
    let source = "light-1,0,0.6,0.8,1,0.7,0.2,0.02\n";
    folder.write("lights.sources.csv", SOURCES.to_owned() + &source.repeat(2));
    folder
}

/// Sources add a loop and vectors at the end of the array, and change nothing else.
#[test]
fn texts_without_sources_are_unchanged() {
    with_shader(|shader| {
        for language in [
            ShaderLanguage::Glsl,
            ShaderLanguage::GlslBlock,
            ShaderLanguage::GlslTexture,
            ShaderLanguage::Wgsl,
        ] {
            let plain = text_of(&shader, language);
            assert_eq!(text_of(&shader.with_sources(0).expect("none"), language), plain);
            assert!(!plain.contains("for ("));
            for sources in [1, 2, 8, 32] {
                let more = shader.with_sources(sources).expect("at most 32");
                assert_eq!(more.vectors(), shader.vectors() + 1 + 4 * sources);
                let text = text_of(&more, language);
                let (before, rest) = text.split_at(text.find(" z = max(").expect("a loop"));
                let (_, after) = rest.split_at(rest.rfind("  return p;").expect("an end"));
                let before = before.rsplit_once("  ").expect("a type").0;
                let without = format!("{before}{after}");
                let length = |shader: &Shader<'_>| match language {
                    ShaderLanguage::Wgsl => format!("vec4f, {}>", shader.vectors()),
                    ShaderLanguage::GlslTexture => "sampler2D".to_owned(),
                    _ => format!("[{}];\n", shader.vectors()),
                };
                assert_eq!(without.replacen(&length(&more), &length(&shader), 1), plain);
            }
        }
    });
}

/// `uniforms` makes all sources dark, and highlights leave the scene's vectors and those of others
/// alone.
#[test]
fn vectors_have_their_places() {
    let gloss = Gloss::new(0.3, [0.04; 3], [0.5; 3]).expect("a gloss");
    let lamp = Source::new([0.0, 0.6, 0.8_f32], [1.0; 3], 0.1).expect("a source");
    let of = |count: usize| Highlights::<3>::new(&gloss, &[lamp; 3][..count]).expect("room");
    with_shader(|shader| {
        let scene = shader.vectors();
        let shader = shader.with_sources(2).expect("at most 32");
        let mut vectors = vec![[7.0; 4]; shader.vectors() + 3];
        shader.highlight_uniforms(&of(2), &mut vectors).expect("room");
        assert!(vectors[..scene].iter().all(|vector| *vector == [7.0; 4]));
        assert_eq!(vectors[scene..][..9].iter().filter(|vector| **vector == [7.0; 4]).count(), 0);
        assert_eq!(vectors[scene + 9..], [[7.0; 4]; 3]);
        assert_eq!(vectors[scene + 1..][..4], vectors[scene + 5..][..4]);
        shader.highlight_uniforms(&of(1), &mut vectors).expect("room");
        assert_ne!(vectors[scene + 1..][..4], [[0.0; 4]; 4]);
        assert_eq!(vectors[scene + 5..][..4], [[0.0; 4]; 4]);

        let most = Error::Capacity { argument: Argument::Sources, needed: 3, capacity: 2 };
        assert_eq!(shader.highlight_uniforms(&of(3), &mut vectors), Err(most));
        let short = shader.highlight_uniforms(&of(2), &mut vectors[..scene + 8]);
        assert!(matches!(short, Err(Error::Length { .. })));
        let none = shader.with_sources(0).expect("none");
        let before = vectors.clone();
        none.highlight_uniforms(&of(0), &mut vectors).expect("nothing to write");
        assert_eq!(vectors, before);
        let most = Error::Capacity { argument: Argument::Sources, needed: 33, capacity: 32 };
        assert_eq!(shader.with_sources(33).map(|shader| shader.vectors()), Err(most));
    });
}

#[test]
fn materials_and_lights_without_sources() {
    let folder = folder_with_sources();
    let of = |light: &str, material: &str, options: &str| {
        format!(
            "shader --lang glsl --table b.bin --light lights.csv:{light} --material {material} \
             --sources 2 {options}"
        )
    };
    // The text depends on the number of sources alone.
    let known = folder.ok(&of("light-1", MATERIAL, ""));
    assert_eq!(folder.ok(&of("light-0", "materials.csv:material-2", "")), known);
    for (light, material, options, named) in [
        ("light-1", "materials.csv:material-2", "--json", "the gloss of `material-2`"),
        ("light-1", "materials.csv:material-2", "--tolerance 0.1", "the gloss of `material-2`"),
        ("light-0", MATERIAL, "--json", "no sources of the light `light-0`"),
    ] {
        assert_fails(&folder, &of(light, material, options), &[named]);
    }
    // A matte material is drawn with all of the light in harmonics.
    let matte = of("light-1", "green-latex", "--out matte.json --json");
    assert!(folder.messages(&matte).contains("note: `green-latex` is as matte as a roughness"));
    let options = "--lang glsl --table b.bin --light lights.csv:light-1 --material green-latex";
    let (_, whole, terms) = parts(&folder, options);
    let (_, dark, _) = parts(&folder, &format!("{options} --sources 2"));
    assert_eq!(dark[..terms], whole[..]);
    assert_eq!(dark[terms..], [[0.0; 4]; 9]);
}
