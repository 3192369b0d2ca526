//! A white sphere under a lamp below and to the left of the camera, as text.

use eigenshade::{Error, Light, Material, Normal};
use own_table::table;

fn main() -> Result<(), Error> {
    let light = Light::new(&[2.0, 0.7, 1.0, 0.7])?;
    let material = Material::new(&[2.0])?;
    let scene = table::collapse(&table::project(&light, &material)?);
    for row in 0..20 {
        let line: String = (0..40)
            .map(|column| {
                let (x, y) = ((column as f32 - 19.5) / 20.0, (9.5 - row as f32) / 10.0);
                let square = 1.0 - x * x - y * y;
                let normal = Normal::new(x, y, square.max(0.0).sqrt());
                let shade = normal.map_or(0.0, |normal| scene.shade(normal));
                let level = (8.0 * shade) as usize;
                if square < 0.0 { ' ' } else { b".:-=+*#%@"[level.min(8)].into() }
            })
            .collect();
        println!("{}", line.trim_end());
    }
    Ok(())
}
