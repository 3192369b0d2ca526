//! The scenes of `firmware/scenes`, from ambient light on a Lambertian material to sun on
//! leather in color, turning: a program for each, of what it calls for and no more.

/// Light from all around on a Lambertian material.
pub mod ambient_lambertian {
    include!(concat!(env!("OUT_DIR"), "/ambient_lambertian.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/ambient_lambertian_q15.rs"));
    }
}

/// Light from all around on velvet.
pub mod ambient_velvet {
    include!(concat!(env!("OUT_DIR"), "/ambient_velvet.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/ambient_velvet_q15.rs"));
    }
}

/// Light to degree 2 on a Lambertian material.
pub mod sky_lambertian {
    include!(concat!(env!("OUT_DIR"), "/sky_lambertian.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/sky_lambertian_q15.rs"));
    }
}

/// Any light on a Lambertian material, to 1e-2.
pub mod park_lambertian {
    include!(concat!(env!("OUT_DIR"), "/park_lambertian.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/park_lambertian_q15.rs"));
    }
}

/// Any light on a Lambertian material, to 1e-3.
pub mod park_lambertian_fine {
    include!(concat!(env!("OUT_DIR"), "/park_lambertian_fine.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/park_lambertian_fine_q15.rs"));
    }
}

/// Any light on plaster without highlights.
pub mod studio_plaster {
    include!(concat!(env!("OUT_DIR"), "/studio_plaster.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/studio_plaster_q15.rs"));
    }
}

/// Any light on velvet.
pub mod studio_velvet {
    include!(concat!(env!("OUT_DIR"), "/studio_velvet.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/studio_velvet_q15.rs"));
    }
}

/// Any light on leather.
pub mod sun_leather {
    include!(concat!(env!("OUT_DIR"), "/sun_leather.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/sun_leather_q15.rs"));
    }
}

/// A scene in f32, with the module `$table`, in so many channels: its pixel, a new light,
/// and a turned light where it `turns`. The material is folded in when it starts.
#[macro_export]
macro_rules! scene_f32 {
    ($table:path, $channels:tt $(, $turns:ident)?) => {
        use $crate::inputs;
        use $table as table;

        board::program!(main);

        const LIGHT: usize = eigenshade::index::light::count(table::DEGREE);
        const MATERIAL: usize = eigenshade::index::material::count(table::ORDER);

        fn main() {
            let material = inputs::numbers::<MATERIAL>();
            let Ok(transfer) = table::transfer(&inputs::material(&material)) else {
                board::exit(false)
            };
            let transfer = core::hint::black_box(transfer);
            let numbers = inputs::numbers::<{ table::COMPONENTS }>();
            let mut d = eigenshade::specialized::coefficients(numbers, &[]);
            let mut scenes = [(); $channels].map(|()| match table::collapse(&d) {
                Ok(scene) => scene,
                Err(_) => board::exit(false),
            });
            board::holds(size_of_val(&transfer) + size_of_val(&d) + size_of_val(&scenes));
            let lights = [[(); $channels].map(|()| inputs::numbers::<LIGHT>())];
            board::measure_named("light", &lights, board::Passes(64), |lights| {
                lights.iter().zip(&mut scenes).try_for_each(|(light, scene)| {
                    let light = eigenshade::Light::new(light)?;
                    table::relight_into(&transfer, &light, &mut d)?;
                    table::collapse_into(&d, core::hint::black_box(scene))
                })
            });
            let scenes = core::hint::black_box(scenes);
            let terms = scenes.each_ref().map(|scene| match table::terms(scene) {
                Some(terms) => terms,
                None => board::exit(false),
            });
            $crate::scene_f32!(@pixel $channels, terms);
            $($crate::scene_f32!(@$turns lights);)?
        }
    };
    // One number, where there is one.
    (@pixel 1, $terms:ident) => {
        let [terms] = $terms;
        board::measure_named("pixel", &inputs::normals(), board::Passes(64), |normal| {
            table::shade_terms(terms, *normal)
        });
    };
    (@pixel $channels:tt, $terms:ident) => {
        board::measure_named("pixel", &inputs::normals(), board::Passes(64), |normal| {
            $terms.map(|terms| table::shade_terms(terms, *normal))
        });
    };
    (@turns $lights:ident) => {
        const ROOM: usize = eigenshade::Light::<f32>::turn_len(table::DEGREE);
        let rotation = eigenshade::Rotation::from_quaternion(core::hint::black_box([0.1, 0.2, 0.3, 1.0]));
        let Ok(rotation) = rotation else { board::exit(false) };
        board::measure_named("turn", &$lights, board::Passes(16), |lights| {
            lights.each_ref().map(|light| {
                let light = eigenshade::Light::new(light)?;
                light.turned::<LIGHT, ROOM>(&rotation)
            })
        });
    };
}

/// The same in Q15; the material was folded in when the program was compiled. A pixel as the
/// nine-term formula with `nine_terms`.
#[macro_export]
macro_rules! scene_q15 {
    ($table:path, $channels:tt $(, $nine_terms:ident)?) => {
        use $crate::integer_inputs as inputs;
        use $table as table;

        board::program!(main);

        const LIGHT: usize = eigenshade::index::light::count(table::DEGREE);

        fn main() {
            let mut d = table::Coefficients::default();
            let mut scenes = [(); $channels].map(|()| table::Scene::default());
            board::holds(size_of_val(&d) + size_of_val(&scenes));
            let lights = [[(); $channels].map(|()| inputs::mantissas::<_, LIGHT>())];
            board::measure_named("light", &lights, board::Passes(64), |lights| {
                lights.iter().zip(&mut scenes).try_for_each(|(light, scene)| {
                    let light = inputs::light(light);
                    table::relight_into(&table::MATERIAL, &light, &mut d)?;
                    table::collapse_into(&d, core::hint::black_box(scene))
                })
            });
            let scenes = core::hint::black_box(scenes);
            $(let scenes = scenes.each_ref().map(|scene| match scene.$nine_terms() {
                Some(formula) => formula,
                None => board::exit(false),
            });)?
            board::measure_named("pixel", &inputs::normals(), board::Passes(256), |normal| {
                scenes.each_ref().map(|scene| {
                    $crate::shade!(@pixel scene, *normal $(, $nine_terms)?)
                })
            });
        }
    };
}
