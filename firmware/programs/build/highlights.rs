//! The highlights of four sources in front of the object as statics, because the smallest board
//! computes nothing in floats.

use crate::Result;
use eigenshade::{Gloss, Highlights, Rgb, Source, q15};

/// Where the sources are: (x, y, 1), scaled. All normals of the integer programs face them.
const PLACES: [[f32; 2]; 4] = [[-0.2, 0.3], [-0.4, 0.1], [-0.1, 0.4], [-0.5, 0.3]];

/// α² and the lobes of one channel and of three, for scenes of exponent 0.
pub fn constants() -> Result<String> {
    let fault = |error: eigenshade::Error| error.to_string();
    let gloss = Gloss::metallic_roughness([1.0, 0.78, 0.34], 1.0, 0.3).map_err(fault)?;
    let sources = PLACES.map(|[x, y]| {
        let length = (x * x + y * y + 1.0).sqrt();
        let direction = [x, y, 1.0].map(|component| component / length);
        Source::new(direction, [1.0, 0.9, 0.8], 0.05).map_err(fault)
    });
    let [a, b, c, d] = sources;
    let floats = Highlights::<4>::new(&gloss, &[a?, b?, c?, d?]);
    let floats = floats.map_err(fault)?;
    let gray = q15::Highlights::<i32, 4>::quantize(&floats, 0).map_err(fault)?;
    let color = q15::Highlights::<Rgb<i32>, 4>::quantize(&floats, Rgb::gray(0));
    let color = color.map_err(fault)?;
    Ok(format!(
        "/// α² in units of 2^-30.\n\
         pub const ALPHA_SQUARE: u32 = {};\n\
         /// In one channel.\n\
         pub static GRAY: [Lobe<i32>; 4] = {:?};\n\
         /// In color.\n\
         pub static COLOR: [Lobe<Rgb<i32>>; 4] = {:?};\n",
        gray.alpha_square(),
        gray.lobes(),
        color.lobes(),
    ))
}
