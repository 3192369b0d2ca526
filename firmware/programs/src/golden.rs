//! The golden vectors of `tests/golden/sphere.csv`, as statics, and the comparison.

/// A light on a material, and what has to come out. Exponents are those of the integer
/// formats.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S: 'static, A: 'static> {
    /// Coefficients of the light, and their exponent.
    pub light: &'static Light<S>,
    /// Coefficients of the material, and their exponents.
    pub material: &'static Material<S>,
    /// Coefficients of the image, and their exponent.
    pub d: (&'static [A], i32),
    /// Irradiances of the normals, and their exponent.
    pub irradiance: (&'static [A], i32),
}

/// Coefficients of a light, and their exponent.
pub type Light<S> = (&'static [S], i32);
/// Coefficients of a material, and the exponents of each o.
pub type Material<S> = (&'static [S], &'static [i8]);

/// In f32.
#[expect(missing_docs, reason = "generated: normals, pairs and the tolerance")]
pub mod f32 {
    include!(concat!(env!("OUT_DIR"), "/golden_f32.rs"));
}

/// In mantissas of 15 bits.
#[expect(missing_docs, reason = "generated: normals and pairs")]
pub mod q15 {
    include!(concat!(env!("OUT_DIR"), "/golden_q15.rs"));
}

/// In mantissas of 31 bits.
#[expect(missing_docs, reason = "generated: normals and pairs")]
pub mod q31 {
    include!(concat!(env!("OUT_DIR"), "/golden_q31.rs"));
}

/// Says how many answers are right, and ends the program if one is not.
pub fn report(right: u32, all: u32) {
    board::print("golden");
    board::print_u32(right);
    board::print(" of");
    board::print_u32(all);
    board::print("\n");
    if right != all {
        board::exit(false);
    }
}

/// The golden vectors in an integer format, bit for bit, by the module `$table`.
#[macro_export]
macro_rules! golden {
    ($table:path, $vectors:path, $format:path) => {
        use $table as table;
        use $vectors as vectors;

        board::program!(main);

        fn main() {
            let (mut right, mut all) = (0, 0);
            for pair in &vectors::PAIRS {
                if compare(pair, &mut right, &mut all).is_err() {
                    board::exit(false);
                }
            }
            $crate::golden::report(right, all);
        }

        fn compare(
            pair: &$crate::golden::Pair<$format, i32>,
            right: &mut u32,
            all: &mut u32,
        ) -> Result<(), eigenshade::Error> {
            use eigenshade::quantized::{Light, Material, Normal};
            let light = Light::new(pair.light.1, pair.light.0)?;
            let material = Material::new(pair.material.1, pair.material.0)?;
            let d = table::relight(&table::transfer(&material)?.view(), &light)?;
            let scene = table::collapse(&d)?;
            let mut check = |holds: bool| {
                *all += 1;
                *right += u32::from(holds);
            };
            let (irradiances, exponent) = pair.irradiance;
            check((d.mantissas(), d.exponent()) == pair.d);
            check(scene.exponent() == exponent);
            let (normals, _) = vectors::NORMALS.as_chunks::<3>();
            check(normals.len() == irradiances.len());
            for (&[x, y, z], &expected) in normals.iter().zip(irradiances) {
                let normal = Normal::<$format>::new(x, y, z)?;
                check(scene.shade(normal) == expected && (*scene).shade(normal) == expected);
            }
            Ok(())
        }
    };
}

/// A sphere drawn as text, in an integer format, by the module `$table`.
#[macro_export]
macro_rules! sphere {
    ($table:path, $vectors:path, $format:path) => {
        use $table as table;
        use $vectors as vectors;

        board::program!(main);

        fn main() {
            if draw().is_err() {
                board::exit(false);
            }
        }

        fn draw() -> Result<(), eigenshade::Error> {
            use eigenshade::quantized::{Light, Material};
            use $crate::integer_inputs::Input;
            let [pair, ..] = &vectors::PAIRS;
            let light = Light::new(pair.light.1, pair.light.0)?;
            let material = Material::new(pair.material.1, pair.material.0)?;
            let d = table::relight(&table::transfer(&material)?.view(), &light)?;
            let scene = table::collapse(&d)?;
            $crate::drawing::draw(|x, y, z| {
                let [x, y, z] = [x, y, z].map(<$format as Input>::of);
                let normal = <$format as Input>::normal(x, y, z)?;
                Some(table::shade(&scene, normal))
            });
            Ok(())
        }
    };
}
