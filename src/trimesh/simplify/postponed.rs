//! Candidates for a collapse that wait outside of the queue. A queue of all edges of a large surface would jump through
//! its whole memory for each of them. So only the cheapest edges stand in the queue, and all others in an unsorted
//! list.

use crate::order::rank;
use crate::solid::Collapse;

/// Up to this many candidates go to the queue together.
const FEW: usize = 1 << 12;
/// About [`COMPARED`] candidates are sorted to find a limit, which is the one with the index [`CHEAP`].
const COMPARED: usize = 256;
const CHEAP: usize = 32;

/// The order of candidates: by the ranks of their costs, then by their ends.
type EdgeOrder = (u64, [u32; 2]);

/// Candidates that are not in the queue yet.
#[derive(Default)]
pub(super) struct PostponedEdges {
    /// Candidates up to this one go to the queue.
    limit: EdgeOrder,
    /// For each candidate its cost, its ends, and how often the ends had changed when it was offered.
    list: Vec<(f64, [u32; 2], u32)>,
}

impl PostponedEdges {
    /// Puts a candidate into the queue, or keeps it for later.
    pub fn offer(&mut self, queue: &mut Collapse, ends: [u32; 2], cost: f64) {
        match (rank(cost), ends) <= self.limit {
            true => queue.offer(ends, cost),
            false => self.list.push((cost, ends, queue.changed(ends))),
        }
    }

    /// Puts the cheapest candidates into the empty queue, and drops those whose ends have changed. False if no
    /// candidate was waiting.
    pub fn refill(&mut self, queue: &mut Collapse) -> bool {
        if self.list.is_empty() {
            return false;
        }
        let limit = self.next_limit();
        self.list.retain(|&(cost, ends, changes)| {
            let (waits, is_current) = ((rank(cost), ends) > limit, queue.changed(ends) == changes);
            if is_current && !waits {
                queue.offer(ends, cost);
            }
            is_current && waits
        });
        self.limit = limit;
        true
    }

    /// A limit that some of the candidates do not exceed.
    fn next_limit(&self) -> EdgeOrder {
        if self.list.len() <= FEW {
            return (u64::MAX, [u32::MAX; 2]);
        }
        let some = self.list.iter().step_by(self.list.len() / COMPARED);
        let mut some: Vec<EdgeOrder> = some.map(|&(cost, ends, _)| (rank(cost), ends)).collect();
        some.sort_unstable();
        some[CHEAP]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// Many candidates, of which many cost the same.
    fn candidates() -> impl Iterator<Item = ([u32; 2], f64)> {
        let numbers = std::iter::successors(Some(1u32), |n| {
            Some(n.wrapping_mul(1_664_525).wrapping_add(1_013_904_223))
        });
        numbers
            .take(30_000)
            .map(|n| ([n >> 24, 256 + (n >> 16 & 255)], f64::from(n >> 8 & 15)))
    }

    /// The ends of all candidates in their order; each of the first ones offers another candidate.
    fn order(
        mut offer: impl FnMut(&mut Collapse, [u32; 2], f64),
        mut refill: impl FnMut(&mut Collapse) -> bool,
    ) -> Vec<[u32; 2]> {
        let mut queue = Collapse::new(vec![DVec3::ZERO; 512], Vec::new());
        candidates().for_each(|(ends, cost)| offer(&mut queue, ends, cost));
        let (mut taken, mut more) = (Vec::new(), candidates().take(10_000));
        loop {
            match queue.take() {
                Some((ends, _)) => taken.push(ends),
                None if refill(&mut queue) => continue,
                None => return taken,
            }
            if let Some((ends, cost)) = more.next() {
                offer(&mut queue, ends, cost + 3.0);
            }
        }
    }

    #[test]
    fn waiting_changes_no_order() {
        let postponed = std::cell::RefCell::new(PostponedEdges::default());
        let mut longest = 0;
        let waited = order(
            |queue, ends, cost| postponed.borrow_mut().offer(queue, ends, cost),
            |queue| {
                let is_refilled = postponed.borrow_mut().refill(queue);
                longest = longest.max(postponed.borrow().list.len());
                is_refilled
            },
        );
        let plain = order(Collapse::offer, |_| false);
        assert_eq!(waited.len(), 40_000);
        assert!(waited == plain);
        // Most of them are not in the queue at first.
        assert!(longest > 20_000, "{longest}");
    }
}
