//! Writes many numbers as text with a fixed number of decimals.

use crate::decimal;

/// The most decimals.
const MOST: u32 = 18;
/// Numbers with more digits than this are written by [`decimal`], which has all of them.
const LONG: f64 = 1e18;

/// Adds a number with at most `decimals` decimals and without trailing zeros.
pub(super) fn push(out: &mut Vec<u8>, x: f64, decimals: u32) {
    let scale = 10u64.pow(decimals.min(MOST));
    if x.is_finite() && x.abs() * scale as f64 >= LONG {
        out.extend_from_slice(decimal::text(x).as_bytes());
        return;
    }
    let whole = (x.abs() * scale as f64 + 0.5) as u64;
    if x < 0.0 && whole > 0 {
        out.push(b'-');
    }
    push_whole(out, whole / scale);
    let (mut rest, mut unit) = (whole % scale, scale);
    if rest > 0 {
        out.push(b'.');
    }
    while rest > 0 {
        unit /= 10;
        out.push(b'0' + (rest / unit) as u8);
        rest %= unit;
    }
}

/// Adds an integer.
pub(super) fn push_whole(out: &mut Vec<u8>, mut x: u64) {
    let start = out.len();
    loop {
        out.push(b'0' + (x % 10) as u8);
        x /= 10;
        if x == 0 {
            break;
        }
    }
    out[start..].reverse();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded() {
        for (x, wanted) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-1e-7, "0"),
            (0.5, "0.5"),
            (-0.0625, "-0.063"),
            (0.9996, "1"),
            (12.305, "12.305"),
            (99999.5, "99999.5"),
            (f64::NAN, "0"),
            (2e15, "2e15"),
            (-1e30, "-1e30"),
        ] {
            let mut out = Vec::new();
            push(&mut out, x, 3);
            assert_eq!(String::from_utf8_lossy(&out), wanted);
        }
        let mut out = Vec::new();
        push(&mut out, -1.5e-12, 14);
        assert_eq!(String::from_utf8_lossy(&out), "-0.0000000000015");
    }
}
