//! The parts into which constraint lines divide the outline.
//!
//! A part is a connected region of one triangulation of the rings and the lines. The mesh's dual keeps the
//! parts apart, too: an element that a line divides has a vertex on each side (`cells::visibility`), and no
//! region is joined to another across a line.

use super::{Domain, cross};
use crate::order;
use crate::planar::{self, Delaunay, Space, position};
use glam::DVec2;
use spade::Triangulation as _;

/// Triangles over the outline, each labelled with its part.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    mesh: Delaunay,
    /// The part of each triangle; `OUTSIDE` if it is in none.
    part: Vec<u32>,
    count: usize,
}

const OUTSIDE: u32 = u32::MAX;

impl Parts {
    /// The parts of a domain, from the junctions of its lines and outline, and from the lines' segments.
    pub fn new(domain: &Domain, junctions: &[(usize, DVec2)], segments: &[[DVec2; 2]]) -> Self {
        let mut lines = planar::divided(domain.segments(), junctions);
        let space = domain.space();
        lines.extend(space.repeated(segments, 2));
        lines.extend(space.frame());
        let (mesh, _) = planar::triangulate_lines(lines.into_iter(), 0);
        let mut parts = Self {
            part: vec![0; mesh.num_inner_faces()],
            mesh,
            count: 0,
        };
        let mut joined = parts.flood();
        parts.fold(space, &mut joined);
        parts.number(domain, &joined);
        parts
    }

    /// Labels each triangle with the first triangle of its region. Gives the parents for the union of regions: at first
    /// each triangle is its own parent.
    fn flood(&mut self) -> Vec<u32> {
        let mut across: Vec<[Option<u32>; 3]> = Vec::with_capacity(self.part.len());
        for face in self.mesh.inner_faces() {
            across.push(face.adjacent_edges().map(|edge| {
                let other = edge.rev().face().as_inner();
                // Inner faces are numbered from 1: 0 is the outer face.
                let index = other.map(|f| f.fix().index() as u32 - 1);
                index.filter(|_| !edge.is_constraint_edge())
            }));
        }
        self.part.fill(OUTSIDE);
        for start in 0..across.len() {
            let mut open = vec![start];
            while let Some(t) = open.pop() {
                if self.part[t] == OUTSIDE {
                    self.part[t] = start as u32;
                    open.extend(across[t].iter().flatten().map(|&k| k as usize));
                }
            }
        }
        (0..across.len() as u32).collect()
    }

    /// Joins regions that are images of each other. It tests every triangle, so that a region that leaves the
    /// picture is found where it enters again.
    fn fold(&self, space: Space, joined: &mut [u32]) {
        for face in self.mesh.inner_faces() {
            let here = self.part[face.fix().index() - 1];
            let middle = face.positions().map(position).iter().sum::<DVec2>() / 3.0;
            for shift in space.shifts(2).skip(1) {
                for there in planar::triangles_at(&self.mesh, middle + shift) {
                    let (a, b) = (root(joined, here), root(joined, self.part[there]));
                    joined[a.max(b) as usize] = a.min(b);
                }
            }
        }
    }

    /// Numbers the parts from the top, and from the left at equal heights.
    fn number(&mut self, domain: &Domain, joined: &[u32]) {
        // For each region its topmost point and its largest triangle.
        let mut first = vec![DVec2::INFINITY; joined.len()];
        let mut largest = vec![(0.0, DVec2::ZERO); joined.len()];
        for face in self.mesh.inner_faces() {
            let region = root(joined, self.part[face.fix().index() - 1]) as usize;
            let corners = face.positions().map(position);
            let area = cross(corners[0], corners[1], corners[2]);
            for p in corners {
                let (p, best) = (domain.space().wrap(p), &mut first[region]);
                if (p.y, p.x) < (best.y, best.x) {
                    *best = p;
                }
            }
            if area > largest[region].0 {
                largest[region] = (area, corners.iter().sum::<DVec2>() / 3.0);
            }
        }
        let mut regions: Vec<u32> = (0..joined.len() as u32)
            .filter(|&k| {
                let (area, middle) = largest[k as usize];
                area > 0.0 && domain.contains(middle)
            })
            .collect();
        order::sort(&mut regions, |&k| {
            let p = first[k as usize];
            (order::rank(p.y), order::rank(p.x))
        });
        let mut number = vec![OUTSIDE; joined.len()];
        for (part, &region) in regions.iter().enumerate() {
            number[region as usize] = part as u32;
        }
        for part in &mut self.part {
            *part = number[root(joined, *part) as usize];
        }
        self.count = regions.len();
    }

    /// The lowest-numbered part that contains a point; `None` outside all.
    pub fn at(&self, p: DVec2) -> Option<usize> {
        let triangles = planar::triangles_at(&self.mesh, p);
        let part = triangles.iter().map(|&t| self.part[t]).min()?;
        (part != OUTSIDE).then_some(part as usize)
    }

    /// The midpoint of the longest edge between a part with an area below `least` and another part; `None` if there is
    /// none.
    pub fn sliver(&self, domain: &Domain, least: f64) -> Option<DVec2> {
        let mut areas = vec![0.0; self.count];
        for face in self.mesh.inner_faces() {
            let corners = face.positions().map(position);
            let middle = corners.iter().sum::<DVec2>() / 3.0;
            let part = self.part[face.fix().index() - 1];
            if part != OUTSIDE && domain.space().wrap(middle) == middle {
                areas[part as usize] += cross(corners[0], corners[1], corners[2]) / 2.0;
            }
        }
        let mut longest = (0.0, None);
        for edge in self.mesh.undirected_edges() {
            let edge = edge.as_directed();
            let sides = [edge, edge.rev()].map(|e| {
                let face = e.face().as_inner()?;
                let part = self.part[face.fix().index() - 1];
                (part != OUTSIDE).then_some(part)
            });
            let [Some(a), Some(b)] = sides else { continue };
            let [from, to] = edge.positions().map(position);
            let small = areas[a as usize].min(areas[b as usize]) < least;
            if a != b && small && from.distance(to) > longest.0 {
                longest = (from.distance(to), Some(from.midpoint(to)));
            }
        }
        longest.1
    }

    /// The number of parts.
    pub fn count(&self) -> usize {
        self.count
    }
}

fn root(joined: &[u32], mut k: u32) -> u32 {
    while joined[k as usize] != k {
        k = joined[k as usize];
    }
    k
}
