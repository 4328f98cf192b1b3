//! Finds the triangles that share edges.

use super::super::sorting::Sorting;
use super::{MeshInRepair, NONE, RepairStep, slice};
use crate::notice::{Code, Notice};
use crate::order::{self, pair};

/// The triangles of an edge are sorted at once up to this count, and in slices above it.
const MANY: usize = 1 << 12;

/// Drops duplicate triangles, and joins the triangles at each edge in pairs.
#[derive(Default)]
pub(super) struct Linking {
    stage: LinkingPhase,
    at: usize,
    edges: Vec<(u64, u32)>,
    sorting: Option<Sorting>,
    /// The edges of a large group, being sorted by the corners opposite them.
    large: Option<Sorting>,
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
                self.at = range.start;
                while self.at < range.end && self.group(work) {}
            }
            LinkingPhase::Drop => range.for_each(|t| self.keep(work, t)),
        }
        if self.at < count {
            return Ok(false);
        }
        self.at = 0;
        let Some(next) = self.next_phase(work) else {
            work.tell(Code::MendedEdges, self.crowded);
            return Ok(true);
        };
        self.stage = next;
        Ok(false)
    }
}

impl Linking {
    /// The phase after the present one, which is over; `None` after the last one.
    fn next_phase(&mut self, work: &mut MeshInRepair) -> Option<LinkingPhase> {
        let triangles = work.triangles.len();
        Some(match self.stage {
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
            // Without the duplicates the edges have other numbers: start again.
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
            LinkingPhase::Link => return None,
        })
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

    /// Handles the next edges that have the same ends. Returns false while a large number of them is being sorted.
    fn group(&mut self, work: &mut MeshInRepair) -> bool {
        let key = self.edges[self.at].0;
        let rest = &self.edges[self.at..];
        let same = rest.iter().take_while(|e| e.0 == key).count();
        let edges = self.at..self.at + same;
        match self.stage {
            LinkingPhase::Doubled if same > MANY => {
                if !self.sort_large(work, edges) {
                    return false;
                }
            }
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
        self.at += same;
        true
    }

    /// Does as [`Linking::find_doubled`], in slices; true when it is done.
    fn sort_large(&mut self, work: &MeshInRepair, edges: std::ops::Range<usize>) -> bool {
        let sorting = self.large.get_or_insert_with(|| {
            let edges = self.edges[edges].iter().map(|&(_, edge)| edge);
            let thirds = edges.map(|edge| (opposite(work, edge).into(), edge / 3));
            Sorting::new(thirds.collect())
        });
        let Some(thirds) = sorting.advance() else {
            return false;
        };
        self.large = None;
        self.mark_doubled(&thirds);
        true
    }

    /// Marks all triangles but the first one at each opposite corner. `thirds` is sorted by these corners.
    fn mark_doubled<T: PartialEq>(&mut self, thirds: &[(T, u32)]) {
        for two in thirds.windows(2) {
            if two[0].0 == two[1].0 {
                self.doubled[two[1].1 as usize] = true;
            }
        }
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
        self.mark_doubled(&thirds);
    }

    fn keep(&mut self, work: &mut MeshInRepair, t: usize) {
        if !self.doubled[t] {
            work.triangles[self.kept] = work.triangles[t];
            self.kept += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{MeshRepair, Soup};
    use super::*;
    use glam::DVec3;

    /// Triangles that all share one edge; every third triangle occurs twice.
    fn book(leaves: usize) -> Soup {
        let leaf = |k: usize| {
            let angle = 6.0 * k as f64 / leaves as f64;
            DVec3::new(libm::cos(angle), 0.5, libm::sin(angle))
        };
        let positions = [DVec3::ZERO, DVec3::Y].into_iter();
        let leaf_of = |k: usize| [0, 1, 2 + k as u32];
        let doubled = (0..leaves).step_by(3).map(leaf_of);
        Soup {
            positions: positions.chain((0..leaves).map(leaf)).collect(),
            triangles: (0..leaves).map(leaf_of).chain(doubled).collect(),
        }
    }

    #[test]
    fn doubled_triangles_at_an_edge_of_many_are_those_at_one_of_few() {
        for leaves in [30, 3 * MANY] {
            let mended = MeshRepair::mend(book(leaves)).expect("a surface");
            let told = mended.notices.iter().map(|notice| notice.code);
            assert!(told.eq([Code::MendedDoubled, Code::MendedEdges, Code::MendedVertices]));
            let doubled = Notice::new(Code::MendedDoubled).with("n", leaves / 3);
            assert_eq!(mended.notices[0], doubled);
            assert_eq!(mended.mesh.triangles().len(), leaves);
        }
    }
}
