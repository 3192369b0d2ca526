//! How well a given number of components represents an image (4.4).

use crate::basis::node_image::NodeImage;
use crate::basis::profile;
use eigenshade_table::Table;

/// An image fitted by the components of a table, one after another.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// d_i = I • U_i, after subtracting the mean image if the table has one.
    pub coefficients: Vec<f64>,
    /// Variance within the residual after K components, K = 0..=all.
    pub variances: Vec<f64>,
    /// Energy of the residual, including its mean, after K components.
    pub energies: Vec<f64>,
}

/// Fits an image of the table's degree by scalar products.
///
/// The residual is stored and reduced step by step, so its energy is accurate far below 1e-16 of
/// the image's.
#[must_use]
pub fn fit(table: &Table, image: &NodeImage) -> Fit {
    let gram = &table.gram;
    let middle = image.by_order.len() / 2;
    let mut residual = image.clone();
    if let Some(mean) = &table.mean {
        let nodes = gram.nodes.iter().zip(&gram.root_weights);
        for (value, (z, root)) in residual.by_order[middle].iter_mut().zip(nodes) {
            *value -= root * profile::evaluate(&mean.chebyshev, *z);
        }
    }
    let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
    let mut squares: Vec<f64> = residual.by_order.iter().map(|values| square(values)).collect();
    let mut fit = Fit { coefficients: vec![], variances: vec![], energies: vec![] };
    let mut note = |residual: &NodeImage, squares: &[f64]| {
        let energy: f64 = squares.iter().sum();
        fit.energies.push(energy);
        fit.variances.push((energy - residual.mean(gram).powi(2)).max(0.0));
    };
    note(&residual, &squares);
    for component in &table.components {
        let place = middle.saturating_add_signed(component.order as isize);
        let values = &mut residual.by_order[place];
        let profile = &table.profiles[component.profile].node_values;
        let coefficient: f64 = values.iter().zip(profile).map(|(value, u)| value * u).sum();
        values.iter_mut().zip(profile).for_each(|(value, u)| *value -= coefficient * u);
        squares[place] = square(values);
        fit.coefficients.push(coefficient);
        note(&residual, &squares);
    }
    fit
}
