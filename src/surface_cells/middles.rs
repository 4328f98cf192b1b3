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
/// A step shorter than this, in sizes, is none.
const SHORT: f64 = 1e-6;
/// The normals of cells around a rim add up to less than this, each counted as 1: they do not tell where out is.
const OUTWARD: f64 = 0.55;
/// Cells meet on a rim where the normal there leads so far out of their sheet; elsewhere one of them is folded over it.
const RIM: f64 = 0.5;
/// A triangle that turns less than this (cosine) away from a direction faces it.
const FACES: f64 = 0.7;
/// The most triangles among which one is sought.
const NEAREST: usize = 100;
/// A surface is not steeper than this (cosine) against the mean normal of the cells on it.
const STEEP: f64 = 0.2;

/// Where the flood's cells meet.
#[derive(Default)]
pub(super) struct Meetings {
    /// The three cells, rising, and the place.
    all: Vec<([u32; 3], SurfacePoint)>,
}

impl Meetings {
    /// Adds triangles between cells, and where each is.
    pub fn add(&mut self, triangles: &Triangles, places: &[SurfacePoint]) {
        let named = triangles.nodes.iter().map(|&three| sorted(three));
        self.all.extend(named.zip(places.iter().copied()));
        // Of one told twice the first counts.
        order::sort(&mut self.all, |m| {
            (order::pair(m.0[0], m.0[1]), m.0[2].into())
        });
        self.all.dedup_by_key(|m| m.0);
    }

    /// Where three cells meet.
    pub fn of(&self, three: [u32; 3]) -> Option<&SurfacePoint> {
        let three = sorted(three);
        let place = self.all.binary_search_by(|m| m.0.cmp(&three)).ok()?;
        Some(&self.all[place].1)
    }

    /// The place and the normal of the rim where some meet, told by rising numbers.
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

    /// The place where an element's cells meet: the larger a cell, the farther from it.
    pub fn middle(&self, mesh: &TriMesh, cells: &[SurfaceParticle], face: &Face) -> SurfacePoint {
        let (mut sum, mut weight, mut normal) = (DVec3::ZERO, 0.0, DVec3::ZERO);
        // The mean normal where those on the other side of a sheet are turned round.
        let mut across = DVec3::ZERO;
        // In one order, whichever corner is the first.
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
            // Of the two triangles, by one diagonal or the other.
            [a, b, c, d] => {
                let found = |k: u32, l: u32| self.of([a, k, l]);
                found(b, d).or_else(|| found(b, c)).or_else(|| found(c, d))
            }
            _ => None,
        };
        let start = *start.unwrap_or(&first.centre);
        // At a rim out of it, along the sheet.
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

/// The mean of unit normals, of which this is the sum; none where they are of different sides of a thin sheet.
pub(super) fn outward(sum: DVec3, count: usize) -> Option<DVec3> {
    let length = sum.length();
    (length > OUTWARD * count as f64).then(|| sum / length)
}

/// The nearest triangle that faces a direction, its middle.
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

/// The foot of a point in space on the surface along a direction, sought from a point nearby: so it stays on that one's side
/// of thin sheets. Along the mean normal it is on the crease where cells lie across one; the nearest foot would be on either
/// side of it.
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
