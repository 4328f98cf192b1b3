//! The borders of a surface as walls. A cell has a foot on a wall where its distance to the border has a local
//! minimum.

use crate::csr::Csr;
use crate::domain::SAME_WALL;
use crate::order;
use crate::packing::packing_domain::{Boundary, ClosestPoint};
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// A place sees a wall if the dot product of its normal and that of the wall's triangle is at least this ...
const SEES: f64 = -0.2;
/// ... and if it lies on the paved side: at least this share of the vector from the wall to it points across the
/// wall.
const ACROSS: f64 = 0.1;

/// An edge of the border.
#[derive(Clone, Copy, Debug)]
struct BorderEdge {
    ends: [DVec3; 2],
    /// Unit vector across the edge, along the surface, into the paved side.
    inward: DVec3,
    /// The normal of its triangle.
    normal: DVec3,
    part: u32,
    /// The segments before and after it on its ring.
    beside: [u32; 2],
}

impl BorderEdge {
    fn middle(&self) -> DVec3 {
        self.ends[0].midpoint(self.ends[1])
    }

    /// The place on the edge nearest to `p`, as a share of its length, 0..1.
    fn nearest(&self, p: DVec3) -> f64 {
        let along = self.ends[1] - self.ends[0];
        ((p - self.ends[0]).dot(along) / along.length_squared().max(f64::MIN_POSITIVE))
            .clamp(0.0, 1.0)
    }
}

/// A triangle, and how far from its middle the segments of its list may be.
struct Around {
    triangle: u32,
    middle: DVec3,
    reach: f64,
}

impl Around {
    fn of(mesh: &TriMesh, triangle: u32, reach: f64) -> Self {
        let corners = mesh.corners(triangle);
        let middle = corners.iter().sum::<DVec3>() / 3.0;
        let far = corners.map(|c| c.distance(middle));
        Self {
            triangle,
            middle,
            reach: reach + far.into_iter().fold(0.0, f64::max),
        }
    }
}

/// The closest point of a wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfaceClosestPoint {
    distance: f64,
    inward: DVec2,
}

impl ClosestPoint for SurfaceClosestPoint {
    fn distance(&self) -> f64 {
        self.distance
    }

    fn inward(&self) -> DVec2 {
        self.inward
    }
}

/// Segments to look at in a slice of the lists.
const LOOKED_AT: usize = 1 << 18;
/// The most entries that all lists may have together, and the most segments to look at for them. Beyond either, as
/// where a border has thousands of edges for each cell, a list is made anew whenever it is needed.
const MOST_LISTED: usize = 1 << 24;
const MOST_LOOKED_AT: usize = 1 << 28;
/// Without lists, a cell takes up to this many times as long.
const UNLISTED: usize = 100;

/// The walls of a mesh, by the triangles within reach of them.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceWalls {
    mesh: Arc<TriMesh>,
    segments: Vec<BorderEdge>,
    part: Arc<Vec<u32>>,
    /// The segments by their middles, and half the length of the longest one.
    boxes: SurfaceHash,
    longest: f64,
    /// The segments near each triangle, from the first triangle on; without rows if there are no walls.
    near: Csr<u32>,
    /// How many segments were looked at for these lists.
    looked_at: usize,
    is_listed: bool,
    reach: f64,
}

impl SurfaceWalls {
    /// Starts without lists; [`SurfaceWalls::advance`] makes them.
    pub fn begin(mesh: Arc<TriMesh>, part: Arc<Vec<u32>>, reach: f64) -> Self {
        let segments = segments(&mesh, &part);
        let half = |s: &BorderEdge| 0.5 * s.ends[0].distance(s.ends[1]);
        let longest = segments.iter().map(half).fold(0.0, f64::max);
        let side = (reach + longest).max(1e-3 * mesh.diagonal());
        let mut boxes = SurfaceHash::new(mesh.bounds(), side);
        for segment in &segments {
            boxes.push_at(segment.middle());
        }
        Self {
            near: Csr::default(),
            looked_at: 0,
            is_listed: true,
            part,
            boxes,
            longest,
            reach,
            segments,
            mesh,
        }
    }

    /// Makes lists for some more triangles; true when all triangles have their lists, or when the lists would get too
    /// long.
    pub fn advance(&mut self) -> bool {
        let (count, mut left) = (self.mesh.triangles().len(), LOOKED_AT as isize);
        let mut row = Vec::new();
        while self.is_listed && !self.segments.is_empty() && self.near.count() < count {
            if left < 0 {
                return false;
            }
            let around = Around::of(&self.mesh, self.near.count() as u32, self.reach);
            row.clear();
            let mut looked_at = 16;
            self.boxes
                .any_near(around.middle, around.reach + self.longest, |k| {
                    looked_at += 1;
                    if self.is_listed_at(k, &around) {
                        row.push(k as u32);
                    }
                    false
                });
            row.sort_unstable();
            self.near.push(row.iter().copied());
            left -= looked_at as isize;
            self.looked_at += looked_at;
            if self.near.len() > MOST_LISTED || self.looked_at > MOST_LOOKED_AT {
                self.unlist();
            }
        }
        true
    }

    /// The number of cells for a slice: `cells` if there are lists, far fewer without.
    pub fn portion(&self, cells: usize) -> usize {
        if self.is_listed {
            cells
        } else {
            cells / UNLISTED
        }
    }

    /// Does without the lists of triangles.
    fn unlist(&mut self) {
        (self.near, self.is_listed) = (Csr::default(), false);
    }

    /// Whether a segment belongs into the list of a triangle.
    fn is_listed_at(&self, k: usize, around: &Around) -> bool {
        let segment = &self.segments[k];
        let at = segment.ends[0].lerp(segment.ends[1], segment.nearest(around.middle));
        segment.part == self.part[around.triangle as usize]
            && at.distance(around.middle) <= around.reach
    }

    /// The segments listed at the triangle of `p` that may have a point within `reach` of `p`, by rising numbers.
    fn listed_near(&self, p: &SurfacePoint, reach: f64) -> Vec<u32> {
        let around = Around::of(&self.mesh, p.triangle, self.reach);
        // Look a little farther, so that rounding leaves out no foot.
        let reach = (reach + self.longest) * (1.0 + 1e-9);
        let mut found = Vec::new();
        self.boxes.any_near(p.at, reach, |k| {
            let far = self.segments[k].middle().distance_squared(p.at);
            if far <= reach * reach && self.is_listed_at(k, &around) {
                found.push(k as u32);
            }
            false
        });
        found.sort_unstable();
        found
    }

    /// The foot of a place on a segment, if the distance has a local minimum there.
    fn foot(&self, index: u32, p: &SurfacePoint) -> Option<SurfaceClosestPoint> {
        let segment = &self.segments[index as usize];
        if segment.normal.dot(p.normal) < SEES {
            return None;
        }
        let t = segment.nearest(p.at);
        let mut inward = segment.inward;
        // A corner belongs to the segment that begins there. It is a foot only if it is the nearest point of both
        // segments.
        if t == 1.0 {
            return None;
        }
        if t == 0.0 {
            let before = &self.segments[segment.beside[0] as usize];
            if before.nearest(p.at) < 1.0 {
                return None;
            }
            inward = (inward + before.inward).normalize_or(inward);
        }
        let at = segment.ends[0].lerp(segment.ends[1], t);
        let way = p.at - at;
        let distance = way.length();
        // A place that has slid along the border lies on the wall.
        let stands = distance < 1e-6 * segment.ends[0].distance(segment.ends[1]);
        if !stands && way.dot(inward) < ACROSS * distance {
            return None;
        }
        let along = p.frame().within(if stands { inward } else { way });
        Some(SurfaceClosestPoint {
            distance,
            inward: along.try_normalize()?,
        })
    }
}

fn segments(mesh: &TriMesh, part: &[u32]) -> Vec<BorderEdge> {
    let mut segments = Vec::new();
    // For each border vertex, the triangle of the border edge that begins there.
    let mut triangle = vec![0; mesh.positions().len()];
    for (t, corners) in mesh.triangles().iter().enumerate() {
        for k in 0..3 {
            if mesh.across(t as u32, k).is_none() {
                triangle[corners[k] as usize] = t as u32;
            }
        }
    }
    for ring in mesh.borders() {
        let (first, count) = (segments.len() as u32, ring.len());
        for k in 0..count {
            let ends = [ring[k], ring[(k + 1) % count]].map(|v| mesh.positions()[v as usize]);
            let own = triangle[ring[k] as usize];
            let normal = mesh.face_normal(own);
            let beside = [(k + count - 1) % count, (k + 1) % count].map(|k| first + k as u32);
            segments.push(BorderEdge {
                ends,
                inward: normal.cross(ends[1] - ends[0]).normalize_or_zero(),
                normal,
                part: part[own as usize],
                beside,
            });
        }
    }
    segments
}

impl Boundary for &SurfaceWalls {
    type Place = SurfacePoint;
    type ClosestPoint = SurfaceClosestPoint;

    fn is_near(self, p: SurfacePoint) -> bool {
        if self.segments.is_empty() || self.is_listed {
            return !self.segments.is_empty() && !self.near.row(p.triangle as usize).is_empty();
        }
        let around = Around::of(&self.mesh, p.triangle, self.reach);
        let reach = around.reach + self.longest;
        self.boxes
            .any_near(around.middle, reach, |k| self.is_listed_at(k, &around))
    }

    fn reach(self) -> f64 {
        self.reach
    }

    fn closest_points(self, p: SurfacePoint, reach: f64, feet: &mut Vec<SurfaceClosestPoint>) {
        feet.clear();
        let made;
        let near = match (self.segments.is_empty(), self.is_listed) {
            (true, _) => &[],
            (false, true) => self.near.row(p.triangle as usize),
            (false, false) => {
                made = self.listed_near(&p, reach);
                &made[..]
            }
        };
        feet.extend(
            near.iter()
                .filter_map(|&k| self.foot(k, &p))
                .filter(|f| f.distance <= reach),
        );
        order::sort(feet, |foot| (order::rank(foot.distance), 0));
        let mut kept = 0;
        for k in 0..feet.len() {
            let next = feet[k];
            if feet[..kept]
                .iter()
                .all(|f| f.inward.dot(next.inward) < SAME_WALL)
            {
                feet[kept] = next;
                kept += 1;
            }
        }
        feet.truncate(kept);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::samples;

    /// Walls whose lists are made, with the most segments that a slice looked at.
    fn listed(mesh: &Arc<TriMesh>, reach: f64) -> (SurfaceWalls, usize) {
        let part = Arc::new(mesh.parts().0);
        let mut walls = SurfaceWalls::begin(mesh.clone(), part, reach);
        let mut most = 0;
        loop {
            let before = walls.looked_at;
            let is_done = walls.advance();
            most = most.max(walls.looked_at - before);
            if is_done {
                return (walls, most);
            }
        }
    }

    #[test]
    fn walls_without_lists_have_the_same_feet() {
        for mesh in [samples::hill(12), samples::cylinder(40, 20)].map(Arc::new) {
            let reach = 0.1 * mesh.diagonal();
            let (with, _) = listed(&mesh, reach);
            let mut without = with.clone();
            without.unlist();
            let mut near = 0;
            for t in 0..mesh.triangles().len() as u32 {
                let weights = DVec3::new(0.6, 0.3, 0.1);
                let p = SurfacePoint::new(&mesh, t, weights);
                assert_eq!((&with).is_near(p), (&without).is_near(p), "{t}");
                for reach in [0.3 * reach, reach, 1.6 * reach] {
                    let feet = [&with, &without].map(|walls| {
                        let mut feet = Vec::new();
                        walls.closest_points(p, reach, &mut feet);
                        feet.iter()
                            .map(|f| (f.distance, f.inward))
                            .collect::<Vec<_>>()
                    });
                    assert_eq!(feet[0], feet[1], "{t}");
                    near += feet[0].len();
                }
            }
            assert!(near > 100, "{near}");
        }
    }

    #[test]
    fn no_slice_looks_at_more_segments_than_stated() {
        let mesh = Arc::new(samples::hill(120));
        let (walls, most) = listed(&mesh, 0.2 * mesh.diagonal());
        assert!(walls.is_listed && walls.looked_at > 4 * LOOKED_AT);
        // A slice ends after the triangle that goes beyond its amount.
        assert!(most <= LOOKED_AT + walls.segments.len() + 16, "{most}");
    }
}
