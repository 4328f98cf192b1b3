//! Makes a building from a draft, in slices.

use super::checking;
use super::class::{Bend, CornerClass};
use super::draft::Draft;
use super::fault::{BuildingFault, BuildingWarning};
use super::ids::{CornerId, EdgeId, PolygonId, VertexId};
use super::labels;
use super::making_child::{Child, ChildMaking};
use super::making_corners::{self, Names};
use super::making_parent::{self, Chains};
use super::parent::{Corner, Edge, EdgeUse, Face};
use super::sides::{self, SideTable, key};
use super::whole::{Building, EdgeFrame};
use super::wings::Wings;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Faces whose planes differ by less are tangent: about a degree (radians).
const SMOOTH: f64 = 0.0175;

/// The work of making a building from a draft, in slices.
#[derive(Default)]
pub struct BuildingMaking {
    step: MakingStep,
}

/// The progress of the work.
#[derive(Default)]
enum MakingStep {
    #[default]
    Begun,
    Checked,
    Joined(SideTable, ChildMaking),
    Child(SideTable, Child),
    Meshes(SideTable, Chains, Building),
    Bent(SideTable, Chains, Building),
    Cornered(SideTable, Chains, Building),
}

impl BuildingMaking {
    /// Does a slice of the work on a draft, which must always be the same one. Returns the building at the end.
    ///
    /// # Errors
    /// The first fault of the draft.
    pub fn advance(&mut self, draft: &Draft) -> Result<Option<Building>, BuildingFault> {
        self.step = match std::mem::take(&mut self.step) {
            MakingStep::Begun => {
                checking::check(draft)?;
                MakingStep::Checked
            }
            MakingStep::Checked => {
                let sides = sides::join(draft)?;
                let child = ChildMaking::new(&sides)?;
                MakingStep::Joined(sides, child)
            }
            MakingStep::Joined(sides, mut child) => match child.advance(draft, &sides)? {
                Some(child) => MakingStep::Child(sides, child),
                None => MakingStep::Joined(sides, child),
            },
            MakingStep::Child(mut sides, child) => {
                let chains = making_parent::find(&sides);
                let building = Building::unlinked(draft, (&mut sides, &chains), child);
                MakingStep::Meshes(sides, chains, building)
            }
            MakingStep::Meshes(sides, chains, mut building) => {
                building.bend();
                building.label_edges();
                MakingStep::Bent(sides, chains, building)
            }
            MakingStep::Bent(sides, chains, mut building) => {
                building.add_corners(&sides, &chains);
                MakingStep::Cornered(sides, chains, building)
            }
            MakingStep::Cornered(sides, chains, mut building) => {
                building.link();
                building.name(draft, &Names::new(&sides, &chains));
                building.list_open_edges();
                return Ok(Some(building));
            }
        };
        Ok(None)
    }
}

impl Building {
    /// Checks a draft, and makes both meshes of it.
    ///
    /// Vertices within 0.2 mm are welded. Consecutive sides that lie between the same two faces and turn by less than
    /// 28 degrees form one edge; all other vertices of loops are corners. A side at which a face meets itself, as the
    /// seam of a cylinder, is dropped.
    ///
    /// # Errors
    /// The first fault of the draft.
    pub fn new(draft: &Draft) -> Result<Self, BuildingFault> {
        let mut making = BuildingMaking::default();
        loop {
            if let Some(building) = making.advance(draft)? {
                return Ok(building);
            }
        }
    }

    /// Both meshes, as yet without corners, without the edges' neighbours and without their bends.
    fn unlinked(draft: &Draft, (sides, chains): (&mut SideTable, &Chains), child: Child) -> Self {
        Self {
            faces: faces(draft, sides, chains, &child),
            edges: edges(sides, chains, &child),
            warnings: std::mem::take(&mut sides.warnings),
            vertices: child.vertices,
            polygon_edges: child.edges,
            polygons: child.polygons,
            corners: Vec::new(),
            extras: draft.extras.clone(),
            ground: draft.ground,
        }
    }

    /// Finds how the faces meet along each edge.
    fn bend(&mut self) {
        for id in self.edge_ids() {
            let frame = self.edge_frame(id, 0.5 * self.edge(id).length());
            let (bend, dihedral) = bend(&frame);
            let edge = &mut self.edges[id.index()];
            (edge.bend, edge.dihedral) = (bend, dihedral);
        }
    }

    fn label_edges(&mut self) {
        for id in self.edge_ids() {
            let faces = self.edge(id).faces.into_iter().flatten();
            let labels = labels::taken(faces.map(|face| &self.face(face).labels[..]));
            self.edges[id.index()].labels = labels;
        }
    }

    fn add_corners(&mut self, sides: &SideTable, chains: &Chains) {
        let around = making_corners::around(sides, chains);
        for (id, around) in (0..).map(CornerId).zip(around) {
            let faces = around.faces.iter().flatten();
            let labels = labels::taken(faces.map(|&face| &self.face(face).labels[..]));
            let bends = around.edges.iter();
            let bends: Vec<_> = bends
                .map(|&end| (self.edge(end.edge).bend, self.leaving(end)))
                .collect();
            if around.fans > 1 {
                self.warnings.push(BuildingWarning::Pinched(id));
            }
            for end in &around.edges {
                self.edges[end.edge.index()].corners[end.end] = Some(id);
            }
            self.vertices[around.vertex as usize].corner = Some(id);
            self.corners.push(Corner {
                vertex: VertexId(around.vertex),
                edges: around.edges,
                faces: around.faces,
                labels,
                has_own_labels: false,
                class: CornerClass::new(&bends),
                flip: false,
            });
        }
    }

    /// Sets the neighbours of edges, and the edges of polygon edges.
    fn link(&mut self) {
        for face in &self.faces {
            for ring in &face.loops {
                let n = ring.len();
                for k in 0..n {
                    let side = usize::from(!ring[k].forward);
                    let wings = &mut self.edges[ring[k].edge.index()].wings;
                    wings.next[side] = Some(ring[(k + 1) % n].edge);
                    wings.previous[side] = Some(ring[(k + n - 1) % n].edge);
                }
            }
        }
        for (k, edge) in self.edges.iter().enumerate() {
            for (part, _) in &edge.chain {
                self.polygon_edges[part.index()].edge = Some(EdgeId(k as u32));
            }
        }
    }

    /// Gives features the labels and flips that the draft has for them.
    fn name(&mut self, draft: &Draft, names: &Names<'_>) {
        let no_edge = |vertices| BuildingWarning::NoSuchEdge { vertices };
        let no_corner = |vertex| BuildingWarning::NoSuchCorner { vertex };
        for (vertices, label) in &draft.edge_labels {
            match names.edge(*vertices) {
                Some(id) => {
                    let edge = &mut self.edges[id.index()];
                    own_label(&mut edge.labels, &mut edge.has_own_labels, label);
                }
                None => self.warnings.push(no_edge(*vertices)),
            }
        }
        for (vertex, label) in &draft.corner_labels {
            match names.corner(*vertex) {
                Some(id) => {
                    let corner = &mut self.corners[id.index()];
                    own_label(&mut corner.labels, &mut corner.has_own_labels, label);
                }
                None => self.warnings.push(no_corner(*vertex)),
            }
        }
        for &vertices in &draft.edge_flips {
            match names.edge(vertices) {
                Some(id) => self.edges[id.index()].flip = true,
                None => self.warnings.push(no_edge(vertices)),
            }
        }
        for &vertex in &draft.corner_flips {
            match names.corner(vertex) {
                Some(id) => self.corners[id.index()].flip = true,
                None => self.warnings.push(no_corner(vertex)),
            }
        }
    }

    fn list_open_edges(&mut self) {
        let is_open = |id: &EdgeId| self.edge(*id).bend == Bend::Open;
        let open: Vec<EdgeId> = self.edge_ids().filter(is_open).collect();
        if !open.is_empty() {
            self.warnings.push(BuildingWarning::OpenEdges(open));
        }
    }
}

/// Adds a label that the draft gives a feature; the first such label replaces the labels taken from the faces.
fn own_label(labels: &mut Vec<String>, has_own: &mut bool, label: &str) {
    if !*has_own {
        labels.clear();
        *has_own = true;
    }
    if labels.iter().all(|known| known != label) {
        labels.push(label.to_owned());
    }
}

fn faces(draft: &Draft, sides: &SideTable, chains: &Chains, child: &Child) -> Vec<Face> {
    let mut polygons: Vec<Vec<PolygonId>> = vec![Vec::new(); draft.faces.len()];
    for (k, polygon) in child.polygons.iter().enumerate() {
        polygons[polygon.face.index()].push(PolygonId(k as u32));
    }
    let all = draft.faces.iter().enumerate().zip(polygons);
    let faces = all.filter_map(|((k, face), polygons)| {
        let loops = sides.loops[k].iter().map(|ring| uses(chains, ring));
        Some(Face {
            labels: face.labels.clone(),
            surface: face.surface.clone()?,
            loops: loops.collect(),
            bounds: bounds(&child.rings[k]),
            rings: child.rings[k].clone(),
            polygons,
            thickness: face.thickness,
        })
    });
    faces.collect()
}

/// The bounding box of rings.
fn bounds(rings: &[Vec<DVec2>]) -> [DVec2; 2] {
    let start = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let all = rings.iter().flatten();
    all.fold(start, |[lo, hi], &p| [lo.min(p), hi.max(p)])
}

/// The edges along a loop of sides, each once.
fn uses(chains: &Chains, ring: &[usize]) -> Vec<EdgeUse> {
    let mut all: Vec<EdgeUse> = Vec::new();
    for &side in ring {
        let (edge, forward) = chains.of_side[side];
        let next = EdgeUse { edge, forward };
        if all.last() != Some(&next) {
            all.push(next);
        }
    }
    // The loop may begin within an edge.
    if all.len() > 1 && all.first() == all.last() {
        all.pop();
    }
    all
}

fn edges(sides: &SideTable, chains: &Chains, child: &Child) -> Vec<Edge> {
    let edge = |chain: &Vec<usize>| {
        let first = &sides.sides[chain[0]];
        let other = first.twin.map(|twin| sides.sides[twin].face);
        let along = chain.iter().flat_map(|&side| child.along[side].windows(2));
        let part = |pair: &[u32]| {
            let id = *child.between.get(&key(pair[0], pair[1]))?;
            Some((id, child.edges[id.index()].vertices[0].0 == pair[0]))
        };
        Edge {
            faces: [Some(first.face), other],
            corners: [None, None],
            path: making_parent::path(&sides.sides, chain),
            chain: along.filter_map(part).collect(),
            wings: Wings::default(),
            bend: Bend::Open,
            dihedral: PI,
            labels: Vec::new(),
            has_own_labels: false,
            flip: false,
        }
    };
    chains.chains.iter().map(edge).collect()
}

/// How faces meet, and the angle that the solid fills between them (radians).
fn bend(frame: &EdgeFrame) -> (Bend, f64) {
    let ([Some(normal), _], [Some(first), Some(second)]) = (frame.normals, frame.inward) else {
        return (Bend::Open, PI);
    };
    // The angle from the first face to the second one through the solid, which lies on the side opposite the normal.
    let angle = libm::atan2(-second.dot(normal), second.dot(first));
    let angle = if angle < 0.0 { angle + TAU } else { angle };
    let bend = if (angle - PI).abs() < SMOOTH {
        Bend::Smooth
    } else if angle < PI {
        Bend::Convex
    } else {
        Bend::Concave
    };
    (bend, angle)
}
