/work/main/benches/pixels/target/debug/deps/unty-4bc4b9dc431043da.d: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/unty-0.0.4/src/lib.rs

/work/main/benches/pixels/target/debug/deps/libunty-4bc4b9dc431043da.rlib: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/unty-0.0.4/src/lib.rs

/work/main/benches/pixels/target/debug/deps/libunty-4bc4b9dc431043da.rmeta: /root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/unty-0.0.4/src/lib.rs

/root/.cargo/registry/src/index.crates.io-1949cf8c6b5b557f/unty-0.0.4/src/lib.rs:
