//! Makes a surface that cells can be packed on from the triangles of a file.
//!
//! [`MeshRepair`] checks, welds and orients the triangles, mends them where that is safe, and reports each kind of
//! change. [`HoleFilling`] closes holes that are small compared with cells, and reports parts that are smaller than a
//! cell. [`CreaseCutting`] cuts a surface along its creases, once its edges are short enough (see [`super::refine`]).
//! All work is cut into slices by amount. Results do not depend on scale or position: a distance counts as zero below a
//! millionth of the model's diagonal.

mod checks;
mod crease;
mod fill;
mod link;
mod loops;
mod orient;
mod split;
mod thin;
mod weld;

#[cfg(test)]
mod hole_tests;
#[cfg(test)]
mod tests;

pub use crease::{CreaseCut, CreaseCutting};
pub use fill::{Filled, HoleFilling};

use super::{MeshBuilding, NONE, Soup, TriMesh};
use crate::notice::{Code, Notice};
use glam::DVec3;

/// Vertices closer than this share of the diagonal are at one place.
const NEAR: f64 = 1e-6;
/// Triangles or vertices in a slice.
const SLICE: usize = 1 << 15;

/// A mended surface and the changes made to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    /// The surface.
    pub mesh: TriMesh,
    /// Notices of the changes, and of defects that remain.
    pub notices: Vec<Notice>,
}

/// The data that the steps change in turn.
struct MeshInRepair {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// For each edge, the same one in the triangle beyond it, as `3 * triangle + edge`, once that is known.
    across: Vec<[u32; 3]>,
    /// The least and greatest corner of the bounding box.
    low: DVec3,
    high: DVec3,
    /// The faults mended so far, with their counts.
    told: Vec<(Code, usize)>,
}

impl MeshInRepair {
    /// Vertices closer than this are at one place, in the model's units.
    fn near(&self) -> f64 {
        NEAR * (self.high - self.low).length()
    }

    fn corners(&self, t: usize) -> [DVec3; 3] {
        self.triangles[t].map(|v| self.positions[v as usize])
    }

    /// Counts mended faults. Several steps may mend faults of one kind.
    fn tell(&mut self, code: Code, count: usize) {
        match self.told.iter_mut().find(|(known, _)| *known == code) {
            Some((_, all)) => *all += count,
            None => self.told.push((code, count)),
        }
    }

    /// A notice for each kind of fault that was there.
    fn notices(&self) -> Vec<Notice> {
        let found = self.told.iter().filter(|(_, count)| *count > 0);
        found
            .map(|&(code, count)| Notice::new(code).with("n", count))
            .collect()
    }
}

/// A step of the work, done in slices.
trait RepairStep {
    /// Does one more slice; true when the step is done.
    fn advance(&mut self, work: &mut MeshInRepair) -> Result<bool, Notice>;
}

/// A surface that is being mended.
pub struct MeshRepair {
    work: MeshInRepair,
    step: Box<dyn RepairStep>,
    /// How many steps are done.
    done: usize,
    building: Option<MeshBuilding>,
}

/// How many steps come before the mesh is built.
const STEPS: usize = 6;

impl MeshRepair {
    /// Starts with the triangles of a file.
    pub fn new(soup: Soup) -> Self {
        let work = MeshInRepair {
            positions: soup.positions,
            triangles: soup.triangles,
            across: Vec::new(),
            low: DVec3::ZERO,
            high: DVec3::ZERO,
            told: Vec::new(),
        };
        Self {
            work,
            step: step(0),
            done: 0,
            building: None,
        }
    }

    /// Does one more slice. Returns the surface when it is done, or the reason why there is none.
    pub fn advance(&mut self) -> Option<Result<Mended, Notice>> {
        if let Some(building) = &mut self.building {
            let mesh = building.advance()?;
            let notices = self.work.notices();
            let mended = mesh.map(|mesh| Mended { mesh, notices });
            // The steps before leave one possible fault: that no triangle with an area is left.
            return Some(mended.map_err(|_| Code::ModelNoArea.into()));
        }
        match self.step.advance(&mut self.work) {
            Err(why) => return Some(Err(why)),
            Ok(false) => return None,
            Ok(true) => {}
        }
        self.done += 1;
        if self.done < STEPS {
            self.step = step(self.done);
        } else {
            let positions = std::mem::take(&mut self.work.positions);
            let triangles = std::mem::take(&mut self.work.triangles);
            self.work.across = Vec::new();
            self.building = Some(MeshBuilding::new(positions, triangles));
        }
        None
    }

    /// The share of the work that is done, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.done as f64 / (STEPS + 1) as f64
    }

    /// Does all the work at once.
    ///
    /// # Errors
    /// The reason why there is no surface.
    pub fn mend(soup: Soup) -> Result<Mended, Notice> {
        let mut mending = Self::new(soup);
        loop {
            if let Some(done) = mending.advance() {
                return done;
            }
        }
    }
}

fn step(number: usize) -> Box<dyn RepairStep> {
    match number {
        0 => Box::<checks::Checking>::default(),
        1 => Box::<weld::Welding>::default(),
        2 => Box::<link::Linking>::default(),
        3 => Box::<orient::Orienting>::default(),
        4 => Box::<thin::Thinning>::default(),
        _ => Box::<split::Splitting>::default(),
    }
}

/// The range of a list for the next slice; moves `at` to its end.
fn slice(at: &mut usize, count: usize) -> std::ops::Range<usize> {
    let start = *at;
    *at = count.min(start + SLICE);
    start..*at
}
