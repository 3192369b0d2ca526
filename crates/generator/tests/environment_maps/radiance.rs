//! Radiance files: the lines of their headers, their rows and their mantissas.

use super::files::{Type, hdr_bytes, held, rgbe};
use super::stated::{assert_color, read_bytes};
use eigenshade_generator::light::environment::EnvironmentMap;

fn hdr(lines: &str, size: [usize; 2], map: &EnvironmentMap, is_coded: bool) -> Vec<u8> {
    let header = format!("#?RADIANCE\n{lines}\n-Y {} +X {}\n", size[1], size[0]);
    hdr_bytes(map, &header, is_coded)
}

#[test]
fn headers_of_radiance_are_applied() {
    let map = EnvironmentMap::new(16, 8, vec![[0.5, 0.25, 0.125]; 128]).unwrap();
    let [r, g, b] = held(Type::Hdr, &map).texels[0];
    let prophoto = "PRIMARIES=0.7347 0.2653 0.1596 0.8404 0.0366 0.0001 0.3457 0.3585\n";
    let srgb = "PRIMARIES= .64 .33 .30 .60 .15 .06 .3127 .329\n";
    for (lines, expected, warning) in [
        ("FORMAT=32-bit_rle_rgbe\n", [r, g, b], ""),
        (srgb, [r, g, b], ""),
        ("COLORCORR=2 1 .5\nCOLORCORR=1 2 1\n", [r / 2.0, g / 2.0, 2.0 * b], "COLORCORR, 2 2 0.5"),
        ("COLORCORR=2 1\n", [r, g, b], "`COLORCORR=2 1`, which is not understood"),
        ("EXPOSURE=2\nEXPOSURE= 3\n", [r, g, b], "its EXPOSURE, 6, is not divided out"),
        ("PRIMARIES=1 2 3\n", [r, g, b], "its PRIMARIES, 1 2 3, are none: nothing is converted"),
        // Of colour-science: RGB_to_RGB(.., "ProPhoto RGB", "sRGB", "Bradford").
        (
            prophoto,
            [
                2.0341 * r - 0.7274 * g - 0.3067 * b,
                -0.2288 * r + 1.2317 * g - 0.0029 * b,
                -0.0086 * r - 0.1533 * g + 1.1618 * b,
            ],
            "are not those of sRGB: its colors are converted",
        ),
        (
            "FORMAT=32-bit_rle_xyze\n",
            [
                3.2410 * r - 1.5374 * g - 0.4986 * b,
                -0.9692 * r + 1.8760 * g + 0.0416 * b,
                0.0556 * r - 0.2040 * g + 1.0570 * b,
            ],
            "CIE XYZ",
        ),
    ] {
        for is_coded in [false, true] {
            let (found, warnings) = read_bytes("map.hdr", &hdr(lines, [16, 8], &map, is_coded));
            assert_color(found.texels[77], expected);
            assert!(warnings.contains(warning), "{lines}: {warnings}");
            assert_eq!(warnings.is_empty(), warning.is_empty(), "{lines}: {warnings}");
            // The same with other ends of lines.
            let header = format!("#?RADIANCE\n{lines}\n-Y 8 +X 16\n").replace('\n', "\r\n");
            assert_eq!(read_bytes("map.hdr", &hdr_bytes(&map, &header, is_coded)).0, found);
        }
    }
}

#[test]
fn rows_of_radiance_are_read_as_they_are_written() {
    // Rows that are too narrow or too wide for run lengths of components, one of which begins like
    // them, and repeated pixels.
    let header = "#?RGBE\n\n-Y 2 +X 4\n".as_bytes();
    let flat = [header, &[2, 2, 4, 140].repeat(8)].concat();
    let unit = 2.0f32.powi(140 - 136);
    let (map, warnings) = read_bytes("map.hdr", &flat);
    assert_eq!(map.texels, vec![[2.5 * unit, 2.5 * unit, 4.5 * unit]; 8]);
    assert_eq!(warnings, "");
    let wide = 0x8000;
    let row = EnvironmentMap::new(wide, 1, vec![[0.5, 0.25, 1.0]; wide]).unwrap();
    assert_eq!(read_bytes("map.hdr", &hdr("", [wide, 1], &row, false)).0, held(Type::Hdr, &row));
    let repeated =
        [&b"#?RGBE\n\n-Y 1 +X 260\n"[..], &[9, 8, 7, 136, 1, 1, 1, 3, 1, 1, 1, 1]].concat();
    assert_eq!(read_bytes("map.hdr", &repeated).0.texels, vec![[9.5, 8.5, 7.5]; 260]);
    let tail = [&flat[..], b"more"].concat();
    let (same, warnings) = read_bytes("map.hdr", &tail);
    assert_eq!((same, warnings.as_str()), (map, "bytes after its last row are ignored"));
}

/// Writing rounds mantissas down; reading adds half a unit, so that the mean is right.
#[test]
fn mantissas_stand_for_their_middle() {
    let mut state = 7u32;
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (f64::from(state >> 8) / 16_777_216.0) as f32
    };
    for dim in [1.0, 0.1, 0.02] {
        let texels: Vec<[f32; 3]> =
            (0..2048).map(|_| [0.5 + random(), dim * (0.5 + random()), 0.3]).collect();
        let map = EnvironmentMap::new(64, 32, texels).unwrap();
        let (found, _) = read_bytes("map.hdr", &hdr("", [64, 32], &map, true));
        let mean = |map: &EnvironmentMap, k: usize| {
            map.texels.iter().map(|texel| f64::from(texel[k])).sum::<f64>() / 2048.0
        };
        for channel in [0, 1] {
            let bias = mean(&found, channel) / mean(&map, channel) - 1.0;
            assert!(bias.abs() < 5e-3, "channel {channel} of {dim}: {bias}");
        }
    }
    assert_eq!(rgbe(&[1.0, 0.5, 0.0]), [128, 64, 0, 129]);
}
