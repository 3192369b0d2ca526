/work/main/benches/pixels/target/debug/deps/eigenshade_index-7e816108a17e7bab.d: /work/main/crates/index/src/lib.rs /work/main/crates/index/src/effect.rs /work/main/crates/index/src/layout.rs /work/main/crates/index/src/light.rs /work/main/crates/index/src/material.rs /work/main/crates/index/src/mode.rs /work/main/crates/index/src/pair.rs /work/main/crates/index/src/wire.rs

/work/main/benches/pixels/target/debug/deps/libeigenshade_index-7e816108a17e7bab.rmeta: /work/main/crates/index/src/lib.rs /work/main/crates/index/src/effect.rs /work/main/crates/index/src/layout.rs /work/main/crates/index/src/light.rs /work/main/crates/index/src/material.rs /work/main/crates/index/src/mode.rs /work/main/crates/index/src/pair.rs /work/main/crates/index/src/wire.rs

/work/main/crates/index/src/lib.rs:
/work/main/crates/index/src/effect.rs:
/work/main/crates/index/src/layout.rs:
/work/main/crates/index/src/light.rs:
/work/main/crates/index/src/material.rs:
/work/main/crates/index/src/mode.rs:
/work/main/crates/index/src/pair.rs:
/work/main/crates/index/src/wire.rs:
