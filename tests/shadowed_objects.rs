//! Objects with shadows: their colors against sums in `f64`, and hard cases.

use eigenshade::object::ShadowedObject;
use eigenshade::screen::{Display, Exposure, Linear, Target, Tone, blend565};
use eigenshade::{Argument, Error, Light, Q15, Rgb, q15};
use eigenshade_table::light;
use eigenshade_table::shadowed::{Cluster, File, Pixel, Row};

pub static DISPLAY: Display = Display::new(Tone::Linear);

/// Numbers of any size, the same in every run.
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn words(&mut self, count: usize) -> Vec<i16> {
        (0..count).map(|_| self.next() as i16).collect()
    }

    fn bytes(&mut self, count: usize) -> Vec<i8> {
        (0..count).map(|_| self.next() as i8).collect()
    }

    pub fn light(&mut self, degree: usize) -> Vec<f32> {
        let mut light: Vec<f32> =
            self.words(light::count(degree)).iter().map(|&one| f32::from(one) / 40_000.0).collect();
        light[0] = 2.0;
        light
    }

    /// A file of these sizes; each cluster has a number of codes and an exponent.
    pub fn file(
        &mut self,
        [degree, parts, rank, images]: [usize; 4],
        clusters: &[(usize, i8)],
        pixels: Vec<Pixel>,
    ) -> File {
        let row = |numbers: &mut Self, j: usize| Row {
            exponent: -12 - j as i8 % 7,
            shifts: (0..=degree).map(|_| (numbers.next() % 5) as u8).collect(),
            mantissas: numbers.bytes(light::count(degree)),
        };
        File {
            size: [7, 5],
            degree: degree as u8,
            shares: (0..parts).map(|_| self.words(3).try_into().unwrap()).collect(),
            rows: (0..parts).map(|_| (0..rank).map(|j| row(self, j)).collect()).collect(),
            clusters: clusters
                .iter()
                .map(|&(codes, exponent)| Cluster {
                    mean: (exponent, self.words(rank)),
                    images: (0..images).map(|_| (exponent, self.bytes(rank))).collect(),
                    weights: (0..codes).map(|_| self.bytes(images)).collect(),
                })
                .collect(),
            pixels,
            tints: vec![],
        }
    }
}

fn sum<A: Copy + Into<f64>, B: Copy + Into<f64>>((exponent, a): &(i8, Vec<A>), b: &[B]) -> f64 {
    let sum: f64 = a.iter().zip(b).map(|(&a, &b)| a.into() * b.into()).sum();
    sum * f64::from(*exponent).exp2()
}

/// The irradiances of the codes in a channel, from the numbers of a file.
pub fn irradiances(file: &File, light: &[f32], channel: usize) -> Vec<f64> {
    let mut d = vec![0.0; file.rows[0].len()];
    for (share, rows) in file.shares.iter().zip(&file.rows) {
        let share = f64::from(share[channel]) / 32_767.0;
        for (d, row) in d.iter_mut().zip(rows) {
            let shifted: Vec<f64> = light::indices(usize::from(file.degree))
                .zip(light)
                .map(|((l, _), one)| f64::from(*one) * f64::from(row.shifts[l]).exp2())
                .collect();
            *d += share * sum(&(row.exponent, row.mantissas.clone()), &shifted);
        }
    }
    let of_clusters = file.clusters.iter().map(|cluster| {
        let mean = sum(&cluster.mean, &d);
        let images: Vec<f64> = cluster.images.iter().map(|image| sum(image, &d)).collect();
        cluster.weights.iter().map(move |weights| mean + sum(&(0, weights.clone()), &images))
    });
    of_clusters.flatten().collect()
}

/// The exposed irradiances of the codes, and their pixels, under a light in `f32` and in integers.
fn shown(file: &File, lights: [&[f32]; 3], exposure: f64) -> [Vec<(Rgb<Linear>, [u8; 3])>; 2] {
    let bytes = file.encode();
    let object = ShadowedObject::new(&bytes).unwrap();
    let mut mantissas = lights.map(|light| vec![Q15(0); light.len()]);
    let mut in_q15 = mantissas.iter_mut().zip(lights);
    let integers = [(); 3].map(|()| {
        let (to, light) = in_q15.next().unwrap();
        q15::Light::quantize(light, to).unwrap()
    });
    let floats = lights.map(|light| Light::new(light).unwrap());
    let exposure = Exposure::new(exposure as f32).unwrap();
    let ways = [object.coefficients(floats.into()), object.coefficients_q15(integers.into())];
    ways.map(|d| {
        let d = d.unwrap();
        let mut shaded = Vec::new();
        object.shade(&d, exposure, |color| shaded.push(color));
        let mut colors = vec![[0_u8; 3]; object.codes()];
        object.colors(&d, exposure, &DISPLAY, &mut colors).unwrap();
        assert_eq!(shaded.len(), object.codes());
        shaded.into_iter().zip(colors).collect()
    })
}

/// Checks codes against the sums: within 1e-3 of white, and within 2 levels of 255.
fn check(file: &File, lights: [&[f32]; 3], codes: std::ops::Range<usize>) {
    let exact = [0, 1, 2].map(|channel| irradiances(file, lights[channel], channel));
    let seen = || exact.iter().flat_map(|channel| &channel[codes.clone()]);
    let peak = seen().fold(0.0_f64, |most, one| most.max(one.abs()));
    let exposure = 1.0 / peak;
    for way in shown(file, lights, exposure) {
        for (code, (linear, pixel)) in way.iter().enumerate().take(codes.end).skip(codes.start) {
            let linear = <[Linear; 3]>::from(*linear);
            for (channel, (Linear(units), level)) in linear.into_iter().zip(pixel).enumerate() {
                let expected = (exposure * exact[channel][code]).max(0.0);
                let found = f64::from(units) / 65_536.0;
                assert!((found - expected).abs() < 1e-3, "{code}: {found} {expected}");
                let expected = DISPLAY.rgb888(Rgb::gray(expected as f32)).r;
                assert!(level.abs_diff(expected) <= 2, "{code}: {level} {expected}");
            }
        }
    }
}

pub fn whole(column: u16, row: u16, code: u16) -> Pixel {
    Pixel { column, row, code, coverage: u8::MAX }
}

/// Two clusters of two codes and one; two runs in a row, and one in the next.
pub fn small() -> File {
    let rim = Pixel { column: 3, row: 0, code: 2, coverage: 90 };
    let pixels = vec![whole(0, 0, 0), whole(1, 0, 1), rim, whole(2, 1, 1)];
    File { size: [4, 2], ..Numbers(1).file([0, 1, 1, 1], &[(2, 0), (1, 3)], pixels) }
}

#[test]
fn colors_are_those_of_a_direct_sum() {
    let mut numbers = Numbers(2);
    let sizes = [
        ([0, 1, 1, 0], [1, 1]),
        ([9, 1, 1, 16], [3, 200]),
        ([9, 3, 100, 0], [40, 1]),
        ([9, 3, 100, 16], [300, 200]),
        ([16, 1, 64, 8], [500, 500]),
    ];
    for (sizes, [first, second]) in sizes {
        let file = numbers.file(sizes, &[(first, 0), (0, 1), (second, -1)], vec![]);
        let lights = [(); 3].map(|()| numbers.light(sizes[0]));
        check(&file, lights.each_ref().map(Vec::as_slice), 0..first + second);
    }
}

/// Exposed for the pits, these are as exact as the rims are when exposed for them.
#[test]
fn dim_pits_beside_bright_rims_keep_their_digits() {
    let mut numbers = Numbers(3);
    for exponent in [-6, -20, -60] {
        let file = numbers.file([9, 1, 40, 8], &[(100, 0), (100, exponent)], vec![]);
        let lights = [(); 3].map(|()| numbers.light(9));
        let lights = lights.each_ref().map(Vec::as_slice);
        check(&file, lights, 0..100);
        check(&file, lights, 100..200);
    }
    // A bright light in one channel, and a dim one in another.
    let file = numbers.file([9, 1, 40, 8], &[(100, 0)], vec![]);
    let light = numbers.light(9);
    let dim: Vec<f32> = light.iter().map(|one| one * 1e-6).collect();
    let of_dim = [&dim[..]; 3];
    check(&file, [&light, &light, &dim], 0..100);
    check(&file, of_dim, 0..100);
}

#[test]
fn an_object_of_one_pixel_has_the_color_of_its_code() {
    let mut numbers = Numbers(4);
    let file = numbers.file([4, 1, 9, 2], &[(1, 0)], vec![whole(0, 0, 0)]);
    let file = File { size: [1, 1], ..file };
    let light = numbers.light(4);
    check(&file, [&light; 3], 0..1);
    let [way, _] = shown(&file, [&light; 3], 1.0);
    let bytes = file.encode();
    let object = ShadowedObject::new(&bytes).unwrap();
    let mut screen = [[9_u8; 3]; 4];
    object.draw(&[way[0].1], &mut Target::new(&mut screen, 2).unwrap().at(1, 1));
    assert_eq!(screen, [[9; 3], [9; 3], [9; 3], way[0].1]);
}

#[test]
fn lights_of_a_lower_degree_fit_and_those_of_a_higher_do_not() {
    let mut numbers = Numbers(5);
    let file = numbers.file([4, 1, 9, 2], &[(30, 0)], vec![]);
    let lights = [0, 3, 4].map(|degree| numbers.light(degree));
    check(&file, lights.each_ref().map(Vec::as_slice), 0..30);
    let bytes = file.encode();
    let object = ShadowedObject::new(&bytes).unwrap();
    let high = numbers.light(5);
    let refused = Error::Beyond { argument: Argument::Light, most: 4, found: 5 };
    let [low, high] = [&lights[0], &high].map(|light| Light::new(light).unwrap());
    assert_eq!(object.coefficients(Rgb::new(low, low, high)), Err(refused));
    let mantissas = [Q15(1); 36];
    let light = q15::Light::new(0, &mantissas).unwrap();
    assert_eq!(object.coefficients_q15(Rgb::gray(light)), Err(refused));
}

#[test]
fn wrong_numbers_of_colors_are_refused() {
    let bytes = small().encode();
    let object = ShadowedObject::new(&bytes).unwrap();
    let d = object.coefficients(Rgb::gray(Light::new(&[1.0]).unwrap())).unwrap();
    for found in [0, 2, 4] {
        let refused = Error::Length { argument: Argument::Colors, expected: 3, found };
        let mut colors = vec![0_u16; found];
        let colored = object.colors(&d, Exposure::default(), &DISPLAY, &mut colors);
        assert_eq!(colored, Err(refused));
        assert!(refused.to_string().contains("one for each code"));
    }
    // Pixels without a color are not drawn.
    let mut screen = [1_u16; 8];
    object.draw(&[7], &mut Target::new(&mut screen, 4).unwrap());
    assert_eq!(screen, [7, 1, 1, 1, 1, 1, 1, 1]);
}

/// At any place of a target and in any part of it, with any coverage of the rim.
#[test]
fn drawing_is_as_pixel_by_pixel() {
    let mut numbers = Numbers(6);
    let places = (0..5).flat_map(|row| (0..7).map(move |column| (column, row)));
    let pixels: Vec<Pixel> = places
        .filter_map(|(column, row)| {
            let choice = numbers.next() as u16;
            let coverage = if choice & 3 == 0 { (choice >> 8) as u8 } else { u8::MAX };
            (choice & 12 > 0).then_some(Pixel { column, row, code: choice >> 4 & 7, coverage })
        })
        .collect();
    let bytes = numbers.file([0, 1, 1, 0], &[(7, 0)], pixels.clone()).encode();
    let object = ShadowedObject::new(&bytes).unwrap();
    let words = [0xf800_u16, 0x07e0, 0x001f, 0xffff, 0x0000, 0x1234, 0xabcd];
    let fine = words.map(|word| [word as u8, (word >> 8) as u8, (word >> 4) as u8]);
    for (x, y) in (-8..13).flat_map(|x| (-6..9).map(move |y| (x, y))) {
        let (mut screen, mut expected) = ([0x5555_u16; 11 * 8], [0x5555_u16; 11 * 8]);
        let (mut screen_fine, mut expected_fine) = ([[70_u8, 80, 90]; 88], [[70_u8, 80, 90]; 88]);
        let (corner, size) = ([2, 1], [7, 6]);
        object.draw(&words, &mut Target::new(&mut screen, 11).unwrap().part(corner, size).at(x, y));
        object.draw(
            &fine,
            &mut Target::new(&mut screen_fine, 11).unwrap().part(corner, size).at(x, y),
        );
        let mut target = Target::new(&mut expected, 11).unwrap();
        let mut part = target.part(corner, size);
        let mut part = part.at(x, y);
        let mut target = Target::new(&mut expected_fine, 11).unwrap();
        let mut part_fine = target.part(corner, size);
        let mut part_fine = part_fine.at(x, y);
        for Pixel { column, row, code, coverage } in &pixels {
            let place = [usize::from(*column), usize::from(*row)];
            let code = usize::from(*code);
            if let (Some(&color), Some(below)) = (words.get(code), part.pixel(place[0], place[1])) {
                *below = blend565(*below, color, *coverage);
            }
            if let (Some(&color), Some(below)) =
                (fine.get(code), part_fine.pixel(place[0], place[1]))
            {
                *below = Rgb::from(color).over((*below).into(), *coverage).into();
            }
        }
        assert_eq!(screen, expected, "{x} {y}");
        assert_eq!(screen_fine, expected_fine, "{x} {y}");
        let swapped = words.map(u16::to_be_bytes);
        let mut bytes = [0x5555_u16.to_be_bytes(); 88];
        object
            .draw(&swapped, &mut Target::new(&mut bytes, 11).unwrap().part(corner, size).at(x, y));
        assert_eq!(bytes.map(u16::from_be_bytes), screen);
    }
}

/// No sum overflows, whatever the numbers are: the tests check their arithmetic.
#[test]
fn extreme_numbers_saturate() {
    let mut numbers = Numbers(7);
    let extremes = [i8::MIN, -1, 0, i8::MAX];
    for (exponent, other) in extremes.into_iter().flat_map(|one| extremes.map(|other| (one, other)))
    {
        for number in [i16::MIN, i16::MAX] {
            let byte = (number >> 8) as i8;
            let mut file = numbers.file([2, 3, 100, 16], &[(2, exponent), (1, other)], vec![]);
            file.shares.fill([number, i16::MAX, 1]);
            // The second part takes from the first what it gives.
            for (rows, byte) in file.rows.iter_mut().zip([byte, -byte.max(-i8::MAX), byte]) {
                for row in rows.iter_mut() {
                    row.shifts.fill(12);
                    row.mantissas.fill(byte);
                }
                rows.iter_mut().step_by(3).for_each(|row| row.exponent = exponent);
                rows.iter_mut().step_by(2).for_each(|row| row.exponent = other);
            }
            for (k, cluster) in file.clusters.iter_mut().enumerate() {
                cluster.mean.1.fill(number);
                cluster.images.iter_mut().for_each(|(_, image)| image.fill(byte));
                cluster.images.iter_mut().step_by(2).for_each(|(of_image, _)| *of_image = other);
                let weight = if k == 0 { i8::MIN } else { i8::MAX };
                cluster.weights.iter_mut().for_each(|weights| weights.fill(weight));
            }
            let bytes = file.encode();
            let object = ShadowedObject::new(&bytes).unwrap();
            let mut all = Vec::new();
            for light in [f32::MIN, f32::MIN_POSITIVE, 1e-45, 0.0, 1.0, f32::MAX] {
                let light = [light; 9];
                all.push(object.coefficients(Rgb::gray(Light::new(&light).unwrap())).unwrap());
            }
            for (exponent, mantissa) in [(-128, 1), (-128, i16::MIN), (128, i16::MIN), (128, 0)] {
                let light = [Q15(mantissa); 9];
                let light = q15::Light::new(exponent, &light).unwrap();
                all.push(object.coefficients_q15(Rgb::gray(light)).unwrap());
            }
            for (d, exposure) in all
                .iter()
                .flat_map(|d| [f32::MIN_POSITIVE, 1.0, f32::MAX].map(|exposure| (d, exposure)))
            {
                let mut count = 0;
                object.shade(d, Exposure::new(exposure).unwrap(), |_| count += 1);
                assert_eq!(count, 3);
            }
        }
    }
}

/// Two parts that cancel at a large exponent, beside a component at a small one: the zero was shifted by
/// 200 bits.
#[test]
fn parts_that_cancel_leave_the_other_components() {
    let row = |exponent, mantissa| Row { exponent, shifts: vec![0], mantissas: vec![mantissa] };
    let file = File {
        size: [1, 1],
        degree: 0,
        shares: vec![[i16::MAX; 3]; 2],
        rows: vec![vec![row(100, 100), row(-100, 100)], vec![row(100, -100), row(-100, 0)]],
        clusters: vec![Cluster {
            mean: (100, vec![20_000; 2]),
            images: vec![],
            weights: vec![vec![]],
        }],
        pixels: vec![],
        tints: vec![],
    };
    check(&file, [&[1.0]; 3], 0..1);
}

/// A coefficient of 2^-114 has fewer bits than others, not another size.
#[test]
fn the_dimmest_lights_keep_their_size() {
    let mut file = Numbers(8).file([0, 1, 1, 0], &[(1, 0)], vec![]);
    file.shares.fill([i16::MAX; 3]);
    file.rows = vec![vec![Row { exponent: -20, shifts: vec![0], mantissas: vec![1 << 6] }]];
    check(&file, [&[2_f32.powi(-100)]; 3], 0..1);
}
