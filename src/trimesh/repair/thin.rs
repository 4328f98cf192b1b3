//! Removes triangles without an area, whose corners lie on a line.
//!
//! To drop such a triangle would open a gap. Its longest edge is flipped instead: it and its neighbour over that edge
//! become two triangles that share the neighbour's area. Without a neighbour there, the triangle is dropped.

use super::{MeshInRepair, NONE, RepairStep, slice};
use crate::notice::{Code, Notice};

/// The most rounds: a flip may leave another triangle without an area.
const MOST_ROUNDS: usize = 8;

#[derive(Default)]
pub(super) struct Thinning {
    at: usize,
    round: usize,
    /// How many triangles this round has changed.
    changed: usize,
    count: usize,
    /// How many triangles are kept, and whether this is the last round.
    kept: usize,
    last: bool,
    number: Vec<u32>,
}

impl RepairStep for Thinning {
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice> {
        let count = work.triangles.len();
        let range = slice(&mut self.at, count);
        if self.last {
            range.for_each(|t| self.keep(work, t));
        } else {
            range.for_each(|t| self.mend(work, t));
        }
        if self.at < count {
            return Ok(false);
        }
        self.at = 0;
        if self.last {
            self.finish(work);
            return Ok(true);
        }
        self.round += 1;
        self.count += self.changed;
        self.last = self.changed == 0 || self.round == MOST_ROUNDS;
        self.changed = 0;
        if self.last && self.count == 0 {
            return Ok(true);
        }
        Ok(false)
    }
}

/// The most triangles around a corner that are looked at. If there are more, no edge of the corner is flipped, because
/// a large fan of flat triangles would take time with the square of its size.
const MOST_AROUND: usize = 1 << 10;

/// A removed triangle.
const GONE: [u32; 3] = [NONE; 3];

/// The height of a triangle over its longest edge, and the number of that edge.
fn height(work: &MeshInRepair, corners: [u32; 3]) -> (f64, usize) {
    let p = corners.map(|v| work.positions[v as usize]);
    let length = |k: usize| (p[(k + 1) % 3] - p[k]).length();
    let mut longest = (length(0), 0);
    for k in 1..3 {
        if length(k) > longest.0 {
            longest = (length(k), k);
        }
    }
    let double = (p[1] - p[0]).cross(p[2] - p[0]).length();
    (double / longest.0, longest.1)
}

impl Thinning {
    fn mend(&mut self, work: &mut MeshInRepair, t: usize) {
        let corners = work.triangles[t];
        if corners == GONE {
            return;
        }
        let (own, k) = height(work, corners);
        if own > work.near() {
            return;
        }
        let across = work.across[t][k];
        if across == NONE {
            self.changed += 1;
            let others = std::mem::replace(&mut work.across[t], GONE);
            for edge in others.into_iter().filter(|&edge| edge != NONE) {
                work.across[edge as usize / 3][edge as usize % 3] = NONE;
            }
            work.triangles[t] = GONE;
            return;
        }
        let (other, j) = (across as usize / 3, across as usize % 3);
        let [a, b, c] = [0, 1, 2].map(|i| corners[(k + i) % 3]);
        let d = work.triangles[other][(j + 2) % 3];
        if d == c || are_joined(work, t, (k + 2) % 3, d) {
            return;
        }
        let (one, two) = ([a, d, c], [d, b, c]);
        let least = height(work, one).0.min(height(work, two).0);
        if least > own.min(height(work, work.triangles[other]).0) {
            turn(work, (t, k), (other, j), [one, two]);
            self.changed += 1;
        }
    }

    fn keep(&mut self, work: &mut MeshInRepair, t: usize) {
        self.number.push(self.kept as u32);
        if work.triangles[t] != GONE {
            work.triangles[self.kept] = work.triangles[t];
            work.across[self.kept] = work.across[t];
            self.kept += 1;
        }
    }

    fn finish(&mut self, work: &mut MeshInRepair) {
        work.triangles.truncate(self.kept);
        work.across.truncate(self.kept);
        for edge in work.across.iter_mut().flatten() {
            if *edge != NONE {
                *edge = 3 * self.number[*edge as usize / 3] + *edge % 3;
            }
        }
        work.tell(Code::MendedThin, self.count);
    }
}

/// Whether an edge joins a corner of a triangle to a vertex. True as well if the fan around the corner has
/// [`MOST_AROUND`] triangles or more, which are not all looked at.
fn are_joined(work: &MeshInRepair, t: usize, corner: usize, vertex: u32) -> bool {
    let first = (t, corner);
    for step in [2, 0] {
        let (mut t, mut corner) = first;
        for left in (0..MOST_AROUND).rev() {
            if left == 0 || work.triangles[t].contains(&vertex) {
                return true;
            }
            let edge = work.across[t][(corner + step) % 3];
            if edge == NONE {
                break;
            }
            (t, corner) = (
                edge as usize / 3,
                (edge as usize + if step == 2 { 0 } else { 1 }) % 3,
            );
            if (t, corner) == first {
                return false;
            }
        }
    }
    false
}

/// Flips an edge: edge `k` of `t`, which is edge `j` of `other`, goes from a to b. The new edge joins d, the corner of
/// `other` opposite the old edge, to c, the corner of `t` opposite it.
fn turn(
    work: &mut MeshInRepair,
    (t, k): (usize, usize),
    (other, j): (usize, usize),
    new: [[u32; 3]; 2],
) {
    // The neighbours over a–d, d–b, b–c and c–a.
    let ad = work.across[other][(j + 1) % 3];
    let db = work.across[other][(j + 2) % 3];
    let bc = work.across[t][(k + 1) % 3];
    let ca = work.across[t][(k + 2) % 3];
    [work.triangles[t], work.triangles[other]] = new;
    let (t, other) = (t as u32, other as u32);
    // The new triangles are [a, d, c] and [d, b, c].
    for (edge, beyond) in [
        (3 * t, ad),
        (3 * t + 1, 3 * other + 2),
        (3 * t + 2, ca),
        (3 * other, db),
        (3 * other + 1, bc),
        (3 * other + 2, 3 * t + 1),
    ] {
        work.across[edge as usize / 3][edge as usize % 3] = beyond;
        if beyond != NONE {
            work.across[beyond as usize / 3][beyond as usize % 3] = edge;
        }
    }
}
