//! Comparing and sorting numbers, the same way everywhere and cheaply in WebAssembly.
//!
//! All lists are sorted through one list of plain keys. Sorted each by itself, every type of item
//! would bring its own copy of the standard library's sort into the program: ten of them made a
//! fifth of the WebAssembly module.

/// What items are sorted by: the first number, then the second.
pub(crate) type Key = (u64, u64);

/// Sorts by a key, the smallest first; equal ones keep their order.
pub(crate) fn sort<T>(items: &mut [T], key: impl Fn(&T) -> Key) {
    if items.len() < 2 {
        return;
    }
    let mut order: Vec<(Key, u32)> = items.iter().map(key).zip(0..).collect();
    sort_keys(&mut order);
    // Cycle by cycle: place k takes the item at order[k].
    for first in 0..items.len() {
        let mut k = first;
        loop {
            let from = order[k].1 as usize;
            order[k].1 = k as u32;
            if from == first {
                break;
            }
            items.swap(k, from);
            k = from;
        }
    }
}

/// Not inlined: the sort of a few keys is, with every call, otherwise.
#[inline(never)]
fn sort_keys(keys: &mut [(Key, u32)]) {
    keys.sort_unstable();
}

/// A number in the order of [`f64::total_cmp`].
pub(crate) fn rank(x: f64) -> u64 {
    let bits = x.to_bits();
    if bits >> 63 == 0 {
        bits | 1 << 63
    } else {
        !bits
    }
}

/// Two small numbers as one, the first the more important.
pub(crate) fn pair(a: u32, b: u32) -> u64 {
    u64::from(a) << 32 | u64::from(b)
}

/// The greater of two numbers. `f32::max` is a call of a function on wasm32: a loop over pixels that
/// could do four at a time takes seven times as long with it.
#[inline(always)]
pub(crate) fn greater<T: PartialOrd>(a: T, b: T) -> T {
    if b > a { b } else { a }
}

/// The lesser of two numbers; see [`greater`].
#[inline(always)]
pub(crate) fn lesser<T: PartialOrd>(a: T, b: T) -> T {
    if b < a { b } else { a }
}

/// The number, or the limit that it is beyond. `f64::clamp` has the limits in a message of its own,
/// with all that writes numbers.
#[inline(always)]
pub(crate) fn within<T: PartialOrd>(x: T, least: T, most: T) -> T {
    lesser(greater(x, least), most)
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
