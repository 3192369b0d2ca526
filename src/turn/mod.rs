//! Turns light.

pub(crate) mod about_view;
mod degree;
pub(crate) mod exchange;
mod recursion;
mod swing_twist;

pub(crate) use degree::{Arithmetic, Degree, Multiples, Turn};
pub(crate) use exchange::LARGEST;

use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light;
use crate::light::Light;
use crate::rotation::Rotation;
use swing_twist::Floats;

impl Light<'_> {
    /// The coefficients of this light after rotation: L'(Rω) = L(ω).
    ///
    /// `N` must be at least (degree + 1)², and the degree at most 12; for higher ones there is
    /// [`turn_into`](Self::turn_into).
    ///
    /// The energy of each degree is preserved. A light of degree 9 that is rotated and
    /// rotated back matches the original within 1e-6 of its largest coefficient. Cost: for degree 9
    /// some 1,500 products, and one root; see `docs/costs.md`. This is set-up work, not work for
    /// each pixel.
    ///
    /// ```
    /// use eigenshade::{Light, Rotation};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?; // brightest at the camera
    /// let quarter = core::f32::consts::FRAC_PI_2;
    /// let rotation = Rotation::from_euler(0.0, quarter, 0.0)?;
    /// let turned = light.turned::<4>(&rotation)?; // now from the right
    /// assert!(turned[2].abs() < 1e-6 && (turned[3].abs() - 1.0).abs() < 1e-6);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small, or the degree above 12.
    pub fn turned<const N: usize>(&self, rotation: &Rotation) -> Result<Buffer<f32, N>, Error> {
        turned([*self], rotation).map(|[turned]| turned)
    }

    /// Workspace length for [`turn_into`](Self::turn_into): 0 to degree 12, above the matrices of
    /// two degrees, and some numbers for each order. `usize::MAX` if that overflows.
    #[must_use]
    pub const fn turn_len(degree: usize) -> usize {
        if degree <= LARGEST { 0 } else { recursion::workspace_len(degree) }
    }

    /// [`turned`](Self::turned) of any degree, into a slice.
    ///
    /// Above degree 12 the rotation's matrices are computed, which takes for each degree l
    /// (2l + 1)² elements of some twenty operations each, and three roots for each order.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `workspace` has [`turn_len`](Self::turn_len) numbers and `turned`
    /// has (degree + 1)².
    pub fn turn_into(
        &self,
        rotation: &Rotation,
        workspace: &mut [f32],
        turned: &mut [f32],
    ) -> Result<(), Error> {
        let degree = self.degree();
        Error::check(Argument::Light, light::count(degree), turned.len())?;
        Error::check(Argument::Workspace, Self::turn_len(degree), workspace.len())?;
        if degree <= LARGEST {
            turn([*self], &rotation.turn(degree), [turned]);
        } else {
            recursion::turn(self, rotation, workspace, turned);
        }
        Ok(())
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::turned`] in each channel, at less than three times its cost.
    ///
    /// # Errors
    ///
    /// The same.
    pub fn turned<const N: usize>(
        &self,
        rotation: &Rotation,
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        turned((*self).into(), rotation).map(Rgb::from)
    }
}

fn turned<const C: usize, const N: usize>(
    lights: [Light<'_>; C],
    rotation: &Rotation,
) -> Result<[Buffer<f32, N>; C], Error> {
    let mut turned = [(); C].map(|()| Buffer::default());
    for (to, light) in turned.iter_mut().zip(&lights) {
        let needed = Light::turn_len(light.degree());
        if needed > 0 {
            return Err(Error::Capacity { argument: Argument::Workspace, needed, capacity: 0 });
        }
        *to = zeros(Argument::Light, light.coefficients().len())?;
    }
    let degree = lights.iter().map(Light::degree).max().unwrap_or_default();
    turn(lights, &rotation.turn(degree), turned.each_mut().map(Buffer::as_mut_slice));
    Ok(turned)
}

/// Turns lights, each into as many numbers. Their degrees are at most [`LARGEST`].
fn turn<const C: usize>(lights: [Light<'_>; C], rotation: &Turn<f32>, mut turned: [&mut [f32]; C]) {
    let degree = lights.iter().map(Light::degree).max().unwrap_or_default();
    for (to, from) in turned.iter_mut().zip(&lights) {
        if let (Some(to), Some(&mean)) = (to.first_mut(), from.coefficients().first()) {
            *to = mean;
        }
    }
    let mut elements = exchange::F32.as_slice();
    let mut numbers = [(); 3].map(|()| Degree::<Floats, C>::new());
    for l in 1..=degree {
        let range = light::count(l - 1)..light::count(l);
        let [of_degree, ..] = &mut numbers;
        for (channel, light) in lights.iter().enumerate() {
            // A light of a lower degree has none.
            let from = light.coefficients().get(range.clone()).unwrap_or_default();
            of_degree.load(channel, from, |number| number);
        }
        rotation.apply(l, &mut elements, &mut numbers);
        let [of_degree, ..] = &mut numbers;
        for (channel, to) in turned.iter_mut().enumerate() {
            let to = to.get_mut(range.clone()).unwrap_or_default();
            of_degree.store(channel, to, |number| number);
        }
    }
}
