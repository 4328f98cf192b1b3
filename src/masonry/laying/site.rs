//! The site: the building with the occupancy maps of its features, and the cells laid so far.

use super::cell::{CellDraft, Feature, MasonryCell};
use super::chords::{EdgeChords, ON, chords, covered, face_chords, same_turn};
use crate::building::{Bend, Building, Edge, EdgeId, Face, FaceId};
use crate::masonry::block::{Plane, Polyhedron};
use crate::masonry::footprint::Footprint;
use crate::masonry::grid_place::GridPlace;
use crate::masonry::occupancy::{EdgeMap, FaceMap};
use crate::masonry::plan::{Plan, region};
use crate::masonry::region::{PartsWork, Region};
use crate::masonry::tree::GeneratorNode;
use glam::{DVec2, DVec3};
use smallvec::SmallVec;
use std::borrow::Cow;
use std::sync::Arc;

/// The least share of a claim that must lie on a face.
const LEAST_SHARE: f64 = 0.05;
/// A side of a cell is a front if the cosine of its normal with the direction of the cell is greater. A stone at a
/// corner has two fronts.
const FRONT: f64 = 0.45;
/// A side of a face slants only if it is longer than this; shorter sides are chords of an arc (metres).
const OBLIQUE: f64 = 0.2;

/// The number of pixels along a module.
pub(super) const PIXELS: f64 = 8.0;

type Bounds = [DVec3; 2];
/// Whether each vertex of a body lies on a face.
type Flags = SmallVec<[bool; 16]>;

/// The building and what is laid on it.
pub(super) struct Site {
    pub building: Arc<Building>,
    pub plan: Plan,
    pub faces: Vec<FaceMap>,
    pub edges: Vec<EdgeMap>,
    pub regions: Vec<Region>,
    /// The directions of each face's long sides that run across its grid.
    pub slopes: Vec<Vec<DVec2>>,
    pub cells: Vec<MasonryCell>,
    /// The number of the node that lays cells now, among those that the feature has reached.
    pub reached: usize,
    boxes: Vec<Bounds>,
    /// The chords of each face's edges, edge by edge.
    chords: Vec<Vec<EdgeChords>>,
    /// The bounding boxes of the edges, so that most of them need no further test.
    pub edge_boxes: Vec<Bounds>,
    /// For each face, the faces whose bounding boxes meet its own.
    near: Vec<Vec<FaceId>>,
    /// The convex edges of each face, with their bounding boxes.
    pub convex: Vec<Vec<(EdgeId, Bounds)>>,
    /// How many pixels lie along a module in the maps of faces.
    pub pixels: f64,
}

impl Site {
    /// The empty site, without the maps of its faces. `pixels` lie along a module in them, usually [`PIXELS`].
    pub fn new(building: Arc<Building>, plan: Plan, pixels: f64) -> Self {
        let edges = building
            .edges()
            .iter()
            .map(|edge| EdgeMap::new(edge.length(), edge.is_closed()));
        let boxes: Vec<Bounds> = building
            .faces()
            .iter()
            .map(|face| bounds(&building, face))
            .collect();
        let regions: Vec<Region> = building.faces().iter().map(region).collect();
        Self {
            faces: Vec::new(),
            edge_boxes: building.edges().iter().map(edge_bounds).collect(),
            edges: edges.collect(),
            near: Vec::new(),
            convex: Vec::new(),
            chords: Vec::new(),
            cells: Vec::new(),
            reached: 0,
            slopes: regions.iter().map(slopes).collect(),
            regions,
            building,
            plan,
            boxes,
            pixels,
        }
    }

    /// The unit of the pattern for maps of faces (metres).
    fn unit(&self) -> f64 {
        self.plan.module.half.min(self.plan.module.course)
    }

    /// Begins with the convex parts of the next face without a map.
    pub fn next_parts(&self) -> PartsWork {
        let id = FaceId(self.faces.len() as u32);
        let margin = FaceMap::margin(self.unit(), self.face(id).surface.period());
        PartsWork::new(&self.regions[id.index()], margin)
    }

    /// Makes the map of the next face from its convex parts, and finds the faces near it.
    pub fn add_map(&mut self, parts: [Vec<Footprint>; 2]) {
        let id = FaceId(self.faces.len() as u32);
        let (region, own) = (&self.regions[id.index()], &self.boxes[id.index()]);
        let period = self.face(id).surface.period();
        let map = FaceMap::with_parts(region, parts, (self.unit(), self.pixels), period);
        let ids = self.building.face_ids();
        let near = ids
            .filter(|id| meet(own, &self.boxes[id.index()]))
            .collect();
        self.faces.push(map);
        self.chords.push(face_chords(&self.building, self.face(id)));
        self.near.push(near);
        let edges = self.face(id).loops.iter().flatten().map(|walk| walk.edge);
        let convex = edges.filter(|&id| self.edge(id).bend == Bend::Convex);
        let convex = convex.map(|id| (id, self.edge_boxes[id.index()])).collect();
        self.convex.push(convex);
    }

    /// Whether each face has its map.
    pub fn has_all_maps(&self) -> bool {
        self.faces.len() == self.building.faces().len()
    }

    pub fn face(&self, id: FaceId) -> &Face {
        self.building.face(id)
    }

    pub fn edge(&self, id: EdgeId) -> &Edge {
        self.building.edge(id)
    }

    /// The point in space at a place of a face; it lies behind the face where z is negative.
    pub fn at(&self, id: FaceId, place: DVec2, z: f64) -> DVec3 {
        self.face(id).surface.map(place.x, place.y, z).origin
    }

    /// The outward normal of a face at a place.
    pub fn normal(&self, id: FaceId, place: DVec2) -> DVec3 {
        self.face(id).surface.frame(place.x, place.y).normal
    }

    /// Places a cell: it claims space on each face on which it lies, and on the edges of these faces. Its sides that
    /// lie on faces are exposed; all others are joints. False if it has no volume.
    pub fn place(&mut self, feature: Feature, node: &GeneratorNode, draft: CellDraft) -> bool {
        if !draft.claimed.is_sound() {
            return false;
        }
        let (claims, on) = self.claims(feature, &draft.claimed);
        let claimed = self.with_joints(draft.claimed, &on);
        self.settle(feature, node, CellDraft { claimed, ..draft }, claims);
        true
    }

    /// Adds a cell whose joints and claims are known. Its exposed sides that look towards `fronts` of the draft are
    /// moved out by `extrude`.
    pub fn settle(
        &mut self,
        feature: Feature,
        node: &GeneratorNode,
        draft: CellDraft,
        claims: Vec<(FaceId, Footprint)>,
    ) {
        let number = self.cells.len() as u32;
        let around = draft.claimed.bounds();
        for (face, footprint) in &claims {
            self.faces[face.index()].claim(footprint, number);
            self.claim_edges(*face, footprint, (number, &around));
        }
        let claimed = Arc::new(draft.claimed);
        let is_front = |plane: &Plane| {
            draft
                .fronts
                .iter()
                .any(|front| plane.normal.dot(*front) > FRONT)
        };
        let mut fronts = Vec::new();
        if draft.extrude != 0.0 {
            let sides = claimed.planes().zip(claimed.sides());
            let exposed = sides.filter(|(plane, side)| side.inset == 0.0 && is_front(plane));
            fronts.extend(exposed.map(|(plane, _)| plane));
        }
        self.cells.push(MasonryCell {
            feature,
            generator: node.generator,
            reached: self.reached,
            tag: node.count("tag") as u8,
            sort: draft.sort,
            body: match fronts.is_empty() {
                true => claimed.clone(),
                false => Arc::new(claimed.as_ref().clone().raised(&fronts, draft.extrude)),
            },
            claimed,
            outwards: draft.outwards,
            claims,
            unclipped: draft.unclipped,
        });
    }

    /// The body with an inset of half a joint at each side that lies on no face.
    fn with_joints(&self, body: Polyhedron, on_faces: &[Flags]) -> Polyhedron {
        let half = 0.5 * self.plan.module.joint;
        body.with_insets_of(|side| {
            let lies_on = |on: &Flags| side.corners.iter().all(|&v| on[v as usize]);
            let is_exposed = on_faces.iter().any(lies_on);
            if is_exposed { 0.0 } else { half }
        })
    }

    /// The faces that a cell may lie on, rising.
    fn candidates(&self, feature: Feature) -> Cow<'_, [FaceId]> {
        let own = match feature {
            Feature::Face(face) => return Cow::Borrowed(&self.near[face.index()]),
            Feature::Edge(edge) => &self.edge(edge).faces[..],
            Feature::Corner(corner) => &self.building.corner(corner).faces[..],
        };
        let near = own.iter().flatten().map(|face| &self.near[face.index()]);
        let mut all: Vec<FaceId> = near.flatten().copied().collect();
        all.sort_unstable();
        all.dedup();
        Cow::Owned(all)
    }

    /// The claims of a body: for each face the hull of the vertices that lie on it, if there are three. Also the flags
    /// of these vertices for each claim. The paper claims on the faces beside the feature only (section 3.3). Thin
    /// slabs need all faces.
    fn claims(
        &self,
        feature: Feature,
        body: &Polyhedron,
    ) -> (Vec<(FaceId, Footprint)>, SmallVec<[Flags; 4]>) {
        let around = body.bounds();
        // Most cells of a face have one claim.
        let (mut claims, mut flags) = (Vec::with_capacity(1), SmallVec::new());
        for &id in &*self.candidates(feature) {
            if !meet(&around, &self.boxes[id.index()]) {
                continue;
            }
            let Some((footprint, on)) = self.footprint(id, body) else {
                continue;
            };
            let is_own = feature == Feature::Face(id);
            if is_own || self.faces[id.index()].has_inside(&footprint, LEAST_SHARE) {
                claims.push((id, footprint));
                flags.push(on);
            }
        }
        (claims, flags)
    }

    /// The hull of a body's vertices on a face, in its (s, t), and the flags of these vertices.
    fn footprint(&self, id: FaceId, body: &Polyhedron) -> Option<(Footprint, Flags)> {
        let surface = &self.face(id).surface;
        let mut found: SmallVec<[DVec2; 8]> = SmallVec::new();
        let is_on = |&p: &DVec3| {
            if surface.is_off(p, ON) {
                return false;
            }
            let place = surface.project(p);
            let is_on = place.z.abs() < ON;
            found.extend(is_on.then_some(place.truncate()));
            is_on
        };
        let on: Flags = body.vertices().iter().map(is_on).collect();
        if found.len() < 3 {
            return None;
        }
        if let (Some(period), Some(&first)) = (surface.period(), found.first()) {
            for place in &mut found {
                place.x -= period * ((place.x - first.x) / period).round();
            }
        }
        let hull = Footprint::hull(&found)?;
        Some((self.home(id, hull), on))
    }

    /// A polygon moved by whole periods to where the face's region is.
    pub fn home(&self, id: FaceId, polygon: Footprint) -> Footprint {
        match self.face(id).surface.period() {
            Some(period) => {
                let way = self.way_home(id, &polygon, period);
                polygon.moved(way)
            }
            None => polygon,
        }
    }

    /// As [`Self::home`], for a rectangle along s and t.
    pub fn home_place(&self, id: FaceId, place: GridPlace) -> GridPlace {
        match self.face(id).surface.period() {
            Some(period) => place.moved(self.way_home(id, &place.footprint(), period)),
            None => place,
        }
    }

    /// The displacement, by whole periods, from a polygon to where the face's region is.
    fn way_home(&self, id: FaceId, polygon: &Footprint, period: f64) -> DVec2 {
        let low = self.face(id).bounds()[0].x;
        let turns = ((polygon.centre().x - low) / period).floor();
        DVec2::new(-turns * period, 0.0)
    }

    /// Whether an edge comes nearer than `near` to a place in space (metres).
    pub fn passes(&self, id: EdgeId, p: DVec3, near: f64) -> bool {
        let path = &self.edge(id).path;
        let along = path.project(p).clamp(0.0, path.length());
        path.point(along).distance(p) < near
    }

    /// Claims the parts of a face's edges that lie in or along a claim. `around` is the bounding box of the cell.
    fn claim_edges(&mut self, id: FaceId, footprint: &Footprint, (cell, around): (u32, &Bounds)) {
        let period = self.face(id).surface.period();
        let middle = period.map_or(DVec2::ZERO, |_| footprint.centre());
        let edges = self.chords[id.index()].iter();
        for edge in edges.filter(|edge| meet(around, &self.edge_boxes[edge.id.index()])) {
            for chord in &edge.chords {
                let ends = same_turn(chord.ends, middle, period);
                if let Some(part) = covered(footprint, ends) {
                    let [from, to] = chord.span;
                    let span = part.map(|part| from + part * (to - from));
                    self.edges[edge.id.index()].claim(span, cell);
                }
            }
        }
    }
}

/// The directions of the long sides of a region that run across its grid.
fn slopes(region: &Region) -> Vec<DVec2> {
    let ways = region.sides().map(|[a, b]| b - a);
    let is_oblique = |way: &DVec2| {
        let size = way.abs();
        size.min_element() > 0.1 * size.max_element() && way.length() > OBLIQUE
    };
    ways.filter(is_oblique).map(DVec2::normalize).collect()
}

/// The bounding box of a face.
fn bounds(building: &Building, face: &Face) -> Bounds {
    let places = face
        .polygons
        .iter()
        .flat_map(|&id| building.polygon(id).vertices.iter());
    let places = places.map(|&v| building.vertex(v).position);
    places.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], p| {
        [low.min(p), high.max(p)]
    })
}

/// The bounding box of an edge; an arc may go beyond it by less than the tolerance of [`meet`].
fn edge_bounds(edge: &Edge) -> Bounds {
    let ends = chords(edge).into_iter().flatten();
    let places = ends.map(|along| edge.path.point(along));
    places.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], p| {
        [low.min(p), high.max(p)]
    })
}

/// Whether two boxes meet, or nearly (within 40 mm). Most are apart along the first axis already.
pub(super) fn meet([low, high]: &Bounds, [from, to]: &Bounds) -> bool {
    let is_apart = |low: f64, high: f64| low - high > 20.0 * ON;
    let is_beside = |k: usize| is_apart(from[k], high[k]) || is_apart(low[k], to[k]);
    !(is_beside(0) || is_beside(1) || is_beside(2))
}
