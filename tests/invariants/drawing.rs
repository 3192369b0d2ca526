//! Objects of any codes in targets of any shape.

use super::Reader;
use eigenshade::object::NormalMap;
use eigenshade::screen::{Display, Linear, LinearPalette, Nodes, Palette, Sent, Target, Tone};
use eigenshade::{Normal, Rgb};

static DISPLAY: Display = Display::new(Tone::Reinhard);

/// An object from a palette has the pixels that it has one by one, and no others are drawn.
pub fn drawing(input: &mut Reader<'_>) {
    let scale = input.float(false);
    let exposed = |normal: Normal| {
        let [x, y, z] = normal.components();
        Rgb::new(x * scale, y, z * scale)
    };
    let (mut palette, mut linear) = (Palette::default(), LinearPalette::default());
    palette.fill(&Nodes::ALL, &DISPLAY, exposed);
    linear.fill_mirrored(&Nodes::ALL, |normal: Normal| normal.mirrored().map(exposed));

    let [width, height] = [(); 2].map(|()| 1 + input.up_to(9));
    let codes: Vec<u8> = (0..2 * width * height).map(|_| input.byte()).collect();
    let map = NormalMap::new(width, height, &codes).expect("two bytes a pixel");
    assert!(map.nodes().count() <= Nodes::ALL.count());
    let [across, down] = [(); 2].map(|()| 1 + input.up_to(12));
    let [left, top, most_across, most_down] = [(); 4].map(|()| input.up_to(14));
    let place = |input: &mut Reader<'_>| match input.byte() {
        255 => i32::MIN,
        254 => i32::MAX,
        byte => i32::from(byte % 24) - 12,
    };
    let at = [place(input), place(input)];

    let mut all = [[(); 2]; 2].map(|pair| pair.map(|()| vec![0x1234_u16; across * down + 3]));
    for (is_dithered, [whole, single]) in [false, true].into_iter().zip(&mut all) {
        let mut target = Target::new(whole, across).expect("a row");
        let mut part = target.part([left, top], [most_across, most_down]);
        let mut part = part.at(at[0], at[1]);
        if is_dithered {
            palette.dithered().draw(&map, &mut part);
        } else {
            palette.draw(&map, &mut part);
        }
        let mut target = Target::new(single, across).expect("a row");
        let mut part = target.part([left, top], [most_across, most_down]);
        let mut part = part.at(at[0], at[1]);
        for pixel in map.pixels() {
            let code = pixel.code();
            let color = if is_dithered {
                palette.dithered().rgb565(code, pixel.column(), pixel.row())
            } else {
                palette.rgb565(code)
            };
            pixel.put(&mut part, color);
            let Rgb { r: Linear(units), .. } = linear.color(code);
            assert!(units <= 16 << 16);
        }
        assert_eq!(whole, single);
        let mut sent = Sent::<1>::default();
        let sent = [whole, single].map(|pixels| sent.send(0, pixels, |_| Ok::<(), ()>(())));
        assert_eq!(sent, [Ok(true), Ok(false)]);
    }
}
