//! Reads and writes decimal numbers, rounded like the standard library. The standard library is faster but
//! takes a twentieth of the WebAssembly module (docs/times.md), and numbers in links, sentences and reports
//! are few.

mod natural;

use natural::Natural;
use std::cmp::Ordering;

/// If the first digit's power of ten is outside this range, the number is infinite or 0.
const POWERS: std::ops::RangeInclusive<i64> = -330..=310;
/// More digits than any halfway point between doubles has.
const DIGITS: usize = 800;

/// Powers of ten that are exact as doubles.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Decimals with at most this many digits all read back as different doubles.
const SHORT: usize = 15;

/// The double nearest to `digits` (below 2^53) times ten to the power (Clinger 1990, How to Read Floating Point Numbers
/// Accurately): both are exact, so the result is rounded once. `None` if the power is not exact as a double.
pub(crate) fn short(digits: u64, power: i32) -> Option<f64> {
    let ten = TENS.get(power.unsigned_abs() as usize)?;
    let digits = digits as f64;
    Some(if power < 0 {
        digits / ten
    } else {
        digits * ten
    })
}

/// The double nearest to a decimal number such as `-12.5e-3`, ties to even; `None` for any other text,
/// including words for infinity. Numbers too large for a double give infinity.
pub(crate) fn parse(text: &str) -> Option<f64> {
    let (negative, plain) = match text.as_bytes() {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        rest => (false, rest),
    };
    let size = magnitude(plain)?;
    Some(if negative { -size } else { size })
}

fn magnitude(text: &[u8]) -> Option<f64> {
    let (mut digits, mut power) = (Vec::new(), 0i64);
    let (mut any, mut point) = (false, false);
    let mut at = 0;
    while let Some(&byte) = text.get(at) {
        match byte {
            b'0'..=b'9' => {
                any = true;
                power -= i64::from(point);
                match digits.len() {
                    0 if byte == b'0' => {}
                    DIGITS.. => power += 1,
                    _ => digits.push(byte - b'0'),
                }
            }
            b'.' if !point => point = true,
            b'e' | b'E' => break,
            _ => return None,
        }
        at += 1;
    }
    if !any {
        return None;
    }
    if at < text.len() {
        power = power.saturating_add(exponent(&text[at + 1..])?);
    }
    let first = power.saturating_add(digits.len() as i64);
    Some(match (digits.is_empty(), POWERS.contains(&first)) {
        (true, _) => 0.0,
        (false, true) => nearest(&digits, power),
        (false, false) if first < 0 => 0.0,
        _ => f64::INFINITY,
    })
}

fn exponent(text: &[u8]) -> Option<i64> {
    let (negative, digits) = match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        rest => (false, rest),
    };
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let add = |sum: i64, d: &u8| (10 * sum + i64::from(d - b'0')).min(1_000_000);
    let size = digits.iter().fold(0, add);
    Some(if negative { -size } else { size })
}

/// The double nearest to the digits times ten to the power.
fn nearest(digits: &[u8], power: i64) -> f64 {
    let quick = match digits.len() {
        0..=SHORT => short(whole(digits), power as i32),
        _ => None,
    };
    quick.unwrap_or_else(|| divided(digits, power))
}

fn whole(digits: &[u8]) -> u64 {
    digits.iter().fold(0, |sum, &d| 10 * sum + u64::from(d))
}

/// Like `nearest`, by a long division in the binary system.
fn divided(digits: &[u8], power: i64) -> f64 {
    let (mut over, mut under) = (Natural::default(), Natural::one());
    digits.iter().for_each(|&d| over.scale(10, d.into()));
    for _ in 0..power.abs() {
        if power > 0 { &mut over } else { &mut under }.scale(10, 0);
    }
    // Scale the quotient into 1..2, adjusting the exponent.
    let mut exponent = 0i32;
    while over.compare(&under) != Ordering::Less {
        under.scale(2, 0);
        exponent += 1;
    }
    while over.compare(&under) == Ordering::Less {
        over.scale(2, 0);
        exponent -= 1;
    }
    // Subnormal doubles have fewer bits.
    let lowest = (exponent - 52).max(-1074);
    let mut bits = 0u64;
    for _ in lowest..=exponent {
        let one = over.compare(&under) != Ordering::Less;
        if one {
            over.subtract(&under);
        }
        bits = 2 * bits + u64::from(one);
        over.scale(2, 0);
    }
    // If no bit fits, the quotient is at most half of the smallest double.
    if lowest > exponent + 1 {
        return 0.0;
    }
    let up = match over.compare(&under) {
        Ordering::Less => false,
        Ordering::Equal => bits & 1 == 1,
        Ordering::Greater => true,
    };
    bits += u64::from(up);
    // Two exact factors: the first product is exact, and so is the second unless it is infinite.
    let two_to = |n: i32| f64::from_bits(((n + 1023) as u64) << 52);
    let half = lowest / 2;
    bits as f64 * two_to(half) * two_to(lowest - half)
}

/// The shortest decimal text that reads back as the same bits, in scientific notation if that is much
/// shorter: `0.1`, `-23`, `1e300`.
pub(crate) fn text(x: f64) -> String {
    if !x.is_finite() {
        return "not a finite number".to_owned();
    }
    let (digits, first) = shortest(x.abs());
    let ciphers =
        |digits: &[u8]| -> String { digits.iter().map(|&d| (b'0' + d) as char).collect() };
    let zeros = |count: i64| "0".repeat(count.max(0) as usize);
    let whole = digits.len().min((first + 1).max(0) as usize);
    let mut plain = ciphers(&digits[..whole]) + &zeros(first + 1 - whole as i64);
    if whole == 0 {
        plain.push('0');
    }
    if whole < digits.len() {
        plain.push('.');
        plain += &(zeros(-1 - first) + &ciphers(&digits[whole..]));
    }
    let mut power = ciphers(&digits[..1]);
    if digits.len() > 1 {
        power.push('.');
        power += &ciphers(&digits[1..]);
    }
    power.push('e');
    power += &first.to_string();
    let sign = if x.is_sign_negative() { "-" } else { "" };
    let is_long = power.len() + 2 < plain.len();
    sign.to_owned() + if is_long { &power } else { &plain }
}

/// A number rounded to this many places behind the point. If it becomes 0, it has no sign.
pub(crate) fn round_to(places: usize, x: f64) -> f64 {
    let ten = TENS[places];
    // Adding 0 turns -0 into 0.
    (x * ten).round() / ten + 0.0
}

/// The text of a number that is rounded to this many places behind the point.
pub(crate) fn text_to(places: usize, x: f64) -> String {
    text(round_to(places, x))
}

/// The fewest digits that read back as a double, and the power of ten of the first.
fn shortest(x: f64) -> (Vec<u8>, i64) {
    if x == 0.0 {
        return (vec![0], 0);
    }
    if let Some(digits) = few(x) {
        return digits;
    }
    let (digits, first) = exact(x);
    for count in 1..MOST {
        let (digits, first) = rounded(&digits, first, count);
        if nearest(&digits, first + 1 - digits.len() as i64) == x {
            return (digits, first);
        }
    }
    rounded(&digits, first, MOST)
}

/// The most places behind the point that [`few`] tries.
const PLACES: i32 = 6;

/// Like `shortest`, for a positive double with few digits and few places behind the point, as most numbers of links.
fn few(x: f64) -> Option<(Vec<u8>, i64)> {
    (0..=PLACES).find_map(|places| {
        let scaled = (x * TENS[places as usize]).round();
        let fits = scaled < TENS[SHORT] && short(scaled as u64, -places) == Some(x);
        let written = fits.then(|| (scaled as u64).to_string())?;
        let first = written.len() as i64 - 1 - i64::from(places);
        let digits = written.trim_end_matches('0').bytes();
        Some((digits.map(|byte| byte - b'0').collect(), first))
    })
}

/// This many digits distinguish any two doubles.
const MOST: usize = 17;

/// The first digits of a positive double, one more than needed, and the power of ten of the first digit.
fn exact(x: f64) -> (Vec<u8>, i64) {
    let (exponent, fraction) = ((x.to_bits() >> 52) as i32, x.to_bits() << 12 >> 12);
    let hidden = u64::from(exponent > 0) << 52;
    let (mut over, mut under) = (Natural::default(), Natural::one());
    let mantissa = fraction | hidden;
    over.scale(1, (mantissa >> 32) as u32);
    over.scale(1 << 16, 0);
    over.scale(1 << 16, mantissa as u32);
    let twos = exponent.max(1) - 1075;
    for _ in 0..twos.abs() {
        if twos > 0 { &mut over } else { &mut under }.scale(2, 0);
    }
    let mut first = 0;
    while over.compare(&under) != Ordering::Less {
        under.scale(10, 0);
        first += 1;
    }
    while over.compare(&under) == Ordering::Less {
        over.scale(10, 0);
        first -= 1;
    }
    let digit = |_| {
        let mut digit = 0;
        while over.compare(&under) != Ordering::Less {
            over.subtract(&under);
            digit += 1;
        }
        over.scale(10, 0);
        digit
    };
    ((0..=MOST).map(digit).collect(), first)
}

/// The first `count` digits, rounded, and the power of ten of the first digit.
fn rounded(digits: &[u8], first: i64, count: usize) -> (Vec<u8>, i64) {
    let mut kept = digits[..count].to_vec();
    if digits[count] < 5 {
        return (kept, first);
    }
    while kept.last() == Some(&9) {
        kept.pop();
    }
    match kept.last_mut() {
        Some(last) => *last += 1,
        None => return (vec![1], first + 1),
    }
    (kept, first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn same(text: &str) {
        let wanted = text.parse::<f64>().ok().map(f64::to_bits);
        assert_eq!(parse(text).map(f64::to_bits), wanted, "{text}");
    }

    #[test]
    fn numbers_of_all_sizes_are_read_as_the_standard_library_does() {
        for text in [
            "0",
            "-0",
            "1",
            "+5",
            ".5",
            "5.",
            "0.1",
            "23",
            "1e3",
            "1E-3",
            "-12.50e+1",
            "0.30000000000000004",
            "1e308",
            "1.7976931348623157e308",
            "1.7976931348623159e308",
            "1e309",
            "1e99999999999999999999",
            "2.2250738585072014e-308",
            "2.2250738585072011e-308",
            "5e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "1e-400",
            "9007199254740993",
            "9007199254740992.5",
            "0.000000000000000001",
            "123456789012345678901234567890",
            "000000000000000000000000000001.50",
        ] {
            same(text);
        }
        same(&format!("0.{}1e350", "0".repeat(400)));
        same(&format!("1{}e-900", "0".repeat(900)));
        same(&format!("9007199254740992.5{}1", "0".repeat(780)));
    }

    #[test]
    fn other_texts_are_no_numbers() {
        for text in [
            "", ".", "-", "+", "e5", "1e", "1e+", "1.2.3", "1 ", " 1", "0x10", "1e5.0", "--1",
            "ten", "1_0", "٣",
        ] {
            assert_eq!(parse(text), None, "{text}");
            same(text);
        }
        assert_eq!(parse("inf").or(parse("NaN")), None);
    }

    #[test]
    fn numbers_are_written_short() {
        for (x, wanted) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-23.5, "-23.5"),
            (0.1 + 0.2, "0.30000000000000004"),
            (0.00025, "0.00025"),
            (1e-7, "1e-7"),
            (1200.0, "1200"),
            (123_456_789.0, "123456789"),
            (1e22, "1e22"),
            (-1.25e-300, "-1.25e-300"),
            (f64::MAX, "1.7976931348623157e308"),
            (f64::MIN_POSITIVE, "2.2250738585072014e-308"),
            (5e-324, "5e-324"),
            (f64::NAN, "not a finite number"),
        ] {
            assert_eq!(text(x), wanted);
        }
    }

    #[test]
    fn what_rounds_to_zero_has_no_sign() {
        for (places, x, wanted) in [
            (2, -0.004, "0"),
            (2, -0.006, "-0.01"),
            (3, -0.0, "0"),
            (0, -0.4, "0"),
            (1, -12.34, "-12.3"),
        ] {
            assert_eq!(text_to(places, x), wanted);
        }
    }

    proptest! {
        #[test]
        fn every_double_is_written_and_read_back(bits in any::<u64>()) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            let text = text(x);
            prop_assert!(text.trim_start_matches('-').len() <= format!("{:e}", x.abs()).len() + 3, "{}", text);
            prop_assert_eq!(parse(&text).map(f64::to_bits), Some(bits), "{}", text);
        }

        #[test]
        fn short_decimals_are_written_as_the_standard_library_does(digits in 1u64..3_000_000_000, places in 0i32..12) {
            let x = short(digits, -places).unwrap();
            // Without the powers of ten, the standard library writes the shortest digits, too.
            if x > 1e-4 && x < 1e5 {
                prop_assert_eq!(text(x), x.to_string());
            }
            let digits = digits.to_string().bytes().map(|b| b - b'0').collect::<Vec<u8>>();
            prop_assert_eq!(divided(&digits, -i64::from(places)).to_bits(), x.to_bits());
        }

        #[test]
        fn every_double_is_read_back(bits in any::<u64>()) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            for text in [format!("{x}"), format!("{x:e}")] {
                prop_assert_eq!(parse(&text).map(f64::to_bits), Some(bits), "{}", text);
            }
        }

        #[test]
        fn all_decimals_are_rounded_the_same_way(text in "-?[0-9]{1,25}(\\.[0-9]{0,25})?(e-?[0-9]{1,3})?") {
            prop_assert_eq!(parse(&text).map(f64::to_bits), text.parse::<f64>().ok().map(f64::to_bits));
        }
    }
}
