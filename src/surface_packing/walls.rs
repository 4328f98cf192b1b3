//! The borders of a surface as walls. A cell has a foot on a wall where its distance to the border has a local
//! minimum.

use crate::csr::Csr;
use crate::domain::SAME_WALL;
use crate::order;
use crate::packing::packing_domain::{Boundary, ClosestPoint};
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::{DVec2, DVec3};

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
    /// The place on it nearest to `p`, as a share of its length, 0..1.
    fn nearest(&self, p: DVec3) -> f64 {
        let along = self.ends[1] - self.ends[0];
        ((p - self.ends[0]).dot(along) / along.length_squared().max(f64::MIN_POSITIVE))
            .clamp(0.0, 1.0)
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

/// The walls of a mesh, by the triangles within reach of them.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceWalls {
    segments: Vec<BorderEdge>,
    part: Vec<u32>,
    /// The segments near each triangle; without rows if there are no walls.
    near: Csr<u32>,
    reach: f64,
}

impl SurfaceWalls {
    pub fn new(mesh: &TriMesh, part: &[u32], reach: f64) -> Self {
        let segments = segments(mesh, part);
        let mut walls = Self {
            near: Csr::default(),
            part: part.to_vec(),
            reach,
            segments,
        };
        if !walls.segments.is_empty() {
            walls.sort_in(mesh);
        }
        walls
    }

    fn sort_in(&mut self, mesh: &TriMesh) {
        let half = |s: &BorderEdge| 0.5 * s.ends[0].distance(s.ends[1]);
        let longest = self.segments.iter().map(half).fold(0.0, f64::max);
        let mut boxes = SurfaceHash::new(
            mesh.bounds(),
            (self.reach + longest).max(1e-3 * mesh.diagonal()),
        );
        for segment in &self.segments {
            boxes.push_at(segment.ends[0].midpoint(segment.ends[1]));
        }
        let mut near = Vec::new();
        for t in 0..mesh.triangles().len() as u32 {
            let corners = mesh.corners(t);
            let middle = corners.iter().sum::<DVec3>() / 3.0;
            let radius = corners
                .map(|c| c.distance(middle))
                .into_iter()
                .fold(0.0, f64::max);
            let reach = self.reach + radius;
            near.clear();
            boxes.any_near(middle, reach + longest, |k| {
                let segment = &self.segments[k];
                let at = segment.ends[0].lerp(segment.ends[1], segment.nearest(middle));
                if segment.part == self.part[t as usize] && at.distance(middle) <= reach {
                    near.push(k as u32);
                }
                false
            });
            near.sort_unstable();
            self.near.push(near.iter().copied());
        }
    }

    fn near(&self, p: &SurfacePoint) -> &[u32] {
        match self.segments.is_empty() {
            true => &[],
            false => self.near.row(p.triangle as usize),
        }
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
        !self.near(&p).is_empty()
    }

    fn reach(self) -> f64 {
        self.reach
    }

    fn closest_points(self, p: SurfacePoint, reach: f64, feet: &mut Vec<SurfaceClosestPoint>) {
        feet.clear();
        let near = self.near(&p).iter();
        feet.extend(
            near.filter_map(|&k| self.foot(k, &p))
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
