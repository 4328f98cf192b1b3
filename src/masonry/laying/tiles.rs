//! Roof tiles and slates that overlap, and the tiles along ridges and hips.
//!
//! A tile claims a volume, not an area. All tiles of a row lie in a slab of their own. The slab of each row rests on
//! the slab of the row below, so tiles lie on each other over the whole of their lap. Heads touch the roof, and tails
//! are lifted by the thickness of the tiles below. On the roof's surface a tile claims only the part that no other tile
//! covers.

use super::cell::{CellDraft, CellSort, Feature};
use super::site::Site;
use super::work::SiteWork;
use crate::building::{Bend, EdgeId, FaceId};
use crate::masonry::block::{Plane, Polyhedron};
use crate::masonry::footprint::{Footprint, HalfPlane};
use crate::masonry::free_space::{LEAST_SHARE, MOST_DEPTH, clip_multi};
use crate::masonry::plan::pieces;
use crate::masonry::tree::GeneratorNode;
use glam::{DVec2, DVec3};

/// The most rows, and the most tiles in a row.
const MOST: usize = 400;
/// The greatest thickness of a tile over the visible part of its length: beyond it tiles would stand up.
const THICKEST: f64 = 0.5;
/// Half of the gap between neighbours in a row (metres).
const GAP: f64 = 1.5e-3;
/// The width and the thickness of a ridge tile's leaf, over the length and the thickness of other tiles.
const LEAF: [f64; 2] = [0.42, 1.4];
/// The length of a ridge tile over the width of other tiles.
const RIDGE_LENGTH: f64 = 2.0;

/// The rows of tiles on a roof, from the eaves to the ridge.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileRows {
    /// t of the tails of row 0 (metres).
    pub low: f64,
    /// How much of each tile is seen, along t (metres).
    pub gauge: f64,
    /// The length of a tile (metres).
    pub length: f64,
    /// How many rows have their tails on the roof.
    pub count: usize,
    /// How many more rows lie below the first one, cut at the eaves.
    pub under: usize,
    pub thickness: f64,
    /// The sine and the cosine of the angle between tiles and roof.
    turn: [f64; 2],
}

impl TileRows {
    /// The rows between two values of t, with gauges of at most that of the node.
    pub fn new(node: &GeneratorNode, [low, high]: [f64; 2]) -> Self {
        let wanted = node.number("length") * (1.0 - node.number("lap"));
        let count = ((high - low) / wanted - 1e-6).ceil().max(1.0);
        let count = (count as usize).min(MOST);
        let gauge = (high - low) / count as f64;
        let length = node.number("length").max(gauge);
        let thickness = node.number("thickness").min(THICKEST * gauge);
        let sin = thickness / gauge;
        Self {
            low,
            gauge,
            length,
            count,
            under: ((length / gauge - 1e-6).ceil() as usize)
                .saturating_sub(1)
                .min(MOST),
            thickness,
            turn: [sin, (1.0 - sin * sin).sqrt()],
        }
    }

    /// t of the tails of a row; those below the first row have negative numbers.
    pub fn tail(&self, row: isize) -> f64 {
        self.low + self.gauge * row as f64
    }

    /// The (t, z) of a point of a tile. It is given by its t as if the tile lay flat, and by its height above the
    /// tile's lower side.
    fn lifted(&self, row: isize, t: f64, height: f64) -> [f64; 2] {
        let ([sin, cos], along) = (self.turn, t - self.tail(row));
        let lift = self.length * sin;
        [
            self.tail(row) + along * cos + height * sin,
            lift - along * sin + height * cos,
        ]
    }

    /// The height of the tiles' upper sides above the roof at t.
    fn top(&self, t: f64) -> f64 {
        let row = ((t - self.low) / self.gauge + 1e-6).floor() as isize;
        self.lifted(row, t, self.thickness)[1]
    }
}

/// Covers a roof with tiles, row by row. Odd rows are shifted by half a tile.
pub(super) struct TileWork {
    id: FaceId,
    node: GeneratorNode,
    rows: TileRows,
    /// The obstacles around the roof.
    around: Vec<Footprint>,
    /// The least s of the tiled region (metres).
    low: f64,
    /// The number of tiles in a row, and their width (metres).
    columns: (usize, f64),
    /// The next row.
    row: isize,
}

impl TileWork {
    /// The work on a face; none if it is no roof.
    pub fn new(site: &Site, id: FaceId, node: &GeneratorNode) -> Option<Self> {
        let region = site.is_roof(id).then(|| site.tiled_region(id))?;
        let (rows, [low, high]) = (site.tile_rows(id, node)?, region.bounds()?);
        let [_, around] = region.convex_parts(DVec2::splat(rows.length + node.number("width")));
        let columns = pieces(high.x - low.x, node.number("width")).min(MOST);
        Some(Self {
            id,
            node: node.clone(),
            rows,
            around,
            low: low.x,
            columns: (columns, (high.x - low.x) / columns as f64),
            row: -(rows.under as isize),
        })
    }
}

impl SiteWork for TileWork {
    fn advance(&mut self, site: &mut Site) -> bool {
        let (row, (columns, width)) = (self.row, self.columns);
        let shift = if row.rem_euclid(2) == 1 { 0.5 } else { 0.0 };
        for column in 0..=columns {
            let left = self.low + (column as f64 - shift) * width;
            let tail = DVec2::new(left, self.rows.tail(row));
            let whole = Footprint::rectangle(tail, tail + DVec2::new(width, self.rows.length));
            if let Some(whole) = whole {
                let place = (&whole, &self.around[..]);
                site.tile(self.id, &self.node, (&self.rows, row), place);
            }
        }
        self.row += 1;
        self.row >= self.rows.count as isize
    }
}

impl Site {
    /// The rows of tiles on a face.
    pub fn tile_rows(&self, face: FaceId, node: &GeneratorNode) -> Option<TileRows> {
        let [low, high] = self.tiled_region(face).bounds()?;
        Some(TileRows::new(node, [low.y, high.y]))
    }

    /// Lays the parts of a tile that lie within the border.
    fn tile(
        &mut self,
        id: FaceId,
        node: &GeneratorNode,
        (rows, row): (&TileRows, isize),
        (whole, around): (&Footprint, &[Footprint]),
    ) {
        let seen = rows.tail(row) + rows.gauge;
        for part in clip_multi(whole, around, 0.0, (LEAST_SHARE, MOST_DEPTH)) {
            let body = Polyhedron::prism(&part, [0.0, rows.thickness], [0.0; 2], |p, z| {
                let [t, z] = rows.lifted(row, p.y, z);
                self.at(id, DVec2::new(p.x, t), z)
            });
            let Some(body) = self.beside_roofs(id, body) else {
                continue;
            };
            let below = HalfPlane::left_of(DVec2::new(1.0, seen), DVec2::new(0.0, seen));
            let claim = part.clip(below, 0.0).filter(|_| row >= 0);
            let claims = claim.into_iter().map(|claim| (id, claim)).collect();
            self.place_tile(Feature::Face(id), node, (id, body), claims);
        }
    }

    /// Places a tile of a roof, with gaps to its neighbours in the row.
    fn place_tile(
        &mut self,
        feature: Feature,
        node: &GeneratorNode,
        (face, body): (FaceId, Polyhedron),
        claims: Vec<(FaceId, Footprint)>,
    ) {
        let normal = self.normal(face, DVec2::ZERO);
        let body = body.with_insets(|plane, _| {
            let is_beside = plane.normal.dot(normal).abs() < 0.5 && plane.normal.y.abs() < 0.3;
            if is_beside { GAP } else { 0.0 }
        });
        self.settle(
            feature,
            node,
            CellDraft::new(CellSort::Tile, body, normal),
            claims,
        );
    }

    /// The part of a body on a roof that is left by the planes which halve the angles to neighbouring roofs.
    fn beside_roofs(&self, face: FaceId, body: Polyhedron) -> Option<Polyhedron> {
        let middle = body.centre();
        let far = body
            .vertices()
            .iter()
            .map(|p| p.distance(middle))
            .fold(0.0, f64::max);
        let mut edges = self.face(face).loops.iter().flatten().map(|walk| walk.edge);
        edges.try_fold(body, |body, id| {
            let path = &self.edge(id).path;
            let along = path.project(middle);
            let is_beside = (0.0..=path.length()).contains(&along)
                && path.point(along).distance(middle) < 2.0 * far;
            match is_beside.then(|| self.half_way(face, id)).flatten() {
                Some(plane) => body.cut(plane, 0.0),
                None => Some(body),
            }
        })
    }

    /// The plane that halves the angle of a roof to the next one at an edge.
    fn half_way(&self, face: FaceId, id: EdgeId) -> Option<Plane> {
        let other = self.next_roof(face, id)?;
        let edge = self.edge(id);
        let frame = self.building.edge_frame(id, 0.5 * edge.length());
        let inward = frame.inward[edge.side(face)?]?;
        let sum = [face, other]
            .map(|face| self.normal(face, DVec2::ZERO))
            .iter()
            .sum::<DVec3>();
        let across = frame.tangent.cross(sum.try_normalize()?);
        let outwards = if across.dot(inward) > 0.0 {
            -across
        } else {
            across
        };
        Some(Plane::through(frame.origin, outwards))
    }

    /// Covers a ridge or a hip between two roofs with pairs of leaves. The leaves lie on the tiles of both roofs and
    /// meet above the edge.
    pub fn ridge_tiles(&mut self, id: EdgeId, node: &GeneratorNode) {
        let edge = self.edge(id);
        let [Some(a), Some(b)] = edge.faces else {
            return;
        };
        let is_ridge = edge.bend == Bend::Convex && edge.path.pieces().len() == 1;
        if !is_ridge || ![a, b].iter().all(|&face| self.is_roof(face)) {
            return;
        }
        let length = edge.length();
        let over = [0.0, length].map(|at| self.ridge_overhang(id, edge.path.point(at)));
        let (from, to) = (-over[0], length + over[1]);
        let count = pieces(to - from, RIDGE_LENGTH * node.number("width")).min(MOST);
        for k in 0..count {
            let ends = [k, k + 1].map(|k| from + (to - from) * k as f64 / count as f64);
            for face in [a, b] {
                self.ridge_leaf(id, node, face, ends);
            }
        }
    }

    fn ridge_leaf(&mut self, id: EdgeId, node: &GeneratorNode, face: FaceId, ends: [f64; 2]) {
        let Some(rows) = self.tile_rows(face, node) else {
            return;
        };
        let edge = self.edge(id);
        let frame = self.building.edge_frame(id, 0.5 * edge.length());
        let Some(inward) = edge.side(face).and_then(|side| frame.inward[side]) else {
            return;
        };
        let middle = 0.5 * edge.length();
        let place = |along: f64, off: f64| {
            let p = frame.origin + frame.tangent * (along - middle) + inward * off;
            self.face(face).surface.project(p).truncate()
        };
        let width = LEAF[0] * rows.length;
        // On a level ridge the leaf rests on a row's upper side; on a hip it must clear the tails of all rows.
        let low = match frame.tangent.y.abs() < 1e-3 {
            true => rows.top(place(middle, width).y),
            false => rows.top(rows.low),
        };
        let high = low + LEAF[1] * rows.thickness;
        let beyond = -4.0 * high;
        let corners = [(0, beyond), (1, beyond), (1, width), (0, width)];
        let corners = corners.map(|(end, off)| place(ends[end], off));
        let Some(base) = Footprint::hull(&corners) else {
            return;
        };
        let body = Polyhedron::prism(&base, [low, high], [0.0; 2], |p, z| self.at(face, p, z));
        if let Some(body) = self.beside_roofs(face, body) {
            self.place_tile(Feature::Edge(id), node, (face, body), Vec::new());
        }
    }
}
