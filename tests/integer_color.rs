//! Materials of integers in a color, and maps of integers in three channels.

use eigenshade::presets::{light, material};
use eigenshade::{Error, Q15, Rgb, q15, sphere};

/// Integers against the same product in floats: half a unit of each mantissa, and of the product.
#[test]
fn a_tint_in_integers_scales_each_channel() {
    let gray = material::q15::PTFE_633NM.g;
    let colors = [[32_767, 16_384, 3], [0, -9_000, 32_767]];
    for color in colors {
        let tinted = gray.tint::<40, 8>(color.map(Q15)).unwrap();
        let found = <[_; 3]>::from(tinted.materials().unwrap());
        for (factor, found) in color.into_iter().zip(found) {
            for (o, (&of_gray, &exponent)) in
                gray.exponents().iter().zip(found.exponents()).enumerate()
            {
                let (mut most, unit) = (0, f64::from(exponent).exp2());
                let of_order = eigenshade_table::material::indices(7).map(|(of, ..)| of == o);
                for (_, (&gray, &found)) in of_order
                    .zip(gray.mantissas().iter().zip(found.mantissas()))
                    .filter(|(is_of_order, _)| *is_of_order)
                {
                    let fraction = f64::from(factor) / 32_768.0;
                    let exact = f64::from(gray.0) * f64::from(of_gray).exp2() * fraction;
                    let apart = (f64::from(found.0) * unit - exact).abs();
                    assert!(apart <= 0.5 * unit, "{factor}, {o}: {apart}");
                    most = most.max(found.0.unsigned_abs());
                }
                assert!(factor == 0 || most >= 1 << 14, "{factor}, {o}: {most} of 15 bits");
            }
        }
    }
    let of_gold = material::q15::GOLD_METALLIC_PAINT.tint::<40, 8>(colors[0].map(Q15)).unwrap();
    let channel = material::q15::GOLD_METALLIC_PAINT.g.tint::<40, 8>([Q15(16_384); 3]).unwrap();
    assert_eq!(of_gold.g, channel.g);
    assert!(matches!(gray.tint::<39, 8>([Q15(1); 3]), Err(Error::Length { .. })));
    assert!(matches!(gray.tint::<40, 9>([Q15(1); 3]), Err(Error::Length { .. })));
}

/// A baked map in color is three maps, looked up and exposed channel by channel.
#[test]
fn integers_are_baked_in_color() {
    let scene = sphere::color::scene(light::LOBBY, material::DARK_RED_PAINT).unwrap();
    let texels = || Rgb::gray([0; 16 * 16]);
    let map = scene.bake_integers_into(16, texels()).unwrap();
    let exposure = map.exposure_by_factor(1.5).unwrap();
    let point = q15::MapPoint::new(Q15(3_000), Q15(-9_000));
    let of_channel = scene.each_ref().map(|scene| {
        let map = scene.bake_integers_into(16, [0; 16 * 16]).unwrap();
        let exposure = q15::Exposure::new(1.5, map.exponent()).unwrap();
        let found = map.bilinear(point);
        (found, exposure.of(found))
    });
    let found = map.bilinear(point);
    assert_eq!(found.zip(exposure.of(found)), of_channel);
    assert!(scene.bake_integers_into(16, Rgb::gray([0; 15])).is_err());
    assert!(map.exposure_by_factor(0.0).is_err());
}
