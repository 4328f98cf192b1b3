//! Refuses numbers from which no surface can be made.

use super::super::MOST_TRIANGLES;
use super::{MeshInRepair, NONE, RepairStep, slice};
use crate::notice::{Code, Notice};
use glam::DVec3;

/// Sizes for which no power in the later work overflows or vanishes.
const SAFE: std::ops::Range<f64> = 1e-20..1e20;
/// A model outside this range is scaled by this power of two or its inverse, until it is inside. So a model gives the
/// same cells in any unit, and coordinates keep all their bits.
const STEP: f64 = (1u128 << 64) as f64;

/// Checks all numbers, and drops vertices that no triangle uses.
#[derive(Default)]
pub(super) struct Checking {
    at: usize,
    /// For each vertex, [`NONE`] if no triangle uses it, else 0; later its new number.
    number: Vec<u32>,
    checked: bool,
}

impl RepairStep for Checking {
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice> {
        let count = work.triangles.len();
        if self.number.is_empty() {
            check_counts(work)?;
            self.number = vec![NONE; work.positions.len()];
            (work.low, work.high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        }
        for t in slice(&mut self.at, count) {
            if self.checked {
                work.triangles[t] = work.triangles[t].map(|v| self.number[v as usize]);
            } else {
                self.check(work, t)?;
            }
        }
        if self.at < count {
            return Ok(false);
        }
        if self.checked {
            return Ok(true);
        }
        scale(work);
        check_extent(work)?;
        (self.at, self.checked) = (0, true);
        Ok(!self.leave_out(work))
    }
}

impl Checking {
    fn check(&mut self, work: &mut MeshInRepair, t: usize) -> Result<(), Notice> {
        for v in work.triangles[t] {
            let Some(&p) = work.positions.get(v as usize) else {
                return Err(Notice::new(Code::ModelCorner).with("n", t + 1));
            };
            if !p.is_finite() {
                return Err(Notice::new(Code::ModelNotFinite).with("n", v as usize + 1));
            }
            self.number[v as usize] = 0;
            (work.low, work.high) = (work.low.min(p), work.high.max(p));
        }
        Ok(())
    }

    /// Removes the vertices that no triangle uses; true if there are any.
    fn leave_out(&mut self, work: &mut MeshInRepair) -> bool {
        if !self.number.contains(&NONE) {
            return false;
        }
        let mut kept = 0;
        for (v, number) in self.number.iter_mut().enumerate() {
            if *number != NONE {
                work.positions[kept] = work.positions[v];
                *number = kept as u32;
                kept += 1;
            }
        }
        work.positions.truncate(kept);
        true
    }
}

/// The greatest coordinate.
fn most(work: &MeshInRepair) -> f64 {
    work.low.abs().max(work.high.abs()).max_element()
}

/// Brings the coordinates into the safe range.
fn scale(work: &mut MeshInRepair) {
    while most(work) > 0.0 && !SAFE.contains(&most(work)) {
        let factor = if most(work) < SAFE.start {
            STEP
        } else {
            1.0 / STEP
        };
        work.positions.iter_mut().for_each(|p| *p *= factor);
        work.low *= factor;
        work.high *= factor;
    }
}

fn check_extent(work: &MeshInRepair) -> Result<(), Notice> {
    let most = most(work);
    let diagonal = (work.high - work.low).length();
    if diagonal == 0.0 {
        return Err(Code::ModelNoArea.into());
    }
    // The rounding of such numbers is as large as the model's details.
    if most > 1e9 * diagonal {
        return Err(Code::ModelFar.into());
    }
    Ok(())
}

fn check_counts(work: &MeshInRepair) -> Result<(), Notice> {
    let (vertices, triangles) = (work.positions.len(), work.triangles.len());
    if triangles == 0 {
        return Err(Code::ModelEmpty.into());
    }
    // With more vertices than this, fewer than one in three of them would be used.
    if triangles > MOST_TRIANGLES || vertices > 9 * MOST_TRIANGLES {
        let too_large = Notice::new(Code::ModelTooLarge);
        let n = triangles.max(vertices / 3);
        return Err(too_large.with("n", n).with("most", MOST_TRIANGLES));
    }
    Ok(())
}
