//! The items that every module of a table has, in floats and in integers.

/// Sizes, and the type of a scene.
#[doc(hidden)]
#[macro_export]
macro_rules! table_items {
    (basis $type:ty = $basis:expr, components $components:expr, workspace $workspace:expr,
        scene $scene:ty) => {
        /// This table, for the functions that are specialized for it.
        struct This;
        impl $crate::specialized::KnownTable<$type> for This {
            const BASIS: &'static $type = &$basis;
        }
        /// Largest degree l of the light.
        pub const DEGREE: usize = PARTS.degree;
        /// Largest order o of the BRDF.
        pub const ORDER: usize = PARTS.order;
        /// Number of components K.
        pub const COMPONENTS: usize = $components;
        /// Numbers in the workspace of a projection or of a transfer.
        pub const WORKSPACE: usize = $workspace;
        /// Numbers in a [`Transfer`].
        pub const TRANSFER: usize = $basis.transfer_len();
        /// Numbers in a [`Scene`].
        pub const SCENE: usize = $basis.scene_len();
        /// A scene of this table's size.
        type Collapsed = $scene;
        /// One image, ready to be shaded, which dereferences to a scene of eigenshade.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Scene(Collapsed);
        impl core::ops::Deref for Scene {
            type Target = Collapsed;
            #[inline]
            fn deref(&self) -> &Collapsed {
                &self.0
            }
        }
    };
}

/// The module `color` of a table: its steps for three channels.
#[doc(hidden)]
#[macro_export]
macro_rules! table_in_color {
    (
        $a:lifetime, light $light:ty, material $material:ty,
        normal $normal:ty, mirrored $mirrored:ty, irradiance $irradiance:ty,
        blank $coefficients:ident::$of_numbers:ident($($numbers:expr)?),
        view |$transfer:ident| $view:expr
    ) => {
        /// The steps from light to pixel in three channels.
        pub mod color {
            use $crate::Rgb;

            type Light<$a> = $light;
            type Material<$a> = $material;

            /// The transfer of a material in each channel. For a gray material, one
            /// [`Transfer`](super::Transfer) is enough for all channels.
            pub type Transfer = Rgb<super::Transfer>;

            /// One image in three channels, ready to be shaded, which dereferences to the channels.
            #[derive(Clone, Debug, Default, PartialEq)]
            pub struct Scene(Rgb<super::Scene>);

            impl core::ops::Deref for Scene {
                type Target = Rgb<super::Scene>;
                #[inline]
                fn deref(&self) -> &Rgb<super::Scene> {
                    &self.0
                }
            }

            impl Scene {
                /// The irradiance of one normal in each channel.
                #[inline]
                #[must_use]
                pub fn shade(&self, normal: $normal) -> Rgb<$irradiance> {
                    self.0.each_ref().map(|scene| of_channel(scene, normal))
                }

                /// The irradiances of a normal and its mirror images in each channel, at little more
                /// than the cost of one normal.
                #[must_use]
                pub fn shade_mirrored(&self, normal: $normal) -> [Rgb<$irradiance>; 4] {
                    let mirrored = <$mirrored>::new(normal);
                    $crate::specialized::by_image(
                        self.0.each_ref().map(|scene| of_mirrored(scene, &mirrored)),
                    )
                }
            }

            // As below.
            #[inline(never)]
            fn of_mirrored(scene: &super::Scene, mirrored: &$mirrored) -> [$irradiance; 4] {
                super::mirrored(scene, mirrored)
            }

            // Not inlined three times, which would leave too few registers.
            #[inline(never)]
            fn of_channel(scene: &super::Scene, normal: $normal) -> $irradiance {
                scene.shade(normal)
            }

            /// The image of a material under a light: [`transfer`](super::transfer),
            /// [`relight`](super::relight) and collapse in each channel, with their errors. A gray
            /// material is transferred once.
            pub fn scene<'l, 'm>(
                light: impl Into<Rgb<Light<'l>>>,
                material: impl Into<Rgb<Material<'m>>>,
            ) -> Result<Scene, $crate::Error> {
                lit(light.into(), material.into())
            }

            fn lit(
                light: Rgb<Light<'_>>,
                material: Rgb<Material<'_>>,
            ) -> Result<Scene, $crate::Error> {
                let mut scene = Scene::default();
                if let Some(gray) = material.as_gray() {
                    lit_gray(&gray, light, &mut scene)?;
                    return Ok(scene);
                }
                let mut d = coefficients();
                let Scene(Rgb { r, g, b }) = &mut scene;
                lit_channel(&material.r, &light.r, &mut d, r)?;
                lit_channel(&material.g, &light.g, &mut d, g)?;
                lit_channel(&material.b, &light.b, &mut d, b)?;
                Ok(scene)
            }

            // Not inlined, so that the memory of a transfer is free again between the channels.
            #[inline(never)]
            fn lit_channel(
                material: &Material<'_>,
                light: &Light<'_>,
                d: &mut super::Coefficients,
                scene: &mut super::Scene,
            ) -> Result<(), $crate::Error> {
                channel(&super::transfer(material)?, light, d, scene)
            }

            // As above.
            #[inline(never)]
            fn lit_gray(
                material: &Material<'_>,
                light: Rgb<Light<'_>>,
                scene: &mut Scene,
            ) -> Result<(), $crate::Error> {
                relit(Rgb::gray(&super::transfer(material)?), light, scene)
            }

            /// The transfer of a material in each channel; errors as [`transfer`](super::transfer).
            pub fn transfer<'m>(
                material: impl Into<Rgb<Material<'m>>>,
            ) -> Result<Transfer, $crate::Error> {
                let material = material.into();
                if let Some(gray) = material.as_gray() {
                    let transfer = super::transfer(&gray)?;
                    return Ok(Rgb::new(transfer.clone(), transfer.clone(), transfer));
                }
                material.try_map(|material| super::transfer(&material))
            }

            /// The image of a transferred material under a new light: relight and collapse in each
            /// channel; errors as [`relight`](super::relight). `transfer` is a [`Transfer`] or, for
            /// a gray material, one channel's.
            pub fn relight<'l, 't>(
                transfer: impl Into<Rgb<&'t super::Transfer>>,
                light: impl Into<Rgb<Light<'l>>>,
            ) -> Result<Scene, $crate::Error> {
                let mut scene = Scene::default();
                relit(transfer.into(), light.into(), &mut scene)?;
                Ok(scene)
            }

            /// [`relight`] into an existing scene, without moving it.
            ///
            /// # Errors
            ///
            /// As [`relight`]; `scene` is then left unspecified.
            pub fn relight_into<'l, 't>(
                transfer: impl Into<Rgb<&'t super::Transfer>>,
                light: impl Into<Rgb<Light<'l>>>,
                scene: &mut Scene,
            ) -> Result<(), $crate::Error> {
                relit(transfer.into(), light.into(), scene)
            }

            fn relit(
                transfer: Rgb<&super::Transfer>,
                light: Rgb<Light<'_>>,
                scene: &mut Scene,
            ) -> Result<(), $crate::Error> {
                let mut d = coefficients();
                let Scene(Rgb { r, g, b }) = scene;
                channel(transfer.r, &light.r, &mut d, r)?;
                channel(transfer.g, &light.g, &mut d, g)?;
                channel(transfer.b, &light.b, &mut d, b)
            }

            /// Relights and collapses one channel.
            fn channel(
                $transfer: &super::Transfer,
                light: &Light<'_>,
                d: &mut super::Coefficients,
                scene: &mut super::Scene,
            ) -> Result<(), $crate::Error> {
                super::relight_into($view, light, d)?;
                super::collapse_into(d, scene);
                Ok(())
            }

            #[inline(always)]
            fn coefficients() -> super::Coefficients {
                super::$coefficients::$of_numbers($($numbers)?)
            }
        }
    };
}
