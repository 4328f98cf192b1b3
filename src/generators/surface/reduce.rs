//! Replaces a huge surface by a coarser one. All later work, on the surface, its ground and their pictures, grows with
//! the number of triangles. Far fewer triangles already show every detail that cells do not hide.

use crate::notice::{Code, Notice};
use crate::trimesh::repair::{Filled, HoleFilling};
use crate::trimesh::{MeshBuilding, Simplifying, TriMesh};
use std::sync::Arc;

/// A surface with more than this many times the wanted number of triangles is huge.
const HUGE: usize = 4;

/// A huge surface that becomes coarser.
pub(super) struct Reducing {
    phase: ReducePhase,
    given: Arc<TriMesh>,
    /// The number of triangles that is wanted.
    most: usize,
    notices: Vec<Notice>,
}

enum ReducePhase {
    /// Small holes are closed first, because a coarser surface keeps each open hole with at least three edges.
    Fill(Box<HoleFilling>),
    LeaveOut(Box<MeshBuilding>),
    Simplify(Box<Simplifying>),
}

impl Reducing {
    /// Starts; `None` if the surface is not huge. The coarser surface gets about `most` triangles. `size` is the side
    /// of a cell of mean size.
    pub fn begin(given: &Arc<TriMesh>, most: usize, size: f64) -> Option<Self> {
        (given.triangles().len() > HUGE * most).then(|| Self {
            phase: ReducePhase::Fill(Box::new(HoleFilling::new(given.clone(), size))),
            given: given.clone(),
            most,
            notices: Vec::new(),
        })
    }

    /// Does one more slice. Returns the coarser surface in the end, with notices of the change and of its repairs.
    pub fn advance(&mut self) -> Option<(TriMesh, Vec<Notice>)> {
        match &mut self.phase {
            ReducePhase::Fill(filling) => {
                self.phase = match filling.advance()? {
                    Ok(filled) => self.filled(filled),
                    // A ragged surface may seem smaller than a cell now, but be large enough once it is simple.
                    Err(_) => self.simplify(self.given.clone()),
                };
                None
            }
            ReducePhase::LeaveOut(building) => {
                // The triangles that stay form a mesh, too, so this does not fail.
                let mesh = building.advance()?.map_or(self.given.clone(), Arc::new);
                self.phase = self.simplify(mesh);
                None
            }
            ReducePhase::Simplify(simplifying) => {
                let mesh = simplifying.advance()?;
                let coarser = Notice::new(Code::ModelCoarser)
                    .with("n", self.given.triangles().len())
                    .with("left", mesh.triangles().len());
                self.notices.push(coarser);
                Some((mesh, std::mem::take(&mut self.notices)))
            }
        }
    }

    fn simplify(&self, mesh: Arc<TriMesh>) -> ReducePhase {
        ReducePhase::Simplify(Box::new(Simplifying::new(mesh, self.most, f64::INFINITY)))
    }

    /// Continues once holes are closed. Parts without cells are left out if they have too many triangles: meshes of
    /// many parts stay large, however coarse each part is.
    fn filled(&mut self, filled: Filled) -> ReducePhase {
        self.notices = filled.notices;
        let bare = filled.bare.iter().filter(|&&bare| bare).count();
        if bare > self.most
            && let Some(building) = leaving_out(&filled.mesh, &filled.bare)
        {
            return ReducePhase::LeaveOut(Box::new(building));
        }
        // Parts without cells that stay are counted later, on the simple surface.
        self.notices.retain(|notice| notice.code != Code::ModelBare);
        self.simplify(filled.mesh)
    }
}

/// The mesh without the triangles marked in `bare`, such as parts that are smaller than a cell.
pub(super) fn without(mesh: &TriMesh, bare: &[bool]) -> TriMesh {
    let built = leaving_out(mesh, bare).map(MeshBuilding::finish);
    built.and_then(Result::ok).unwrap_or_else(|| mesh.clone())
}

/// Begins to build the mesh without the triangles marked in `bare`; `None` if none is marked.
pub(super) fn leaving_out(mesh: &TriMesh, bare: &[bool]) -> Option<MeshBuilding> {
    if !bare.contains(&true) {
        return None;
    }
    let all = mesh.triangles().iter().zip(bare);
    let kept: Vec<[u32; 3]> = all.filter(|(_, bare)| !**bare).map(|(t, _)| *t).collect();
    let mut number = vec![u32::MAX; mesh.positions().len()];
    let mut positions = Vec::new();
    let mut renamed = |v: u32| {
        let own = &mut number[v as usize];
        if *own == u32::MAX {
            *own = positions.len() as u32;
            positions.push(mesh.positions()[v as usize]);
        }
        *own
    };
    let triangles: Vec<[u32; 3]> = kept.iter().map(|t| t.map(&mut renamed)).collect();
    Some(MeshBuilding::new(positions, triangles))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::testing::{self, mesh};
    use glam::DVec3;

    fn reduced(soup: testing::Soup, most: usize, size: f64) -> (TriMesh, Vec<Code>) {
        let mut work = Reducing::begin(&Arc::new(mesh(soup)), most, size).expect("a huge surface");
        loop {
            if let Some((mesh, notices)) = work.advance() {
                return (mesh, notices.iter().map(|notice| notice.code).collect());
            }
        }
    }

    #[test]
    fn a_huge_surface_becomes_coarser() {
        let full = Arc::new(mesh(testing::blob(5)));
        assert!(Reducing::begin(&full, full.triangles().len() / HUGE, 0.3).is_none());
        // A surface that is smaller than a cell as a whole is simplified, too.
        for size in [0.3, 90.0] {
            let (coarse, said) = reduced(testing::blob(5), 1000, size);
            assert!(coarse.triangles().len() <= 1000);
            assert_eq!(coarse.euler(), full.euler());
            assert!((coarse.area() / full.area() - 1.0).abs() < 0.03);
            assert_eq!(said, [Code::ModelCoarser]);
        }
    }

    /// Each third square of each third row is missing.
    fn sieve(squares: usize) -> testing::Soup {
        let (positions, triangles) = testing::flat(squares as u32);
        let is_kept = |k: &usize| [k / 2 % squares, k / 2 / squares].map(|at| at % 3) != [1, 1];
        let kept = (0..triangles.len()).filter(is_kept);
        let triangles = kept.map(|k| triangles[k]).collect();
        (positions, triangles)
    }

    #[test]
    fn holes_smaller_than_a_cell_keep_no_surface_fine() {
        let (coarse, said) = reduced(sieve(60), 100, 0.2);
        assert!(coarse.triangles().len() <= 100);
        assert_eq!(said, [Code::MendedHoles, Code::ModelCoarser]);
        assert!((coarse.area() - 1.0).abs() < 1e-3);
        // Holes as large as a cell stay.
        let (open, said) = reduced(sieve(60), 100, 1e-3);
        let only = vec![Code::ModelCoarser];
        assert_eq!((open.borders().len(), said), (401, only));
    }

    /// A ball with single small triangles round it.
    fn dusty(count: u32) -> testing::Soup {
        let (mut positions, mut triangles) = testing::ball(3);
        for k in 0..count {
            let at = DVec3::new(2.0, f64::from(k), 0.0);
            let first = positions.len() as u32;
            positions.extend([at, at + 0.01 * DVec3::X, at + 0.01 * DVec3::Z]);
            triangles.push([first, first + 1, first + 2]);
        }
        (positions, triangles)
    }

    #[test]
    fn many_parts_without_cells_are_left_out() {
        let (coarse, said) = reduced(dusty(1000), 100, 0.3);
        assert!((50..=100).contains(&coarse.triangles().len()));
        let both = vec![Code::ModelBare, Code::ModelCoarser];
        assert_eq!((coarse.parts().1, said), (1, both));
        // If only a few parts have no cells, these parts stay.
        let (coarse, said) = reduced(dusty(50), 100, 0.3);
        let only = vec![Code::ModelCoarser];
        assert_eq!((coarse.parts().1, said), (51, only));
    }
}
