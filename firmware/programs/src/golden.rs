//! The golden vectors of `tests/golden/sphere.csv`, as statics, and the comparison.

/// A light on a material, and what has to come out. Exponents are those of the integer
/// formats.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S: 'static, A: 'static> {
    /// Coefficients of the light.
    pub light: &'static [S],
    /// Their exponent.
    pub of_light: i32,
    /// Coefficients of the material.
    pub material: &'static [S],
    /// Their exponents.
    pub of_material: &'static [i8],
    /// Coefficients of the image.
    pub d: &'static [A],
    /// Their exponent.
    pub of_d: i32,
    /// Irradiances of the normals.
    pub irradiance: &'static [A],
    /// Their exponent.
    pub of_irradiance: i32,
}

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
    board::say("golden");
    board::say_number(right);
    board::say(" of");
    board::say_number(all);
    board::say("\n");
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
            use eigenshade::quantised::{Light, Material, Normal};
            let light = Light::new(table::DEGREE, pair.of_light, pair.light)?;
            let material = Material::new(table::ORDER, pair.of_material, pair.material)?;
            let d = table::relight(&table::fold(&material)?.view(), &light)?;
            let scene = table::collapse(&d)?;
            let mut check = |holds: bool| {
                *all += 1;
                *right += u32::from(holds);
            };
            check(d.mantissas() == pair.d && d.exponent() == pair.of_d);
            check(scene.exponent() == pair.of_irradiance);
            let (normals, _) = vectors::NORMALS.as_chunks::<3>();
            check(normals.len() == pair.irradiance.len());
            for (&[x, y, z], &expected) in normals.iter().zip(pair.irradiance) {
                let normal = Normal::<$format>::new(x, y, z)?;
                check(table::shade(&scene, normal) == expected && scene.shade(normal) == expected);
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
            use $crate::integer_inputs::Input;
            use eigenshade::quantised::{Light, Material};
            let [pair, ..] = &vectors::PAIRS;
            let light = Light::new(table::DEGREE, pair.of_light, pair.light)?;
            let material = Material::new(table::ORDER, pair.of_material, pair.material)?;
            let d = table::relight(&table::fold(&material)?.view(), &light)?;
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
