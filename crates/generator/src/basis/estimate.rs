//! Estimates the memory and time that a scene's table needs, before it is made.

use crate::basis::profile::terms;
use crate::scene_file::Loaded;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel;
use eigenshade_table::scene::Store;
use eigenshade_table::{layout, light, material, mode, pair};
use std::time::Duration;

/// The most memory that a table may need, in bytes.
const MOST_BYTES: u64 = 8 << 30;

/// Bytes per number.
const NUMBER: f64 = 8.0;

/// Multiplications and additions per second on one core, in the dominant work: matrix products and
/// factorizations, and sums over columns.
const RATE: f64 = 5e8;

/// Shorter times are not reported.
const LONG: Duration = Duration::from_secs(60);

/// Memory and time that making a table needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The degree of the light and the order of the material.
    size: [usize; 2],
    /// Peak memory in bytes: an upper bound.
    pub bytes: u64,
    /// Time on this computer, to within a factor of about three.
    pub time: Duration,
}

/// Counts for the blocks of all azimuths.
#[derive(Default)]
struct Blocks {
    /// Numbers kept for all blocks.
    kept: f64,
    /// Largest count of numbers that making a single block needs.
    making: f64,
    /// Numbers of all profiles, if each is in the table.
    profiles: f64,
    operations: f64,
}

impl Estimate {
    /// Estimates the table of a scene at its full degree and order, which bounds whatever a
    /// tolerance may choose.
    #[must_use]
    pub fn of(loaded: &Loaded) -> Self {
        let scene = &loaded.scene;
        let (degree, order) = (scene.degree(), scene.order());
        let count = |count: usize| count as f64;
        let materials = count(loaded.materials.entries.len());
        let blocks = Blocks::new(degree, order, materials);
        let nodes = nodes(degree, order);
        let cores = count(parallel::threads());

        let pairs = pair::count(order) * (degree + 1 + nodes);
        let rotations = (degree + 1) * (degree + 2) / 2 * (order.min(degree) + 1) * nodes;
        let databases = loaded.lights.entries.len() * light::count(degree)
            + loaded.materials.entries.len() * material::count(order);
        // Each color of the databases: as loaded, fitted to the scene, and as moments.
        let common = count(pairs) + count(rotations) + 8.0 * count(databases);

        let most = blocks.profiles;
        let given = scene.basis.components.map_or(most, |components| {
            let factors = (degree + 1) * layout::row(order);
            count(components) * count(mode::count(degree, order, 0) + factors + 2 * nodes)
        });
        // The table, its modes at the nodes, and its bytes while the buffer grows.
        let copies = if scene.basis.store == Store::Modes { 4.0 } else { 2.0 };
        let numbers = blocks.kept + (cores * blocks.making).max(copies * given.min(most));
        Self {
            size: [degree, order],
            bytes: (NUMBER * (common + numbers)) as u64,
            time: Duration::from_secs_f64(blocks.operations / cores / RATE),
        }
    }

    /// Checks the memory before the table is made.
    ///
    /// # Errors
    ///
    /// If it is more than 8 GiB. The message gives degree, order, memory and time.
    pub fn check(&self) -> Result<()> {
        if self.bytes <= MOST_BYTES {
            return Ok(());
        }
        let [degree, order] = self.size;
        let time = self.minutes().map(|time| format!(" and {time}")).unwrap_or_default();
        let [needed, most] = [self.bytes.div_ceil(1 << 30), MOST_BYTES >> 30];
        let what = format!(
            "a table of degree {degree}, order {order} needs {needed} GiB of memory{time}, and at \
             most {most} GiB are allowed"
        );
        Err(Error::new(what, "reduce the degree or the order, or name fewer materials"))
    }

    /// The time as text; `None` if it is shorter than a minute.
    #[must_use]
    pub fn minutes(&self) -> Option<String> {
        (self.time >= LONG).then(|| format!("about {} minutes", self.time.as_secs().div_ceil(60)))
    }
}

impl Blocks {
    fn new(degree: usize, order: usize, materials: f64) -> Self {
        let nodes = nodes(degree, order) as f64;
        let coefficients = material::count(order) as f64;
        let mut blocks = Self::default();
        for azimuth in 0..=degree {
            let modes = mode::count(degree, order, azimuth) as f64;
            let terms = terms(degree, order, azimuth) as f64;
            let degrees = (degree + 1 - azimuth) as f64;
            let images = materials * (degrees + 1.0);
            let factors = degrees * layout::row(order) as f64;
            // A and its singular vectors, the space, and the principal components.
            blocks.kept += 2.0 * terms * modes + terms * (nodes + 4.0 * terms);
            // The modes at the nodes, twice; A and the workspace of its factorization; the
            // deviations and their images.
            let making =
                2.0 * nodes * modes + 4.0 * terms * modes + images * (coefficients + 4.0 * terms);
            blocks.making = blocks.making.max(making);
            blocks.profiles += terms * (modes + factors + nodes + terms);
            blocks.operations += 4.0 * modes * terms * (2.0 * terms + nodes)
                + images * terms * (coefficients + 8.0 * terms);
        }
        blocks
    }
}

/// The number of nodes of [`crate::basis::gram::of_sphere`].
fn nodes(degree: usize, order: usize) -> usize {
    terms(degree, order, 0) + degree + 1
}
