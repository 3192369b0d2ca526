/work/main/benches/pixels/target/debug/deps/eigenshade_table-686d03b1e38c7b38.d: /work/main/crates/table/src/lib.rs /work/main/crates/table/src/scene.rs /work/main/crates/table/src/gram.rs /work/main/crates/table/src/general.rs /work/main/crates/table/src/table.rs /work/main/crates/table/src/transfer.rs /work/main/crates/table/src/check.rs /work/main/crates/table/src/file.rs /work/main/crates/table/src/manifest.rs /work/main/crates/table/src/polynomials.rs /work/main/crates/table/src/parts.rs /work/main/crates/table/src/passes.rs /work/main/crates/table/src/components.rs /work/main/crates/table/src/cut.rs /work/main/crates/table/src/trim.rs /work/main/crates/table/src/quantise.rs /work/main/crates/table/src/rust_kernels.rs /work/main/crates/table/src/rust_scene.rs /work/main/crates/table/src/rust_quantised.rs /work/main/crates/table/src/rust_quantised_functions.rs /work/main/crates/table/src/rust_source.rs /work/main/crates/table/src/statics.rs /work/main/crates/table/src/wire.rs

/work/main/benches/pixels/target/debug/deps/libeigenshade_table-686d03b1e38c7b38.rlib: /work/main/crates/table/src/lib.rs /work/main/crates/table/src/scene.rs /work/main/crates/table/src/gram.rs /work/main/crates/table/src/general.rs /work/main/crates/table/src/table.rs /work/main/crates/table/src/transfer.rs /work/main/crates/table/src/check.rs /work/main/crates/table/src/file.rs /work/main/crates/table/src/manifest.rs /work/main/crates/table/src/polynomials.rs /work/main/crates/table/src/parts.rs /work/main/crates/table/src/passes.rs /work/main/crates/table/src/components.rs /work/main/crates/table/src/cut.rs /work/main/crates/table/src/trim.rs /work/main/crates/table/src/quantise.rs /work/main/crates/table/src/rust_kernels.rs /work/main/crates/table/src/rust_scene.rs /work/main/crates/table/src/rust_quantised.rs /work/main/crates/table/src/rust_quantised_functions.rs /work/main/crates/table/src/rust_source.rs /work/main/crates/table/src/statics.rs /work/main/crates/table/src/wire.rs

/work/main/benches/pixels/target/debug/deps/libeigenshade_table-686d03b1e38c7b38.rmeta: /work/main/crates/table/src/lib.rs /work/main/crates/table/src/scene.rs /work/main/crates/table/src/gram.rs /work/main/crates/table/src/general.rs /work/main/crates/table/src/table.rs /work/main/crates/table/src/transfer.rs /work/main/crates/table/src/check.rs /work/main/crates/table/src/file.rs /work/main/crates/table/src/manifest.rs /work/main/crates/table/src/polynomials.rs /work/main/crates/table/src/parts.rs /work/main/crates/table/src/passes.rs /work/main/crates/table/src/components.rs /work/main/crates/table/src/cut.rs /work/main/crates/table/src/trim.rs /work/main/crates/table/src/quantise.rs /work/main/crates/table/src/rust_kernels.rs /work/main/crates/table/src/rust_scene.rs /work/main/crates/table/src/rust_quantised.rs /work/main/crates/table/src/rust_quantised_functions.rs /work/main/crates/table/src/rust_source.rs /work/main/crates/table/src/statics.rs /work/main/crates/table/src/wire.rs

/work/main/crates/table/src/lib.rs:
/work/main/crates/table/src/scene.rs:
/work/main/crates/table/src/gram.rs:
/work/main/crates/table/src/general.rs:
/work/main/crates/table/src/table.rs:
/work/main/crates/table/src/transfer.rs:
/work/main/crates/table/src/check.rs:
/work/main/crates/table/src/file.rs:
/work/main/crates/table/src/manifest.rs:
/work/main/crates/table/src/polynomials.rs:
/work/main/crates/table/src/parts.rs:
/work/main/crates/table/src/passes.rs:
/work/main/crates/table/src/components.rs:
/work/main/crates/table/src/cut.rs:
/work/main/crates/table/src/trim.rs:
/work/main/crates/table/src/quantise.rs:
/work/main/crates/table/src/rust_kernels.rs:
/work/main/crates/table/src/rust_scene.rs:
/work/main/crates/table/src/rust_quantised.rs:
/work/main/crates/table/src/rust_quantised_functions.rs:
/work/main/crates/table/src/rust_source.rs:
/work/main/crates/table/src/statics.rs:
/work/main/crates/table/src/wire.rs:
