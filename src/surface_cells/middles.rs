//! The middles of elements, where their cells meet.

use crate::mesh::Face;
use crate::mesh::triangles::Triangles;
use crate::order;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::frame::rotated;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::DVec3;

/// The most steps to the foot of a point.
const STEPS: u32 = 6;
/// A step shorter than this, in sizes, ends the search.
const SHORT: f64 = 1e-6;
/// If the mean of the normals of an element's cells is shorter than this, the cells lie around a rim, and the mean
/// does not point outwards.
const OUTWARD: f64 = 0.55;
/// Cells meet on a rim if the part of the rim's normal along their sheet is longer than this. Otherwise one of them is
/// folded over the rim.
const RIM: f64 = 0.5;
/// A triangle faces a direction if the cosine between its normal and the direction is greater than this.
const FACES: f64 = 0.7;
/// The most triangles searched for one that faces a direction.
const NEAREST: usize = 100;
/// The search for a foot ends where the cosine between the surface's normal and the mean normal of the cells is less
/// than this.
const STEEP: f64 = 0.2;

/// The points where three cells meet, as the flood has found them.
#[derive(Default)]
pub(super) struct Meetings {
    /// The three cells, in rising order, and the point where they meet.
    all: Vec<([u32; 3], SurfacePoint)>,
}

impl Meetings {
    /// Adds triangles between cells, and their places.
    pub fn add(&mut self, triangles: &Triangles, places: &[SurfacePoint]) {
        let named = triangles.nodes.iter().map(|&three| sorted(three));
        self.all.extend(named.zip(places.iter().copied()));
        // If three cells occur twice, keep the first place.
        order::sort(&mut self.all, |m| {
            (order::pair(m.0[0], m.0[1]), m.0[2].into())
        });
        self.all.dedup_by_key(|m| m.0);
    }

    /// The point where three cells meet.
    pub fn of(&self, three: [u32; 3]) -> Option<&SurfacePoint> {
        let three = sorted(three);
        let place = self.all.binary_search_by(|m| m.0.cmp(&three)).ok()?;
        Some(&self.all[place].1)
    }

    /// The mean place and normal of the points of the rim where these cells meet. `cells` are in rising order.
    pub fn rim(&self, cells: &[u32]) -> Option<(DVec3, DVec3)> {
        let (mut at, mut normal, mut count) = (DVec3::ZERO, DVec3::ZERO, 0.0);
        for (k, &c) in cells.iter().enumerate() {
            for (j, &b) in cells[..k].iter().enumerate() {
                for &a in &cells[..j] {
                    if let Some(place) = self.of([a, b, c]) {
                        at += place.at;
                        normal += place.normal;
                        count += 1.0;
                    }
                }
            }
        }
        Some((at / count, normal.try_normalize()?))
    }

    /// The point where an element's cells meet. A larger cell is farther from it.
    pub fn middle(&self, mesh: &TriMesh, cells: &[SurfaceParticle], face: &Face) -> SurfacePoint {
        let (mut sum, mut weight, mut normal) = (DVec3::ZERO, 0.0, DVec3::ZERO);
        // The sum of the cells' normals, with those from the other side of the sheet reversed.
        let mut across = DVec3::ZERO;
        // Sums run in rising order, whichever corner comes first.
        let mut nodes = [u32::MAX; 4];
        let count = face.nodes().len();
        nodes[..count].copy_from_slice(face.nodes());
        nodes.sort_unstable();
        for &k in &nodes[..count] {
            let cell = &cells[k as usize];
            sum += cell.centre.at / cell.size;
            let own = cell.centre.normal;
            normal += own;
            across += if across.dot(own) < 0.0 { -own } else { own };
            weight += 1.0 / cell.size;
        }
        let first = &cells[nodes[0] as usize];
        let start = match *face.nodes() {
            [a, b, c] => self.of([a, b, c]),
            // Take the meeting of one of the two triangles, by either diagonal.
            [a, b, c, d] => {
                let found = |k: u32, l: u32| self.of([a, k, l]);
                found(b, d).or_else(|| found(b, c)).or_else(|| found(c, d))
            }
            _ => None,
        };
        let start = *start.unwrap_or(&first.centre);
        // At a rim: the direction out of it, along the sheet.
        let rim = || {
            let (_, out) = self.rim(&nodes[..count])?;
            let out = out.reject_from(across);
            (out.length() > RIM).then(|| out.normalize())
        };
        let to = sum / weight;
        match (outward(normal, count), rim()) {
            (Some(out), _) => foot(mesh, start, to, out, first.size),
            (None, Some(out)) => foot(mesh, facing(mesh, start, out), to, out, first.size),
            _ => start,
        }
    }
}

/// The mean of `count` unit normals from their sum. Nothing if they belong to different sides of a thin sheet.
pub(super) fn outward(sum: DVec3, count: usize) -> Option<DVec3> {
    let length = sum.length();
    (length > OUTWARD * count as f64).then(|| sum / length)
}

/// The start, if its triangle faces the direction; else the middle of the nearest triangle that does.
fn facing(mesh: &TriMesh, start: SurfacePoint, out: DVec3) -> SurfacePoint {
    let mut near = vec![start.triangle];
    for k in 0..NEAREST {
        let Some(&t) = near.get(k) else { break };
        if mesh.face_normal(t).dot(out) > FACES {
            if k == 0 {
                return start;
            }
            return SurfacePoint::new(mesh, t, DVec3::splat(1.0 / 3.0));
        }
        for (next, _) in (0..3).filter_map(|edge| mesh.across(t, edge)) {
            if !near.contains(&next) {
                near.push(next);
            }
        }
    }
    start
}

fn sorted(mut three: [u32; 3]) -> [u32; 3] {
    three.sort_unstable();
    three
}

/// Projects a point in space onto the surface along `out`, by steps from a start nearby. So it stays on the start's
/// side of thin sheets. Along the mean normal the result lies on a crease that cells lie across; the nearest point of
/// the surface would lie on one side of it.
pub(super) fn foot(
    mesh: &TriMesh,
    start: SurfacePoint,
    to: DVec3,
    out: DVec3,
    size: f64,
) -> SurfacePoint {
    let mut at = start;
    for _ in 0..STEPS {
        let r = to - at.at;
        let face = mesh.face_normal(at.triangle);
        let cos = out.dot(face);
        if cos < STEEP {
            break;
        }
        let across = r - out * out.dot(r);
        let along = across - out * (across.dot(face) / cos);
        let by = at.frame().within(rotated(along, face, at.normal));
        let by = by.clamp_length_max(size);
        if by.length() < SHORT * size {
            break;
        }
        at = mesh.walk(&at, by).to;
    }
    at
}
