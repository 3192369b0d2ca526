//! Cubes as crosses and as folders of six faces, and their faults.

use super::files::{self, map_of};
use super::pictures::png;
use super::refusals::assert_starts;
use eigenshade_generator::light::cube::{CubeMap, FACES};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::frame::Frame;
use eigenshade_generator::light::map::{Layout, Map};
use eigenshade_generator::light::projection::{coefficients, named_maps, project, project_cube};
use eigenshade_table::light;
use png::{BitDepth, ColorType};
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The midpoint rule of a smooth function on faces of 32 x 32 texels and on a map of 64 rows, of
/// the largest coefficient, to degree 6.
const CUBE_MIDPOINT: f64 = 4e-3;

/// Solid angles as differences of angles, of the sphere.
const CUBE_SPHERE: f64 = 1e-12;

/// A polynomial of the direction and a smooth lobe, without symmetry.
fn radiance([x, y, z]: [f64; 3]) -> [f32; 3] {
    let lobe = (4.0 * (0.6 * x + 0.64 * y - 0.48 * z - 1.0)).exp();
    [1.0 + 0.5 * x - 0.2 * z, 0.8 + 0.4 * y * z + 0.3 * x * x, 0.3 + 3.0 * lobe].map(|v| v as f32)
}

/// OpenGL's rule for the direction of a point of a face, as in table 8.19 of its specification: s
/// to the right and t down, from -1 to 1, in the left-handed frame of cubes.
fn opengl(face: usize, s: f64, t: f64) -> [f64; 3] {
    match face {
        0 => [1.0, -t, -s],
        1 => [-1.0, -t, s],
        2 => [s, 1.0, t],
        3 => [s, -1.0, -t],
        4 => [s, -t, 1.0],
        _ => [-s, -t, -1.0],
    }
}

/// The radiance of a face's texel, where the cube's z is the project's -z.
fn texel(face: usize, size: usize, column: usize, row: usize) -> [f32; 3] {
    let place = |k: usize| (2 * k + 1) as f64 / size as f64 - 1.0;
    let [x, y, z] = opengl(face, place(column), place(row));
    let length = (x * x + y * y + z * z).sqrt();
    radiance([x / length, y / length, -z / length])
}

fn face(face: usize, size: usize) -> EnvironmentMap {
    let places = (0..size).flat_map(|row| (0..size).map(move |column| (column, row)));
    let texels = places.map(|(column, row)| texel(face, size, column, row)).collect();
    EnvironmentMap::new(size, size, texels).unwrap()
}

/// A cross of 4 x 3 faces, or of 3 x 4, with values beside the faces that are to be ignored.
fn cross(size: usize, is_horizontal: bool) -> EnvironmentMap {
    let (columns, rows) = if is_horizontal { (4, 3) } else { (3, 4) };
    let (width, height) = (columns * size, rows * size);
    let mut texels = vec![[100.0; 3]; width * height];
    for (k, (left, top)) in [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1)].into_iter().enumerate() {
        for (place, texel) in face(k, size).texels.into_iter().enumerate() {
            texels[(top * size + place / size) * width + left * size + place % size] = texel;
        }
    }
    let mut last = face(5, size).texels;
    let (left, top) = if is_horizontal { (3, 1) } else { (1, 3) };
    if !is_horizontal {
        last.reverse();
    }
    for (place, texel) in last.into_iter().enumerate() {
        texels[(top * size + place / size) * width + left * size + place % size] = texel;
    }
    EnvironmentMap::new(width, height, texels).unwrap()
}

fn pfm(map: &EnvironmentMap, path: &Path) {
    files::pfm(map, path, "PF", "-1", f32::to_le_bytes);
}

fn folder_of_faces(size: usize) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let cube = folder.path().join("studio.v2");
    fs::create_dir(&cube).unwrap();
    for (k, name) in FACES.into_iter().enumerate() {
        pfm(&face(k, size), &cube.join(format!("{name}.pfm")));
    }
    (folder, cube)
}

#[test]
fn a_cube_has_the_light_of_the_equirectangular_map() {
    let (degree, size) = (6, 32);
    let expected = project(&map_of(64, radiance), degree);
    let (_kept, folder) = folder_of_faces(size);
    let six = project_cube(&CubeMap::from_folder(&(&folder).into()).unwrap(), degree);
    super::assert_near(&six, &expected, CUBE_MIDPOINT);
    for is_horizontal in [true, false] {
        let cross = CubeMap::from_cross(cross(size, is_horizontal)).unwrap();
        assert_eq!(cross.size(), size);
        assert_eq!(project_cube(&cross, degree), six);
    }
}

#[test]
fn a_white_cube_fills_the_sphere() {
    for size in [1, 2, 3, 64] {
        let picture = EnvironmentMap::new(4 * size, 3 * size, vec![[1.0; 3]; 12 * size * size]);
        let cube = CubeMap::from_cross(picture.unwrap()).unwrap();
        let [total, ..] = cube.negative_integral().total;
        assert!((total - 4.0 * PI).abs() < 4.0 * PI * CUBE_SPHERE, "{total}");
    }
}

#[test]
fn layouts_are_recognized() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("cross.pfm");
    for is_horizontal in [true, false] {
        pfm(&cross(4, is_horizontal), &path);
        assert!(Map::read(&path, None).unwrap().is_cube());
        assert!(Map::read(&path, Some(Layout::Cross)).unwrap().is_cube());
        assert!(!Map::read(&path, Some(Layout::Equirectangular)).unwrap().is_cube());
        let text = Map::read(&path, Some(Layout::Cube)).unwrap_err().to_string();
        assert!(text.contains("cross.pfm: a cube is a folder with the maps px, "), "{text}");
    }
    for (width, height) in [(8, 4), (4, 4), (5, 4), (8, 7)] {
        let map = EnvironmentMap::new(width, height, vec![[1.0; 3]; width * height]).unwrap();
        pfm(&map, &path);
        assert!(!Map::read(&path, None).unwrap().is_cube());
        let text = Map::read(&path, Some(Layout::Cross)).unwrap_err().to_string();
        assert!(text.contains("pixels, not a cross of 4 x 3 or 3 x 4 squares; crop"), "{text}");
    }
    let bytes = png((8, 6), ColorType::Grayscale, BitDepth::Eight, &[255; 48]);
    fs::write(folder.path().join("cross.png"), bytes).unwrap();
    assert!(Map::read(folder.path().join("cross.png"), None).unwrap().is_cube());
}

#[test]
fn a_folder_of_faces_is_one_light() {
    let (kept, folder) = folder_of_faces(4);
    fs::write(folder.join("readme.txt"), "no map").unwrap();
    assert_eq!(named_maps(&[&folder]).unwrap(), [("studio.v2".to_owned(), folder.clone())]);
    assert!(Map::read(&folder, None).unwrap().is_cube());
    let text = Map::read(&folder, Some(Layout::Equirectangular)).unwrap_err().to_string();
    assert!(text.contains("studio.v2: this folder holds the six faces of a cube; "), "{text}");
    // With other maps it is a folder of maps.
    pfm(&map_of(4, radiance), &folder.join("sky.pfm"));
    assert_eq!(named_maps(&[&folder]).unwrap().len(), 7);
    drop(kept);
}

#[test]
fn faults_of_faces_are_named() {
    let (_kept, folder) = folder_of_faces(4);
    let refused = |what: &str| {
        let text = Map::read(&folder, None).map(|map| map.is_cube()).unwrap_err().to_string();
        assert!(!text.contains('\n'));
        assert_starts(&text[text.find("studio.v2").unwrap()..], what);
    };
    pfm(&face(2, 5), &folder.join("py.pfm"));
    refused("studio.v2/py.pfm: it is 5 x 5 pixels, but px is 4 x 4; give six square faces ");
    pfm(&map_of(2, radiance), &folder.join("py.pfm"));
    refused("studio.v2/py.pfm: it is 4 x 2 pixels, not square; ");
    fs::write(folder.join("py.pfm"), "PF\n4 4\n-1\n").unwrap();
    refused("studio.v2/py.pfm: it is broken or cut short ");
    pfm(&face(2, 4), &folder.join("py.PFM"));
    refused("studio.v2: it has more than one face py; ");
    for name in ["py.PFM", "py.pfm", "nz.pfm"] {
        fs::remove_file(folder.join(name)).unwrap();
    }
    refused("studio.v2: it has no map named py, nz; a cube is a folder ");
    assert_eq!(named_maps(&[&folder]).unwrap().len(), 1);
}

/// The direction from which the light of degree 1 comes: L_1^m is proportional to its Y_1^m.
fn centroid(channel: &[f64]) -> [f64; 3] {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let along = axes.map(|axis| {
        let harmonics = eigenshade_model::special::spherical_harmonic::all(1, axis);
        (1..light::count(1)).map(|k| harmonics[k] * channel[k]).sum::<f64>()
    });
    let length = along.iter().map(|value| value * value).sum::<f64>().sqrt();
    along.map(|value| value / length)
}

#[track_caller]
fn assert_direction(found: [f64; 3], expected: [f64; 3]) {
    let distance = |(a, b): (f64, f64)| (a - b).abs();
    assert!(
        found.into_iter().zip(expected).map(distance).all(|d| d < 1e-9),
        "{found:?} {expected:?}"
    );
}

/// The direction of a point (u, v) of a map, v down from its top, in a program, y up.
fn published(frame: Frame, u: f64, v: f64) -> [f64; 3] {
    let (sine, cosine) = (PI * v).sin_cos();
    match frame {
        Frame::Eigenshade => {
            let (x, z) = (2.0 * PI * (u - 0.5)).sin_cos();
            [x * sine, cosine, -z * sine]
        }
        // three.js, equirectUv of src/renderers/shaders/ShaderChunk/common.glsl.js, inverted:
        // u - 1/2 is atan(z, x) / 2 pi, and asin(y) / pi + 1/2 counts from the bottom.
        Frame::ThreeJs => {
            let (z, x) = (2.0 * PI * (u - 0.5)).sin_cos();
            let height = (PI * (0.5 - v)).sin();
            [x * sine, height, z * sine]
        }
        // Cycles, direction_to_equirectangular of kernel/camera/projection.h, inverted: with z up,
        // u is (atan2(y, x) - pi) / -2 pi, and (acos(z) - pi) / -pi counts from the bottom.
        Frame::Blender => {
            let (y, x) = (PI - 2.0 * PI * u).sin_cos();
            let z = (PI - PI * (1.0 - v)).cos();
            // To y up, as the export to glTF.
            [x * sine, z, -y * sine]
        }
        // Mitsuba 3, uv_to_direction of src/emitters/envmap.cpp.
        Frame::Mitsuba => {
            let (sin_phi, cos_phi) = (2.0 * PI * u).sin_cos();
            [sin_phi * sine, cosine, -cos_phi * sine]
        }
        // OpenEXR, LatLongMap::direction of src/lib/OpenEXR/ImfEnvmap.cpp.
        Frame::OpenExr => {
            let (latitude, longitude) = (-PI * (v - 0.5), -2.0 * PI * (u - 0.5));
            let across = latitude.cos();
            [longitude.sin() * across, latitude.sin(), longitude.cos() * across]
        }
        // cmgen, toRectilinear of libs/ibl/src/CubemapUtils.cpp, inverted: u is (atan2(x, z) / pi +
        // 1) / 2, and asin(y) 2 / pi counts from the bottom. mirrorCubemap then reverses x.
        Frame::Filament => {
            let (x, z) = (PI * (2.0 * u - 1.0)).sin_cos();
            let (y, across) = (0.5 * PI * (1.0 - 2.0 * v)).sin_cos();
            [-x * across, y, z * across]
        }
    }
}

const FRAMES: [Frame; 6] = [
    Frame::Eigenshade,
    Frame::ThreeJs,
    Frame::Blender,
    Frame::Mitsuba,
    Frame::OpenExr,
    Frame::Filament,
];

/// A red, a green and a blue patch of one texel each.
#[test]
fn patches_of_color_are_where_the_program_places_them() {
    let places = [(0, 8), (3, 5), (15, 8), (20, 2), (25, 12)];
    for patches in places.windows(3) {
        let mut map = map_of(16, |_| [0.0; 3]);
        for (channel, &(column, row)) in patches.iter().enumerate() {
            map.texels[row * map.width + column][channel] = 1.0;
        }
        let map = Map::Equirectangular(map);
        for frame in FRAMES {
            let found = coefficients(&map, frame, 1).unwrap();
            for (channel, &(column, row)) in found.iter().zip(patches) {
                let expected =
                    published(frame, (column as f64 + 0.5) / 32.0, (row as f64 + 0.5) / 16.0);
                assert_direction(centroid(channel), expected);
            }
        }
    }
}

/// Each frame, by a red, a green and a blue patch on three faces.
#[test]
fn frames_of_cubes() {
    let size = 4;
    let places = [(0, 1, 1), (1, 0, 2), (2, 3, 0), (3, 1, 3), (4, 2, 0), (5, 0, 0), (0, 1, 1)];
    for patches in places.windows(3) {
        let mut texels = vec![[0.0; 3]; 6 * size * size];
        for (channel, &(k, column, row)) in patches.iter().enumerate() {
            texels[(k * size + row) * size + column][channel] = 1.0;
        }
        let folder = TempDir::new().unwrap();
        for (name, texels) in FACES.into_iter().zip(texels.chunks(size * size)) {
            let face = EnvironmentMap::new(size, size, texels.to_vec()).unwrap();
            pfm(&face, &folder.path().join(format!("{name}.pfm")));
        }
        let map = Map::read(folder.path(), None).unwrap();
        // three.js looks (-x, y, z) up, see flipEnvMap in src/renderers/webgl/WebGLMaterials.js.
        // So does mirrorCubemap of libs/ibl/src/CubemapUtils.cpp of Filament.
        for (frame, signs) in [
            (Frame::Eigenshade, [1.0, 1.0, -1.0]),
            (Frame::ThreeJs, [-1.0, 1.0, 1.0]),
            (Frame::Filament, [-1.0, 1.0, 1.0]),
        ] {
            let found = coefficients(&map, frame, 1).unwrap();
            for (channel, &(k, column, row)) in found.iter().zip(patches) {
                let place = |k: usize| (2 * k + 1) as f64 / size as f64 - 1.0;
                let at = opengl(k, place(column), place(row));
                let length = at.iter().map(|x| x * x).sum::<f64>().sqrt();
                let expected = [0, 1, 2].map(|axis: usize| signs[axis] * at[axis] / length);
                assert_direction(centroid(channel), expected);
            }
        }
        for frame in [Frame::Blender, Frame::Mitsuba, Frame::OpenExr] {
            let text = coefficients(&map, frame, 1).unwrap_err().to_string();
            assert_starts(&text, "this frame is defined for equirectangular maps, ");
        }
    }
}
