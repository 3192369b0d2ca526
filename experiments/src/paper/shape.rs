//! Describes an eigenimage of the sphere in numbers and in words.

use eigenshade_generator::basis::profile::evaluate;
use eigenshade_table::Table;

/// The number of rings of equal area at which a profile is sampled.
const RINGS: u32 = 2000;
/// The outer ring of the disc whose share is reported, as a share of the disc's area.
pub const RIM: f64 = 0.1;

/// The shape of one component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// The order m.
    pub order: i32,
    /// The number of sign changes of the profile between the pole and the rim.
    pub changes: usize,
    /// The share of its mean square that lies in the outer [`RIM`] of the disc.
    pub rim: f64,
    /// The share of its mean square that is constant over the sphere.
    pub constant: f64,
}

impl Shape {
    /// The shape of one component of a table of the sphere.
    #[must_use]
    pub fn new(table: &Table, component: usize) -> Option<Self> {
        let component = table.components.get(component)?;
        let profile = table.profiles.get(component.profile)?;
        let squared_sine = |ring: u32| (f64::from(ring) + 0.5) / f64::from(RINGS);
        let values: Vec<f64> = (0..RINGS)
            .map(|ring| {
                let s = squared_sine(ring);
                let sine_power = s.sqrt().powi(profile.azimuth as i32);
                sine_power * evaluate(&profile.chebyshev, (1.0 - s).sqrt())
            })
            .collect();
        let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
        let outer = ((1.0 - RIM) * f64::from(RINGS)) as usize;
        let mean = values.iter().sum::<f64>() / f64::from(RINGS);
        let mean = if component.order == 0 { mean } else { 0.0 };
        Some(Self {
            order: component.order,
            changes: values.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count(),
            rim: square(&values[outer..]) / square(&values),
            constant: mean * mean * f64::from(RINGS) / square(&values),
        })
    }

    /// A word for the shape, in singular or plural.
    fn words(&self, several: bool) -> String {
        let ending = if several { "s" } else { "" };
        let azimuth = self.order.unsigned_abs();
        let (rings, what) = match (azimuth, self.changes) {
            (0, 0) => (0, format!("constant{ending}")),
            (0, rings) => (rings - 1, format!("bowl{ending}")),
            (1, rings) => (rings, format!("slope{ending}")),
            (2, rings) => (rings, format!("saddle{ending}")),
            (_, rings) => (rings, format!("star{ending} of {} rays", 2 * azimuth)),
        };
        match rings {
            0 => what,
            1 => format!("{what} with a ring of the other sign"),
            _ => format!("{what} with {rings} rings of changing sign"),
        }
    }
}

/// Describes a sequence of shapes in words.
#[must_use]
pub fn sequence(shapes: &[Shape]) -> String {
    const COUNTS: [&str; 5] = ["no", "a", "two", "three", "four"];
    let alike = |a: &Shape, b: &Shape| a.words(false) == b.words(false);
    let words: Vec<String> = shapes
        .chunk_by(alike)
        .map(|group| {
            let count = COUNTS.get(group.len()).copied().unwrap_or("several");
            group
                .first()
                .map_or(String::new(), |one| format!("{count} {}", one.words(group.len() > 1)))
        })
        .collect();
    words.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_follow_the_numbers() {
        let shape = |order, changes| Shape { order, changes, rim: 0.0, constant: 0.0 };
        let shapes = [(0, 0), (1, 0), (-1, 0), (0, 1), (2, 0), (1, 1), (-1, 1), (0, 3), (3, 0)];
        assert_eq!(
            sequence(&shapes.map(|(order, changes)| shape(order, changes))),
            "a constant, two slopes, a bowl, a saddle, two slopes with a ring of the other sign, \
             a bowl with 2 rings of changing sign, a star of 6 rays"
        );
    }
}
