//! How far the runtime in floats is from the direct sum over modes, from degree 9 to 32, with all
//! components: `cargo run --release --example float_errors -- [DEGREE,ORDER ..]`.
//!
//! CSV on standard output: the largest and the root mean square error of a pixel, as shares of
//! the image's peak, of the worst pair of a light and a material.

#[path = "../tests/float_errors/mod.rs"]
mod float_errors;
#[path = "../tests/stability/glossy.rs"]
mod glossy;

fn main() {
    let shape = |text: String| {
        let (degree, order) = text.split_once(',').expect("DEGREE,ORDER");
        [degree, order].map(|number| number.parse().expect("a number"))
    };
    let asked: Vec<[usize; 2]> = std::env::args().skip(1).map(shape).collect();
    let shapes = if asked.is_empty() { float_errors::SHAPES.to_vec() } else { asked };
    println!("degree,order,components,method,format,max,rms");
    for [degree, order] in shapes {
        for one in float_errors::errors([degree, order]) {
            let float_errors::Errors { components, method, format, largest, rms } = one;
            println!("{degree},{order},{components},{method},{format},{largest:.1e},{rms:.1e}");
        }
    }
}
