//! Points in buckets, as linked lists: points can be added at any time.

use crate::csr::NONE;
use std::ops::Range;

/// A list of points for each bucket, in reverse order of insertion.
#[derive(Clone, Debug)]
pub(crate) struct Chains {
    /// The last point of each bucket.
    head: Vec<u32>,
    /// For each point, the previous point in its bucket.
    next: Vec<u32>,
}

impl Chains {
    /// Lists without points.
    pub fn new(buckets: usize) -> Self {
        Self {
            head: vec![NONE; buckets],
            next: Vec::new(),
        }
    }

    /// The number of buckets.
    pub fn buckets(&self) -> usize {
        self.head.len()
    }

    /// Adds the next point; points are numbered from 0 in order of insertion.
    pub fn push(&mut self, bucket: usize) {
        self.next.push(self.head[bucket]);
        self.head[bucket] = (self.next.len() - 1) as u32;
    }

    /// Calls `visit` with the number of every point in these buckets, until one call returns true. Returns whether one
    /// did.
    #[inline]
    pub fn any(&self, buckets: Range<usize>, mut visit: impl FnMut(usize) -> bool) -> bool {
        for &first in &self.head[buckets] {
            let mut k = first;
            while k != NONE {
                if visit(k as usize) {
                    return true;
                }
                k = self.next[k as usize];
            }
        }
        false
    }
}
