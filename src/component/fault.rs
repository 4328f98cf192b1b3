//! Why a file's mesh is no component.

use super::crossing::CrossingSearch;
use crate::decimal;
use crate::notice::{Code, Notice};
use crate::trimesh::repair::{Mended, MeshRepair};
use crate::trimesh::{Search, Soup, TriMesh};
use glam::DVec3;
use std::sync::Arc;

/// A mesh is flat if its volume is less than this share of its diagonal's cube.
const FLAT: f64 = 1e-9;
/// The least thickness of a component, in its diagonals.
const THIN: f64 = 1.0 / 200.0;

/// Why a file's mesh is no component.
#[derive(Clone, Debug, PartialEq)]
pub enum ComponentFault {
    /// There are no triangles with an area.
    Empty,
    /// The file is broken in some other way, which the notice names.
    Broken(Notice),
    /// The surface has a border.
    Open {
        /// Edges with one triangle.
        edges: usize,
    },
    /// The surface has one side only, as a Moebius strip.
    OneSided,
    /// The surface encloses no volume.
    Flat,
    /// The surface crosses itself.
    Crossing {
        /// Pairs of triangles that cross.
        pairs: usize,
        /// A place where two of them cross, in the units of the mesh that was checked.
        at: DVec3,
    },
    /// The largest inner sphere is too small beside the diagonal.
    Thin {
        /// The diagonal over the thickness; above 200.
        ratio: f64,
    },
}

impl ComponentFault {
    /// The same fault with its place mapped to other coordinates.
    pub fn mapped(mut self, map: impl FnOnce(DVec3) -> DVec3) -> Self {
        if let Self::Crossing { at, .. } = &mut self {
            *at = map(*at);
        }
        self
    }

    /// The sentence on the fault.
    pub fn notice(self) -> Notice {
        match self {
            Self::Empty => Code::ModelNoArea.into(),
            Self::Broken(notice) => notice,
            Self::Open { edges } => Notice::new(Code::ComponentOpen).with("edges", edges),
            Self::OneSided => Code::ModelOneSided.into(),
            Self::Flat => Code::ComponentFlat.into(),
            Self::Crossing { pairs, at } => {
                let places = places(at);
                let at = at.to_array().map(|v| decimal::text_to(places, v));
                let at = at.join(", ");
                let notice = Notice::new(Code::ComponentCrossing).with("pairs", pairs);
                notice.with("at", at)
            }
            Self::Thin { ratio } => {
                Notice::new(Code::ComponentThin).with("ratio", ratio.round() as usize)
            }
        }
    }
}

impl From<Notice> for ComponentFault {
    fn from(notice: Notice) -> Self {
        match notice.code {
            Code::ModelEmpty | Code::ModelNoArea => Self::Empty,
            Code::ModelOneSided => Self::OneSided,
            _ => Self::Broken(notice),
        }
    }
}

/// The places behind the point to which a place is rounded: two, or more for a small file.
fn places(at: DVec3) -> usize {
    let most = at.abs().max_element();
    let steps = [1e2, 1e3, 1e4, 1e5];
    2 + steps.iter().take_while(|step| most * **step < 50.0).count()
}

/// Whether a component with this largest inner sphere and this diagonal is thick enough.
///
/// # Errors
/// [`ComponentFault::Thin`].
pub(super) fn thick(radius: f64, diagonal: f64) -> Result<(), ComponentFault> {
    let ratio = diagonal / (2.0 * radius);
    match ratio * THIN <= 1.0 {
        true => Ok(()),
        false => Err(ComponentFault::Thin { ratio }),
    }
}

enum CheckPhase {
    Mend(Box<MeshRepair>),
    Tree,
    Cross,
}

/// Mends and checks the mesh of a file, in slices. Parts are turned outwards by their volumes.
pub struct Checking {
    phase: CheckPhase,
    mended: Option<Mended>,
    search: Option<Search>,
    crossing: CrossingSearch,
}

/// A closed mesh that does not cross itself, and the notices of faults that were mended.
pub type Checked = Result<(Arc<TriMesh>, Vec<Notice>), ComponentFault>;

impl Checking {
    /// Starts with the triangles of a file.
    pub fn new(soup: Soup) -> Self {
        Self {
            phase: CheckPhase::Mend(Box::new(MeshRepair::new(soup))),
            mended: None,
            search: None,
            crossing: CrossingSearch::default(),
        }
    }

    /// Works on at most `amount` triangles, or on a slice of the repair. Returns the mesh or the fault in the end.
    pub fn advance(&mut self, amount: usize) -> Option<Checked> {
        if let CheckPhase::Mend(repair) = &mut self.phase {
            let mended = match repair.advance()? {
                Ok(mended) => mended,
                Err(notice) => return Some(Err(notice.into())),
            };
            if let Err(fault) = closed(&mended.mesh) {
                return Some(Err(fault));
            }
            self.search = Some(Search::begin(&mended.mesh));
            self.mended = Some(mended);
            self.phase = CheckPhase::Tree;
            return None;
        }
        let (mended, search) = (self.mended.as_ref()?, self.search.as_mut()?);
        if let CheckPhase::Tree = self.phase {
            if search.advance(&mended.mesh, amount) {
                self.phase = CheckPhase::Cross;
            }
            return None;
        }
        let found = self.crossing.advance(&mended.mesh, search, amount)?;
        if let Some(at) = found.at {
            let pairs = found.pairs;
            return Some(Err(ComponentFault::Crossing { pairs, at }));
        }
        let mended = self.mended.take()?;
        Some(Ok((Arc::new(mended.mesh), mended.notices)))
    }
}

/// Whether a mesh has no border, and encloses a volume.
fn closed(mesh: &TriMesh) -> Result<(), ComponentFault> {
    let Some(body) = mesh.closed() else {
        let all = (0..mesh.triangles().len() as u32).flat_map(|t| (0..3).map(move |k| (t, k)));
        let edges = all.filter(|&(t, k)| mesh.across(t, k).is_none()).count();
        return Err(ComponentFault::Open { edges });
    };
    let size = mesh.diagonal();
    match body.volume() > FLAT * size * size * size {
        true => Ok(()),
        false => Err(ComponentFault::Flat),
    }
}
