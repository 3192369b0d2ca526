//! The items of a table's module besides its numbers.

/// The items of a module that holds the numbers of one table. `eigenshade-table` writes the numbers
/// and the lines that call this macro.
///
/// - `table!(sphere ...)`: constants, types and functions of a table of a sphere. A pass of a
///   transfer is given by its place among the sums, its number and its profiles; a run by its number
///   and its profiles.
/// - `table!(project ...)`, `table!(collapse ...)` and `table!(shade ...)`: functions specialized
///   for the azimuths listed and their profiles.
#[doc(hidden)]
#[macro_export]
macro_rules! table {
    (sphere passes $([$number:tt $pass:literal $profiles:literal])*
        runs $([$run:literal $rows:literal])*) => {
        $crate::table!(@items);
        /// The basis; its shape was checked when it was compiled.
        pub static BASIS: $crate::Basis<'static> =
            $crate::specialized::checked($crate::Basis::new(PARTS));
        /// The transfer of a material: see [`eigenshade::Basis::transfer`]. The same errors, but no
        /// capacity is too small.
        pub fn transfer(material: &$crate::Material<'_>) -> Result<Transfer, $crate::Error> {
            BASIS.transfer::<WORKSPACE, TRANSFER>(material)
        }
        /// An estimate of the coefficients d from pixels.
        pub type Estimate = $crate::Estimate<'static, COMPONENTS>;
        /// Starts an estimate from pixels: see [`eigenshade::Basis::estimate`].
        #[must_use]
        pub fn estimate() -> Estimate {
            Estimate::of_table(BASIS)
        }
        /// The scene of some coefficients with as few terms as a tolerance allows: see
        /// [`eigenshade::Basis::collapse_within`]. `lengths` receives the lengths of its
        /// polynomials.
        ///
        /// # Errors
        ///
        /// [`Error::Tolerance`](eigenshade::Error::Tolerance) unless the tolerance is above zero.
        pub fn collapse_within<'l>(
            coefficients: &Coefficients,
            tolerance: $crate::truncation::Tolerance,
            lengths: &'l mut [u16; DEGREE + 1],
        ) -> Result<(Truncated<'l>, $crate::truncation::Truncation), $crate::Error> {
            let buffer = $crate::Buffer::from([0.0; SCENE]);
            BASIS.collapse_within(coefficients, tolerance, lengths, buffer)
        }
        /// A scene with fewer terms than a [`Scene`].
        pub type Truncated<'l> = $crate::Scene<'l, $crate::Buffer<f32, SCENE>>;
        /// A new light on a transferred material: see `relight` of [`BASIS`]. The same errors, but
        /// no capacity is too small.
        pub fn relight(
            transfer: &Transfer,
            light: &$crate::Light<'_>,
        ) -> Result<Coefficients, $crate::Error> {
            // An array: a buffer that a call has written is copied once more.
            let mut d = [0.0; COMPONENTS];
            relight_array(transfer, light, &mut d)?;
            Ok(d.into())
        }
        /// [`relight`] into existing coefficients, unmoved; after an error they are unspecified.
        pub fn relight_into(
            transfer: &Transfer,
            light: &$crate::Light<'_>,
            coefficients: &mut Coefficients,
        ) -> Result<(), $crate::Error> {
            relight_array(transfer, light, $crate::specialized::coefficients(coefficients)?)
        }
        #[inline(always)]
        fn relight_array(
            transfer: &Transfer,
            light: &$crate::Light<'_>,
            d: &mut [f32; COMPONENTS],
        ) -> Result<(), $crate::Error> {
            use $crate::specialized as inputs;
            inputs::accept_light(DEGREE, light)?;
            let transfer = inputs::transfer_numbers(transfer)?;
            inputs::whole(light.coefficients(), |light| {
                if inputs::relight::GROUPS {
                    relight_passes(transfer, light, d);
                } else {
                    relight_runs(transfer, light, d);
                }
            });
            Ok(())
        }
        /// Relights pass by pass. Inlined: the components are stored where the caller has them.
        #[inline(always)]
        fn relight_passes(
            transfer: &[f32; TRANSFER],
            light: &[f32; LIGHT],
            d: &mut [f32; COMPONENTS],
        ) {
            use $crate::specialized::relight;
            // All sums first: between the calls, components would be spilled one by one.
            let sums = ($(
                relight::sums::<This, $pass, $profiles, TRANSFER, LIGHT>(transfer, light),
            )*);
            $(relight::write::<This, $pass, $profiles, COMPONENTS>(&sums.$number, d);)*
        }
        /// Relights run by run.
        #[inline(never)]
        fn relight_runs(
            transfer: &[f32; TRANSFER],
            light: &[f32; LIGHT],
            d: &mut [f32; COMPONENTS],
        ) {
            use $crate::specialized::relight;
            $(relight::run::<This, $run, $rows, TRANSFER, LIGHT, COMPONENTS>(
                transfer, light, d,
            );)*
        }
    };
    (project scatter $([$q:literal $pairs:literal])*
        $(azimuth $azimuth:literal $([$first:literal $twos:literal])*)*) => {
        /// d = UᵀMc: see `project` of [`BASIS`]. The same errors, but no capacity is too small.
        pub fn project(
            light: &$crate::Light<'_>,
            material: &$crate::Material<'_>,
        ) -> Result<Coefficients, $crate::Error> {
            use $crate::specialized as inputs;
            inputs::accept_light(DEGREE, light)?;
            inputs::accept_material(ORDER, material)?;
            let mut d = [0.0; COMPONENTS];
            inputs::whole(material.coefficients(), |material| {
                inputs::whole(light.coefficients(), |light| project_whole(light, material, &mut d));
            });
            Ok(d.into())
        }
        const MODES: usize = $crate::specialized::material::count(ORDER);
        /// Projects a light and a material of this table's degree and order. Not inlined: the
        /// components would be copied one by one.
        #[inline(never)]
        fn project_whole(
            light: &[f32; LIGHT],
            material: &[f32; MODES],
            d: &mut [f32; COMPONENTS],
        ) {
            use $crate::specialized::{layout, pair};
            use $crate::specialized::project;
            const LANES: usize = layout::LANES;
            const PAIRS: usize = pair::count(ORDER);
            const PADDED: usize = layout::row(ORDER);
            const GROUPS: usize = layout::groups(DEGREE);
            let polar = project::table_rows::<GROUPS, PAIRS>(PARTS.polar);
            let Some(polar) = polar else { return };
            let mut sums = [[[0.0; LANES]; GROUPS]; PADDED];
            $(project::scatter::<$q, $pairs, GROUPS, MODES, PAIRS>(
                material, polar, &mut sums,
            );)*
            let scattering = project::transposed::<
                { PADDED / LANES }, { DEGREE + 1 }, GROUPS, PADDED,
            >(&sums);
            $(
                let lights =
                    project::lights::<$azimuth, { DEGREE + 1 - $azimuth }, LIGHT>(light);
                $(
                    let rows = project::rows::<
                        This, $azimuth, $first, $twos, { PADDED / LANES },
                        { DEGREE + 1 - $azimuth }, { DEGREE + 1 },
                    >(&scattering, &lights);
                    project::write::<This, $azimuth, $first, $twos, COMPONENTS>(&rows, d);
                )*
            )*
        }
    };
    (collapse $([$azimuth:literal $profiles:literal])*) => {
        /// Sums the components of each azimuth: see `collapse` of [`BASIS`].
        #[must_use]
        pub fn collapse(coefficients: &Coefficients) -> Scene {
            let mut scene = Scene::default();
            collapse_into(coefficients, &mut scene);
            scene
        }
        /// [`collapse`] into an existing scene, without moving it.
        #[inline]
        pub fn collapse_into(coefficients: &Coefficients, scene: &mut Scene) {
            use $crate::specialized as kernels;
            let terms = kernels::terms_mut(&mut scene.0);
            kernels::whole(coefficients, |d: &[f32; COMPONENTS]| {
                $(kernels::collapse::<This, $azimuth, $profiles, COMPONENTS, SCENE>(d, terms);)*
            });
        }
    };
    (shade $($azimuth:literal)*) => {
        impl Scene {
            /// The irradiance of one normal: see [`eigenshade::Scene::shade`], with every
            /// length a constant.
            #[inline]
            #[must_use]
            pub fn shade(&self, normal: $crate::Normal) -> f32 {
                shade_terms(self.terms(), normal)
            }
        }
        /// The irradiance of one normal from a scene's terms, bit for bit as [`Scene::shade`], for
        /// bindings that store the terms alone.
        #[doc(hidden)]
        #[inline]
        #[must_use]
        pub fn shade_terms(terms: &[f32; SCENE], normal: $crate::Normal) -> f32 {
            let axes = normal.components().map(|axis| [axis]);
            let pixel = $crate::specialized::Block::new(axes.each_ref());
            let above = None;
            $(let above =
                $crate::specialized::azimuth::<This, $azimuth, SCENE>(terms, &pixel, above);)*
            $crate::specialized::pole::<This, SCENE>(terms, &pixel, above)
        }
        /// The irradiances of a normal and its mirror images.
        #[inline(always)]
        fn mirrored(scene: &Scene, mirrored: &$crate::specialized::Mirrored) -> [f32; 4] {
            mirrored_terms(scene.terms(), mirrored)
        }
        /// The irradiances of a normal and its mirror images from a scene's terms, as
        /// [`shade_terms`].
        #[doc(hidden)]
        #[inline(always)]
        #[must_use]
        pub fn mirrored_terms(
            terms: &[f32; SCENE],
            mirrored: &$crate::specialized::Mirrored,
        ) -> [f32; 4] {
            let sums = mirrored.pole::<This, SCENE>(terms);
            $(let sums = mirrored.azimuth::<This, $azimuth, SCENE>(terms, sums);)*
            $crate::specialized::Mirrored::images(sums)
        }
    };
    (@items) => {
        $crate::table_items! {
            basis $crate::Basis<'static> = BASIS,
            components PARTS.components, workspace BASIS.workspace_len(),
            scene $crate::Scene<'static, [f32; SCENE]>
        }
        /// Number of coefficients of a light.
        pub const LIGHT: usize = (DEGREE + 1) * (DEGREE + 1);
        /// The coefficients d of one image.
        pub type Coefficients = $crate::Coefficients<COMPONENTS>;
        /// The transfer of one material.
        pub type Transfer = $crate::Transfer<TRANSFER>;
        impl Scene {
            /// The polynomials' terms, azimuth by azimuth.
            #[doc(hidden)]
            #[inline(always)]
            #[must_use]
            pub fn terms(&self) -> &[f32; SCENE] {
                $crate::specialized::terms(&self.0)
            }
        }
        impl Default for Scene {
            /// A black image, to be overwritten.
            #[inline(always)]
            fn default() -> Self {
                Self($crate::specialized::blank_scene(PARTS.lengths))
            }
        }
        $crate::table_in_color! {
            'a, light $crate::Light<'a>, material $crate::Material<'a>,
            normal $crate::Normal, mirrored $crate::specialized::Mirrored, irradiance f32,
            blank Coefficients::from([0.0; super::COMPONENTS]),
            view |transfer| transfer
        }
        impl color::Scene {
            /// The exposure that multiplies the irradiances of [`shade`](Self::shade) by a factor,
            /// the same for every scene; errors as [`eigenshade::screen::Exposure::new`]. A
            /// [`Meter`](eigenshade::screen::Meter) finds the factor.
            pub fn exposure_by_factor(
                &self,
                factor: f32,
            ) -> Result<$crate::screen::Exposure, $crate::Error> {
                $crate::screen::Exposure::new(factor)
            }

            /// Bakes the scene into `size` x `size` texels, at most `T`: see
            /// [`eigenshade::Scene::bake`]; the same errors.
            pub fn bake<const T: usize>(
                &self,
                size: usize,
            ) -> Result<$crate::Rgb<$crate::object::BakedMap<$crate::Buffer<f32, T>>>, $crate::Error>
            {
                self.each_ref().try_map(|scene| scene.bake(size))
            }

            /// Bakes the scene into `size` x `size` integers: see
            /// [`eigenshade::Scene::bake_integers_into`]; the same errors.
            pub fn bake_integers_into<B: AsMut<[i16]>>(
                &self,
                size: usize,
                texels: $crate::Rgb<B>,
            ) -> Result<$crate::Rgb<$crate::q15::BakedMap<B>>, $crate::Error> {
                let channels = self.each_ref().zip(texels);
                channels.try_map(|(scene, texels)| scene.bake_integers_into(size, texels))
            }

            /// The irradiance of each normal in each channel; errors as
            /// [`eigenshade::Rgb::shade_slice`].
            // Inlined: the crate that calls it chooses between speed and size.
            #[inline]
            pub fn shade_slice(
                &self,
                normals: $crate::Normals<'_>,
                irradiance: &mut [$crate::Rgb<f32>],
            ) -> Result<(), $crate::Error> {
                use $crate::specialized::{ONE_BY_ONE, shade_normals};
                if ONE_BY_ONE {
                    return shade_normals(normals, irradiance, |normal| self.shade(normal));
                }
                self.each_ref().map(|scene| &**scene).shade_slice(normals, irradiance)
            }
        }
    };
}
