//! Lights and materials by name, as coefficients of three colour channels.

use eigenshade_index::{light, material};

/// The coefficients of one light or one material, channel by channel (r, g, b).
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// What it is called; unique in its set.
    pub name: String,
    /// Linear coefficients; all three channels have the same length.
    pub rgb: [Vec<f64>; 3],
}

/// 0.2126 R + 0.7152 G + 0.0722 B.
#[must_use]
pub fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

impl Named {
    /// The [`luminance`] of every coefficient.
    #[must_use]
    pub fn luminance(&self) -> Vec<f64> {
        let [r, g, b] = &self.rgb;
        r.iter().zip(g).zip(b).map(|((&r, &g), &b)| luminance([r, g, b])).collect()
    }

    /// Whether all three channels are the same.
    #[must_use]
    pub fn is_grey(&self) -> bool {
        self.rgb[0] == self.rgb[1] && self.rgb[1] == self.rgb[2]
    }
}

/// Lights of one degree: L_l^m in radiance, in the order of
/// [`eigenshade_index::light`].
#[derive(Clone, Debug, PartialEq)]
pub struct Lights {
    /// The degree of every light.
    pub degree: usize,
    /// The lights, (degree + 1)² coefficients each.
    pub entries: Vec<Named>,
}

/// Materials of one order: b_op^q in 1/sr, in the order of
/// [`eigenshade_index::material`].
#[derive(Clone, Debug, PartialEq)]
pub struct Materials {
    /// The order of every material.
    pub order: usize,
    /// The materials.
    pub entries: Vec<Named>,
}

impl Lights {
    /// The same lights up to a lower degree.
    #[must_use]
    pub fn truncated(&self, degree: usize) -> Self {
        let degree = degree.min(self.degree);
        Self { degree, entries: prefix(&self.entries, light::count(degree)) }
    }
}

impl Materials {
    /// The same materials up to a lower order.
    #[must_use]
    pub fn truncated(&self, order: usize) -> Self {
        let order = order.min(self.order);
        Self { order, entries: prefix(&self.entries, material::count(order)) }
    }
}

fn prefix(entries: &[Named], count: usize) -> Vec<Named> {
    let cut = |channel: &Vec<f64>| channel[..count.min(channel.len())].to_vec();
    entries
        .iter()
        .map(|entry| Named { name: entry.name.clone(), rgb: entry.rgb.each_ref().map(cut) })
        .collect()
}
