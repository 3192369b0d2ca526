//! Complete programs, which draw a picture in color with all components of the shipped table, as
//! text. Their size includes tables and start-up code.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use board::{exit, print, print_u32, stack};
use eigenshade::q15::{Light, Material, Normal, Scene, Transfer};
use eigenshade::sphere::q15 as sphere;
use eigenshade::{Error, Q15};
use programs::drawing;
use programs::golden::q15::{LIGHT_0, LIGHT_1, LIGHT_2, MATERIAL_0, MATERIAL_1, MATERIAL_2};
use programs::one_material as fixed;

programs::program!();

/// Any light on any material.
fn any_material() {
    run(|| {
        let mut numbers = [[0; sphere::SCENE]; 3];
        let [red, green, blue] = numbers.each_mut();
        let channels = (
            any_scene(&LIGHT_0, &MATERIAL_0, red),
            any_scene(&LIGHT_1, &MATERIAL_1, green),
            any_scene(&LIGHT_2, &MATERIAL_2, blue),
        );
        let (Ok(red), Ok(green), Ok(blue)) = (&channels.0, &channels.1, &channels.2) else {
            return false;
        };
        draw(red, green, blue)
    });
}

/// Any light on one material, which was transferred when the program was compiled.
fn one_material() {
    run(|| {
        let mut numbers = [[0; fixed::SCENE]; 3];
        let [red, green, blue] = numbers.each_mut();
        let channels =
            (fixed_scene(&LIGHT_0, red), fixed_scene(&LIGHT_1, green), fixed_scene(&LIGHT_2, blue));
        let (Ok(red), Ok(green), Ok(blue)) = (&channels.0, &channels.1, &channels.2) else {
            return false;
        };
        draw(red, green, blue)
    });
}

/// Runs a program, and prints the depth of its stack.
fn run(program: impl Fn() -> bool) {
    let bytes = stack::used(|| {
        if !program() {
            exit(false);
        }
    });
    print("stack");
    print_u32(bytes);
    print("\n");
}

/// The scene of one color.
type Channel<'a> = Scene<'static, &'a mut [i32]>;

fn draw(red: &Channel<'_>, green: &Channel<'_>, blue: &Channel<'_>) -> bool {
    drawing::in_color(|normal| [pixel(red, normal), pixel(green, normal), pixel(blue, normal)]);
    true
}

/// Not inlined, so that it exists once for all channels.
#[inline(never)]
fn pixel(channel: &Channel<'_>, normal: Normal) -> i32 {
    channel.shade(normal)
}

/// Not inlined, so that its stack is free again when the picture is drawn.
#[inline(never)]
fn any_scene<'a>(
    &(light, of_light): &programs::golden::Light<Q15>,
    &(material, of_material): &programs::golden::Material<Q15>,
    numbers: &'a mut [i32],
) -> Result<Channel<'a>, Error> {
    use sphere::{BASIS, COMPONENTS, PROFILES, TRANSFER, WORKSPACE};
    let mut workspace = [0; WORKSPACE];
    let (mut transfer, mut exponents) = ([Q15(0); TRANSFER], [0; PROFILES]);
    let mut d = [0; COMPONENTS];
    let material = Material::new(of_material, material)?;
    BASIS.transfer_into(&material, &mut workspace, &mut transfer, &mut exponents)?;
    let light = Light::new(of_light, light)?;
    let exponent = BASIS.relight_into(&Transfer::new(&transfer, &exponents), &light, &mut d)?;
    BASIS.collapse_into(&d, exponent, numbers)
}

/// Not inlined, as above.
#[inline(never)]
fn fixed_scene<'a>(
    &(light, of_light): &programs::golden::Light<Q15>,
    numbers: &'a mut [i32],
) -> Result<Channel<'a>, Error> {
    use fixed::{BASIS, COMPONENTS, MATERIAL};
    let mut d = [0; COMPONENTS];
    let light = Light::new(of_light, light)?;
    let exponent = BASIS.relight_into(&MATERIAL, &light, &mut d)?;
    BASIS.collapse_into(&d, exponent, numbers)
}
