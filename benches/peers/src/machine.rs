//! What the figures were measured on, and with which versions.

/// Instruction sets, from the widest on.
macro_rules! widest {
    ($has:ident) => {
        [
            ("AVX-512", $has!("avx512f")),
            ("AVX2 with FMA", $has!("avx2") && $has!("fma")),
            ("AVX", $has!("avx")),
            ("SSE4.2", $has!("sse4.2")),
            ("SSE2", $has!("sse2")),
        ]
        .into_iter()
        .find_map(|(name, has)| has.then_some(name))
        .unwrap_or("none")
    };
}

#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
fn of_processor() -> &'static str {
    macro_rules! has {
        ($feature:tt) => {
            is_x86_feature_detected!($feature)
        };
    }
    widest!(has)
}

#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
fn of_build() -> &'static str {
    macro_rules! has {
        ($feature:tt) => {
            cfg!(target_feature = $feature)
        };
    }
    widest!(has)
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86")))]
fn of_processor() -> &'static str {
    of_build()
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86")))]
fn of_build() -> &'static str {
    if cfg!(target_feature = "neon") { "NEON" } else { "its own" }
}

/// One sentence for each.
pub fn described() -> String {
    let libraries = ["faer", "nalgebra", "ndarray", "sphrs"].map(|name| {
        let version = version(name).unwrap_or("?");
        format!("{name} {version}")
    });
    format!(
        "{}, one core. The processor has {}, the build may take {}; faer and ndarray choose theirs when they run. {}, ndarray \
         without BLAS.",
        std::env::consts::ARCH,
        of_processor(),
        of_build(),
        libraries.join(", ")
    )
}

/// As locked.
fn version(name: &str) -> Option<&'static str> {
    let lock = include_str!("../Cargo.lock");
    let (_, after) = lock.split_once(&format!("name = \"{name}\"\nversion = \""))?;
    after.split('"').next()
}

/// Marks of this build's part of the page.
pub fn marks() -> [&'static str; 2] {
    if of_build() == "SSE2" || cfg!(not(target_arch = "x86_64")) {
        ["<!-- default target -->", "<!-- end of default target -->"]
    } else {
        ["<!-- target-cpu=native -->", "<!-- end of target-cpu=native -->"]
    }
}
