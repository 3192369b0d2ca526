//! What scenes in color of a table in floats have besides [`table_in_color`](crate::table_in_color).

/// The methods of `color::Scene` in floats.
#[doc(hidden)]
#[macro_export]
macro_rules! float_table_in_color {
    () => {
        impl color::Scene {
            /// What exposes the irradiances of [`shade`](Self::shade), the same for every scene;
            /// errors as [`eigenshade::Exposure::new`].
            pub fn exposure(&self, exposure: f32) -> Result<$crate::Exposure, $crate::Error> {
                $crate::Exposure::new(exposure)
            }

            /// Bakes the scene into `size` x `size` texels, at most `T`: see
            /// [`eigenshade::Scene::bake`]; the same errors.
            pub fn bake<const T: usize>(
                &self,
                size: usize,
            ) -> Result<$crate::Rgb<$crate::BakedMap<f32, $crate::MapBuffer<f32, T>>>, $crate::Error>
            {
                self.each_ref().try_map(|scene| scene.bake(size))
            }

            /// Bakes the scene into `size` x `size` integers: see
            /// [`eigenshade::Scene::bake_integers_into`]; the same errors.
            pub fn bake_integers_into<B: AsMut<[i16]>>(
                &self,
                size: usize,
                texels: $crate::Rgb<B>,
            ) -> Result<$crate::Rgb<$crate::IntegerMap<B>>, $crate::Error> {
                let channels = self.each_ref().zip(texels);
                channels.try_map(|(scene, texels)| scene.bake_integers_into(size, texels))
            }

            /// The irradiance of each normal in each channel: see [`eigenshade::Rgb::shade_slice`];
            /// the same errors.
            // Inlined: the crate that calls it chooses between speed and size.
            #[inline]
            pub fn shade_slice(
                &self,
                normals: $crate::Normals<'_, f32>,
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
