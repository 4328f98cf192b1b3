//! A planar arrangement of lines and its regions.
//!
//! The lines become constraints of a Delaunay triangulation (spade), divided where they cross. Triangles not
//! separated by a line form a region.

use crate::domain::cross;
use crate::planar::{self, Delaunay, position};
use glam::DVec2;
use spade::Triangulation as _;

/// A line of the arrangement.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    ends: [DVec2; 2],
    boundary: bool,
}

impl Line {
    /// A piece of the outline or of a constraint line.
    pub fn boundary(from: DVec2, to: DVec2) -> Self {
        Self {
            ends: [from, to],
            boundary: true,
        }
    }

    /// A side of a cell.
    pub fn side(from: DVec2, to: DVec2) -> Self {
        Self {
            ends: [from, to],
            boundary: false,
        }
    }
}

/// Separation of two adjacent triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Between {
    /// No line: both triangles are in one region.
    Open,
    /// A side of a cell.
    Side,
    /// The outline or a constraint line: no cell lies on both sides.
    Wall,
}

/// Triangles, each labelled with its region.
pub(super) struct Arrangement {
    mesh: Delaunay,
    /// The triangles' corners, with positive shoelace area.
    pub corners: Vec<[DVec2; 3]>,
    /// For each edge of each triangle, the neighbour and the separation from it.
    pub across: Vec<[(Option<u32>, Between); 3]>,
    /// The region of each triangle.
    pub region: Vec<u32>,
    /// The area of each region.
    pub areas: Vec<f64>,
}

impl Arrangement {
    /// Builds the arrangement of these lines.
    pub fn new(lines: Vec<Line>) -> Self {
        // The outline and the constraint lines come first, which tells them from the sides.
        let (boundary, sides): (Vec<Line>, Vec<Line>) = lines.into_iter().partition(|l| l.boundary);
        let all = boundary.iter().chain(&sides).map(|line| line.ends);
        let (mesh, walls) = planar::triangulate_lines(all, boundary.len());
        let count = mesh.num_inner_faces();
        let mut arrangement = Self {
            corners: Vec::with_capacity(count),
            across: Vec::with_capacity(count),
            region: vec![u32::MAX; count],
            areas: Vec::new(),
            mesh,
        };
        arrangement.read_triangles(&walls);
        arrangement.flood();
        arrangement
    }

    fn read_triangles(&mut self, walls: &[[u32; 2]]) {
        for face in self.mesh.inner_faces() {
            self.corners.push(face.positions().map(position));
            self.across.push(face.adjacent_edges().map(|edge| {
                let other = edge.rev().face().as_inner();
                // Inner faces are numbered from 1: 0 is the outer face.
                let index = other.map(|f| f.fix().index() as u32 - 1);
                let ends = planar::edge_of(edge.from().fix(), edge.to().fix());
                let between = if !edge.is_constraint_edge() {
                    Between::Open
                } else if walls.binary_search(&ends).is_ok() {
                    Between::Wall
                } else {
                    Between::Side
                };
                (index, between)
            }));
        }
    }

    /// Numbers the regions.
    fn flood(&mut self) {
        for start in 0..self.region.len() {
            if self.region[start] != u32::MAX {
                continue;
            }
            let region = self.areas.len() as u32;
            let mut area = 0.0;
            let mut open = vec![start];
            self.region[start] = region;
            while let Some(t) = open.pop() {
                area += self.area(t);
                for (other, between) in self.across[t] {
                    let Some(other) = other else { continue };
                    if between == Between::Open && self.region[other as usize] == u32::MAX {
                        self.region[other as usize] = region;
                        open.push(other as usize);
                    }
                }
            }
            self.areas.push(area);
        }
    }

    /// The area of a triangle.
    pub fn area(&self, triangle: usize) -> f64 {
        let [a, b, c] = self.corners[triangle];
        0.5 * cross(a, b, c)
    }

    /// For each region the centre of its largest triangle, a point that is safely inside.
    pub fn middles(&self) -> Vec<DVec2> {
        let mut largest: Vec<(f64, usize)> = vec![(-1.0, 0); self.areas.len()];
        for t in 0..self.region.len() {
            let best = &mut largest[self.region[t] as usize];
            if self.area(t) > best.0 {
                *best = (self.area(t), t);
            }
        }
        let middle = |(_, t): (f64, usize)| {
            let [a, b, c] = self.corners[t];
            (a + b + c) / 3.0
        };
        largest.into_iter().map(middle).collect()
    }

    /// A triangle that contains a place; `None` outside all of them.
    pub fn triangle_at(&self, place: DVec2) -> Option<usize> {
        planar::triangles_at(&self.mesh, place).first().copied()
    }
}
