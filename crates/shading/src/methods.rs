//! Other ways to an image than all collapsed polynomials: the fewest terms for a tolerance,
//! a baked map, and the sum of the components.

use crate::shader::{Lit, OwnedNormals, Shader, fault};
use eigenshade::object::MapPoint;
use eigenshade::truncation::{Tolerance, Truncation};
use eigenshade::{Normal, Scene};
use eigenshade_model::error::Result;
use eigenshade_model::overflow;

impl Shader<'_> {
    /// The channels of one color image, with a common shape that has the fewest polynomial terms
    /// for a tolerance relative to the brightest channel's peak. Also returns the resulting
    /// truncation of each channel.
    ///
    /// # Errors
    ///
    /// As [`project`](Self::project).
    pub fn within(
        &mut self,
        channels: &[Lit<'_>],
        normals: &OwnedNormals,
        tolerance: Tolerance,
    ) -> Result<Vec<(Vec<f32>, Truncation)>> {
        let normals = normals.view()?;
        self.truncated(channels, tolerance, |scenes, truncations| {
            let mut shaded = Vec::new();
            for ((scene, truncation), (light, material)) in
                scenes.iter().zip(truncations).zip(channels)
            {
                let mut irradiance = vec![0.0; normals.len()];
                scene.shade_slice(normals, &mut irradiance).map_err(fault)?;
                overflow::check(&irradiance, light, material)?;
                shaded.push((irradiance, truncation));
            }
            Ok(shaded)
        })
    }

    /// Calls a function with the scenes of [`within`](Self::within), which have one shape, and
    /// their truncations.
    ///
    /// # Errors
    ///
    /// As [`within`](Self::within), and the errors of the function.
    pub fn truncated<R>(
        &mut self,
        channels: &[Lit<'_>],
        tolerance: Tolerance,
        function: impl FnOnce(&[Scene<'_, &[f32]>], Vec<Truncation>) -> Result<R>,
    ) -> Result<R> {
        let mut images = Vec::new();
        for &(light, material) in channels {
            images.push(self.project(light, material)?.to_vec());
        }
        let basis = self.basis;
        let (count, len) = (images.len(), basis.scene_len());
        let mut lengths = vec![0; basis.azimuths()];
        let mut buffer = vec![0.0; count * len];
        let mut truncations = vec![Truncation::default(); count];
        let (room, report) = (&mut buffer, &mut truncations);
        let shape = basis
            .collapse_set_within(&images, count, tolerance, &mut lengths, room, report)
            .map_err(fault)?;
        let scenes = buffer.chunks(len).map(|numbers| shape.scene(numbers));
        let scenes = scenes.collect::<std::result::Result<Vec<_>, _>>().map_err(fault)?;
        function(&scenes, truncations)
    }

    /// One channel of the image, baked on a map of `size` x `size` texels and looked up.
    ///
    /// # Errors
    ///
    /// As [`project`](Self::project), and if the runtime does not support this number of texels.
    pub fn baked(
        &mut self,
        light: &[f64],
        material: &[f64],
        normals: &[Normal],
        size: usize,
    ) -> Result<Vec<f32>> {
        self.project(light, material)?;
        let scene = self.scene()?;
        let map = scene.bake_into(size, vec![0.0; size * size]).map_err(fault)?;
        let irradiance: Vec<f32> =
            normals.iter().map(|&normal| map.bilinear(MapPoint::of(normal))).collect();
        overflow::check(&irradiance, light, material)?;
        Ok(irradiance)
    }

    /// One channel of the image, summed component by component.
    ///
    /// # Errors
    ///
    /// See [`project`](Self::project).
    pub fn eigen(
        &mut self,
        light: &[f64],
        material: &[f64],
        normals: &[Normal],
    ) -> Result<Vec<f32>> {
        let basis = self.basis;
        let coefficients = self.project(light, material)?;
        let one = |&normal: &Normal| basis.reconstruct(coefficients, normal).map_err(fault);
        let irradiance: Vec<f32> = normals.iter().map(one).collect::<Result<_>>()?;
        overflow::check(&irradiance, light, material)?;
        Ok(irradiance)
    }
}
