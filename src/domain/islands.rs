//! The islands of an outline with several outer rings.
//!
//! One packing moves the cells of all islands, but they exert no force across a gap ([`Domain::is_parted`]).
//! The boundary rows, the mesh and the fitted cells are made island by island, each as its own domain. The
//! direction field is shared by all rings.

use super::Domain;
use super::nesting::owners;
use super::segment_grid::SegmentGrid;
use crate::order;
use glam::DVec2;

/// Squares along the larger side of the box around the outline.
const SQUARES: f64 = 64.0;

/// The islands of a domain that has more than one.
#[derive(Clone, Debug)]
pub(super) struct Islands {
    /// Each island as its own domain, with the lines inside it. They are sorted from the top, and from the
    /// left at equal heights.
    pub domains: Vec<Domain>,
    /// The island of each segment of the outline.
    pub of: Vec<u32>,
    grid: SegmentGrid,
}

impl Islands {
    /// `None` if there is only one island.
    pub fn new(domain: &Domain) -> Option<Self> {
        let rings = domain.rings();
        let owners = owners(rings);
        let mut outer: Vec<usize> = (0..rings.len()).filter(|&k| owners[k] == k).collect();
        if outer.len() < 2 {
            return None;
        }
        order::sort(&mut outer, |&k| {
            let heights = rings[k]
                .iter()
                .map(|p| (order::rank(p.y), order::rank(p.x)));
            heights.min().unwrap_or_default()
        });
        let mut number = vec![0; rings.len()];
        for (island, &ring) in (0..).zip(&outer) {
            number[ring] = island;
        }
        let of = rings.iter().zip(&owners);
        let of: Vec<u32> = of
            .flat_map(|(ring, &owner)| std::iter::repeat_n(number[owner], ring.len()))
            .collect();
        let (lo, hi) = domain.bounds();
        let step = (hi - lo).max_element() / SQUARES;
        let grid = SegmentGrid::new((lo, hi), 0.0, step, domain.segments(), 0.0);
        let domains = (0..)
            .zip(&outer)
            .map(|(island, &ring)| {
                let holes = (0..rings.len()).filter(|&k| k != ring && owners[k] == ring);
                let rings = std::iter::once(ring).chain(holes);
                let inside = |line: &&Vec<DVec2>| {
                    let middle = line[0].midpoint(line[1]);
                    of[domain.nearest(middle).segment] == island
                };
                let lines: Vec<_> = domain.lines().iter().filter(inside).cloned().collect();
                let rings = rings.map(|k| domain.rings()[k].clone());
                Domain::of_rings(rings.collect(), Some(domain)).with_lines(&lines)
            })
            .collect();
        Some(Self { domains, of, grid })
    }

    /// Whether the boundary may pass between two places, or near them.
    pub fn is_near(&self, a: DVec2, b: DVec2) -> bool {
        self.grid.any(a, b, |_| true)
    }
}

impl Domain {
    /// The islands, each as a domain of its own with the constraint lines inside; from the top, at equal heights from
    /// the left. If there is only one island, it is this domain itself.
    pub fn islands(&self) -> &[Domain] {
        match &self.islands {
            Some(islands) => &islands.domains,
            None => std::slice::from_ref(self),
        }
    }

    /// The number of the island that contains a point; outside, of the nearest island.
    pub fn island(&self, p: DVec2) -> usize {
        let islands = self.islands.as_ref();
        islands.map_or(0, |i| i.of[self.nearest(p).segment] as usize)
    }

    /// The island of a segment of the outline.
    pub(super) fn island_of(&self, segment: usize) -> u32 {
        self.islands.as_ref().map_or(0, |i| i.of[segment])
    }

    /// Whether two places lie on different islands.
    #[inline]
    pub fn is_gap_between(&self, a: DVec2, b: DVec2) -> bool {
        let islands = self.islands.as_ref();
        islands.is_some_and(|i| i.is_near(a, b) && self.island(a) != self.island(b))
    }

    /// The middle of each island that holds none of these places.
    pub(crate) fn empty_middles(&self, places: &[DVec2]) -> Vec<DVec2> {
        let mut empty = vec![true; self.islands().len()];
        for &p in places {
            empty[self.island(p)] = false;
        }
        let islands = self.islands().iter().zip(empty);
        let empty = islands.filter_map(|(island, empty)| empty.then_some(island));
        empty.filter_map(Self::deepest).collect()
    }
}
