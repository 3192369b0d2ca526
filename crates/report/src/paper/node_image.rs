//! Images at the nodes of the slant, without pixels: I = Σ_m u_m(α) Φ_m(β) is stored as √w_k
//! u_m(α_k) for each m. The scalar product (19) is then the dot product of these numbers.
//!
//! [`fit`] finds how well each number of components represents an image (4.4).

use eigenshade_generator::basis::profile;
use eigenshade_table::{GramFactor, Table, light, material, mode};

/// An image as √w_k u_m(α_k) for m = -degree..=degree and each node k.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeImage {
    /// Node values of each m, starting at -degree.
    pub by_order: Vec<Vec<f64>>,
}

impl NodeImage {
    /// I • I.
    pub fn energy(&self) -> f64 {
        self.by_order.iter().flatten().map(|value| value * value).sum()
    }

    /// I • 1, (30).
    pub fn mean(&self, gram: &GramFactor) -> f64 {
        let middle = &self.by_order[self.by_order.len() / 2];
        middle.iter().zip(&gram.root_weights).map(|(value, root)| value * root).sum()
    }

    /// I • I - (I • 1)², from the deviations, so that nearly constant images lose no accuracy.
    pub fn variance(&self, gram: &GramFactor) -> f64 {
        let mean = self.mean(gram);
        let middle = self.by_order.len() / 2;
        let mut sum = 0.0;
        for (place, values) in self.by_order.iter().enumerate() {
            let center = if place == middle { mean } else { 0.0 };
            let deviations = values.iter().zip(&gram.root_weights);
            sum += deviations.map(|(value, root)| (value - center * root).powi(2)).sum::<f64>();
        }
        sum
    }

    pub fn minus(&self, other: &Self) -> Self {
        let by_order = self.by_order.iter().zip(&other.by_order).map(|(ours, theirs)| {
            ours.iter().zip(theirs).map(|(ours, theirs)| ours - theirs).collect()
        });
        Self { by_order: by_order.collect() }
    }
}

/// Materials prepared for any light: each has the image of every harmonic.
#[derive(Clone, Debug)]
pub struct MaterialImages {
    degree: usize,
    nodes: usize,
    /// Node values of Y_l^m, indexed by material, then |m|, then l from |m|.
    harmonics: Vec<Vec<Vec<Vec<f64>>>>,
}

impl MaterialImages {
    /// Prepares materials b_op^q of the order of `gram`. `kept` selects modes in the layout of
    /// `Table::selection`; empty selects all.
    pub fn new(gram: &GramFactor, kept: &[bool], materials: &[Vec<f64>]) -> Self {
        let nodes = gram.nodes.len();
        let empty = |azimuth: usize| vec![vec![0.0; nodes]; gram.degree + 1 - azimuth];
        let mut harmonics = vec![(0..=gram.degree).map(empty).collect::<Vec<_>>(); materials.len()];
        for azimuth in 0..=gram.degree {
            let columns = gram.columns(azimuth);
            let modes = mode::indices(gram.degree, gram.order, azimuth);
            for (column, (l, o, p, q)) in columns.iter().zip(modes) {
                if !kept.is_empty() && !kept[gram.place(azimuth, l, o, p, q)] {
                    continue;
                }
                for (material, images) in materials.iter().zip(&mut harmonics) {
                    let b = material[material::position(o, p, q)];
                    let image = &mut images[azimuth][l - azimuth];
                    image.iter_mut().zip(column).for_each(|(value, a)| *value += b * a);
                }
            }
        }
        Self { degree: gram.degree, nodes, harmonics }
    }

    /// The image of the light L_l^m, which has the degree of the `gram`, on one of the materials.
    pub fn image(&self, light: &[f64], material: usize) -> NodeImage {
        let top = self.degree.cast_signed();
        let of_order = |m: isize| {
            let azimuth = m.unsigned_abs();
            // f of -m is (-1)^m times f of m.
            let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
            let mut values = vec![0.0; self.nodes];
            for (l, harmonic) in (azimuth..).zip(&self.harmonics[material][azimuth]) {
                let coefficient = sign * light[light::position(l, m)];
                values.iter_mut().zip(harmonic).for_each(|(value, h)| *value += coefficient * h);
            }
            values
        };
        NodeImage { by_order: (-top..=top).map(of_order).collect() }
    }
}

/// An image fitted by the components of a table, one after another.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// d_i = I • U_i, after subtracting the mean image if the table has one.
    pub coefficients: Vec<f64>,
    /// Variance within the residual after K components, K = 0..=all.
    pub variances: Vec<f64>,
}

/// Fits an image of the table's degree by scalar products.
///
/// The residual is reduced step by step, so its energy is accurate far below 1e-16 of the image's.
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
    let variance = |residual: &NodeImage, squares: &[f64]| {
        (squares.iter().sum::<f64>() - residual.mean(gram).powi(2)).max(0.0)
    };
    let mut fit = Fit { coefficients: vec![], variances: vec![variance(&residual, &squares)] };
    for component in &table.components {
        let place = middle.saturating_add_signed(component.order as isize);
        let values = &mut residual.by_order[place];
        let profile = &table.profiles[component.profile].node_values;
        let coefficient: f64 = values.iter().zip(profile).map(|(value, u)| value * u).sum();
        values.iter_mut().zip(profile).for_each(|(value, u)| *value -= coefficient * u);
        squares[place] = square(values);
        fit.coefficients.push(coefficient);
        fit.variances.push(variance(&residual, &squares));
    }
    fit
}
