//! Words and numbers of text files.

use crate::decimal;

/// The length of the byte order mark that some programs put first.
pub(super) fn mark(bytes: &[u8]) -> usize {
    if bytes.starts_with(b"\xEF\xBB\xBF") {
        3
    } else {
        0
    }
}

/// The line that begins at `at`, without its end; moves `at` to the next one. Lines end with LF, CR LF or CR. Nothing
/// if the line has more than `most` bytes.
pub(super) fn next_line<'a>(bytes: &'a [u8], at: &mut usize, most: usize) -> Option<&'a [u8]> {
    let rest = &bytes[*at..];
    let near = &rest[..rest.len().min(most)];
    let length = near.iter().position(|b| b"\r\n".contains(b));
    let length = match length {
        Some(length) => length,
        None if near.len() == rest.len() => rest.len(),
        None => return None,
    };
    let (line, end) = rest.split_at(length);
    *at += length + if end.starts_with(b"\r\n") { 2 } else { 1 }.min(end.len());
    Some(line)
}

/// Counts lines as a reader goes on, so that a notice need not count from the start.
#[derive(Default)]
pub(super) struct LineCount {
    at: usize,
    ends: usize,
}

impl LineCount {
    /// Goes on to a place; returns the number of its line, from 1.
    pub fn reach(&mut self, bytes: &[u8], place: usize) -> usize {
        let is_end = |k: &usize| match bytes[*k] {
            b'\r' => bytes.get(k + 1) != Some(&b'\n'),
            byte => byte == b'\n',
        };
        self.ends += (self.at..place).filter(is_end).count();
        self.at = self.at.max(place);
        1 + self.ends
    }
}

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

/// The longest run of letters or of white space that is taken at a time, in bytes.
const RUN: usize = 1 << 20;

/// The next word at or after `at`; moves `at` behind it. A word longer than [`RUN`] comes in parts. White space longer
/// than [`RUN`] gives an empty word.
pub(super) fn next_word<'a>(bytes: &'a [u8], at: &mut usize) -> Option<&'a [u8]> {
    let rest = bytes.get(*at..)?;
    let near = &rest[..rest.len().min(RUN)];
    let Some(start) = near.iter().position(|b| !b.is_ascii_whitespace()) else {
        *at += near.len();
        return (near.len() < rest.len()).then_some(&[]);
    };
    let word = &rest[start..rest.len().min(start + RUN)];
    let length = word.iter().position(u8::is_ascii_whitespace);
    let length = length.unwrap_or(word.len());
    *at += start + length;
    Some(&word[..length])
}

/// The longest text of a number, in bytes.
const LONGEST: usize = 1000;

/// The double nearest to a decimal number; `None` if the word is not a number. Most numbers have few digits and need no
/// long division (Clinger 1990, How to Read Floating Point Numbers Accurately).
pub(super) fn number(word: &[u8]) -> Option<f64> {
    if word.len() > LONGEST {
        return None;
    }
    let (is_negative, plain) = match word {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        rest => (false, rest),
    };
    let size = match short(plain) {
        Some((digits, power)) => quickly(digits, power),
        None => None,
    };
    let size = match size {
        Some(size) => size,
        None if plain.first().is_some_and(|b| b"+-".contains(b)) => return None,
        None => decimal::parse(std::str::from_utf8(plain).ok()?)?,
    };
    Some(if is_negative { -size } else { size })
}

/// The digits as an integer, and the power of ten to multiply it by. `None` if there are too many digits, or the word
/// is no number.
fn short(plain: &[u8]) -> Option<(u64, i32)> {
    let (mut digits, mut count, mut power) = (0u64, 0, 0);
    let mut has_point = false;
    for (k, &byte) in plain.iter().enumerate() {
        match byte {
            b'0'..=b'9' => {
                if count == 19 || k > 40 {
                    return None;
                }
                digits = 10 * digits + u64::from(byte - b'0');
                // Leading zeros do not count.
                count += i32::from(digits > 0);
                power -= i32::from(has_point);
            }
            b'.' if !has_point => has_point = true,
            b'e' | b'E' if k > 0 => {
                power += exponent(&plain[k + 1..])?;
                return plain[..k]
                    .iter()
                    .any(u8::is_ascii_digit)
                    .then_some((digits, power));
            }
            _ => return None,
        }
    }
    plain
        .iter()
        .any(u8::is_ascii_digit)
        .then_some((digits, power))
}

fn exponent(word: &[u8]) -> Option<i32> {
    let (sign, digits) = match word {
        [b'-', rest @ ..] => (-1, rest),
        [b'+', rest @ ..] => (1, rest),
        rest => (1, rest),
    };
    let fits = (1..=3).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    fits.then(|| {
        sign * digits
            .iter()
            .fold(0, |sum, b| 10 * sum + i32::from(b - b'0'))
    })
}

fn quickly(digits: u64, power: i32) -> Option<f64> {
    if digits == 0 {
        return Some(0.0);
    }
    if digits < 1 << 53 {
        return decimal::short(digits, power);
    }
    if !(-19..=0).contains(&power) {
        return None;
    }
    // The quotient has more bits than a double. Its last bit tells whether there is a remainder.
    let zeros = digits.leading_zeros();
    let over = u128::from(digits << zeros) << 63;
    let under = 10u128.pow(power.unsigned_abs());
    let quotient = (over / under) | u128::from(!over.is_multiple_of(under));
    let two_to = f64::from_bits(u64::from(1023 - 63 - zeros) << 52);
    Some(quotient as f64 * two_to)
}

/// An integer of at least 0.
pub(super) fn whole(word: &[u8]) -> Option<u64> {
    let fits = (1..=18).contains(&word.len()) && word.iter().all(u8::is_ascii_digit);
    fits.then(|| word.iter().fold(0, |sum, b| 10 * sum + u64::from(b - b'0')))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::testing;

    fn same(word: &str) {
        let wanted = word.parse::<f64>().ok().map(f64::to_bits);
        assert_eq!(number(word.as_bytes()).map(f64::to_bits), wanted, "{word}");
    }

    #[test]
    fn numbers_are_read_as_the_standard_library_does() {
        let mut chance = testing::chance(6);
        for _ in 0..20_000 {
            let x = chance.signed();
            for word in [
                format!("{x}"),
                format!("{x:.6}"),
                format!("{x:e}"),
                format!("{}", x as f32),
                format!("{:.9}", 1e5 * x),
                format!("{}", 1e8 * x),
                format!("{:.25}", x),
                format!("{}", f64::from_bits(chance.bits() >> 1).min(1e308)),
            ] {
                same(&word);
            }
        }
        for word in [
            "0",
            "-0",
            ".5",
            "5.",
            "-.5e3",
            "1e22",
            "1e23",
            "9007199254740993",
            "18446744073709551615",
            "1e-5",
            "1E+5",
            "0.0000000000000000000000000000000000000000000000000001",
            "00000000000000000000000000000000000000000000001",
        ] {
            same(word);
        }
    }

    #[test]
    fn lines_end_in_three_ways() {
        let text = b"a\nb\r\nc\rd\n\n\re";
        let (mut at, mut lines, mut count) = (0, Vec::new(), LineCount::default());
        while at < text.len() {
            assert_eq!(count.reach(text, at), lines.len() + 1);
            lines.push(next_line(text, &mut at, 9).unwrap());
        }
        assert_eq!(lines, [&b"a"[..], b"b", b"c", b"d", b"", b"", b"e"]);
        assert_eq!(next_line(text, &mut 0, 1), None);
        assert_eq!(next_line(&text[..1], &mut 0, 1), Some(&b"a"[..]));
    }

    #[test]
    fn long_runs_come_in_parts() {
        let text = [vec![b' '; RUN + 1], vec![b'a'; RUN + 1]].concat();
        let mut at = 0;
        let words = std::iter::from_fn(|| next_word(&text, &mut at).map(<[u8]>::len));
        assert_eq!(words.collect::<Vec<_>>(), [0, RUN, 1]);
        assert_eq!(number(&[b'1'; LONGEST + 1]), None);
    }

    #[test]
    fn other_words_are_no_numbers() {
        for word in [
            "", "-", ".", "e5", "1e", "1e+", "--1", "+-1", "1.2.3", "ten", "1,5", "-e1", ".e1",
            "nan", "inf",
        ] {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
        assert_eq!(whole(b"12"), Some(12));
        assert_eq!(whole(b"-12").or(whole(b"")).or(whole(&[b'9'; 30])), None);
    }
}
