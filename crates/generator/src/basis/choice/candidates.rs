//! Finds the degree and order that need the smallest table.
//!
//! A candidate's components are counted from the eigenvalues of Σ y yᵀ over its images y, in the
//! coordinates of the highest degree and order. The final table counts its own components from
//! singular values. Polynomials, about a tenth of a table, are not counted.

use crate::basis::canonical;
use crate::basis::choice::report::{Energies, Images, POLYNOMIALS, budget};
use crate::basis::choice::report::{Reach, Remaining, Share};
use crate::basis::database::material_weights;
use crate::basis::eigenimages::constant_coordinates;
use crate::basis::gram;
use crate::basis::moments::{LightMoments, MaterialMoments, deviations};
use eigenshade_model::database::{self, Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::selection::Kept;
use eigenshade_table::scene::{Criterion, Store};
use eigenshade_table::{Scene, layout, pair};
use faer::{Mat, Side};

/// The smallest fraction of the tolerance that is reserved for components and polynomials.
const LEAST_BUDGET: f64 = 0.2;

/// If a degree or order leaves out at most this fraction of the tolerance, no higher one is tried:
/// the components would gain no more than that.
const NEGLIGIBLE: f64 = 0.01;

/// A degree and an order, with the energies that they leave out.
pub(super) struct Candidate {
    pub(super) degree: usize,
    pub(super) order: usize,
    pub(super) degrees_left: f64,
    pub(super) orders_left: f64,
    /// Energy left out with one degree less, and with one order less.
    one_less: [Option<f64>; 2],
}

impl Candidate {
    fn new(energies: &Energies, degree: usize, order: usize) -> Self {
        Self {
            degree,
            order,
            degrees_left: energies.of_degrees_above(degree),
            orders_left: energies.of_orders_from(order + 1, degree),
            one_less: [
                degree.checked_sub(1).map(|less| energies.of_degrees_above(less)),
                order.checked_sub(1).map(|_| energies.of_orders_from(order, degree)),
            ],
        }
    }

    /// Converts the energies to shares of the peak; totals come from the scene.
    pub(super) fn reach(&self, scene: &Scene, peak: f64) -> Reach {
        let share = |energy: f64| energy.sqrt() / peak;
        let [degree, order] = self.one_less.map(|one| one.map(share));
        Reach::Chosen {
            degree: Share {
                kept: self.degree,
                of: scene.light.degree,
                leaves: share(self.degrees_left),
                one_less: degree,
            },
            order: Share {
                kept: self.order,
                of: scene.material.order,
                leaves: share(self.orders_left),
                one_less: order,
            },
        }
    }
}

/// The candidate with the smallest table among those that leave out at most `allowed` energy in
/// total. Ties go to the lowest degree, then the lowest order.
///
/// # Errors
///
/// If the weights are invalid, a light cannot be normalized or eigenvalues do not converge.
pub(super) fn least(
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
    allowed: f64,
) -> Result<Candidate> {
    let weights = database::weights(&lights.entries, &scene.light.weights)?;
    let effects = scene.effects.set();
    let lights = &lights.truncated(effects.degree(lights.degree));
    let materials = &materials.truncated(effects.order(materials.order));
    let light = LightMoments::weighted(lights, scene.light.normalize, &weights)?;
    let weights = material_weights(scene, lights, materials)?;
    let of_materials = MaterialMoments::weighted(materials, weights);
    let gram = gram::of_sphere(lights.degree, materials.order);
    let kept = Kept { selection: Vec::new() };
    let moments = |criterion, azimuth| deviations(&light, &of_materials, criterion, azimuth);
    let energies =
        Energies::new(&gram, &kept, |azimuth| moments(Criterion::ImageCentered, azimuth));
    let candidates = within(&energies, [gram.degree, gram.order], allowed);

    let criterion = scene.basis.criterion;
    let mut spectra = vec![Vec::new(); candidates.len()];
    for azimuth in 0..=gram.degree {
        let images = Images::new(&gram, &kept, azimuth);
        let deviations = moments(criterion, azimuth);
        let constant = (criterion == Criterion::ImageCentered && azimuth == 0)
            .then(|| constant_coordinates(&gram, &images.space));
        let size = images.space.dimension();
        let mut squares = vec![Mat::<f64>::zeros(size, size); gram.order + 1];
        for l in azimuth..=gram.degree {
            for (squares, images) in squares.iter_mut().zip(images.by_order(&deviations, l)) {
                *squares += &images * images.transpose();
            }
            for (candidate, spectrum) in candidates.iter().zip(&mut spectra) {
                if candidate.degree == l {
                    let values = eigenvalues(&squares[candidate.order], constant.as_deref())?;
                    spectrum.extend(values.into_iter().map(|value| (azimuth, value)));
                }
            }
        }
    }
    let transfers = materials.entries.len();
    let sized = candidates.into_iter().zip(spectra).map(|(candidate, spectrum)| {
        let left = [candidate.degrees_left, candidate.orders_left];
        let profiles = profiles(spectrum, criterion, (1.0 - POLYNOMIALS) * budget(allowed, left));
        let reach = [candidate.degree, candidate.order];
        (numbers(scene.basis.store, reach, &profiles, transfers), candidate)
    });
    // Ties go to the first.
    let least = sized.reduce(|least, one| if one.0 < least.0 { one } else { least });
    Ok(least.expect("all of the light and the material is a candidate").1)
}

/// The candidates, sorted by degree, then order.
fn within(
    energies: &Energies,
    [most_degree, most_order]: [usize; 2],
    allowed: f64,
) -> Vec<Candidate> {
    let negligible = NEGLIGIBLE * NEGLIGIBLE * allowed;
    let mut candidates = Vec::new();
    for degree in 0..=most_degree {
        for order in 0..=most_order {
            let one = Candidate::new(energies, degree, order);
            let left = budget(allowed, [one.degrees_left, one.orders_left]);
            let is_last = one.orders_left <= negligible;
            if left >= LEAST_BUDGET * LEAST_BUDGET * allowed {
                candidates.push(one);
            }
            if is_last {
                break;
            }
        }
        if energies.of_degrees_above(degree) <= negligible && !candidates.is_empty() {
            break;
        }
    }
    candidates
}

/// Eigenvalues after projecting out the unit vector `constant`; negative rounding errors become
/// zero.
fn eigenvalues(squares: &Mat<f64>, constant: Option<&[f64]>) -> Result<Vec<f64>> {
    let rest = match constant {
        None => squares.clone(),
        Some(constant) => {
            let size = constant.len();
            let project = Mat::from_fn(size, size, |i, j| {
                f64::from(u8::from(i == j)) - constant[i] * constant[j]
            });
            &project * squares * &project
        }
    };
    let values = rest.self_adjoint_eigenvalues(Side::Lower).map_err(|_| {
        Error::new(
            "the eigenvalues of the images' energies do not converge",
            "look for numbers that are not finite, or far out of range",
        )
    })?;
    Ok(values.into_iter().map(|value| value.max(0.0)).collect())
}

/// How many profiles each |m| contributes to the fewest components that leave at most `allowed`.
fn profiles(spectrum: Vec<(usize, f64)>, criterion: Criterion, allowed: f64) -> Vec<usize> {
    let mut values: Vec<(usize, f64)> = spectrum
        .into_iter()
        .flat_map(|(azimuth, value)| {
            canonical::orders(azimuth).iter().map(move |_| (azimuth, value))
        })
        .collect();
    values.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    let only: Vec<_> = values.iter().map(|(_, value)| (0, Some(*value))).collect();
    let count = Remaining::new(&only, 0.0).least(allowed);
    let most = values.iter().map(|(azimuth, _)| azimuth + 1).max().unwrap_or(1);
    let mut components = vec![0; most];
    values[..count].iter().for_each(|(azimuth, _)| components[*azimuth] += 1);
    let mut profiles: Vec<usize> = (components.iter().enumerate())
        .map(|(azimuth, count): (usize, &usize)| count.div_ceil(canonical::orders(azimuth).len()))
        .collect();
    // The constant image.
    profiles[0] += usize::from(criterion == Criterion::ImageCentered);
    profiles
}

/// How many numbers projection reads from the runtime table: polar integrals and factors; or the
/// transfers of `transfers` materials.
fn numbers(
    store: Store,
    [degree, order]: [usize; 2],
    profiles: &[usize],
    transfers: usize,
) -> usize {
    let by_azimuth = profiles.iter().enumerate();
    if store == Store::Materials {
        let rows = by_azimuth.map(|(azimuth, count)| count * (degree + 1 - azimuth));
        return transfers * rows.sum::<usize>();
    }
    let polar = pair::count(order) * layout::LANES * layout::groups(degree);
    let rows = by_azimuth.map(|(azimuth, &count)| layout::rows(degree, azimuth, count));
    polar + layout::row(order) * rows.sum::<usize>()
}
