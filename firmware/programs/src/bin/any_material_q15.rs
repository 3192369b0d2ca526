//! A scene in color with fifty components: any light on any material, both may change.
//! Everything that it takes is in it; tables, start-up, and a picture as text.
#![no_std]
#![no_main]

use board::{exit, print, print_u32, program, stack};
use eigenshade::quantized::{Light, Material, Normal, Scene, Transfer};
use eigenshade::sphere::q15::{BASIS, COMPONENTS, PROFILES, SCENE, TRANSFER, WORKSPACE};
use eigenshade::{Error, Q15};
use programs::golden::q15::{LIGHT_0, LIGHT_1, LIGHT_2, MATERIAL_0, MATERIAL_1, MATERIAL_2};
use programs::picture;

program!(main);

fn main() {
    let bytes = stack::used(|| {
        if !run() {
            exit(false);
        }
    });
    print("stack");
    print_u32(bytes);
    print("\n");
}

/// Other lights and materials for each channel, so that all may differ.
fn run() -> bool {
    let mut numbers = [[0; SCENE]; 3];
    let [red, green, blue] = numbers.each_mut();
    // Looked at where they are: moving takes code.
    let channels = (
        scene(&LIGHT_0, &MATERIAL_0, red),
        scene(&LIGHT_1, &MATERIAL_1, green),
        scene(&LIGHT_2, &MATERIAL_2, blue),
    );
    let (Ok(red), Ok(green), Ok(blue)) = (&channels.0, &channels.1, &channels.2) else {
        return false;
    };
    picture::draw(|normal| [pixel(red, normal), pixel(green, normal), pixel(blue, normal)]);
    true
}

type Channel<'a> = Scene<'static, Q15, &'a mut [i32]>;

/// Once for all channels.
#[inline(never)]
fn pixel(channel: &Channel<'_>, normal: Normal<Q15>) -> i32 {
    channel.shade(normal)
}

/// Apart, so that its room is free again when the picture is drawn.
#[inline(never)]
fn scene<'a>(
    &(light, of_light): &programs::golden::Light<Q15>,
    &(material, of_material): &programs::golden::Material<Q15>,
    numbers: &'a mut [i32],
) -> Result<Channel<'a>, Error> {
    let mut workspace = [0; WORKSPACE];
    let (mut transfer, mut exponents) = ([Q15(0); TRANSFER], [0; PROFILES]);
    let mut d = [0; COMPONENTS];
    let material = Material::new(of_material, material)?;
    BASIS.transfer_into(&material, &mut workspace, &mut transfer, &mut exponents)?;
    let light = Light::new(of_light, light)?;
    let exponent = BASIS.relight_into(&Transfer::new(&transfer, &exponents), &light, &mut d)?;
    BASIS.collapse_into(&d, exponent, numbers)
}
