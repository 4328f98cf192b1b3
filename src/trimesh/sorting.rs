//! Sorts long lists in slices.

/// Entries in a slice.
const SLICE: usize = 1 << 18;
/// Bits of a digit.
const BITS: u32 = 11;

/// Sorts pairs of a key and a number by their keys; pairs with equal keys keep their order (a radix sort, lowest digits
/// first).
#[derive(Clone, Debug)]
pub(super) struct Sorting {
    entries: Vec<(u64, u32)>,
    sorted: Vec<(u64, u32)>,
    /// The number of entries with each value of a digit; later the place of the next such entry.
    places: Vec<u32>,
    shift: u32,
    at: usize,
    counted: bool,
}

impl Sorting {
    pub fn new(entries: Vec<(u64, u32)>) -> Self {
        Self {
            sorted: Vec::new(),
            places: vec![0; 1 << BITS],
            shift: 0,
            at: 0,
            counted: false,
            entries,
        }
    }

    fn digit(&self, key: u64) -> usize {
        (key >> self.shift) as usize & ((1 << BITS) - 1)
    }

    /// Does one more slice; returns the sorted list when it is done.
    pub fn advance(&mut self) -> Option<Vec<(u64, u32)>> {
        let count = self.entries.len();
        let end = count.min(self.at + SLICE);
        for k in self.at..end {
            let entry = self.entries[k];
            let digit = self.digit(entry.0);
            let place = &mut self.places[digit];
            if self.counted {
                self.sorted[*place as usize] = entry;
            }
            *place += 1;
        }
        self.at = end;
        if end < count {
            return None;
        }
        self.at = 0;
        // If all entries have the same digit, they are in order already.
        let alike = self.places.iter().any(|&n| n as usize == count);
        if !self.counted && !alike {
            self.counted = true;
            let mut sum = 0;
            for place in &mut self.places {
                sum += std::mem::replace(place, sum);
            }
            self.sorted.resize(count, (0, 0));
            return None;
        }
        if self.counted {
            std::mem::swap(&mut self.entries, &mut self.sorted);
        }
        self.counted = false;
        self.places.fill(0);
        self.shift += BITS;
        (self.shift >= u64::BITS).then(|| std::mem::take(&mut self.entries))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::testing;

    fn sorted(entries: Vec<(u64, u32)>) -> Vec<(u64, u32)> {
        let mut sorting = Sorting::new(entries);
        std::iter::from_fn(|| Some(sorting.advance()))
            .find_map(|done| done)
            .unwrap()
    }

    #[test]
    fn entries_are_sorted_and_keep_their_order() {
        let mut chance = testing::chance(4);
        for (count, mask) in [
            (0, 0),
            (1, 0),
            (5000, 0xFF),
            (5000, u64::MAX),
            (600_000, 0xFFF_F000),
        ] {
            let list: Vec<(u64, u32)> = (0..count).map(|k| (chance.bits() & mask, k)).collect();
            let mut wanted = list.clone();
            wanted.sort();
            assert!(sorted(list) == wanted, "{count}");
        }
    }
}
