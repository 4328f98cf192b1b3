//! Model files that are refused, with the same sentence on every machine. Each line of `refusals.txt` has a name, the
//! bytes as hexadecimal digits, and the sentence; `node/shipped.test.mjs` compares with it, too.
//!
//! After an intended change: `BUBBLESTONE_UPDATE=1 cargo test --test refusals`.

// The tests under Node compare the sentences in WebAssembly.
#![cfg(not(target_arch = "wasm32"))]

mod common;
mod strangers;

use strangers::file_ends_well;

const GOLDEN: &str = include_str!("refusals.txt");

/// The bytes of hexadecimal digits.
fn bytes(hex: &str) -> Vec<u8> {
    let pair = |at: usize| u8::from_str_radix(&hex[at..at + 2], 16).expect("two digits");
    (0..hex.len()).step_by(2).map(pair).collect()
}

#[test]
fn refusals_are_the_same_everywhere() {
    let made = |line: &str| {
        let mut words = line.splitn(3, ' ');
        let (name, hex) = (words.next().unwrap(), words.next().unwrap());
        let end = file_ends_well("cn=60", name, bytes(hex), &mut || 0.0);
        assert!(end.cells.is_none(), "{name} is taken");
        format!("{name} {hex} {}\n", end.text)
    };
    let found: String = GOLDEN.lines().map(made).collect();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/refusals.txt");
        std::fs::write(path, found).unwrap();
        return;
    }
    assert_eq!(found, GOLDEN);
}
