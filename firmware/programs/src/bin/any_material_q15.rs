//! A scene in colour with fifty components: any light on any material, both may change.
//! Everything that it takes is in it; tables, start-up, and a picture as text.
#![no_std]
#![no_main]

use board::{exit, program, say, say_number, stack};
use eigenshade::quantised::{Light, Material, Scene, Transfer};
use eigenshade::sphere::q15::{
    BASIS, COMPONENTS, DEGREE, ORDER, PROFILES, SCENE, TRANSFER, WORKSPACE,
};
use eigenshade::{Error, Q15};
use programs::golden::q15::{LIGHT_0, LIGHT_1, LIGHT_2, MATERIAL_0, MATERIAL_1, MATERIAL_2};
use programs::picture;

program!(main);

fn main() {
    let bytes = stack::taken(|| {
        if run().is_err() {
            exit(false);
        }
    });
    say("stack");
    say_number(bytes);
    say("\n");
}

/// What the channels share while they are set up.
struct Room {
    workspace: [i32; WORKSPACE],
    transfer: [Q15; TRANSFER],
    exponents: [i16; PROFILES],
    d: [i32; COMPONENTS],
}

/// Other lights and materials for each channel, so that all may differ.
fn run() -> Result<(), Error> {
    let mut numbers = [[0; SCENE]; 3];
    let [red, green, blue] = numbers.each_mut();
    let channels = set_up(red, green, blue)?;
    picture::draw(|normal| channels.each_ref().map(|scene| scene.shade(normal)));
    Ok(())
}

type Channel<'a> = Scene<'static, Q15, &'a mut [i32]>;

/// Apart, so that its room is free again when the picture is drawn.
#[inline(never)]
fn set_up<'a>(
    red: &'a mut [i32],
    green: &'a mut [i32],
    blue: &'a mut [i32],
) -> Result<[Channel<'a>; 3], Error> {
    let mut room = Room {
        workspace: [0; WORKSPACE],
        transfer: [Q15(0); TRANSFER],
        exponents: [0; PROFILES],
        d: [0; COMPONENTS],
    };
    Ok([
        room.scene(&LIGHT_0, &MATERIAL_0, red)?,
        room.scene(&LIGHT_1, &MATERIAL_1, green)?,
        room.scene(&LIGHT_2, &MATERIAL_2, blue)?,
    ])
}

impl Room {
    #[inline(never)]
    fn scene<'a>(
        &mut self,
        &(light, of_light): &programs::golden::Light<Q15>,
        &(material, of_material): &programs::golden::Material<Q15>,
        numbers: &'a mut [i32],
    ) -> Result<Channel<'a>, Error> {
        let Self { workspace, transfer, exponents, d } = self;
        let material = Material::new(ORDER, of_material, material)?;
        BASIS.fold_into(&material, workspace, transfer, exponents)?;
        let light = Light::new(DEGREE, of_light, light)?;
        let exponent = BASIS.relight_into(&Transfer::new(transfer, exponents), &light, d)?;
        BASIS.collapse_into(d, exponent, numbers)
    }
}
