/work/main/benches/pixels/target/debug/deps/eigenshade_pixels-2c94c8c36536a4e9.d: src/main.rs src/calls.rs src/counts.rs src/images.rs src/inputs.rs src/limit.rs src/long.rs src/page.rs src/place.rs src/times.rs

/work/main/benches/pixels/target/debug/deps/libeigenshade_pixels-2c94c8c36536a4e9.rmeta: src/main.rs src/calls.rs src/counts.rs src/images.rs src/inputs.rs src/limit.rs src/long.rs src/page.rs src/place.rs src/times.rs

src/main.rs:
src/calls.rs:
src/counts.rs:
src/images.rs:
src/inputs.rs:
src/limit.rs:
src/long.rs:
src/page.rs:
src/place.rs:
src/times.rs:

# env-dep:CARGO_MANIFEST_DIR=/work/main/benches/pixels
