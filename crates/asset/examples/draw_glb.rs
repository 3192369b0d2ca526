//! Draws an object in its own materials under a light, as `eigenshade render --object` does. A
//! light is the name of a shipped one, or a CSV.

use eigenshade_asset::{asset::Asset, picture::Picture, picture::Settings};
use std::error::Error;

/// Draws an object in its own materials.
pub fn draw(object: &str, light: &str, out: &str) -> Result<(), Box<dyn Error>> {
    let file = object.into();
    let asset = Asset::read(&file)?.ok_or("the object has no materials")?;
    let picture = Picture::of(&file, &asset, &light.parse()?, &Settings::default())?;
    picture.write_png(out)?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    draw("watch.glb", "lobby", "watch.png")
}
