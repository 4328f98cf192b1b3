//! Straightens cells with four corners towards rectangles along their axes, as in the plane.
//!
//! Each cell finds its rectangle in its own tangent plane. A corner moves by the mean of the moves that its cells
//! want, in its own tangent plane or along the border. Corners walk over the surface only at the end.

use super::borders::{Border, Crossing};
use super::rings::CornerRing;
use crate::cells::{CORNER, PACE, ROOM, ROUNDS, rectangle};
use crate::csr::Csr;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::frame::{log_in, rotated};
use crate::trimesh::{SurfacePoint, TangentFrame, TriMesh};
use glam::{DVec2, DVec3};

/// A cell is folded over a rim at a corner if the cosine between their normals is less than this. Such a cell wants
/// nothing, and the corner stays.
const FOLDED: f64 = 0.3;

/// The straightening of cells, in rounds.
pub(super) struct Straightening {
    /// The frames of the cells, with their axes along x.
    frames: Vec<TangentFrame>,
    /// The four corners of each cell that has exactly four.
    quads: Vec<Option<[u32; 4]>>,
    /// The current places of corners, on or beside the surface.
    points: Vec<DVec3>,
    /// For each corner the cells that have it: (cell, index in its ring).
    uses: Csr<(u32, u32)>,
    /// For each crossing, how far it may slide back and ahead along the border.
    room: Vec<[f64; 2]>,
    /// The area of all cells over the area that their sizes want.
    share: f64,
    round: u32,
    /// For each corner the sum of the moves wanted in this round, and how many they are.
    asked: Vec<(DVec3, u32)>,
    next: usize,
}

/// Cells to measure, or corners to move, in a slice.
const ASKING: usize = 2000;

/// The inputs of straightening.
pub(super) struct Table<'a> {
    pub cells: &'a [SurfaceParticle],
    pub rings: &'a [Option<CornerRing>],
    pub corners: &'a [SurfacePoint],
    pub borders: &'a [Border],
    pub crossings: &'a [Crossing],
    /// The index of the first crossing in the table, after the middles of elements.
    pub first_crossing: usize,
}

impl Table<'_> {
    fn ring(&self, cell: u32) -> &[u32] {
        self.rings[cell as usize]
            .as_ref()
            .map_or(&[], |ring| &ring.corners)
    }

    fn crossing(&self, corner: usize) -> Option<usize> {
        let x = corner.checked_sub(self.first_crossing)?;
        (x < self.crossings.len()).then_some(x)
    }
}

impl Straightening {
    pub fn new(table: &Table) -> Self {
        let uses = (0..table.cells.len() as u32).flat_map(|cell| {
            let ring = table.ring(cell).iter().zip(0..);
            ring.map(move |(&corner, place)| (corner as usize, (cell, place)))
        });
        let mut made = Self {
            frames: table.cells.iter().map(frame_of).collect(),
            quads: Vec::new(),
            points: table.corners.iter().map(|c| c.at).collect(),
            uses: Csr::from_pairs(table.corners.len(), uses),
            room: Vec::new(),
            share: 1.0,
            round: 0,
            asked: vec![(DVec3::ZERO, 0); table.corners.len()],
            next: 0,
        };
        made.quads = (0..table.cells.len() as u32)
            .map(|cell| made.four_corners(table, cell))
            .collect();
        made.room = made.room(table);
        made.share = made.share(table);
        made
    }

    /// Does one more slice; true when done.
    pub fn advance(&mut self, table: &Table) -> bool {
        let end = self.quads.len().min(self.next + ASKING);
        for cell in self.next.min(end)..end {
            if let Some(corners) = self.quads[cell] {
                self.ask(table, cell, corners);
            }
        }
        // Corners move after all cells have been measured.
        let first = self.next.max(self.quads.len()) - self.quads.len();
        self.next = end;
        if end < self.quads.len() {
            return false;
        }
        let last = self.asked.len().min(first + ASKING);
        self.next = self.quads.len() + last;
        for corner in first..last {
            let (sum, count) = std::mem::take(&mut self.asked[corner]);
            if count > 0 && !self.is_folded(table, corner) {
                self.move_one(table, corner, sum * (PACE / f64::from(count)));
            }
        }
        if last < self.asked.len() {
            return false;
        }
        (self.next, self.round) = (0, self.round + 1);
        self.round == ROUNDS
    }

    /// Walks all corners over the surface to their new places.
    pub fn finish(&self, mesh: &TriMesh, table: &Table) -> Vec<SurfacePoint> {
        let each = table.corners.iter().zip(&self.points).enumerate();
        each.map(|(corner, (old, &p))| {
            if p == old.at {
                return *old;
            }
            let Some(x) = table.crossing(corner) else {
                return mesh.walk(old, old.frame().within(p - old.at)).to;
            };
            let crossing = &table.crossings[x];
            let border = &table.borders[crossing.border as usize];
            let along = border.heading_at(crossing.at).dot(p - old.at);
            border.point(mesh, crossing.at + along)
        })
        .collect()
    }

    fn ask(&mut self, table: &Table, cell: usize, corners: [u32; 4]) -> Option<()> {
        let mut local = [DVec2::ZERO; 4];
        for (at, corner) in local.iter_mut().zip(corners) {
            let normal = table.corners[corner as usize].normal;
            if normal.dot(self.frames[cell].normal) < FOLDED {
                return None;
            }
            *at = self.seen(table, cell, corner)?;
        }
        let placed = &table.cells[cell];
        let axis = if placed.axis == DVec2::ZERO {
            return None;
        } else {
            DVec2::X
        };
        let targets = rectangle(local, axis, placed.size, self.share)?;
        let frame = self.frames[cell];
        for k in 0..4 {
            let normal = table.corners[corners[k] as usize].normal;
            let by = rotated(frame.out(targets[k] - local[k]), frame.normal, normal);
            let asked = &mut self.asked[corners[k] as usize];
            *asked = (asked.0 + by, asked.1 + 1);
        }
        Some(())
    }

    /// A corner in the plane of a cell, by the logarithmic map.
    fn seen(&self, table: &Table, cell: usize, corner: u32) -> Option<DVec2> {
        let corner = corner as usize;
        let normal = table.corners[corner].normal;
        log_in(
            &self.frames[cell],
            table.cells[cell].centre.at,
            self.points[corner],
            normal,
        )
    }

    fn move_one(&mut self, table: &Table, corner: usize, by: DVec3) {
        let home = &table.corners[corner];
        let old = self.points[corner];
        let by = match table.crossing(corner) {
            Some(x) => {
                let crossing = &table.crossings[x];
                let border = &table.borders[crossing.border as usize];
                let along = border.heading_at(crossing.at);
                let [lo, hi] = self.room[x];
                let gone = along.dot(old - home.at);
                along * ((gone + along.dot(by)).clamp(lo, hi) - gone)
            }
            // Corners of the border itself never move.
            None if corner >= table.first_crossing => return,
            None => by - home.normal * home.normal.dot(by),
        };
        self.points[corner] = old + by;
        if !self.is_sound(table, corner, old) {
            self.points[corner] = old;
        }
    }

    /// Whether a cell of this corner is folded there.
    fn is_folded(&self, table: &Table, corner: usize) -> bool {
        let normal = table.corners[corner].normal;
        let turned = |cell: u32| normal.dot(self.frames[cell as usize].normal) < FOLDED;
        self.uses_of(corner).iter().any(|&(cell, _)| turned(cell))
    }

    /// The cells of a corner, with its index in their rings.
    fn uses_of(&self, corner: usize) -> &[(u32, u32)] {
        self.uses.row(corner)
    }

    /// Whether the corner, moved from `old`, turns no ring inside out, seen in its tangent plane.
    fn is_sound(&self, table: &Table, corner: usize, old: DVec3) -> bool {
        let normal = table.corners[corner].normal;
        let turn = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - b).dot(normal);
        self.uses_of(corner).iter().all(|&(cell, place)| {
            let ring = table.ring(cell);
            let n = ring.len();
            (n - 1..n + 2).all(|shift| {
                let k = place as usize + shift;
                let three = [k + n - 1, k, k + 1].map(|k| ring[k % n] as usize);
                let now = turn(three.map(|k| self.points[k]));
                let before = |k: usize| if k == corner { old } else { self.points[k] };
                now > 0.0 || now >= turn(three.map(before))
            })
        })
    }

    /// The corners of a cell that has exactly four; `None` for other cells. Points where cells meet count, and corners
    /// of the border.
    fn four_corners(&self, table: &Table, cell: u32) -> Option<[u32; 4]> {
        let ring = table.ring(cell);
        let n = ring.len();
        if !table.cells[cell as usize].kind.has_corners() {
            return None;
        }
        let ends = table.first_crossing + table.crossings.len();
        let mut four = [0; 4];
        let mut count = 0;
        for (k, &corner) in ring.iter().enumerate() {
            let three = [k + n - 1, k, k + 1].map(|k| self.points[ring[k % n] as usize]);
            let [a, b, c] = three;
            let turn = (b - a).normalize_or_zero().dot((c - b).normalize_or_zero());
            if (corner as usize) < ends || turn < CORNER {
                if count == 4 {
                    return None;
                }
                four[count] = corner;
                count += 1;
            }
        }
        (count == 4).then_some(four)
    }

    /// How far each crossing may slide: less than to the next corner on either side.
    fn room(&self, table: &Table) -> Vec<[f64; 2]> {
        let mut room = vec![[0.0; 2]; table.crossings.len()];
        for (x, room) in room.iter_mut().enumerate() {
            let corner = table.first_crossing + x;
            let crossing = &table.crossings[x];
            let border = &table.borders[crossing.border as usize];
            let along = border.heading_at(crossing.at);
            let back = border.heading_at(crossing.at - 1e-9 * border.length());
            // A crossing at a corner of the border stays.
            if along.dot(back) < CORNER {
                continue;
            }
            let own = self.points[corner];
            for &(cell, place) in self.uses_of(corner) {
                let ring = table.ring(cell);
                let n = ring.len();
                // Along the border, the cell after the crossing lies ahead, the cell before it lies back.
                let ahead = cell == crossing.to;
                let shift = if ahead { 1 } else { n - 1 };
                let next = self.points[ring[(place as usize + shift) % n] as usize];
                let far = ROOM * own.distance(next);
                room[usize::from(ahead)] = if ahead { far } else { -far };
            }
        }
        room
    }

    fn share(&self, table: &Table) -> f64 {
        let (mut area, mut asked) = (0.0, 0.0);
        for (cell, placed) in table.cells.iter().enumerate() {
            let ring = table.ring(cell as u32);
            let at = |k: usize| self.seen(table, cell, ring[k % ring.len()]);
            for k in 0..ring.len() {
                if let (Some(p), Some(q)) = (at(k), at(k + 1)) {
                    area += 0.5 * p.perp_dot(q);
                }
            }
            if !ring.is_empty() {
                asked += placed.size * placed.size;
            }
        }
        if asked > 0.0 { area / asked } else { 1.0 }
    }
}

/// The frame of a cell, with its axis along x.
fn frame_of(cell: &SurfaceParticle) -> TangentFrame {
    let frame = cell.centre.frame();
    let x = frame.out(cell.axis).normalize_or(frame.x);
    TangentFrame {
        x,
        y: frame.normal.cross(x),
        normal: frame.normal,
    }
}
