//! What an integer table's module consists of besides its numbers.

/// The items of a module that holds the numbers of one table in an integer format.
/// `eigenshade-table` writes the numbers and the lines that call this macro.
///
/// - `integer_table!(Q15)`: constants, types and the basis.
/// - `integer_table!(Q15 transfer ...)` and so on: functions, specialized for these pairs (p, q),
///   azimuths and numbers of profiles, or `by basis`.
#[doc(hidden)]
#[macro_export]
macro_rules! integer_table {
    ($format:ident) => {
        $crate::table_items! {
            basis $crate::quantized::Basis<'static, $crate::$format> = BASIS,
            components PARTS.components, workspace BASIS.workspace_len(),
            scene $crate::quantized::Scene<
                'static, $crate::$format, $crate::quantized::SceneBuffer<SCENE>,
            >,
            derive Clone, Default
        }
        /// Number of slant profiles.
        pub const PROFILES: usize = BASIS.profiles();
        /// The basis; its shape and its bounds were checked when it was compiled.
        pub static BASIS: $crate::quantized::Basis<'static, $crate::$format> =
            $crate::specialized::checked($crate::quantized::Basis::<$crate::$format>::new(PARTS));
        /// The coefficients d of one image.
        pub type Coefficients = $crate::quantized::Coefficients<COMPONENTS>;
        /// The transfer of one material.
        pub type Transfer =
            $crate::quantized::TransferBuffer<$crate::$format, TRANSFER, PROFILES>;
        /// An estimate of the coefficients d from pixels.
        pub type Estimate = $crate::quantized::Estimate<'static, $crate::$format, COMPONENTS>;
        /// Starts an estimate from pixels: see [`eigenshade::quantized::Basis::estimate`].
        ///
        /// # Errors
        ///
        /// Never: the capacity is that of this table.
        pub fn estimate() -> Result<Estimate, $crate::Error> {
            BASIS.estimate()
        }
        $crate::table_in_color! {
            'a, light $crate::quantized::Light<'a, $crate::$format>,
            material $crate::quantized::Material<'a, $crate::$format>,
            normal $crate::quantized::Normal<$crate::$format>, irradiance i32,
            blank Coefficients::default(), Scene::default(),
            view |transfer| &transfer.view()
        }
        impl color::Scene {
            /// What multiplies the irradiances of the mantissas of [`shade`](Self::shade) by a
            /// factor, channel by channel. A [`Meter`](eigenshade::Meter) finds the factor.
            ///
            /// # Errors
            ///
            /// Those of [`eigenshade::quantized::Exposure::new`].
            pub fn exposure_by_factor(
                &self,
                factor: f32,
            ) -> Result<$crate::Rgb<$crate::quantized::Exposure>, $crate::Error> {
                self.each_ref().try_map(|scene| {
                    $crate::quantized::Exposure::new(factor, scene.exponent())
                })
            }

            /// The mantissas of each normal in each channel, for engines that interpolate between
            /// the vertices of a mesh: those of [`shade`](Self::shade).
            ///
            /// # Errors
            ///
            /// [`Error::Length`](eigenshade::Error::Length) unless `irradiance` and `normals` have
            /// the same length.
            #[inline]
            pub fn shade_slice(
                &self,
                normals: &[$crate::quantized::Normal<$crate::$format>],
                irradiance: &mut [$crate::Rgb<i32>],
            ) -> Result<(), $crate::Error> {
                $crate::specialized::shade_each(normals, irradiance, |normal| self.shade(normal))
            }
        }
    };
    ($format:ident transfer scatter $([$p:literal $q:literal $($o:literal)*])*
        azimuths $($azimuth:literal)*) => {
        $crate::integer_table!(@transfer $format, |material, transfer| {
            use $crate::quantized::kernels::transfer as kernels;
            let inputs = kernels::inputs::<$crate::$format, MODES, ORDERS>(material);
            let of_transfer = kernels::numbers(transfer);
            if let (Some(inputs), Some((numbers, exponents))) = (inputs, of_transfer) {
                let (mut sums, mut of_sums) = ([[0; PAIRS]; DEGREES], [0; DEGREES]);
                let b = kernels::coefficients(inputs.0);
                for (l, (sums, exponent)) in sums.iter_mut().zip(&mut of_sums).enumerate() {
                    let degree = kernels::Degree::new::<This>(l, inputs.1);
                    let Some(degree) = &degree else { continue };
                    scatter(degree, &b, sums);
                    *exponent = degree.normalize(sums);
                }
                $(kernels::azimuth::<
                    This, $crate::$format, $azimuth, { DEGREES - $azimuth }, PAIRS, DEGREES,
                    TRANSFER, PROFILES,
                >(&sums, &of_sums, (&mut *numbers, &mut *exponents));)*
                return Ok(());
            }
            transfer_generally(material, transfer)
        });
        #[cold]
        #[inline(never)]
        fn transfer_generally(
            material: &$crate::quantized::Material<'_, $crate::$format>,
            transfer: &mut Transfer,
        ) -> Result<(), $crate::Error> {
            *transfer = BASIS.transfer::<WORKSPACE, TRANSFER, PROFILES>(material)?;
            Ok(())
        }
        /// The sums S of one degree.
        #[inline(never)]
        fn scatter(
            degree: &$crate::quantized::kernels::transfer::Degree<$crate::$format, PAIRS, ORDERS>,
            b: &[<$crate::$format as $crate::Format>::Wide; MODES],
            sums: &mut [<$crate::$format as $crate::Format>::Wide; PAIRS],
        ) {
            $(
                let sum = 0;
                $(let sum = degree.add::<$p, $q, $o, MODES>(sum, b);)*
                if let Some(to) = sums.get_mut($crate::index::pair::position($p, $q)) {
                    *to = sum;
                }
            )*
        }
        const DEGREES: usize = DEGREE + 1;
        const ORDERS: usize = ORDER + 1;
        const PAIRS: usize = $crate::index::pair::count(ORDER);
        const MODES: usize = $crate::index::material::count(ORDER);
    };
    ($format:ident transfer by basis) => {
        $crate::integer_table!(@transfer $format, |material, transfer| {
            *transfer = BASIS.transfer::<WORKSPACE, TRANSFER, PROFILES>(material)?;
            Ok(())
        });
    };
    (@transfer $format:ident, |$material:ident, $transfer:ident| $into:block) => {
        /// The transfer of a material: see [`eigenshade::quantized::Basis::transfer`].
        ///
        /// # Errors
        ///
        /// The same, except that no capacity can be too small.
        pub fn transfer(
            material: &$crate::quantized::Material<'_, $crate::$format>,
        ) -> Result<Transfer, $crate::Error> {
            let mut transfer = Transfer::default();
            transfer_into(material, &mut transfer)?;
            Ok(transfer)
        }
        /// [`transfer`] into an existing transfer, without moving it.
        ///
        /// # Errors
        ///
        /// The same; `transfer` is then left unspecified.
        pub fn transfer_into(
            $material: &$crate::quantized::Material<'_, $crate::$format>,
            $transfer: &mut Transfer,
        ) -> Result<(), $crate::Error> $into
    };
    ($format:ident relight $($azimuth:literal)*) => {
        /// A new light on a transferred material: see [`eigenshade::quantized::Basis::relight`].
        ///
        /// # Errors
        ///
        /// The same, except that no capacity can be too small.
        pub fn relight(
            transfer: &$crate::quantized::Transfer<'_, $crate::$format>,
            light: &$crate::quantized::Light<'_, $crate::$format>,
        ) -> Result<Coefficients, $crate::Error> {
            let mut coefficients = Coefficients::default();
            relight_into(transfer, light, &mut coefficients)?;
            Ok(coefficients)
        }
        /// [`relight`] into existing coefficients, without moving them.
        ///
        /// # Errors
        ///
        /// The same; `coefficients` is then left unspecified.
        pub fn relight_into(
            transfer: &$crate::quantized::Transfer<'_, $crate::$format>,
            light: &$crate::quantized::Light<'_, $crate::$format>,
            coefficients: &mut Coefficients,
        ) -> Result<(), $crate::Error> {
            use $crate::quantized::kernels::relight as kernels;
            const LIGHT: usize = (DEGREE + 1) * (DEGREE + 1);
            let inputs =
                kernels::inputs::<$crate::$format, TRANSFER, PROFILES, LIGHT>(transfer, light);
            let coefficients_mut = kernels::coefficients(coefficients);
            if let (Some(inputs), Some((d, exponent))) = (inputs, coefficients_mut) {
                let top = kernels::NONE;
                $(let top = kernels::azimuth::<
                    This, $crate::$format, $azimuth, TRANSFER, PROFILES, LIGHT, COMPONENTS,
                >(inputs, d, top);)*
                let common = kernels::common(top);
                $(kernels::align::<This, $crate::$format, $azimuth, PROFILES, COMPONENTS>(
                    inputs.1, common, d,
                );)*
                *exponent = kernels::exponent::<$crate::$format>(common, light.exponent());
                return Ok(());
            }
            relight_generally(transfer, light, coefficients)
        }
        #[cold]
        #[inline(never)]
        fn relight_generally(
            transfer: &$crate::quantized::Transfer<'_, $crate::$format>,
            light: &$crate::quantized::Light<'_, $crate::$format>,
            coefficients: &mut Coefficients,
        ) -> Result<(), $crate::Error> {
            *coefficients = BASIS.relight::<COMPONENTS>(transfer, light)?;
            Ok(())
        }
    };
    ($format:ident collapse $([$azimuth:literal $profiles:literal])*) => {
        $crate::integer_table!(@collapse |coefficients, scene| {
            use $crate::quantized::kernels::collapse as kernels;
            const AZIMUTHS: usize = kernels::azimuths(&BASIS);
            let terms = kernels::terms(&BASIS, &mut scene.0);
            if let (Some(d), Some(terms)) = (kernels::mantissas(coefficients), terms) {
                let size = kernels::Size::<AZIMUTHS>::empty()
                    $(.azimuth::<This, $crate::$format, $azimuth, COMPONENTS>(d))*;
                if let Some(shifts) = size.shifts::<This, $crate::$format>() {
                    $(kernels::azimuth::<
                        This, $crate::$format, $azimuth, $profiles, AZIMUTHS, COMPONENTS, SCENE,
                    >(d, &shifts, terms);)*
                    kernels::finish(coefficients, &shifts, &mut scene.0);
                    return Ok(());
                }
            }
            collapse_generally(coefficients, scene)
        });
        #[cold]
        #[inline(never)]
        fn collapse_generally(
            coefficients: &Coefficients,
            scene: &mut Scene,
        ) -> Result<(), $crate::Error> {
            *scene = Scene(BASIS.collapse(coefficients.mantissas(), coefficients.exponent())?);
            Ok(())
        }
    };
    ($format:ident collapse by basis) => {
        $crate::integer_table!(@collapse |coefficients, scene| {
            *scene = Scene(BASIS.collapse(coefficients.mantissas(), coefficients.exponent())?);
            Ok(())
        });
    };
    (@collapse |$coefficients:ident, $scene:ident| $into:block) => {
        /// Sums the components of each azimuth: see [`eigenshade::quantized::Basis::collapse`].
        ///
        /// # Errors
        ///
        /// The same, except that no capacity can be too small.
        pub fn collapse(coefficients: &Coefficients) -> Result<Scene, $crate::Error> {
            let mut scene = Scene::default();
            collapse_into(coefficients, &mut scene)?;
            Ok(scene)
        }
        /// [`collapse`] into an existing scene, without moving it.
        ///
        /// # Errors
        ///
        /// The same; `scene` is then left unspecified.
        pub fn collapse_into(
            $coefficients: &Coefficients,
            $scene: &mut Scene,
        ) -> Result<(), $crate::Error> $into
    };
    ($format:ident shade $($azimuth:literal)*) => {
        impl Scene {
            /// The irradiance of one normal, times 2 to the power of the scene's negative
            /// [`exponent`](eigenshade::quantized::Scene::exponent): bit for bit that of
            /// [`eigenshade::quantized::Scene::shade`], with every length a constant.
            #[inline]
            #[must_use]
            pub fn shade(&self, normal: $crate::quantized::Normal<$crate::$format>) -> i32 {
                shade(&self.0, normal)
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
                normals: &[$crate::quantized::Normal<$crate::$format>],
                irradiance: &mut [i32],
            ) -> Result<(), $crate::Error> {
                $crate::specialized::shade_each(normals, irradiance, |normal| self.shade(normal))
            }
        }
        /// [`Scene::shade`] for a scene in a buffer of any type. The irradiance is 0 if the scene
        /// has fewer terms than one of this table.
        #[inline]
        #[must_use]
        pub fn shade<B: AsRef<[i32]>>(
            scene: &$crate::quantized::Scene<'_, $crate::$format, B>,
            normal: $crate::quantized::Normal<$crate::$format>,
        ) -> i32 {
            let Some(terms) = scene.terms().first_chunk::<SCENE>() else { return 0 };
            $crate::quantized::kernels::Pixel::start::<This, SCENE>(terms, normal)
                $(.azimuth::<This, $azimuth, SCENE>(terms))*
                .irradiance()
        }
    };
}
