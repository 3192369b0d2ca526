//! What a PNG's samples stand for: by its own word, by the caller's, by its bits.

use eigenshade_cli::reading::linear_image::{LinearImage, Transfer};
use png::chunk::ChunkType;
use png::{BitDepth, ColorType, Encoder, ScaledFloat, SrgbRenderingIntent};

/// Half of full scale, less a half.
const SAMPLE: [u8; 2] = [127, 255];

/// What a file says of itself.
#[derive(Clone, Copy, Debug, Default)]
struct Says {
    srgb: bool,
    gamma: Option<u32>,
    profile: bool,
    points: Option<u8>,
}

fn picture(depth: BitDepth, says: Says) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, 1, 1);
    encoder.set_depth(depth);
    encoder.set_color(ColorType::Grayscale);
    if let Some(gamma) = says.gamma {
        encoder.set_source_gamma(ScaledFloat::from_scaled(gamma));
    }
    if says.srgb {
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    }
    let mut writer = encoder.write_header().unwrap();
    if says.profile {
        // What is packed in it is no profile, and is not to be looked at.
        writer.write_chunk(ChunkType(*b"iCCP"), b"name\0\0rubbish").unwrap();
    }
    if let Some(points) = says.points {
        writer.write_chunk(ChunkType(*b"cICP"), &[1, points, 0, 1]).unwrap();
    }
    let bytes = if depth == BitDepth::Sixteen { &SAMPLE[..] } else { &SAMPLE[..1] };
    writer.write_image_data(bytes).unwrap();
    writer.finish().unwrap();
    file
}

#[test]
fn a_picture_is_what_it_says() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("one.png");
    let (eight, sixteen) = (BitDepth::Eight, BitDepth::Sixteen);
    let (linear, srgb) = (Ok(Transfer::Linear), Ok(Transfer::Srgb));
    let nothing = Says::default();
    let gamma = |value| Says { gamma: Some(value), ..nothing };
    let profile = Says { profile: true, ..nothing };
    let points = |value| Says { points: Some(value), ..nothing };
    for (depth, says, wanted) in [
        (eight, nothing, srgb),
        (sixteen, nothing, linear),
        (sixteen, Says { srgb: true, ..nothing }, srgb),
        (eight, gamma(100_000), linear),
        (sixteen, gamma(100_000), linear),
        (eight, gamma(45_455), srgb),
        (sixteen, gamma(45_455), srgb),
        (sixteen, gamma(45_454), srgb),
        (eight, gamma(55_556), Err("gAMA chunk says 0.55556")),
        (sixteen, gamma(50_000), Err("gAMA chunk says 0.5,")),
        // Of no meaning, and to be ignored by the format.
        (sixteen, gamma(0), linear),
        (eight, profile, Err("color profile")),
        (sixteen, profile, Err("color profile")),
        (eight, Says { gamma: Some(100_000), ..profile }, Err("color profile")),
        (sixteen, Says { srgb: true, ..profile }, srgb),
        (eight, points(8), linear),
        (sixteen, points(13), srgb),
        (eight, points(16), Err("cICP chunk has the transfer 16")),
    ] {
        std::fs::write(&path, picture(depth, says)).unwrap();
        let stored = match depth {
            BitDepth::Sixteen => f64::from(u16::from_be_bytes(SAMPLE)) / 65535.0,
            _ => f64::from(SAMPLE[0]) / 255.0,
        };
        let of = |transfer| match transfer {
            Transfer::Linear => stored,
            Transfer::Srgb => ((stored + 0.055) / 1.055).powf(2.4),
        };
        let value = |image: LinearImage| image.pixels[0][0];
        match (LinearImage::read(&path, None), wanted) {
            (Ok(image), Ok(transfer)) => {
                let (found, wanted) = (value(image), of(transfer));
                assert!((found - wanted).abs() < 1e-9, "{says:?}: {found}, not {wanted}");
            }
            (Err(error), Err(word)) => {
                let line = error.to_string();
                for word in [word, "one.png", "; ", "--transfer"] {
                    assert!(line.contains(word), "{says:?}: {line}");
                }
                assert_eq!(line.lines().count(), 1);
            }
            (found, wanted) => panic!("{says:?}: {found:?}, not {wanted:?}"),
        }
        // The caller's word goes before the file's.
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            let found = value(LinearImage::read(&path, Some(transfer)).unwrap());
            assert!((found - of(transfer)).abs() < 1e-9, "{says:?} as {transfer:?}: {found}");
        }
    }
}
