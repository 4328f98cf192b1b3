//! From the triangles of a file to a surface that cells can be packed on.
//!
//! [`Mending`] has checked, welded, oriented and, where that is safe, mended what it is given, and tells each thing that
//! it has done. [`Filling`] closes holes that are small beside cells, and tells of parts that are smaller than one.
//! [`Cutting`] cuts a surface along its creases, once its edges are short enough (see [`super::refine`]). All work is
//! cut by amount. Nothing hangs on scale or place: what counts as nothing is a millionth of the model's diagonal.

mod checks;
mod crease;
mod fill;
mod link;
mod orient;
mod split;
mod thin;
mod weld;

#[cfg(test)]
mod tests;

pub use crease::{Cut, Cutting};
pub use fill::{Filled, Filling};

use super::{MeshBuilding, NONE, Soup, TriMesh};
use crate::notice::{Code, Notice};
use glam::DVec3;

/// What is closer than this, as a part of the diagonal, is at one place.
const NEAR: f64 = 1e-6;
/// Triangles or vertices of a slice.
const SLICE: usize = 1 << 15;

/// A surface, and what has been done to get it.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    /// The surface.
    pub mesh: TriMesh,
    /// What was done, or is to be said.
    pub notices: Vec<Notice>,
}

/// What the steps work on.
struct Work {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Of each edge the same one of the triangle beyond it, `3 * triangle + edge`, once that is known.
    across: Vec<[u32; 3]>,
    /// The corners of the box around all triangles.
    low: DVec3,
    high: DVec3,
    notices: Vec<Notice>,
}

impl Work {
    /// What is closer than this is at one place.
    fn near(&self) -> f64 {
        NEAR * (self.high - self.low).length()
    }

    fn corners(&self, t: usize) -> [DVec3; 3] {
        self.triangles[t].map(|v| self.positions[v as usize])
    }

    /// Tells of things of one kind, where there are any.
    fn tell(&mut self, code: Code, count: usize) {
        if count > 0 {
            self.notices.push(Notice::new(code).with("n", count));
        }
    }
}

/// A part of the work, in slices.
trait Step {
    /// Works on some more; true when it is done.
    fn advance(&mut self, work: &mut Work) -> Result<bool, Notice>;
}

/// A surface in the making.
pub struct Mending {
    work: Work,
    step: Box<dyn Step>,
    /// How many steps are done.
    done: usize,
    building: Option<MeshBuilding>,
}

/// Steps before the mesh is built.
const STEPS: usize = 6;

impl Mending {
    /// Of the triangles of a file.
    pub fn new(soup: Soup) -> Self {
        let work = Work {
            positions: soup.positions,
            triangles: soup.triangles,
            across: Vec::new(),
            low: DVec3::ZERO,
            high: DVec3::ZERO,
            notices: Vec::new(),
        };
        Self {
            work,
            step: step(0),
            done: 0,
            building: None,
        }
    }

    /// Works on some more. The surface when it is done, or why there can be none.
    pub fn advance(&mut self) -> Option<Result<Mended, Notice>> {
        if let Some(building) = &mut self.building {
            let mesh = building.advance()?;
            let notices = std::mem::take(&mut self.work.notices);
            let mended = mesh.map(|mesh| Mended { mesh, notices });
            // What comes here without a triangle had none with an area; all else has been seen to.
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

    /// How much of it is done, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.done as f64 / (STEPS + 1) as f64
    }

    /// All of it at once.
    ///
    /// # Errors
    /// Why there can be no surface.
    pub fn mend(soup: Soup) -> Result<Mended, Notice> {
        let mut mending = Self::new(soup);
        loop {
            if let Some(done) = mending.advance() {
                return done;
            }
        }
    }
}

fn step(number: usize) -> Box<dyn Step> {
    match number {
        0 => Box::<checks::Checking>::default(),
        1 => Box::<weld::Welding>::default(),
        2 => Box::<link::Linking>::default(),
        3 => Box::<orient::Orienting>::default(),
        4 => Box::<thin::Thinning>::default(),
        _ => Box::<split::Splitting>::default(),
    }
}

/// The part of a list that a slice works on.
fn slice(at: &mut usize, count: usize) -> std::ops::Range<usize> {
    let start = *at;
    *at = count.min(start + SLICE);
    start..*at
}
