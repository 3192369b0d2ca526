//! A basis at degree 32 and order 32.

use super::{Case, Figure, fixtures, glossy, tolerances};
use eigenshade_generator::basis;
use eigenshade_index::mode;

pub const CASE: Case = Case {
    name: "degree 32, order 32: 1.7 million modes, GGX of roughness 0.1 to 1",
    naively: "M has 3e12 numbers, A over modes 90 million",
    here: "blocks of |m|; A as products of one-dimensional tables; a space of 33 to 65 polynomials for each",
    measure,
};

fn measure() -> Vec<Figure> {
    let mut loaded = fixtures::scene(fixtures::captured(32), glossy::materials(32));
    loaded.scene.basis.components = Some(100);
    let table = fixtures::table(&loaded);
    vec![
        Figure::exactly("modes", mode::total(32, 32), 1_741_497),
        Figure::exactly("components", table.components.len(), 100),
        Figure::most(
            "|UᵀMU - I| of the first 100",
            basis::orthonormality(&table, 100),
            tolerances::ORTHONORMAL_HIGH,
        ),
    ]
}
