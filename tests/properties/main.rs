//! What holds for every scene: properties, on random degrees, orders, lights, materials, selections
//! and cut-offs.
//!
//! The same few scenes each time. To search further:
//! `PROPTEST_CASES=1000 PROPTEST_RNG_SEED=7 cargo test --test properties`.

mod samples;
mod sphere;

use eigenshade_testing::tolerances;

use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Cases of each property, unless the environment says otherwise.
const CASES: u32 = 24;

fn config() -> ProptestConfig {
    let mut config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = CASES;
    }
    if config.rng_seed == RngSeed::Random {
        config.rng_seed = RngSeed::Fixed(1);
    }
    config
}
