//! Finds the triangles that share edges.

use super::super::sorting::Sorting;
use super::{MeshInRepair, NONE, RepairStep, slice};
use crate::notice::{Code, Notice};
use crate::order::{self, pair};

/// Drops duplicate triangles, and joins the triangles at each edge in pairs.
#[derive(Default)]
pub(super) struct Linking {
    stage: LinkingPhase,
    at: usize,
    edges: Vec<(u64, u32)>,
    sorting: Option<Sorting>,
    /// Marks triangles that are duplicates.
    doubled: Vec<bool>,
    /// How many edges have more than two triangles.
    crowded: usize,
    /// How many triangles are left without the duplicates.
    kept: usize,
}

#[derive(Clone, Copy, Default)]
enum LinkingPhase {
    #[default]
    List,
    Sort,
    Doubled,
    Link,
    Drop,
}

impl RepairStep for Linking {
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice> {
        let triangles = work.triangles.len();
        let count = match self.stage {
            LinkingPhase::List | LinkingPhase::Drop => triangles,
            LinkingPhase::Sort => 0,
            _ => self.edges.len(),
        };
        let range = slice(&mut self.at, count);
        match self.stage {
            LinkingPhase::List => range.for_each(|t| self.list(work, t)),
            LinkingPhase::Sort => match self.sorting.as_mut().map(Sorting::advance) {
                Some(None) => return Ok(false),
                sorted => self.edges = sorted.flatten().unwrap_or_default(),
            },
            LinkingPhase::Doubled | LinkingPhase::Link => {
                let mut at = range.start;
                while at < range.end {
                    at = self.group(work, at);
                }
                self.at = at;
            }
            LinkingPhase::Drop => range.for_each(|t| self.keep(work, t)),
        }
        if self.at < count {
            return Ok(false);
        }
        self.at = 0;
        self.stage = match self.stage {
            LinkingPhase::List => {
                self.sorting = Some(Sorting::new(std::mem::take(&mut self.edges)));
                LinkingPhase::Sort
            }
            LinkingPhase::Sort => {
                self.sorting = None;
                self.doubled = vec![false; triangles];
                LinkingPhase::Doubled
            }
            LinkingPhase::Doubled => LinkingPhase::Drop,
            // Without them the edges have other numbers: start again.
            LinkingPhase::Drop if self.kept < triangles => {
                work.tell(Code::MendedDoubled, triangles - self.kept);
                work.triangles.truncate(self.kept);
                self.edges.clear();
                self.kept = 0;
                LinkingPhase::List
            }
            LinkingPhase::Drop => {
                work.across = vec![[NONE; 3]; triangles];
                LinkingPhase::Link
            }
            LinkingPhase::Link => {
                work.tell(Code::MendedEdges, self.crowded);
                return Ok(true);
            }
        };
        Ok(false)
    }
}

/// The corner opposite an edge.
fn opposite(work: &MeshInRepair, edge: u32) -> u32 {
    work.triangles[edge as usize / 3][(edge as usize + 2) % 3]
}

impl Linking {
    fn list(&mut self, work: &MeshInRepair, t: usize) {
        let [a, b, c] = work.triangles[t];
        for (k, [a, b]) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
            let key = pair(a.min(b), a.max(b));
            self.edges.push((key, (3 * t + k) as u32));
        }
    }

    /// Handles the edges from `at` on that have the same ends; returns where the next group begins.
    fn group(&mut self, work: &mut MeshInRepair, at: usize) -> usize {
        let key = self.edges[at].0;
        let same = self.edges[at..].iter().take_while(|e| e.0 == key).count();
        let edges = at..at + same;
        match self.stage {
            LinkingPhase::Doubled => self.find_doubled(work, edges),
            _ => {
                if let [(_, a), (_, b)] = self.edges[edges] {
                    work.across[a as usize / 3][a as usize % 3] = b;
                    work.across[b as usize / 3][b as usize % 3] = a;
                } else if same > 2 {
                    self.crowded += 1;
                }
            }
        }
        at + same
    }

    fn find_doubled(&mut self, work: &MeshInRepair, edges: std::ops::Range<usize>) {
        if edges.len() < 2 {
            return;
        }
        let mut thirds: Vec<(u32, u32)> = self.edges[edges]
            .iter()
            .map(|&(_, edge)| (opposite(work, edge), edge / 3))
            .collect();
        order::sort(&mut thirds, |&(v, t)| (v.into(), t.into()));
        for two in thirds.windows(2) {
            if two[0].0 == two[1].0 {
                self.doubled[two[1].1 as usize] = true;
            }
        }
    }

    fn keep(&mut self, work: &mut MeshInRepair, t: usize) {
        if !self.doubled[t] {
            work.triangles[self.kept] = work.triangles[t];
            self.kept += 1;
        }
    }
}
