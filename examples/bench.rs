//! Measures the stages natively: one JSON object {"name", "ms"} a line, the shortest of several runs in milliseconds.
//!
//!     cargo run --release --example bench

#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(not(target_arch = "wasm32"))]
#[path = "../benches/suite.rs"]
mod suite;

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    for timing in suite::run(&mut native::clock()) {
        let name = bubblestone::export::text(&timing.name);
        println!("{{\"name\":{name},\"ms\":{}}}", timing.ms);
    }
}
