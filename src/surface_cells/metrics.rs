//! Figures for the quality of cells on a surface.
//!
//! All are pure functions of the mesh and the cells, computed only on demand.

use crate::order;
use crate::planar::signed_angle;
use crate::surface_cells::SurfaceMesh;
use crate::trimesh::frame::log_in;
use crate::trimesh::{SurfacePoint, TangentFrame, TriMesh};
use glam::{DVec2, DVec3};

/// Samples for each cell.
const SAMPLES: f64 = 40.0;
/// Strides of the low-discrepancy sequence by which samples lie in their triangles (Roberts 2018).
const STRIDE: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_3];

/// Normals belong to the two sides of a sheet if their dot product is less than this.
const OTHER_SIDE: f64 = -0.2;

/// Figures for the quality of cells on a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceMetrics {
    /// How many cells there are.
    pub cells: usize,
    /// How many cells have a polygon.
    pub rings: usize,
    /// The mean ratio of the root of a polygon's area to the size that it should have.
    pub size: f64,
    /// Standard deviation over mean of that ratio.
    pub size_cv: f64,
    /// The mean angle of polygons' sides to their cells' axes, weighted by length, 0..45 degrees; for cells with
    /// corners. Sides along the border are left out.
    pub angle: Option<f64>,
    /// The share of quadrilaterals among the elements.
    pub quads: f64,
    /// The share of regular inner nodes: with four sides for cells with corners, six for others.
    pub regular: Option<f64>,
    /// The share of the surface that no polygon covers.
    pub holes: f64,
    /// The share of the surface that several polygons cover.
    pub overlaps: f64,
    /// The area of all polygons over that of the surface.
    pub area: f64,
    /// The Euler characteristic of the elements.
    pub euler: i64,
    /// How many directed sides of elements occur more than once.
    pub doubled: usize,
}

impl SurfaceMetrics {
    /// Measures the cells made on a mesh.
    pub fn new(mesh: &TriMesh, made: &SurfaceMesh) -> Self {
        let (mut sizes, mut squares, mut area) = (0.0, 0.0, 0.0);
        let (mut angles, mut lengths) = (0.0, 0.0);
        let mut with = 0.0;
        for (cell, ring) in made.cells.iter().zip(&made.rings) {
            if ring.len() < 3 {
                continue;
            }
            with += 1.0;
            let own = polygon_area(made, &cell.centre, ring);
            area += own;
            let size = own.max(0.0).sqrt() / cell.size;
            sizes += size;
            squares += size * size;
            // The angles of a polygon that is bent over a rim are left out.
            let flat = flattened(made, &cell.centre, ring).unwrap_or_default();
            for k in 0..flat.len() {
                let next = (k + 1) % flat.len();
                let inner = [k, next].iter().any(|&k| !made.is_on_border(ring[k]));
                let (side, e) = (flat[next] - flat[k], cell.axis);
                if inner && cell.kind.has_corners() && e != DVec2::ZERO {
                    let turn = signed_angle(e, side).to_degrees();
                    let rest = turn - 90.0 * (turn / 90.0).floor();
                    angles += rest.min(90.0 - rest) * side.length();
                    lengths += side.length();
                }
            }
        }
        let mean = sizes / f64::max(with, 1.0);
        let deviation = (squares / f64::max(with, 1.0) - mean * mean)
            .max(0.0)
            .sqrt();
        let (holes, overlaps) = cover(mesh, made);
        let quads = made.elements.iter().filter(|f| f.nodes().len() == 4);
        let sides = ElementSides::new(made);
        Self {
            cells: made.cells.len(),
            rings: made.rings.iter().filter(|r| !r.is_empty()).count(),
            size: mean,
            size_cv: if mean > 0.0 { deviation / mean } else { 0.0 },
            angle: (lengths > 0.0).then(|| angles / lengths),
            quads: quads.count() as f64 / made.elements.len().max(1) as f64,
            regular: sides.regular(made),
            holes,
            overlaps,
            area: area / mesh.area(),
            euler: sides.euler(made),
            doubled: sides.doubled,
        }
    }
}

/// A polygon in the plane of its cell, by the logarithmic map.
fn flattened(made: &SurfaceMesh, centre: &SurfacePoint, ring: &[u32]) -> Option<Vec<DVec2>> {
    let frame = centre.frame();
    let seen = |&k: &u32| {
        let corner = &made.corners[k as usize];
        log_in(&frame, centre.at, corner.at, corner.normal)
    };
    let flat: Vec<DVec2> = ring.iter().map(seen).collect::<Option<_>>()?;
    (flat.len() >= 3).then_some(flat)
}

/// The area of the triangles between a cell's centre and its polygon's sides.
fn polygon_area(made: &SurfaceMesh, centre: &SurfacePoint, ring: &[u32]) -> f64 {
    let at = |k: usize| made.corners[ring[k % ring.len()] as usize];
    let triangles = (0..ring.len()).map(|k| {
        let (a, b) = (at(k), at(k + 1));
        let double = (a.at - centre.at).cross(b.at - centre.at);
        let out = centre.normal + faced(centre, &a) + faced(centre, &b);
        0.5 * double.length() * double.dot(out).signum()
    });
    triangles.sum()
}

/// The normal at a corner, or the centre's own if the corner is on the other side of a sheet.
fn faced(centre: &SurfacePoint, corner: &SurfacePoint) -> DVec3 {
    if corner.normal.dot(centre.normal) < OTHER_SIDE {
        centre.normal
    } else {
        corner.normal
    }
}

/// The sides of all elements.
struct ElementSides {
    /// The number of sides at each node, and whether the node lies on the border.
    valence: Vec<u32>,
    is_border: Vec<bool>,
    count: usize,
    doubled: usize,
}

impl ElementSides {
    fn new(made: &SurfaceMesh) -> Self {
        let mut sides: Vec<(u64, bool)> = Vec::new();
        for face in &made.elements {
            let nodes = face.nodes();
            for (k, &a) in nodes.iter().enumerate() {
                let b = nodes[(k + 1) % nodes.len()];
                sides.push((order::pair(a.min(b), a.max(b)), a < b));
            }
        }
        sides.sort_unstable();
        let mut of = Self {
            valence: vec![0; made.cells.len()],
            is_border: vec![false; made.cells.len()],
            count: 0,
            doubled: 0,
        };
        for same in sides.chunk_by(|a, b| a.0 == b.0) {
            let forth = same.iter().filter(|s| s.1).count();
            let most = forth.max(same.len() - forth);
            of.count += most;
            of.doubled += forth.saturating_sub(1) + (same.len() - forth).saturating_sub(1);
            for k in [(same[0].0 >> 32) as usize, same[0].0 as u32 as usize] {
                of.valence[k] += most as u32;
                of.is_border[k] |= 2 * forth != same.len();
            }
        }
        of
    }

    fn euler(&self, made: &SurfaceMesh) -> i64 {
        let nodes = self.valence.iter().filter(|&&v| v > 0).count();
        nodes as i64 - self.count as i64 + made.elements.len() as i64
    }

    fn regular(&self, made: &SurfaceMesh) -> Option<f64> {
        let (mut all, mut regular) = (0, 0);
        for (k, cell) in made.cells.iter().enumerate() {
            if self.valence[k] > 0 && !self.is_border[k] {
                let wanted = if cell.kind.has_corners() { 4 } else { 6 };
                all += 1;
                regular += u32::from(self.valence[k] == wanted);
            }
        }
        (all > 0).then(|| f64::from(regular) / f64::from(all))
    }
}

/// Points all over the surface, spread by area.
fn samples(mesh: &TriMesh, count: f64) -> Vec<SurfacePoint> {
    let mut made = Vec::new();
    let (mut due, mut number) = (0.5, 0.0);
    for t in 0..mesh.triangles().len() as u32 {
        due += mesh.area_of(t) / mesh.area() * count;
        while due >= 1.0 {
            due -= 1.0;
            number += 1.0;
            let [mut u, mut v] = STRIDE.map(|s| (number * s).fract());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            made.push(SurfacePoint::new(mesh, t, DVec3::new(1.0 - u - v, u, v)));
        }
    }
    made
}

/// The shares of the surface that no polygon covers, and that several cover.
fn cover(mesh: &TriMesh, made: &SurfaceMesh) -> (f64, f64) {
    let samples = samples(mesh, SAMPLES * made.cells.len() as f64);
    let beside = beside(made);
    let polygons: Vec<SurfacePolygon> = made
        .cells
        .iter()
        .zip(&made.rings)
        .filter(|(_, ring)| !ring.is_empty())
        .map(|(cell, ring)| SurfacePolygon::new(made, cell.centre, ring, &beside))
        .collect();
    let sum: f64 = polygons.iter().map(|p| p.radius).sum();
    let step = (sum / polygons.len().max(1) as f64).max(1e-9 * mesh.diagonal());
    let (lo, _) = mesh.bounds();
    let box_of = |p: DVec3| ((p - lo) / step).floor();
    let key = |b: DVec3| [b.x as i64, b.y as i64, b.z as i64];
    let mut placed: Vec<([i64; 3], u32)> = samples
        .iter()
        .enumerate()
        .map(|(k, s)| (key(box_of(s.at)), k as u32))
        .collect();
    placed.sort_unstable();
    let mut times = vec![0u8; samples.len()];
    for polygon in &polygons {
        let reach = DVec3::splat(polygon.radius);
        let from = key(box_of(polygon.centre.at - reach));
        let to = key(box_of(polygon.centre.at + reach));
        for x in from[0]..=to[0] {
            for y in from[1]..=to[1] {
                let first = placed.partition_point(|p| p.0 < [x, y, from[2]]);
                let here = placed[first..].iter();
                for &(_, k) in here.take_while(|p| p.0 <= [x, y, to[2]]) {
                    if polygon.has(&samples[k as usize]) {
                        times[k as usize] += 1;
                    }
                }
            }
        }
    }
    let share = |of: &dyn Fn(u8) -> bool| {
        times.iter().filter(|&&t| of(t)).count() as f64 / times.len().max(1) as f64
    };
    (share(&|t| t == 0), share(&|t| t > 1))
}

/// The polygon of each side, by the side's two corners.
fn beside(made: &SurfaceMesh) -> Vec<(u64, u32)> {
    let mut sides = Vec::new();
    for (cell, ring) in made.rings.iter().enumerate() {
        for k in 0..ring.len() {
            let next = ring[(k + 1) % ring.len()];
            sides.push((order::pair(ring[k], next), cell as u32));
        }
    }
    sides.sort_unstable();
    sides
}

/// A polygon on the surface, for tests whether it contains a point.
///
/// The test for the side of a line projects along a normal: the mean of the normals at the line's ends, of the cells
/// beside it, and of the point. It is the same for both cells. (The normal of a rim alone is never quite upright:
/// projected along it, a point far down one side of the sheet would lie beyond the rim.)
struct SurfacePolygon {
    centre: SurfacePoint,
    frame: TangentFrame,
    radius: f64,
    /// For each corner: its place, the normal along which its spoke is projected, and the normal for the side to the
    /// next corner.
    ring: Vec<[DVec3; 3]>,
}

impl SurfacePolygon {
    fn new(made: &SurfaceMesh, centre: SurfacePoint, ring: &[u32], beside: &[(u64, u32)]) -> Self {
        let n = ring.len();
        let corner = |k: usize| {
            let (a, b) = (ring[k], ring[(k + 1) % n]);
            let [p, q] = [a, b].map(|k| &made.corners[k as usize]);
            let back = order::pair(b, a);
            let other = beside.binary_search_by_key(&back, |s| s.0).ok();
            let other = other.map(|s| made.cells[beside[s].1 as usize].centre.normal);
            let cells = centre.normal + other.unwrap_or(centre.normal);
            [
                p.at,
                centre.normal + p.normal,
                (p.normal + q.normal) + cells,
            ]
        };
        let ring: Vec<[DVec3; 3]> = (0..n).map(corner).collect();
        let far = ring.iter().map(|c| c[0].distance(centre.at));
        Self {
            radius: 1.2 * far.fold(0.0, f64::max),
            frame: centre.frame(),
            centre,
            ring,
        }
    }

    fn has(&self, p: &SurfacePoint) -> bool {
        let centre = self.centre.at;
        let n = self.ring.len();
        if p.at.distance(centre) > self.radius
            || log_in(&self.frame, centre, p.at, p.normal).is_none()
        {
            return false;
        }
        // Count the triangles around the centre that contain the point; triangles that are turned over count
        // negative.
        let mut sum = 0;
        let spoke = |[at, along, _]: [DVec3; 3]| is_left([centre, at], along, p.at);
        let mut last = spoke(self.ring[0]);
        for k in 0..n {
            let (a, b) = (self.ring[k], self.ring[(k + 1) % n]);
            let next = spoke(b);
            let side = is_left([a[0], b[0]], a[2] + 2.0 * p.normal, p.at);
            match (last, side, next) {
                (true, true, false) => sum += 1,
                (false, false, true) => sum -= 1,
                _ => {}
            }
            last = next;
        }
        sum > 0
    }
}

/// Whether a point is on the left of the line from `a` to `b`, projected along a normal. For the reverse line the
/// answer is always the opposite.
fn is_left([a, b]: [DVec3; 2], normal: DVec3, p: DVec3) -> bool {
    let rank = |v: DVec3| [v.x, v.y, v.z].map(order::rank);
    let of = |a: DVec3, b: DVec3| (b - a).cross(p - a).dot(normal) >= 0.0;
    if rank(a) <= rank(b) {
        of(a, b)
    } else {
        !of(b, a)
    }
}
