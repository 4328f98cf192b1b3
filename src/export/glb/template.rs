//! Templates of the JSON, and its numbers.

use crate::decimal;

/// Pads to a multiple of four bytes.
pub(super) fn fill_up(bytes: &mut Vec<u8>, by: u8) {
    while !bytes.len().is_multiple_of(4) {
        bytes.push(by);
    }
}

/// Adds a template, with numbers in place of each @.
pub(super) fn fill(json: &mut String, template: &str, numbers: &[f64]) {
    let mut numbers = numbers.iter();
    for (k, piece) in template.split('@').enumerate() {
        if k > 0 {
            *json += &numbers.next().map_or(String::new(), |&x| number(x));
        }
        *json += piece;
    }
}

/// Integers get no exponent: not all readers take 2e7 for an integer.
fn number(x: f64) -> String {
    let whole = x as u64;
    if whole as f64 == x {
        whole.to_string()
    } else {
        decimal::text(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_written_as_such() {
        for (x, wanted) in [
            (0.0, "0"),
            (12e6, "12000000"),
            (-0.5, "-0.5"),
            (1e-9, "1e-9"),
        ] {
            assert_eq!(number(x), wanted);
        }
    }
}
