//! The numbers of triangles of stones at each level of detail.

/// The approximate number of triangles of all stones together at the finest level.
const ALL: usize = 700_000;
/// The ratio of triangles between one level and the next.
const FINER: usize = 4;

/// The number of triangles of each of `stones` stones at the finest level, between `fewest` and `most`.
pub(crate) fn finest(stones: usize, [fewest, most]: [usize; 2]) -> usize {
    (ALL / stones.max(1)).clamp(fewest, most)
}

/// The number of triangles of a stone at each level, the finest first. Levels with fewer than `least` are left out.
pub(crate) fn levels(finest: usize, least: usize) -> impl Iterator<Item = usize> {
    let next = move |&count: &usize| Some(count / FINER).filter(|&count| count >= least);
    std::iter::successors(Some(finest), next)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_stones_are_finer_than_many() {
        let each = [100, 1500];
        assert_eq!(
            [0, 10, 1000, 100_000].map(|n| finest(n, each)),
            [1500, 1500, 700, 100]
        );
        assert!(levels(700, 28).eq([700, 175, 43]));
        assert!(levels(20, 28).eq([20]));
    }
}
