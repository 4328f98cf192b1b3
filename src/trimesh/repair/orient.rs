//! Makes all triangles of a part run the same way round, seen from outside.

use super::{MeshInRepair, NONE, RepairStep, SLICE, slice};
use crate::notice::{Code, Notice};

/// A part has no outside if its volume is less than this share of its area to the power of 3/2.
const NO_VOLUME: f64 = 1e-9;

/// Visits triangle after triangle over edges: the two triangles of an edge must run along it in opposite directions.
/// Closed parts are then turned outwards; in open ones the smaller set of triangles is turned.
#[derive(Default)]
pub(super) struct Orienting {
    stage: OrientingPhase,
    at: usize,
    /// For each triangle the number of its part.
    part: Vec<u32>,
    /// For each triangle, whether its direction differs from that of the part's first triangle.
    turned: Vec<bool>,
    open: Vec<u32>,
    parts: Vec<OrientedPart>,
    count: usize,
}

#[derive(Clone, Copy, Default)]
enum OrientingPhase {
    #[default]
    Spread,
    Measure,
    Turn,
}

#[derive(Default)]
struct OrientedPart {
    /// A vertex of the part; volumes are summed about it.
    about: glam::DVec3,
    is_open: bool,
    triangles: usize,
    turned: usize,
    /// Six times the volume, and twice the area.
    volume: f64,
    area: f64,
}

impl OrientedPart {
    fn is_inside_out(&self) -> bool {
        let least = NO_VOLUME * self.area * self.area.sqrt();
        if self.is_open || self.volume.abs() < least {
            2 * self.turned > self.triangles
        } else {
            self.volume < 0.0
        }
    }
}

impl RepairStep for Orienting {
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice> {
        let count = work.triangles.len();
        match self.stage {
            OrientingPhase::Spread => {
                if self.part.is_empty() {
                    self.part = vec![NONE; count];
                    self.turned = vec![false; count];
                }
                if self.spread(work)? {
                    (self.stage, self.at) = (OrientingPhase::Measure, 0);
                }
                Ok(false)
            }
            OrientingPhase::Measure => {
                let range = slice(&mut self.at, count);
                range.for_each(|t| self.measure(work, t));
                if self.at == count {
                    (self.stage, self.at) = (OrientingPhase::Turn, 0);
                }
                Ok(false)
            }
            OrientingPhase::Turn => {
                let range = slice(&mut self.at, count);
                range.for_each(|t| self.turn(work, t));
                if self.at < count {
                    return Ok(false);
                }
                work.tell(Code::MendedTurned, self.count);
                Ok(true)
            }
        }
    }
}

impl Orienting {
    /// Visits one more slice of triangles; true when all have been visited.
    fn spread(&mut self, work: &MeshInRepair) -> Result<bool, Notice> {
        for _ in 0..SLICE {
            let Some(t) = self.open.pop() else {
                let Some(next) = self.part[self.at..].iter().position(|&p| p == NONE) else {
                    return Ok(true);
                };
                self.at += next;
                self.part[self.at] = self.parts.len() as u32;
                self.open.push(self.at as u32);
                self.parts.push(OrientedPart {
                    about: work.corners(self.at)[0],
                    ..OrientedPart::default()
                });
                continue;
            };
            self.neighbours(work, t as usize)?;
        }
        Ok(false)
    }

    fn neighbours(&mut self, work: &MeshInRepair, t: usize) -> Result<(), Notice> {
        for (k, &edge) in work.across[t].iter().enumerate() {
            if edge == NONE {
                self.parts[self.part[t] as usize].is_open = true;
                continue;
            }
            let (other, j) = (edge as usize / 3, edge as usize % 3);
            let alike = work.triangles[t][k] == work.triangles[other][j];
            let turned = self.turned[t] != alike;
            if self.part[other] == NONE {
                self.part[other] = self.part[t];
                self.turned[other] = turned;
                self.open.push(other as u32);
            } else if self.turned[other] != turned {
                return Err(Code::ModelOneSided.into());
            }
        }
        Ok(())
    }

    fn measure(&mut self, work: &MeshInRepair, t: usize) {
        let part = &mut self.parts[self.part[t] as usize];
        let [a, b, c] = work.corners(t).map(|p| p - part.about);
        let sign = if self.turned[t] { -1.0 } else { 1.0 };
        part.triangles += 1;
        part.turned += usize::from(self.turned[t]);
        part.volume += sign * a.dot(b.cross(c));
        part.area += (b - a).cross(c - a).length();
    }

    fn turn(&mut self, work: &mut MeshInRepair, t: usize) {
        let is_turned =
            |t: usize| self.turned[t] != self.parts[self.part[t] as usize].is_inside_out();
        let across = work.across[t].map(|edge| match edge {
            // If the triangle beyond is turned, its edges get numbers in reverse order.
            edge if edge != NONE && is_turned(edge as usize / 3) => edge / 3 * 3 + 2 - edge % 3,
            edge => edge,
        });
        work.across[t] = across;
        if is_turned(t) {
            work.triangles[t].swap(1, 2);
            work.across[t].swap(0, 2);
            self.count += 1;
        }
    }
}
