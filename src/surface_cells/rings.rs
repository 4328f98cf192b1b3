//! The rings of cells: closed chains of links between neighbours. Each link is an element of the mesh, or a part of
//! the border.

use super::bends::Bends;
use super::borders::{Border, Crossing};
use crate::mesh::quads::Faces;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{NONE, SurfacePoint, TriMesh};

/// The most links of a chain.
const MOST_LINKS: usize = 100_000;

/// The inputs of rings.
pub(super) struct RingInputs<'a> {
    pub mesh: &'a TriMesh,
    pub cells: &'a [SurfaceParticle],
    pub faces: &'a Faces,
    pub borders: &'a [Border],
    pub crossings: &'a [Crossing],
    pub bends: &'a Bends,
    /// The index of the first crossing in the table of corners.
    pub first_crossing: u32,
    /// For each cell an element that it is a corner of.
    pub element: Vec<u32>,
    /// Sides of elements on the border: (key of their two nodes, element).
    sides: Vec<(u64, u32)>,
    /// Crossings by the cells before and after them: (key of both cells, crossing).
    by_cells: Vec<(u64, u32)>,
    /// For each cell a crossing where its part of the border begins; [`NONE`] if it has none.
    crossing: Vec<u32>,
}

/// A ring as indices into the table of corners, and whether it runs along the border.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct CornerRing {
    pub corners: Vec<u32>,
    pub on_border: bool,
}

/// A link of a chain.
#[derive(Clone, Copy, PartialEq)]
enum At {
    /// An element, and the index of its corner that is the cell.
    Element(u32, usize),
    /// A crossing where the cell's part of the border begins.
    Crossing(u32),
}

impl<'a> RingInputs<'a> {
    pub fn new(
        mesh: &'a TriMesh,
        cells: &'a [SurfaceParticle],
        faces: &'a Faces,
        bends: &'a Bends,
        (borders, crossings): (&'a [Border], &'a [Crossing]),
        first_crossing: u32,
    ) -> Self {
        let mut element = vec![NONE; cells.len()];
        let mut sides = Vec::new();
        for (f, (face, adjacent)) in faces.faces.iter().zip(&faces.adjacent).enumerate() {
            let nodes = face.nodes();
            for (k, &a) in nodes.iter().enumerate() {
                element[a as usize] = f as u32;
                if adjacent[k] == NONE {
                    let b = nodes[(k + 1) % nodes.len()];
                    sides.push((order::pair(a, b), f as u32));
                }
            }
        }
        sides.sort_unstable();
        let mut by_cells = Vec::with_capacity(crossings.len());
        let mut crossing = vec![NONE; cells.len()];
        for (x, c) in crossings.iter().enumerate() {
            by_cells.push((order::pair(c.from, c.to), x as u32));
            crossing[c.to as usize] = x as u32;
        }
        by_cells.sort_unstable();
        Self {
            mesh,
            cells,
            faces,
            bends,
            borders,
            crossings,
            first_crossing,
            element,
            sides,
            by_cells,
            crossing,
        }
    }

    /// The ring of a cell. Nothing if there is no closed chain of at least three corners. Corners of the border
    /// within this cell are appended to the table.
    pub fn ring(&self, cell: u32, table: &mut Vec<SurfacePoint>) -> Option<CornerRing> {
        let mut ring = CornerRing::default();
        let start = match (self.element[cell as usize], self.crossing[cell as usize]) {
            (NONE, NONE) => return None,
            (NONE, x) => At::Crossing(x),
            (f, _) => At::Element(f, self.corner(f, cell)?),
        };
        let before = table.len();
        let mut at = start;
        for _ in 0..MOST_LINKS {
            at = match at {
                At::Element(f, k) => {
                    ring.corners.push(f);
                    let next = self.beyond(cell, f, k)?;
                    if let At::Element(g, _) = next {
                        ring.corners.extend(self.bends.between(f, g));
                    }
                    next
                }
                At::Crossing(x) => {
                    ring.on_border = true;
                    self.along(cell, x, &mut ring.corners, table)?
                }
            };
            if at == start {
                if ring.corners.len() >= 3 {
                    return Some(ring);
                }
                break;
            }
        }
        table.truncate(before);
        None
    }

    /// The ring of a cell that has a whole border to itself.
    pub fn whole(
        &self,
        border: &Border,
        cell: u32,
        table: &mut Vec<SurfacePoint>,
    ) -> Option<CornerRing> {
        let corners = border.between(0.0, 0.0, self.cells[cell as usize].size);
        let first = table.len() as u32;
        if corners.len() < 2 {
            return None;
        }
        table.push(border.corner(self.mesh, 0));
        table.extend(
            corners
                .into_iter()
                .filter(|&k| k != 0)
                .map(|k| border.corner(self.mesh, k)),
        );
        let corners: Vec<u32> = (first..table.len() as u32).collect();
        (corners.len() >= 3).then_some(CornerRing {
            corners,
            on_border: true,
        })
    }

    fn corner(&self, element: u32, cell: u32) -> Option<usize> {
        let nodes = self.faces.faces[element as usize].nodes();
        nodes.iter().position(|&n| n == cell)
    }

    /// The link over the side before the cell's corner: the next element counter-clockwise, or the border.
    fn beyond(&self, cell: u32, f: u32, k: usize) -> Option<At> {
        let nodes = self.faces.faces[f as usize].nodes();
        let side = (k + nodes.len() - 1) % nodes.len();
        let before = nodes[side];
        let next = self.faces.adjacent[f as usize][side];
        if next == NONE {
            return self.crossing_at(before, cell, f).map(At::Crossing);
        }
        let nodes = self.faces.faces[next as usize].nodes();
        let is_side = |j: usize| nodes[j] == cell && nodes[(j + 1) % nodes.len()] == before;
        let j = (0..nodes.len()).find(|&j| is_side(j))?;
        Some(At::Element(next, j))
    }

    /// The crossing at the end of a side of an element. If several crossings lie between the same two cells, they go
    /// in the order of the elements.
    fn crossing_at(&self, from: u32, to: u32, element: u32) -> Option<u32> {
        let key = order::pair(from, to);
        let among = run(&self.sides, key);
        let place = among.iter().position(|s| s.1 == element).unwrap_or(0);
        let all = run(&self.by_cells, key);
        all.get(place).or(all.last()).map(|x| x.1)
    }

    /// Goes along the border to the end of the cell's part.
    fn along(
        &self,
        cell: u32,
        x: u32,
        corners: &mut Vec<u32>,
        table: &mut Vec<SurfacePoint>,
    ) -> Option<At> {
        let start = &self.crossings[x as usize];
        let end = &self.crossings[start.next as usize];
        if end.from != cell {
            return None;
        }
        corners.push(self.first_crossing + x);
        let border = &self.borders[start.border as usize];
        let size = self.cells[cell as usize].size;
        for k in border.between(start.at, end.at, size) {
            corners.push(table.len() as u32);
            table.push(border.corner(self.mesh, k));
        }
        corners.push(self.first_crossing + start.next);
        // Go on into the element at the end. Without an element, go on to the crossing from the next cell back to this
        // one.
        let key = order::pair(cell, end.to);
        let place = run(&self.by_cells, key);
        let place = place.iter().position(|c| c.1 == start.next).unwrap_or(0);
        if let Some(&(_, f)) = run(&self.sides, key).get(place) {
            let nodes = self.faces.faces[f as usize].nodes();
            let is_side = |j: usize| {
                let next = nodes[(j + 1) % nodes.len()];
                nodes[j] == cell && next == end.to && self.faces.adjacent[f as usize][j] == NONE
            };
            let j = (0..nodes.len()).find(|&j| is_side(j))?;
            return Some(At::Element(f, j));
        }
        let back = run(&self.by_cells, order::pair(end.to, cell));
        // If there are two such crossings, take the one that the chain has not just come from.
        let other = back.iter().rev().find(|c| c.1 != x).or(back.first());
        other.map(|c| At::Crossing(c.1))
    }
}

/// The entries of a sorted list with this key.
fn run(list: &[(u64, u32)], key: u64) -> &[(u64, u32)] {
    let from = list.partition_point(|e| e.0 < key);
    let to = list.partition_point(|e| e.0 <= key);
    &list[from..to]
}
