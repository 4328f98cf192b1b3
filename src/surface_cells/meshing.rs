//! Makes the mesh and the polygons of cells, in slices.

use super::SurfaceMesh;
use super::bends::Bends;
use super::borders::{Border, Crossing, crossings};
use super::divided::Divided;
use super::flips::Flips;
use super::flood::Flood;
use super::junctions::Junctions;
use super::nodes::SurfaceNodes;
use super::rings::{CornerRing, RingInputs};
use super::smooth::settle;
use super::straighten::{Straightening, Table};
use crate::mesh::Smoothing;
use crate::mesh::patch::{Goal, PatchSearch, SearchInputs};
use crate::mesh::quads::{Faces, Pairing, is_lone};
use crate::mesh::requad::STANDARDS;
use crate::mesh::triangles::Triangles;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{NONE, SurfacePoint, TriMesh};

/// Triangles in a slice of the pairing.
const PAIRS: usize = 4000;
/// Work of the search in a slice: the sum of the squared numbers of corners of the patches.
const WORK: usize = 25_000;
/// Triangles whose meeting places are computed in a slice.
const PLACES: usize = 6000;
/// Middles in a slice.
const MIDDLES: usize = 1000;
/// Rings in a slice.
const RINGS: usize = 5000;
/// The fewest corners that pairing leaves to a cell; with three it would be a wedge ...
const CORNERS: u32 = 4;
/// ... but a pair with a score above this is nearly a rectangle, and may leave three.
const RECTANGLE: f64 = 0.9;
/// The fewest sides that pairing leaves at an inner node when it makes the mesh.
const FEWEST: u32 = 3;
/// Lone triangles are joined over the elements between them while their share of all elements is above this ...
const FEW_TRIANGLES: f64 = 0.02;
/// ... plus a number for the singular points of a ball.
const SINGULAR: f64 = 8.0;
/// Nodes that are tried in one slice of a smoothing.
const TRIED: usize = 600;
/// Nodes to move in a slice.
const WALKS: usize = 5000;

/// The fewest corners that a pair with this score leaves to a cell.
fn corners(score: f64) -> u32 {
    if score > RECTANGLE { FEWEST } else { CORNERS }
}

/// How cells are finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Polish {
    /// Whether the mesh itself is wanted, with few lone triangles: lone triangles near each other become quadrilaterals
    /// with the elements between them. The cells do not change.
    pub join: bool,
    /// Whether cells with four corners become more like rectangles.
    pub straighten: bool,
}

impl Default for Polish {
    fn default() -> Self {
        Self {
            join: true,
            straighten: true,
        }
    }
}

/// Makes the mesh and the polygons of cells, in slices.
pub struct SurfaceMeshing {
    made: SurfaceMesh,
    polish: Polish,
    nodes: SurfaceNodes,
    triangles: Triangles,
    /// The approximate place of each triangle.
    places: Vec<SurfacePoint>,
    faces: Faces,
    label: Vec<u32>,
    bends: Bends,
    borders: Vec<Border>,
    crossings: Vec<Crossing>,
    rings: Vec<Option<CornerRing>>,
    step: Option<MeshingPhase>,
}

/// The step of the work.
enum MeshingPhase {
    Begin,
    Divide(Divided),
    Flood(Divided, Flood),
    Junctions(Divided, Junctions),
    Places(Divided, Vec<u32>),
    Flips(Flips),
    /// Steps for the cells.
    Pairs(Pairing),
    Middles,
    Borders,
    Rings(usize),
    Shapes,
    Straighten(Straightening),
    /// Steps for the mesh.
    Mesh(Pairing),
    Join(usize, PatchSearch),
    Smooth(usize, Smoothing),
    Settle(usize),
    Finish,
}

impl SurfaceMeshing {
    /// Starts with cells that are placed on a mesh, in any order.
    pub fn new(mut cells: Vec<SurfaceParticle>, polish: Polish) -> Self {
        order::sort(&mut cells, |c| (c.id.into(), 0));
        Self {
            nodes: SurfaceNodes::default(),
            made: SurfaceMesh {
                cells,
                ..SurfaceMesh::default()
            },
            polish,
            triangles: Triangles::default(),
            places: Vec::new(),
            faces: Faces::default(),
            label: Vec::new(),
            bends: Bends::default(),
            borders: Vec::new(),
            crossings: Vec::new(),
            rings: Vec::new(),
            step: Some(MeshingPhase::Begin),
        }
    }

    /// Does one more slice, on the same mesh each time; returns the result when it is done.
    pub fn advance(&mut self, mesh: &TriMesh) -> Option<SurfaceMesh> {
        let step = self.step.take()?;
        let next = self.work(mesh, step);
        if matches!(next, MeshingPhase::Finish) {
            self.finish();
            return Some(std::mem::take(&mut self.made));
        }
        self.step = Some(next);
        None
    }

    fn work(&mut self, mesh: &TriMesh, step: MeshingPhase) -> MeshingPhase {
        let cells = &self.made.cells;
        match step {
            MeshingPhase::Begin => {
                self.nodes = SurfaceNodes::new(cells);
                MeshingPhase::Divide(Divided::new(mesh, cells))
            }
            MeshingPhase::Divide(mut divided) => {
                if !divided.advance(mesh, cells) {
                    return MeshingPhase::Divide(divided);
                }
                let flood = Flood::new(&divided, cells);
                MeshingPhase::Flood(divided, flood)
            }
            MeshingPhase::Flood(divided, mut flood) => {
                if !flood.advance(mesh, &divided) {
                    return MeshingPhase::Flood(divided, flood);
                }
                self.label = flood.label;
                MeshingPhase::Junctions(divided, Junctions::default())
            }
            MeshingPhase::Junctions(divided, mut junctions) => {
                let Some(triangles) = junctions.advance(&divided, &self.label) else {
                    return MeshingPhase::Junctions(divided, junctions);
                };
                self.triangles = triangles;
                MeshingPhase::Places(divided, junctions.places)
            }
            MeshingPhase::Places(divided, triangles) => {
                let from = self.places.len();
                let to = triangles.len().min(from + PLACES);
                let places = triangles[from..to].iter();
                let places = places.map(|&t| divided.middle(mesh, cells, t));
                self.places.extend(places);
                if to < triangles.len() {
                    return MeshingPhase::Places(divided, triangles);
                }
                self.nodes.meetings.add(&self.triangles, &self.places);
                MeshingPhase::Flips(Flips::new(&self.nodes, &self.triangles))
            }
            step => self.join_triangles(mesh, step),
        }
    }

    /// The steps that join triangles, and smooth what they have made.
    fn join_triangles(&mut self, mesh: &TriMesh, step: MeshingPhase) -> MeshingPhase {
        let nodes = &self.nodes;
        match step {
            MeshingPhase::Flips(mut flips) => {
                if !flips.advance(nodes, &mut self.triangles) {
                    return MeshingPhase::Flips(flips);
                }
                // After a flip both triangles are about where they were.
                self.nodes.meetings.add(&self.triangles, &self.places);
                MeshingPhase::Pairs(Pairing::default())
            }
            MeshingPhase::Pairs(mut pairing) => {
                if !pairing.advance(nodes, &self.triangles, |_| false, PAIRS) {
                    return MeshingPhase::Pairs(pairing);
                }
                self.faces = pairing.finish(self.nodes.points.len(), &self.triangles, corners);
                MeshingPhase::Middles
            }
            MeshingPhase::Mesh(mut pairing) => {
                if !pairing.advance(nodes, &self.triangles, |_| false, PAIRS) {
                    return MeshingPhase::Mesh(pairing);
                }
                self.faces = pairing.finish(self.nodes.points.len(), &self.triangles, |_| FEWEST);
                self.join(0)
            }
            MeshingPhase::Join(number, mut search) => {
                let on = SearchInputs {
                    nodes,
                    keep: |_| false,
                };
                if !search.advance(&on, WORK) {
                    return MeshingPhase::Join(number, search);
                }
                self.faces = search.finish();
                MeshingPhase::Smooth(number, Smoothing::new(&self.faces.faces, self.free()))
            }
            MeshingPhase::Smooth(number, mut smoothing) => {
                if !smoothing.advance(&mut self.nodes, &self.faces.faces, TRIED) {
                    return MeshingPhase::Smooth(number, smoothing);
                }
                self.join(number + 1)
            }
            step => self.bound_cells(mesh, step),
        }
    }

    /// The steps that settle the points and give the cells their corners.
    fn bound_cells(&mut self, mesh: &TriMesh, step: MeshingPhase) -> MeshingPhase {
        let cells = &self.made.cells;
        match step {
            MeshingPhase::Settle(from) => {
                let to = cells.len().min(from + WALKS);
                settle(mesh, &mut self.nodes, from, to, |k| cells[k].centre);
                if to < cells.len() {
                    MeshingPhase::Settle(to)
                } else {
                    MeshingPhase::Finish
                }
            }
            MeshingPhase::Middles => self.middles(mesh),
            MeshingPhase::Borders => {
                self.bends = Bends::new(mesh, cells, &self.faces, &mut self.made.corners);
                self.made.inner = self.made.corners.len();
                self.borders = Border::all(mesh);
                self.crossings = crossings(&self.borders, &self.label, cells);
                let point = |c: &Crossing| self.borders[c.border as usize].point(mesh, c.at);
                self.made.corners.extend(self.crossings.iter().map(point));
                MeshingPhase::Rings(0)
            }
            MeshingPhase::Rings(from) => self.rings(mesh, from),
            MeshingPhase::Shapes => MeshingPhase::Straighten(Straightening::new(&self.table())),
            MeshingPhase::Straighten(mut straightening) => {
                let table = self.table();
                if !straightening.advance(&table) {
                    return MeshingPhase::Straighten(straightening);
                }
                self.made.corners = straightening.finish(mesh, &table);
                self.mesh()
            }
            step => step,
        }
    }

    /// Begins the next search that joins lone triangles, unless there are few enough.
    fn join(&mut self, number: usize) -> MeshingPhase {
        let lone = self.faces.faces.iter();
        let lone = lone.filter(|f| is_lone(&self.nodes, f)).count();
        let few = (FEW_TRIANGLES * self.faces.faces.len() as f64 + SINGULAR) as usize;
        match STANDARDS.get(number) {
            Some(&worst) if lone > few => {
                let goal = Goal {
                    worst,
                    few,
                    least: FEWEST as i32,
                };
                let on = SearchInputs {
                    nodes: &self.nodes,
                    keep: (),
                };
                let faces = std::mem::take(&mut self.faces);
                MeshingPhase::Join(number, PatchSearch::new(&on, faces, goal))
            }
            _ => MeshingPhase::Settle(0),
        }
    }

    /// Marks the nodes that may move: the inner ones.
    fn free(&self) -> Vec<bool> {
        let mut free = vec![true; self.nodes.points.len()];
        for (face, adjacent) in self.faces.faces.iter().zip(&self.faces.adjacent) {
            let corners = face.nodes();
            for k in (0..corners.len()).filter(|&k| adjacent[k] == NONE) {
                free[corners[k] as usize] = false;
                free[corners[(k + 1) % corners.len()] as usize] = false;
            }
        }
        free
    }

    /// The step after the cells: the mesh, if it is wanted.
    fn mesh(&self) -> MeshingPhase {
        if self.polish.join {
            MeshingPhase::Mesh(Pairing::default())
        } else {
            MeshingPhase::Finish
        }
    }

    fn middles(&mut self, mesh: &TriMesh) -> MeshingPhase {
        let from = self.made.corners.len();
        let to = self.faces.faces.len().min(from + MIDDLES);
        for face in &self.faces.faces[from..to] {
            let place = self.nodes.meetings.middle(mesh, &self.made.cells, face);
            self.made.corners.push(place);
        }
        if to < self.faces.faces.len() {
            MeshingPhase::Middles
        } else {
            MeshingPhase::Borders
        }
    }

    fn rings(&mut self, mesh: &TriMesh, from: usize) -> MeshingPhase {
        let first = self.made.inner as u32;
        let lines = (&self.borders[..], &self.crossings[..]);
        let links = RingInputs::new(
            mesh,
            &self.made.cells,
            &self.faces,
            &self.bends,
            lines,
            first,
        );
        let to = self.made.cells.len().min(from + RINGS);
        for cell in from as u32..to as u32 {
            let ring = links.ring(cell, &mut self.made.corners);
            self.rings.push(ring);
        }
        if to < self.made.cells.len() {
            return MeshingPhase::Rings(to);
        }
        for border in &self.borders {
            if let Some(cell) = border.only(&self.label)
                && links.element[cell as usize] == NONE
                && self.rings[cell as usize].is_none()
            {
                self.rings[cell as usize] = links.whole(border, cell, &mut self.made.corners);
            }
        }
        if !self.polish.straighten {
            return self.mesh();
        }
        MeshingPhase::Shapes
    }

    fn table(&self) -> Table<'_> {
        Table {
            cells: &self.made.cells,
            rings: &self.rings,
            corners: &self.made.corners,
            borders: &self.borders,
            crossings: &self.crossings,
            first_crossing: self.made.inner,
        }
    }

    fn finish(&mut self) {
        self.made.nodes = std::mem::take(&mut self.nodes.points);
        let faces = std::mem::take(&mut self.faces.faces).into_iter();
        self.made.elements = faces.filter(|face| !face.is_none()).collect();
        let rings = std::mem::take(&mut self.rings).into_iter();
        self.made.rings = rings
            .map(|ring| ring.map_or(Vec::new(), |r| r.corners))
            .collect();
    }
}
