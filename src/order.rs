//! Comparing and sorting numbers, the same way everywhere and cheaply in WebAssembly.

/// A sort key: the first number, then the second.
pub(crate) type SortKey = (u64, u64);

/// Sorts by a key, the smallest first; the sort is stable.
///
/// It sorts the keys together with the items' indices, so all lists share one sort. A separate sort for each
/// type of item would add copies of the standard library's sort to the WebAssembly module (docs/times.md).
pub(crate) fn sort<T>(items: &mut [T], key: impl Fn(&T) -> SortKey) {
    items.sort_by_cached_key(key);
}

/// Maps a number to an integer with the order of [`f64::total_cmp`].
pub(crate) fn rank(x: f64) -> u64 {
    let bits = x.to_bits();
    if bits >> 63 == 0 {
        bits | 1 << 63
    } else {
        !bits
    }
}

/// Two small numbers as one; the first is more significant.
pub(crate) fn pair(a: u32, b: u32) -> u64 {
    u64::from(a) << 32 | u64::from(b)
}

/// The greater of two numbers. `f32::max` is a function call on wasm32: a loop over pixels that could do four
/// at a time takes seven times as long with it.
#[inline(always)]
pub(crate) fn greater<T: PartialOrd>(a: T, b: T) -> T {
    if b > a { b } else { a }
}

/// The lesser of two numbers; see [`greater`].
#[inline(always)]
pub(crate) fn lesser<T: PartialOrd>(a: T, b: T) -> T {
    if b < a { b } else { a }
}

/// The numbers of the bits that are set, from the lowest.
#[cfg(house)]
pub(crate) fn set_bits(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = bits.trailing_zeros();
        bits &= bits.wrapping_sub(1);
        (bit < 32).then_some(bit as usize)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_are_in_the_order_of_the_numbers() {
        let numbers = [
            f64::NEG_INFINITY,
            -2.0,
            -1e-300,
            -0.0,
            0.0,
            1e-300,
            1.0,
            f64::INFINITY,
        ];
        assert!(numbers.windows(2).all(|w| rank(w[0]) < rank(w[1])));
    }

    #[cfg(house)]
    #[test]
    fn bits_are_numbered_from_the_lowest() {
        assert_eq!(set_bits(0b1010_0001).collect::<Vec<_>>(), [0, 5, 7]);
        assert_eq!(set_bits(0).count(), 0);
        assert_eq!(
            set_bits(u32::MAX).collect::<Vec<_>>(),
            (0..32).collect::<Vec<_>>()
        );
    }

    #[test]
    fn equal_items_keep_their_order() {
        let mut items: Vec<(u32, usize)> = (0..100).map(|k| ((k * 37 % 10) as u32, k)).collect();
        let mut wanted = items.clone();
        wanted.sort();
        sort(&mut items, |i| (i.0.into(), 0));
        assert_eq!(items, wanted);
        sort(&mut items, |i| (0, !pair(i.0, i.1 as u32)));
        wanted.reverse();
        assert_eq!(items, wanted);
    }
}
