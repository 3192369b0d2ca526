//! The tables of `firmware/tables/ladder.csv`, from few components to many, and a program for
//! each in Q15: a pixel and a new light, any material folded in when it starts. Those in f32
//! are [`scene_f32`](crate::scene_f32)'s.

macro_rules! table {
    ($(#[$what:meta])* $name:ident) => {
        $(#[$what])*
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));

            /// In mantissas of 15 bits.
            pub mod q15 {
                include!(concat!(env!("OUT_DIR"), "/", stringify!($name), "_q15.rs"));
            }
        }
    };
}

table! {
    /// 9 components to 1e-1.
    first_9
}
table! {
    /// 25 components to 3e-2.
    first_25
}
table! {
    /// 50 components to 1e-2.
    first_50
}
table! {
    /// 100 components to 1e-2.
    first_100
}
table! {
    /// 130 components to 1e-3.
    first_130
}
table! {
    /// The shipped table, not trimmed.
    shipped
}

/// A table in Q15, the module `$table`: its pixel, and a new light on a folded material up to
/// the scene.
#[macro_export]
macro_rules! rung_q15 {
    ($table:path) => {
        use $crate::integer_inputs as inputs;
        use $table as table;

        board::program!(main);

        const LIGHT: usize = eigenshade::index::light::count(table::DEGREE);
        const MATERIAL: usize = eigenshade::index::material::count(table::ORDER);

        fn main() {
            let material = inputs::mantissas::<_, MATERIAL>();
            let Ok(transfer) = table::transfer(&inputs::material(&material, table::ORDER)) else {
                board::exit(false)
            };
            let transfer = core::hint::black_box(transfer);
            let mut d = table::Coefficients::default();
            let mut scene = table::Scene::default();
            board::holds(size_of_val(&transfer) + size_of_val(&d) + size_of_val(&scene));
            let lights = [inputs::mantissas::<_, LIGHT>()];
            board::measure_named("light", &lights, board::Passes(64), |light| {
                let light = inputs::light(light);
                table::relight_into(&transfer.view(), &light, &mut d)?;
                table::collapse_into(&d, core::hint::black_box(&mut scene))
            });
            let scene = core::hint::black_box(scene);
            board::measure_named("pixel", &inputs::normals(), board::Passes(256), |normal| {
                table::shade(&scene, *normal)
            });
        }
    };
}
