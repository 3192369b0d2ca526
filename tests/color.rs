//! Three channels at once, the presets, and pixels of a display.

use eigenshade::lights::Window;
use eigenshade::object::{Disc, DiscPixel, MapPoint};
use eigenshade::presets::{gloss, light, material, sources};
use eigenshade::screen::{Display, Tone};
use eigenshade::specialized::shade_normals;
use eigenshade::sphere;
use eigenshade::truncation::Tolerance;
use eigenshade::{
    Argument, Error, Gloss, Light, Material, Normals, Q15, Rgb, Rotation, Source, q15,
};
use eigenshade_model::shipped;
use eigenshade_model::source::{Base, SourceError};
use eigenshade_shading::highlights;
use eigenshade_testing::fixtures::{axes, normal};

const NORMALS: [[f64; 3]; 4] =
    [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -0.6, 0.8], [-0.28, 0.96, 0.0]];

/// Three channels give the bits of three calls; a gray material those of one transfer.
#[test]
fn color_is_three_channels() {
    let (light, gold) = (light::LOBBY, material::GOLD_METALLIC_PAINT);
    let matte = Material::new(&[1.0]).unwrap();
    for material in [gold, Rgb::from(matte)] {
        let scene = sphere::color::scene(light, material).unwrap();
        let transfer = sphere::color::transfer(material).unwrap();
        assert_eq!(sphere::color::relight(&transfer, light).unwrap(), scene);
        for normal in NORMALS.map(normal) {
            let expected = light.zip(material).map(|(light, material)| {
                let transfer = sphere::transfer(&material).unwrap();
                let d = sphere::relight(&transfer, &light).unwrap();
                sphere::collapse(&d).shade(normal)
            });
            assert_eq!(scene.shade(normal), expected);
        }
    }
    let transfer = sphere::transfer(&matte).unwrap();
    let scene = sphere::color::relight(&transfer, light).unwrap();
    assert_eq!(scene, sphere::color::scene(light, matte).unwrap());
}

/// Materials are gray if their numbers are, wherever they lie.
#[test]
fn gray_materials_are_found_by_their_numbers() {
    let channels = [[0.7, -0.2]; 3];
    let is_gray = |channels: &[[f32; 2]; 3]| {
        let [r, g, b] = channels.each_ref().map(|channel| Material::new(channel).unwrap());
        Rgb::new(r, g, b).as_gray().is_some()
    };
    let mut colored = channels;
    colored[2][1] = -0.1;
    assert!(is_gray(&channels) && !is_gray(&colored));
    let glossy = Material::metallic_roughness([0.5; 3], 1.0, 0.4).unwrap();
    assert!(glossy.materials().unwrap().as_gray().is_some());
    let exponents = [[0_i8; 2]; 3];
    let of = |mantissas: &[[Q15; 2]; 3]| {
        let [r, g, b] =
            [0, 1, 2].map(|c: usize| q15::Material::new(&exponents[c], &mantissas[c]).unwrap());
        Rgb::new(r, g, b).as_gray().is_some()
    };
    let gray = [[Q15(9000), Q15(-400)]; 3];
    let mut colored = gray;
    colored[0][0] = Q15(8999);
    assert!(of(&gray) && !of(&colored));
}

/// A baked map in color is that of each channel.
#[test]
fn maps_are_baked_in_color() {
    let scene = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let maps = scene.bake::<256>(16).unwrap();
    let expected = scene.each_ref().map(|channel| channel.bake::<256>(16).unwrap());
    assert_eq!(maps, expected);
    let point = MapPoint::of(normal([0.0, 0.6, 0.8]));
    assert_eq!(maps.bilinear(point), expected.each_ref().map(|map| map.bilinear(point)));
    assert_eq!(scene.bake::<256>(1).err(), Some(Error::Size { found: 1 }));
    assert!(scene.bake::<255>(16).is_err());
}

#[test]
fn integers_in_color_are_three_channels() {
    let (light, gold) = (light::q15::PARK, material::q15::GOLD_METALLIC_PAINT);
    let scene = sphere::q15::color::scene(light, gold).unwrap();
    let exposure = scene.exposure_by_factor(2.0).unwrap();
    for pixel in Disc::new(9).unwrap() {
        let normal = pixel.normal_q15();
        let found = scene.shade(normal);
        let expected = light.zip(gold).map(|(light, material)| {
            let transfer = sphere::q15::transfer(&material).unwrap();
            let d = sphere::q15::relight(&transfer.view(), &light).unwrap();
            sphere::q15::collapse(&d).shade(normal)
        });
        assert_eq!(found, expected);
        let exact = f64::from(found.g) * f64::from(scene.g.exponent()).exp2() * 2.0 * 65_536.0;
        assert!((f64::from(exposure.of(found).g.0) - exact).abs() < 1.0 + exact / 32_000.0);
    }
    assert!(scene.exposure_by_factor(0.0).is_err());
}

/// The constants hold the numbers of the files, rounded, and in integers those of `quantize`.
#[test]
fn presets_are_the_shipped_files() {
    let lights = shipped::lights().unwrap().truncated(sphere::DEGREE).entries;
    assert_eq!(light::ALL.len(), lights.len());
    let all = light::ALL.into_iter().zip(light::q15::ALL);
    for (((name, preset), (of_integers, integers)), file) in all.zip(lights) {
        assert_eq!([name, of_integers], [&file.name; 2]);
        for (channel, (preset, integers)) in <[_; 3]>::from(preset.zip(integers)).iter().enumerate()
        {
            let exact = file.rgb[channel].iter().map(|&number| number as f32);
            assert!(exact.eq(preset.coefficients().iter().copied()), "{name}");
            let mut room = [Q15(0); 100];
            let expected = q15::Light::quantize(preset.coefficients(), &mut room);
            assert_eq!(expected.as_ref(), Ok(integers), "{name}");
        }
    }
    assert_eq!(material::ALL.len(), 95);
    let all = material::ALL.into_iter().zip(material::q15::ALL);
    for ((name, preset), (of_integers, integers)) in all {
        assert_eq!(name, of_integers);
        for (preset, integers) in <[_; 3]>::from(preset.zip(integers)) {
            let (mut room, mut exponents) = ([Q15(0); 40], [0; 8]);
            let from = preset.coefficients();
            let expected = q15::Material::quantize(from, &mut room, &mut exponents);
            assert_eq!(expected, Ok(integers), "{name}");
        }
    }
}

/// The rows of errors are those of the file, at the degree and order of the presets, and the choice
/// for a tolerance is that of the file's numbers.
#[test]
fn sources_have_the_errors_of_the_shipped_file() {
    let files = shipped::source_errors().unwrap();
    let size = (sphere::DEGREE, sphere::ORDER);
    for (light, lamps, rows) in sources::ALL {
        let is_of_light = |one: &&SourceError| {
            (one.light.as_str(), one.size, one.base) == (light, size, Base::Metal)
        };
        let of_light: Vec<_> = files.iter().filter(is_of_light).collect();
        assert_eq!((rows.len(), of_light.len()), (lamps.len() + 1, lamps.len() + 1), "{light}");
        for (count, (row, file)) in rows.iter().zip(&of_light).enumerate() {
            assert_eq!(count, file.sources, "{light}");
            assert_eq!(*row, file.errors.map(|error| error.white as f32), "{light}");
        }
        for tenths in 1..=10_usize {
            let gloss = Gloss::new(tenths as f32 / 10.0, [0.9; 3], [0.0; 3]).unwrap();
            for tolerance in [1.03e-3, 5.03e-3, 1.003e-2, 2.003e-2, 5.003e-2] {
                let found = gloss.fewest_sources(rows, tolerance as f32);
                let fits =
                    |file: &&SourceError| tenths >= 6 || file.errors[tenths - 1].white <= tolerance;
                let expected = of_light.iter().position(fits);
                assert_eq!(found, expected, "{light}, {tenths}, {tolerance}");
            }
        }
    }
}

/// Sources are those of the files after their check, and so are glosses.
#[test]
fn sources_and_glosses_are_the_shipped_files() {
    let files = shipped::sources().unwrap();
    assert_eq!((files.len(), sources::ALL.len()), (18, 18));
    for (file, (name, presets, _)) in files.iter().zip(sources::ALL) {
        assert_eq!((name, presets.len()), (file.name.as_str(), file.sources.len()));
        for (preset, file) in presets.iter().zip(&file.sources) {
            let file = highlights::source(file).unwrap();
            for (preset, file) in preset.direction().iter().zip(file.direction()) {
                assert!((preset - file).abs() <= 1e-6);
            }
            assert_eq!((preset.spread(), preset.energy()), (file.spread(), file.energy()));
            // It is accepted as it is.
            let [x, y, z] = preset.direction();
            assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6);
            Source::new([x, y, z], preset.energy(), preset.spread()).unwrap();
        }
    }
    let glosses = shipped::glosses().unwrap();
    assert_eq!(gloss::ALL.len(), glosses.len());
    for ((name, preset), file) in gloss::ALL.into_iter().zip(glosses) {
        assert_eq!(name, file.name);
        assert_eq!(Ok(preset), highlights::gloss(&file.gloss).map_err(|error| error.to_string()));
    }
}

#[test]
fn a_tint_scales_each_channel() {
    let gray = Material::new(&[2.0, -0.5]).unwrap();
    let tinted = gray.tint::<2>([1.0, 0.5, 0.0]).unwrap();
    let scene = sphere::color::scene(light::PARK, tinted.materials().unwrap()).unwrap();
    let front = normal([0.0, 0.0, 1.0]);
    let white = sphere::color::scene(light::PARK, gray).unwrap().shade(front);
    let found: [f32; 3] = scene.shade(front).into();
    for (found, expected) in found.into_iter().zip([white.r, 0.5 * white.g, 0.0]) {
        assert!((found - expected).abs() < 1e-5);
    }
    assert_eq!(
        gray.tint::<2>([1.0, f32::NAN, 0.0]).unwrap_err(),
        Error::NotFinite { argument: Argument::Color, index: 1 }
    );
    assert!(matches!(gray.tint::<1>([1.0; 3]), Err(Error::Capacity { .. })));
    // A preset has three channels, each of which has its factor.
    let of_gold = material::GOLD_METALLIC_PAINT.tint::<40>([1.0, 0.5, 0.0]).unwrap();
    for (factor, channel, found) in [
        (1.0, material::GOLD_METALLIC_PAINT.r, &of_gold.r),
        (0.5, material::GOLD_METALLIC_PAINT.g, &of_gold.g),
        (0.0, material::GOLD_METALLIC_PAINT.b, &of_gold.b),
    ] {
        assert!(channel.coefficients().iter().zip(&**found).all(|(&of, &to)| factor * of == to));
    }
}

/// Vertices of a mesh, in one call: the bits of one call for each.
#[test]
fn slices_are_shaded_in_color_as_their_normals() {
    let scene = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let integers = sphere::q15::color::scene(light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT);
    let integers = integers.unwrap();
    let pixels: Vec<_> = Disc::new(60).unwrap().collect();
    for count in [0, 1, 7, 64, 320, 321, 640, 1300, pixels.len()] {
        let pixels = &pixels[..count];
        let [x, y, z] = axes(&pixels.iter().map(|pixel| pixel.normal()).collect::<Vec<_>>());
        let normals = Normals::new(&x, &y, &z).unwrap();
        let mut colors = vec![Rgb::gray(f32::NAN); count];
        scene.shade_slice(normals, &mut colors).unwrap();
        let of_channel = scene.each_ref().map(|channel| {
            let mut values = vec![0.0; count];
            channel.shade_slice(normals, &mut values).unwrap();
            values
        });
        for (index, color) in colors.iter().enumerate() {
            assert_eq!(*color, of_channel.each_ref().map(|values| values[index]), "{count}");
        }
        // As on targets without vectors.
        let mut one_by_one = vec![Rgb::gray(f32::NAN); count];
        shade_normals(normals, &mut one_by_one, |normal| scene.shade(normal)).unwrap();
        assert_eq!(one_by_one, colors);
        let quantized: Vec<_> = pixels.iter().map(|pixel| pixel.normal_q15()).collect();
        let mut colors = vec![Rgb::gray(i32::MIN); count];
        integers.shade_slice(&quantized, &mut colors).unwrap();
        assert!(colors.iter().zip(&quantized).all(|(color, &of)| *color == integers.shade(of)));
        let short =
            Err(Error::Length { argument: Argument::Normals, expected: count, found: count + 1 });
        colors.push(Rgb::gray(0));
        assert_eq!(integers.shade_slice(&quantized, &mut colors), short);
        assert_eq!(scene.shade_slice(normals, &mut vec![Rgb::gray(0.0); count + 1]), short);
    }
}

/// Channels of one irradiance, of nine terms, of more, and of each.
#[test]
fn few_terms_are_shaded_in_color_as_each_channel() {
    let pixels: Vec<_> = Disc::new(60).unwrap().map(DiscPixel::normal).collect();
    let [x, y, z] = axes(&pixels);
    let normals = Normals::new(&x, &y, &z).unwrap();
    let matte = sphere::transfer(&Material::new(&[2.0]).unwrap()).unwrap();
    for degrees in [[0; 3], [2; 3], [5; 3], [0, 2, 5], [9, 0, 2]] {
        let mut lengths = [[0; sphere::DEGREE + 1]; 3];
        let mut scenes = degrees.into_iter().zip(&mut lengths).map(|(degree, lengths)| {
            let d = sphere::relight(&matte, &light::LOBBY.g.truncated(degree)).unwrap();
            sphere::collapse_within(&d, Tolerance::OfPeak(1e-3), lengths).unwrap().0
        });
        let scenes = Rgb::gray(()).map(|()| scenes.next().unwrap());
        let mut colors = vec![Rgb::gray(f32::NAN); pixels.len()];
        scenes.shade_slice(normals, &mut colors).unwrap();
        for (color, normal) in colors.iter().zip(normals.iter()) {
            assert_eq!(*color, scenes.shade(normal), "{degrees:?}");
        }
    }
}

#[test]
fn a_light_turns_and_a_map_is_baked_in_three_channels() {
    let rotation = Rotation::from_euler(0.3, 0.2, 0.1).unwrap();
    let turned = light::PARK.turned::<100>(&rotation).unwrap();
    let expected = light::PARK.g.turned::<100>(&rotation).unwrap();
    assert_eq!(turned.lights().unwrap().g.coefficients(), expected.as_slice());
    let window = Window::SincFourth { width: 20.0 };
    let windowed = light::PARK.windowed::<100>(window).unwrap();
    let expected = light::PARK.b.windowed::<100>(window).unwrap();
    assert_eq!(windowed.b, expected);
    let four = light::PARK.truncated(1).b.coefficients().len();
    assert_eq!(four, eigenshade_table::light::count(1));

    let scene = sphere::color::scene(light::PARK, material::GREEN_LATEX).unwrap();
    let maps = scene.each_ref().try_map(|scene| scene.bake::<1024>(32)).unwrap();
    for normal in NORMALS.map(normal) {
        let pairs = maps.bilinear(MapPoint::of(normal)).zip(scene.shade(normal));
        for (baked, exact) in <[_; 3]>::from(pairs) {
            assert!((baked - exact).abs() < 1e-2 * scene.shade(normal).largest());
        }
    }
}

/// Displayed pixels of integers differ from those of floats by what rounding explains, and are the
/// same bits on every machine.
#[test]
fn a_gold_sphere_on_a_display() {
    static DISPLAY: Display = Display::new(Tone::Filmic);
    let floats = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let integers =
        sphere::q15::color::scene(light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT).unwrap();
    let (exposure, of_floats) =
        (integers.exposure_by_factor(1.5).unwrap(), floats.exposure_by_factor(1.5).unwrap());
    let mut bytes = Vec::new();
    for pixel in Disc::new(120).unwrap() {
        let float = DISPLAY.rgb888(of_floats.of(floats.shade(pixel.normal())));
        let linear = exposure.of(integers.shade(pixel.normal_q15()));
        let integer = DISPLAY.rgb888(linear);
        for (float, integer) in <[_; 3]>::from(float.zip(integer)) {
            assert!(float.abs_diff(integer) <= 2, "{float} {integer}");
        }
        bytes.extend(DISPLAY.rgb565(linear).to_le_bytes());
    }
    assert_eq!(bytes.len(), 2 * 11_476);
    assert_eq!(crc32fast::hash(&bytes), 2_577_139_986);
}

/// About the view axis, the short way agrees with the matrices of any rotation.
#[test]
fn turning_about_the_view_axis() {
    /// Of the largest coefficient: sixteen roundings.
    const TOLERANCE: f32 = 2e-6;
    for angle in [0.0, 0.3, -1.7, 3.1] {
        let rotation = Rotation::from_euler(angle, 0.0, 0.0).unwrap();
        let expected = light::PARK.turned::<100>(&rotation).unwrap();
        let found = light::PARK.turned_about_view::<100>([angle.cos(), angle.sin()]).unwrap();
        for (found, expected) in <[_; 3]>::from(found.zip(expected)) {
            let largest = expected.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
            for (found, expected) in found.iter().zip(expected.iter()) {
                assert!((found - expected).abs() <= TOLERANCE * largest, "{found} {expected}");
            }
        }
    }
    // In a larger buffer, and of the largest degree.
    let numbers: Vec<f32> = (0..169).map(|k| (k as f32 * 0.7).sin()).collect();
    let light = Light::new(&numbers).unwrap();
    let expected = light.turned::<169>(&Rotation::from_euler(0.3, 0.0, 0.0).unwrap()).unwrap();
    let angle = [0.3_f32.cos(), 0.3_f32.sin()];
    let found = light.turned_about_view::<200>(angle).unwrap();
    assert_eq!(found.as_slice(), light.turned_about_view::<169>(angle).unwrap().as_slice());
    assert!(found.iter().zip(expected.iter()).all(|(a, b)| (a - b).abs() < TOLERANCE));
    let refused = light::PARK.turned_about_view::<99>([1.0, 0.0]);
    assert!(matches!(refused, Err(Error::Capacity { needed: 100, capacity: 99, .. })));
}
