//! How many triangles stones have at each level of detail.

/// About how many triangles all stones have at the finest level.
const ALL: usize = 700_000;
/// Each level has this many times the triangles of the next one.
const FINER: usize = 4;

/// Triangles of each of some stones at the finest level, between the fewest and the most that one may have.
pub(crate) fn finest(stones: usize, [fewest, most]: [usize; 2]) -> usize {
    (ALL / stones.max(1)).clamp(fewest, most)
}

/// Triangles of a stone at each level, the finest first; coarser ones have at least `least`.
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
