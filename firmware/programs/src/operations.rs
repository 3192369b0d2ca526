//! The measured operations in integers, once for each format: a table's modules in two
//! formats share names, not types.

/// A pixel of a scene of the module `$table`, as the nine-term formula with `nine_terms`.
#[macro_export]
macro_rules! shade {
    ($table:path $(, $nine_terms:ident)?) => {
        use $table as table;

        board::program!(main);

        fn main() {
            let mantissas = [0; table::COMPONENTS].map(|_: i32| core::hint::black_box(123_456_789));
            let Ok(scene) = table::BASIS.collapse::<{ table::SCENE }>(&mantissas, -30) else {
                board::exit(false)
            };
            let scene = core::hint::black_box(scene);
            board::holds(size_of_val(&scene));
            $(let Some(scene) = scene.$nine_terms() else { board::exit(false) };)?
            board::measure(&$crate::integer_inputs::normals(), board::Passes(256), |normal| {
                $crate::shade!(@pixel &scene, *normal $(, $nine_terms)?)
            });
        }
    };
    (@pixel $scene:expr, $normal:expr) => {
        table::shade($scene, $normal)
    };
    (@pixel $scene:expr, $normal:expr, nine_terms) => {
        $scene.shade($normal)
    };
}

/// A new light on a fixed material, with the module `$table`; up to the scene with
/// `collapse_into`.
#[macro_export]
macro_rules! relight {
    ($table:path $(, $collapse_into:ident)?) => {
        use $crate::integer_inputs as inputs;
        use $table as table;

        board::program!(main);

        fn main() {
            let material = inputs::mantissas::<_, 40>();
            let Ok(transfer) = table::transfer(&inputs::material(&material, table::ORDER)) else {
                board::exit(false)
            };
            let transfer = core::hint::black_box(transfer);
            let mut d = table::Coefficients::default();
            // Not linked where it is not used.
            let mut scene = table::Scene::default();
            let of_scene = [$(stringify!($collapse_into))?].map(|_: &str| size_of_val(&scene));
            board::holds(of_scene.into_iter().sum());
            board::holds(size_of_val(&transfer) + size_of_val(&d));
            board::measure(&[inputs::mantissas::<_, 100>()], board::Passes(64), |light| {
                let light = inputs::light(light);
                let done =
                    table::relight_into(&transfer.view(), &light, core::hint::black_box(&mut d));
                let _ = &mut scene;
                $(let done = done.and_then(|()| {
                    table::$collapse_into(&d, core::hint::black_box(&mut scene))
                });)?
                done
            });
        }
    };
}

/// The coefficients of an image to its scene, with the module `$table`.
#[macro_export]
macro_rules! collapse {
    ($table:path) => {
        use $crate::integer_inputs as inputs;
        use $table as table;

        board::program!(main);

        fn main() {
            let material = inputs::mantissas::<_, 40>();
            let light = inputs::mantissas::<_, 100>();
            let light = inputs::light(&light);
            let relit = table::transfer(&inputs::material(&material, table::ORDER))
                .and_then(|transfer| table::relight(&transfer.view(), &light));
            let Ok(relit) = relit else { board::exit(false) };
            let mut scene = table::Scene::default();
            board::holds(size_of_val(&relit) + size_of_val(&scene));
            board::measure(&[relit], board::Passes(64), |relit| {
                table::collapse_into(relit, core::hint::black_box(&mut scene))
            });
        }
    };
}

/// A new material, folded into the basis of the module `$table`.
#[macro_export]
macro_rules! transfer {
    ($table:path) => {
        use $crate::integer_inputs as inputs;
        use $table as table;

        board::program!(main);

        fn main() {
            let mut transfer = table::Transfer::default();
            board::holds(size_of_val(&transfer));
            board::measure(&[inputs::mantissas::<_, 40>()], board::Passes(16), |material| {
                let material = inputs::material(material, table::ORDER);
                table::transfer_into(&material, core::hint::black_box(&mut transfer))
            });
        }
    };
}
