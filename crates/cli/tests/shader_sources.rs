//! `shader --sources`: the text with highlights against the model's [`Lobes`] in f64, against the formula
//! of the literature for points of light, and against the direct sum over the rest of the light.
//! Texts without sources stay as they are.

use crate::interpreter::Function;
use crate::oracle::ggx;
use crate::shader::{normals, parts};
use crate::support::{DEGREE, Folder, ORDER, SOURCES, assert_fails, assert_near, difference};
use eigenshade::{Argument, Error, Gloss, Highlights, Shader, ShaderLanguage, Source};
use eigenshade_index::{light, material};
use eigenshade_model::highlights::Highlights as Lobes;
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::source::{Gloss as Material, Source as Blob};
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shading::highlights;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader as Projector;
use eigenshade_shading::shipped;
use eigenshade_testing::fixtures;
use eigenshade_testing::vectors::{Vector, at, cross, dot, unit};
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

/// The text on constants in f32, of the peak. A lobe of α moves by its width where a direction
/// turns by α, so rounding a direction to 24 bits leaves some ε/α: measured 7.5e-6 for α = 0.01,
/// 1.5e-6 for 0.09. The second bound is for the least roughness, α = 0.0042: measured 2.7e-5.
const TEXT: [f64; 2] = [1e-5, 3e-5];

/// Sources from the front over the side and the rim to behind: points, round and elongated ones.
fn sources() -> Vec<Blob> {
    let shapes = [(0.0, 0.0), (0.02, 0.02), (0.1, 0.03), (0.5, 0.5)];
    let angles = [0.0_f64, 20.0, 45.0, 80.0, 90.0, 110.0, 150.0, 175.0];
    let places = angles.into_iter().enumerate();
    let source = |((k, degrees), (major, minor)): ((usize, f64), (f64, f64))| {
        let direction = at(degrees.to_radians(), 0.4 + 1.3 * k as f64);
        let axis = unit(cross(direction, [0.6, -0.64, 0.48]));
        Blob { direction, energy: [1.0, 0.7, 0.2], major: axis.map(|x| major * x), minor }
    };
    places.flat_map(|place| shapes.map(|shape| source((place, shape)))).collect()
}

/// Normals of the disc, of the rim and just beyond it, and near the half-way directions of these
/// sources, in steps of a part of α.
fn normals_for(sources: &[Blob], alpha: f64) -> Vec<Vector> {
    let mut normals = fixtures::disc(16);
    normals.extend(
        (0..24).map(|k| at(FRAC_PI_2, f64::from(k) * PI / 12.0)).map(|[x, y, _]| [x, y, 0.0]),
    );
    normals.extend((0..24).map(|k| at(90.3_f64.to_radians(), f64::from(k) * PI / 12.0)));
    for source in sources {
        let [x, y, z] = source.direction;
        let half = unit([x, y, z + 1.0]);
        let near = (0..25).map(|k| [f64::from(k % 5 - 2), f64::from(k / 5 - 2)]);
        let step = 0.4 * alpha;
        normals.extend(near.map(|[u, v]| unit([half[0] + step * u, half[1] + step * v, half[2]])));
    }
    normals.push([0.0, 0.0, 1.0]);
    normals.retain(|[_, _, z]| *z > -0.01);
    normals
}

/// What highlights in f64 give at these normals, beyond the rim too.
fn shaded(highlights: &Lobes, normals: &[Vector]) -> Vec<f64> {
    normals.iter().flat_map(|&normal| highlights.irradiance(normal)).collect()
}

/// Runs a test with the shader of scenes of the small table.
fn with_shader(test: impl Fn(Shader<'_>)) {
    let folder = Folder::with_table();
    let table = folder.table("b.bin");
    let owned = OwnedBasis::new(&table);
    let mut projector = Projector::new(owned.any().expect("a basis"), table.count());
    let (light, material) = (vec![1.0; light::count(DEGREE)], vec![1.0; material::count(ORDER)]);
    projector.project(&light, &material).expect("a scene");
    test(Shader::new(&projector.scene().expect("a scene")));
}

fn text_of(shader: &Shader<'_>, language: ShaderLanguage) -> String {
    let mut text = String::new();
    shader.write(language, &mut text).expect("text");
    text
}

/// The shader with room for `N` sources gives what `Highlights` give for `count` of them.
fn compare<const N: usize>(shader: Shader<'_>, roughness: f64, count: usize) {
    let shader = shader.with_sources(N).expect("at most 32");
    // The other two are GLSL with another array.
    let languages = [ShaderLanguage::Glsl, ShaderLanguage::Wgsl];
    let functions = languages.map(|language| Function::new(&text_of(&shader, language)));
    let (f0, albedo) = ([0.04, 0.3, 0.9], [0.5, 0.2, 0.0]);
    let single =
        Gloss::new(roughness as f32, f0.map(|x| x as f32), albedo.map(|x| x as f32));
    let single = single.expect("a gloss");
    let double = Material { roughness, reflectance: f0, grazing: [1.0; 3], albedo };
    let all = sources();
    let mut most = 0.0_f64;
    // Those of a set are spread over all angles.
    let step = all.len() / count;
    for first in 0..step {
        let set: Vec<_> = all.iter().skip(first).step_by(step).take(count).copied().collect();
        assert_eq!(set.len(), count);
        let normals = normals_for(&set, roughness * roughness);
        let expected = shaded(&Lobes::new(&double, &set), &normals);
        let of: Vec<Source> = set.iter().map(|one| highlights::source(one).unwrap()).collect();
        let found = Highlights::<N>::new(&single, &of).expect("room");
        let mut vectors = vec![[0.0; 4]; shader.vectors()];
        shader.highlight_uniforms(&found, &mut vectors).expect("room");
        let vectors: Vec<_> = vectors.iter().map(|vector| vector.map(f64::from)).collect();
        for (function, language) in functions.iter().zip(languages) {
            let found = difference(&function.values(&vectors, &normals), &expected);
            let allowed = TEXT[usize::from(roughness < 0.1)];
            assert!(found <= allowed, "{language:?}, {roughness}, {count}, {first}: {found:e}");
            most = most.max(found);
        }
    }
    println!("{N} sources, {count} of them lit, roughness {roughness}: {most:.1e}");
}

#[test]
fn texts_are_the_highlights() {
    with_shader(|shader| {
        // One source and a dark one; two; eight; eight and 24 dark ones.
        compare::<2>(shader, 0.3, 1);
        for roughness in [0.065, 0.1, 0.3, 1.0] {
            compare::<2>(shader, roughness, 2);
            compare::<8>(shader, roughness, 8);
        }
        compare::<32>(shader, 0.2, 8);
    });
}

/// The irradiance of points of light by the formula of the literature, in one channel.
fn of_points(gloss: [f64; 4], points: &[(Vector, f64)], normal: Vector) -> f64 {
    let [roughness, f0, f90, albedo] = gloss;
    // A frame about the normal.
    let first = unit(cross(normal, [0.36, 0.48, 0.8]));
    let second = cross(normal, first);
    let local = |v: Vector| [dot(first, v), dot(second, v), dot(normal, v)];
    let view = local([0.0, 0.0, 1.0]);
    let one = |&(direction, energy): &(Vector, f64)| {
        let light = local(direction);
        if light[2] <= 0.0 {
            return 0.0;
        }
        // The formula has f90 = 1, and is linear in F: with f0 = 0 it has p = (1 - cos)^5, with f0
        // = 1 it has 1, and F = f0 (1 - p) + f90 p.
        let [dark, bright] = [0.0, 1.0].map(|f0| ggx(roughness, f0, albedo, light, view));
        let matte = albedo / PI;
        energy * light[2] * (matte + f0 * (bright - dark) + f90 * (dark - matte))
    };
    points.iter().map(one).sum()
}

/// A material with a gloss, narrow.
const MATERIAL: &str = "gold-metallic-paint2";

/// Of `light-1`: two round sources, and eight points from the front to behind.
fn source_sets() -> [Vec<Blob>; 2] {
    let all = sources();
    let of = |shape: usize| all.iter().skip(shape).step_by(4).copied().collect::<Vec<_>>();
    [vec![of(1)[2], of(3)[4]], of(0)]
}

/// A folder with a table, lights, and sources beside them.
fn folder_with_sources() -> Folder {
    let folder = Folder::with_table();
    let mut text = SOURCES.to_owned();
    for set in source_sets() {
        for source in &set {
            let numbers = [source.direction, source.energy, source.major].concat();
            let numbers: Vec<_> = numbers.iter().map(f64::to_string).collect();
            let (size, minor) = (set.len(), source.minor);
            writeln!(text, "light-1,{size},{},{minor}", numbers.join(",")).expect("text");
        }
    }
    folder.write("lights.sources.csv", text);
    folder
}

/// Writes the light without round sources as `rest.csv`: minus their energy times
/// exp(-l (l + 1) minor² / 2) Y(direction).
fn write_rest(folder: &Folder, set: &[Blob]) {
    let lights = read_lights(folder.path("lights.csv"), None).expect("lights");
    let light = lights.entries.iter().find(|light| light.name == "light-1").expect("a light");
    let mut text = "name,l,m,r,g,b\n".to_owned();
    let harmonics: Vec<_> =
        set.iter().map(|source| spherical_harmonic::all(DEGREE, source.direction)).collect();
    for (place, (l, m)) in light::indices(DEGREE).enumerate() {
        let degree = l as f64;
        let rest = [0, 1, 2].map(|channel| {
            let taken = set.iter().zip(&harmonics).map(|(source, harmonics)| {
                let damping = (-0.5 * degree * (degree + 1.0) * source.minor.powi(2)).exp();
                source.energy[channel] * damping * harmonics[place]
            });
            (light.rgb[channel][place] - taken.sum::<f64>()).to_string()
        });
        writeln!(text, "light-1,{l},{m},{}", rest.join(",")).expect("text");
    }
    folder.write("rest.csv", text);
}

/// The direct sum over the rest of the light, and the highlights by other code.
#[test]
fn scenes_with_sources_are_the_direct_sum_and_the_highlights() {
    let folder = folder_with_sources();
    let glosses = shipped::glosses().expect("glosses");
    let gloss = glosses.iter().find(|one| one.name == MATERIAL).expect("a gloss").gloss;
    let [round, points] = source_sets();
    // Near highlights too, and no rim, where the formula of the literature has 0/0.
    let mut text = folder.read("normals.csv").replace("1,0,0\n0,-1,0\n", "");
    for [x, y, z] in normals_for(&points, gloss.roughness.powi(2)) {
        if z > 0.02 {
            writeln!(text, "{x},{y},{z}").expect("text");
        }
    }
    folder.write("normals.csv", text);
    let normals = normals(&folder);

    let of_round = shaded(&Lobes::new(&gloss, &round), &normals);
    let of_points: Vec<f64> = normals
        .iter()
        .flat_map(|&normal| {
            [0, 1, 2].map(|c| {
                let lit: Vec<_> = points.iter().map(|s| (s.direction, s.energy[c])).collect();
                let [f0, f90] = [gloss.reflectance[c], gloss.grazing[c]];
                let gloss = [gloss.roughness, f0, f90, gloss.albedo[c]];
                of_points(gloss, &lit, normal)
            })
        })
        .collect();
    // A text with room for four takes the set of two.
    for (most, set, of_set) in
        [(2, &round, &of_round), (4, &round, &of_round), (8, &points, &of_points)]
    {
        write_rest(&folder, set);
        let direct = folder.irradiance(&format!(
            "--quiet --table b.bin --light rest.csv --material {MATERIAL} --normals normals.csv \
             --method modes"
        ));
        let expected: Vec<f64> =
            direct.iter().zip(of_set).map(|(rest, lobes)| rest + lobes).collect();
        assert!(difference(&direct, &expected) > 0.1, "highlights that nobody would miss");
        for lang in ["glsl", "glsl-block", "glsl-texture", "wgsl"] {
            let (text, vectors, terms) = parts(
                &folder,
                &format!(
                    "--lang {lang} --table b.bin --light lights.csv:light-1 --material {MATERIAL} \
                     --sources {most}"
                ),
            );
            assert_eq!(vectors.len(), terms + 1 + 4 * most);
            let found = Function::new(&text).values(&vectors, &normals);
            assert_near(&format!("{lang}, {most} sources"), &found, &expected, TEXT[0]);
        }
    }
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
    let lamp = Source::round([0.0, 0.6, 0.8_f32], [1.0; 3], 0.1).expect("a source");
    let of = |count: usize| {
        Highlights::<3>::new(&gloss, &[lamp; 3][..count]).expect("room")
    };
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
