//! The items of an integer table's module besides its numbers.

/// The items of a module that holds the numbers of one table in Q15.
/// `eigenshade-table` writes the numbers and the lines that call this macro.
///
/// - `integer_table!(basis)`: constants, types and the basis.
/// - `integer_table!(transfer ...)` and so on: functions, specialized for these pairs (p, q),
///   azimuths and numbers of profiles, or `by basis`.
#[doc(hidden)]
#[macro_export]
macro_rules! integer_table {
    (basis) => {
        $crate::table_items! {
            basis $crate::q15::Basis<'static> = BASIS,
            components PARTS.components, workspace BASIS.workspace_len(),
            scene $crate::q15::Scene<'static, [i32; SCENE]>
        }
        /// Number of slant profiles.
        pub const PROFILES: usize = BASIS.profiles();
        /// The basis; its shape and its bounds were checked when it was compiled.
        pub static BASIS: $crate::q15::Basis<'static> =
            $crate::specialized::checked($crate::q15::Basis::new(PARTS));
        /// The coefficients d of one image.
        pub type Coefficients = $crate::q15::Coefficients<COMPONENTS>;
        /// The transfer of one material.
        pub type Transfer =
            $crate::q15::TransferBuffer<TRANSFER, PROFILES>;
        /// An estimate of the coefficients d from pixels.
        pub type Estimate = $crate::q15::Estimate<'static, COMPONENTS>;
        /// Starts an estimate from pixels: see [`eigenshade::q15::Basis::estimate`].
        #[must_use]
        pub fn estimate() -> Estimate {
            Estimate::of_table(BASIS)
        }
        $crate::table_in_color! {
            'a, light $crate::q15::Light<'a>,
            material $crate::q15::Material<'a>,
            normal $crate::q15::Normal, mirrored $crate::q15::kernels::Mirrored,
            irradiance i32,
            blank Coefficients::default(),
            view |transfer| &transfer.view()
        }
        impl Default for Scene {
            /// A black image, to be overwritten.
            #[inline(always)]
            fn default() -> Self {
                Self($crate::q15::kernels::blank_scene(&BASIS))
            }
        }
        impl color::Scene {
            /// The exposure that multiplies the irradiances of the mantissas of
            /// [`shade`](Self::shade) by a factor, channel by channel. A
            /// [`Meter`](eigenshade::screen::Meter) finds the factor.
            ///
            /// # Errors
            ///
            /// As [`eigenshade::q15::Exposure::new`].
            pub fn exposure_by_factor(
                &self,
                factor: f32,
            ) -> Result<$crate::Rgb<$crate::q15::Exposure>, $crate::Error> {
                self.each_ref().try_map(|scene| {
                    $crate::q15::Exposure::new(factor, scene.exponent())
                })
            }

            /// The mantissas that [`shade`](Self::shade) gives for each normal in each channel, for
            /// engines that interpolate between the vertices of a mesh.
            ///
            /// # Errors
            ///
            /// [`Error::Length`](eigenshade::Error::Length) unless `irradiance` and `normals` have
            /// the same length.
            #[inline]
            pub fn shade_slice(
                &self,
                normals: &[$crate::q15::Normal],
                irradiance: &mut [$crate::Rgb<i32>],
            ) -> Result<(), $crate::Error> {
                $crate::specialized::shade_each(normals, irradiance, |normal| self.shade(normal))
            }
        }
    };
    (transfer scatter $([$p:literal $q:literal $($o:literal)*])*
        azimuths $($azimuth:literal)*) => {
        $crate::integer_table!(@transfer |material, transfer| {
            use $crate::q15::kernels;
            kernels::accept_material(ORDER, material)?;
            let (numbers, exponents) = kernels::transfer_numbers(transfer)?;
            let orders = kernels::Orders::<ORDERS>::of(material);
            let mut b = [0; MODES];
            $crate::specialized::whole(material.mantissas(), |mantissas| {
                b = kernels::weighted_coefficients(mantissas);
            });
            let (mut sums, mut of_sums) = ([[0; PAIRS]; DEGREES], [0; DEGREES]);
            for (l, (sums, exponent)) in sums.iter_mut().zip(&mut of_sums).enumerate() {
                let degree = kernels::Degree::new::<This>(l, &orders);
                let Some(degree) = &degree else { continue };
                scatter(degree, &b, sums);
                *exponent = degree.normalize(sums);
            }
            $(kernels::transfer_azimuth::<
                This, $azimuth, { DEGREES - $azimuth }, PAIRS, DEGREES,
                TRANSFER, PROFILES,
            >(&sums, &of_sums, (&mut *numbers, &mut *exponents));)*
            Ok(())
        });
        /// The sums S of one degree.
        #[inline(never)]
        fn scatter(
            degree: &$crate::q15::kernels::Degree<PAIRS, ORDERS>,
            b: &[i32; MODES],
            sums: &mut [i32; PAIRS],
        ) {
            $(
                let sum = 0;
                $(let sum = degree.add::<$p, $q, $o, MODES>(sum, b);)*
                if let Some(to) = sums.get_mut($crate::specialized::pair::position($p, $q)) {
                    *to = sum;
                }
            )*
        }
        const DEGREES: usize = DEGREE + 1;
        const ORDERS: usize = ORDER + 1;
        const PAIRS: usize = $crate::specialized::pair::count(ORDER);
        const MODES: usize = $crate::specialized::material::count(ORDER);
    };
    (transfer by basis) => {
        $crate::integer_table!(@transfer |material, transfer| {
            *transfer = BASIS.transfer::<WORKSPACE, TRANSFER, PROFILES>(material)?;
            Ok(())
        });
    };
    (@transfer |$material:ident, $transfer:ident| $into:block) => {
        /// The transfer of a material: see [`eigenshade::q15::Basis::transfer`].
        ///
        /// # Errors
        ///
        /// The same, except that no capacity can be too small.
        pub fn transfer(
            material: &$crate::q15::Material<'_>,
        ) -> Result<Transfer, $crate::Error> {
            let mut transfer = Transfer::default();
            transfer_into(material, &mut transfer)?;
            Ok(transfer)
        }
        /// [`transfer`] into an existing transfer, without moving it.
        ///
        /// # Errors
        ///
        /// As [`transfer`]; `transfer` is then left unspecified.
        pub fn transfer_into(
            $material: &$crate::q15::Material<'_>,
            $transfer: &mut Transfer,
        ) -> Result<(), $crate::Error> $into
    };
    (relight $($azimuth:literal)*) => {
        /// A new light on a transferred material: see [`eigenshade::q15::Basis::relight`].
        ///
        /// # Errors
        ///
        /// The same, except that no capacity can be too small.
        pub fn relight(
            transfer: &$crate::q15::Transfer<'_>,
            light: &$crate::q15::Light<'_>,
        ) -> Result<Coefficients, $crate::Error> {
            let mut coefficients = Coefficients::default();
            relight_into(transfer, light, &mut coefficients)?;
            Ok(coefficients)
        }
        /// [`relight`] into existing coefficients, without moving them.
        ///
        /// # Errors
        ///
        /// As [`relight`]; `coefficients` is then left unspecified.
        pub fn relight_into(
            transfer: &$crate::q15::Transfer<'_>,
            light: &$crate::q15::Light<'_>,
            coefficients: &mut Coefficients,
        ) -> Result<(), $crate::Error> {
            use $crate::q15::kernels;
            const LIGHT: usize = (DEGREE + 1) * (DEGREE + 1);
            let (numbers, exponents) =
                kernels::inputs::<TRANSFER, PROFILES>(&BASIS, transfer, light)?;
            let (d, exponent) = kernels::coefficients(coefficients)?;
            let mut top = kernels::NONE;
            $crate::specialized::whole(light.mantissas(), |mantissas: &[_; LIGHT]| {
                let inputs = (numbers, exponents, mantissas);
                $(top = kernels::relight_azimuth::<
                    This, $azimuth, TRANSFER, PROFILES, LIGHT, COMPONENTS,
                >(inputs, d, top);)*
            });
            let common = kernels::common(top);
            $(kernels::align::<This, $azimuth, PROFILES, COMPONENTS>(exponents, common, d);)*
            *exponent = kernels::exponent(common, light.exponent());
            Ok(())
        }
    };
    (collapse $([$azimuth:literal $profiles:literal])*) => {
        $crate::integer_table!(@collapse |coefficients, scene| {
            use $crate::q15::kernels;
            const AZIMUTHS: usize = kernels::azimuths(&BASIS);
            if let Some(d) = kernels::mantissas(coefficients) {
                let terms = kernels::terms_mut(&mut scene.0);
                let size = kernels::Size::<AZIMUTHS>::empty()
                    $(.azimuth::<This, $azimuth, COMPONENTS>(d))*;
                if let Some(shifts) = size.shifts::<This>() {
                    $(kernels::collapse_azimuth::<
                        This, $azimuth, $profiles, AZIMUTHS, COMPONENTS, SCENE,
                    >(d, &shifts, terms);)*
                    kernels::finish(coefficients, &shifts, &mut scene.0);
                    return;
                }
            }
            collapse_generally(coefficients, scene);
        });
        $crate::integer_table!(@collapse_generally #[cold]);
    };
    (collapse by basis) => {
        $crate::integer_table!(@collapse |coefficients, scene| {
            collapse_generally(coefficients, scene);
        });
        $crate::integer_table!(@collapse_generally);
    };
    (@collapse_generally $(#[$cold:ident])?) => {
        $(#[$cold])?
        #[inline(never)]
        fn collapse_generally(coefficients: &Coefficients, scene: &mut Scene) {
            let (mantissas, exponent) = (coefficients.mantissas(), coefficients.exponent());
            // No length can be wrong: all are this table's. Nor can the exponent of coefficients.
            if let Ok(collapsed) = BASIS.collapse_into(mantissas, exponent, [0; SCENE]) {
                *scene = Scene(collapsed);
            }
        }
    };
    (@collapse |$coefficients:ident, $scene:ident| $into:block) => {
        /// Sums the components of each azimuth: see [`eigenshade::q15::Basis::collapse`].
        #[must_use]
        pub fn collapse(coefficients: &Coefficients) -> Scene {
            let mut scene = Scene::default();
            collapse_into(coefficients, &mut scene);
            scene
        }
        /// [`collapse`] into an existing scene, without moving it.
        pub fn collapse_into($coefficients: &Coefficients, $scene: &mut Scene) $into
    };
    (shade $($azimuth:literal)*) => {
        impl Scene {
            /// The irradiance of one normal, times 2 to the power of the scene's negative
            /// [`exponent`](eigenshade::q15::Scene::exponent): bit for bit as
            /// [`eigenshade::q15::Scene::shade`], with every length a constant.
            #[inline]
            #[must_use]
            pub fn shade(&self, normal: $crate::q15::Normal) -> i32 {
                shade_terms($crate::q15::kernels::terms(&self.0), normal)
            }
            /// [`shade`](Self::shade) for many normals.
            ///
            /// # Errors
            ///
            /// [`Error::Length`](eigenshade::Error::Length) unless `irradiance` and `normals` have
            /// the same length.
            #[inline]
            pub fn shade_slice(
                &self,
                normals: &[$crate::q15::Normal],
                irradiance: &mut [i32],
            ) -> Result<(), $crate::Error> {
                $crate::specialized::shade_each(normals, irradiance, |normal| self.shade(normal))
            }
        }
        /// The irradiance of one normal from a scene's terms, bit for bit as [`Scene::shade`], for
        /// bindings that store the terms alone.
        #[doc(hidden)]
        #[inline]
        #[must_use]
        pub fn shade_terms(terms: &[i32; SCENE], normal: $crate::q15::Normal) -> i32 {
            $crate::q15::kernels::Pixel::start::<This, SCENE>(terms, normal)
                $(.azimuth::<This, $azimuth, SCENE>(terms))*
                .irradiance()
        }
        /// The irradiances of a normal and its mirror images.
        #[inline(always)]
        fn mirrored(scene: &Scene, mirrored: &$crate::q15::kernels::Mirrored) -> [i32; 4] {
            mirrored_terms($crate::q15::kernels::terms(&scene.0), mirrored)
        }
        /// The irradiances of a normal and its mirror images from a scene's terms, as
        /// [`shade_terms`].
        #[doc(hidden)]
        #[inline(always)]
        #[must_use]
        pub fn mirrored_terms(
            terms: &[i32; SCENE],
            mirrored: &$crate::q15::kernels::Mirrored,
        ) -> [i32; 4] {
            let sums = mirrored.pole::<This, SCENE>(terms);
            $(let sums = mirrored.azimuth::<This, $azimuth, SCENE>(terms, sums);)*
            $crate::q15::kernels::Mirrored::images(sums)
        }
    };
}
