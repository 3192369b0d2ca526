//! Objects of any codes in targets of any shape.

use super::Reader;
use eigenshade::object::{NormalMap, Object, Region};
use eigenshade::screen::{
    Display, Linear, LinearPalette, Nodes, Palette, Sent, Target, Tone, blend565,
};
use eigenshade::{Normal, Rgb};
use eigenshade_table::object::{Pixel, encode};

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
    linear.fill_mirrored(&Nodes::ALL, |normal: Normal| [normal.mirrored().map(exposed); 2]);

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
            let Rgb { r: Linear(units), .. } = linear.color(code, Rgb::gray(u16::MAX));
            assert!(units <= 32 << 16);
        }
        assert_eq!(whole, single);
        let mut sent = Sent::<1>::default();
        let sent = [whole, single].map(|pixels| sent.send(0, pixels, |_| Ok::<(), ()>(())));
        assert_eq!(sent, [Ok(true), Ok(false)]);
    }
}

/// A packed object has the pixels that were written, and draws them as one by one; with changed
/// bytes, it is refused or drawn.
pub fn packed(input: &mut Reader<'_>) {
    let size = [(); 2].map(|()| 1 + u16::from(input.byte()) % 9);
    let regions = [(); 2].map(|()| {
        let [metallic, roughness] = [(); 2].map(|()| f32::from(input.byte()) / 255.0);
        Region::new(metallic, roughness).expect("from 0 to 1")
    });
    let mut pixels = Vec::new();
    for (row, column) in (0..size[1]).flat_map(|row| (0..size[0]).map(move |one| (row, one))) {
        let choice = input.byte();
        if choice > 60 {
            let region = u16::from(choice & 1);
            pixels.push(Pixel { column, row, region, record: input.bytes() });
        }
    }
    let mut bytes = encode(size, &regions.map(Region::bytes), &pixels);
    let object = Object::new(&bytes).expect("a written object");
    assert!(object.regions().eq(regions));
    let has_normal = |[u, v, ..]: [u8; 6]| {
        let [u, v] = [u, v].map(|one| i32::from(one.cast_signed()));
        u * u + v * v < 1 << 14
    };
    let written = pixels.iter().filter(|pixel| has_normal(pixel.record));
    let found = object.pixels().map(|pixel| {
        let [u, v] = pixel.code().bytes();
        (pixel.column(), pixel.row(), pixel.region(), [u, v, pixel.coverage()])
    });
    assert!(found.eq(written.map(|pixel| {
        let [u, v, _, _, _, coverage] = pixel.record;
        let place = [pixel.column, pixel.row, pixel.region].map(usize::from);
        (place[0], place[1], place[2], [u, v, coverage])
    })));
    let palettes = [0.3, 0.8].map(|scale: f32| {
        let mut palette = LinearPalette::default();
        palette.fill(&Nodes::ALL, |normal: Normal| {
            let [x, y, z] = normal.components();
            [Rgb::new(scale * z, 0.5 - y, x), Rgb::gray(0.1 * scale)]
        });
        palette
    });
    let [across, down] = [(); 2].map(|()| 1 + input.up_to(12));
    let at = [(); 2].map(|()| i32::from(input.byte() % 24) - 12);
    let mut both = [(); 2].map(|()| vec![[9_u8, 8]; across * down]);
    let [whole, single] = &mut both;
    let painted = object.painted(&palettes, &DISPLAY).expect("two palettes");
    painted.draw(&mut Target::new(whole, across).expect("a row").at(at[0], at[1]));
    let mut target = Target::new(single, across).expect("a row");
    let mut target = target.at(at[0], at[1]);
    for pixel in object.pixels() {
        let color = palettes[pixel.region()].color(pixel.code(), pixel.base_color());
        if let Some(below) = target.pixel(pixel.column(), pixel.row()) {
            let [below565, color] = [u16::from_be_bytes(*below), DISPLAY.rgb565(color)];
            *below = blend565(below565, color, pixel.coverage()).to_be_bytes();
        }
    }
    assert_eq!(whole, single);
    assert!(object.painted(&palettes[..1], &DISPLAY).is_err());

    for _ in 0..1 + input.up_to(3) {
        let place = usize::from(u16::from_le_bytes(input.bytes())) % bytes.len();
        bytes[place] = input.byte();
    }
    bytes.truncate(bytes.len() - input.up_to(2) * input.up_to(40).min(bytes.len() / 2));
    if let Ok(object) = Object::new(&bytes) {
        let palettes = vec![LinearPalette::default(); object.regions().len().min(4)];
        if let Ok(painted) = object.painted(&palettes, &DISPLAY) {
            painted.dithered().draw(&mut Target::new(&mut [0_u16; 30], 6).expect("rows"));
        }
        let _ = object.pixels().take(100).count();
    }
}
