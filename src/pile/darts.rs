//! Darts: points spread evenly over a surface, without a period.

use crate::component::FULL_COVER;
use crate::order::rank;
use crate::random::{Purpose, Random};
use crate::trimesh::running_sums::RunningSums;
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::DVec3;
use std::cell::OnceCell;
use std::cmp::Reverse;

/// Darts thrown on the whole surface first, for each square of the least distance.
const THROWN: f64 = 2.0;
/// Darts thrown first in scan order, for each square of the least distance: enough that rows show.
const SCANNED: f64 = 32.0;
/// The width of a row in scan order, as a share of the least distance.
const ROW: f64 = 0.125;
/// A fragment is not divided if its edges are shorter than this share of the least distance.
const SHORTEST: f64 = 0.03;
/// The most rounds of division, for triangles that are huge beside the distance.
const MOST_ROUNDS: usize = 16;
/// The cosine of the greatest angle between normals of one side of the surface.
const SIDE: f64 = -0.2;

/// A point at which a body is placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dart {
    /// The number of its type.
    pub kind: u32,
    /// The number of its layer: 0 on the surface, and then inwards.
    pub layer: u32,
    /// Where it lies.
    pub at: DVec3,
    /// The unit normal of the surface at the dart; for inner layers, at the point of the surface above.
    pub normal: DVec3,
    /// The triangle on which it lies; for inner layers, the triangle above.
    pub triangle: u32,
}

/// About the number of darts on an area if they are at least `spacing` apart.
pub fn expected_darts(area: f64, spacing: f64) -> f64 {
    FULL_COVER * area / (spacing * spacing)
}

/// Whether two points with these normals lie on one side of a thin sheet. Darts on different sides do not see each
/// other.
pub fn same_side(a: DVec3, b: DVec3) -> bool {
    a.dot(b) > SIDE
}

/// Throws darts on a surface until there is no room: a maximal Poisson-disk distribution by Euclidean distance (section
/// 4.1.2). Darts on different sides do not count ([`same_side`]).
///
/// Darts fall on the whole surface first. Then fragments of triangles that are not covered by a single dart's disk get
/// a dart each, and are divided in four (White, Cline, Egbert 2007, Poisson Disk Point Sets by Hierarchical Dart
/// Throwing). The cost of a dart does not depend on the number of darts.
pub struct Darting {
    spacing: f64,
    in_scan_order: bool,
    random: Random,
    accepted: Accepted,
    stage: DartingPhase,
}

enum DartingPhase {
    /// The sums of the triangles' areas.
    Areas(RunningSums),
    Throw {
        sums: RunningSums,
        left: usize,
        /// Points that wait for their turn in scan order.
        points: Vec<SurfacePoint>,
    },
    /// Points against scan order, so that the next one is the last of the list.
    Scan(Vec<SurfacePoint>),
    Cover(Cover),
    Done,
}

/// Fragments that may be uncovered.
struct Cover {
    now: Vec<Fragment>,
    at: usize,
    next: Vec<Fragment>,
    rounds: usize,
}

#[derive(Clone, Copy)]
struct Fragment {
    triangle: u32,
    /// The barycentric weights of its corners.
    corners: [DVec3; 3],
}

/// The darts so far.
struct Accepted {
    points: Vec<SurfacePoint>,
    hash: SurfaceHash,
    square: f64,
    spacing: f64,
    /// The number of the dart that has covered a fragment last. It often covers the next one, too.
    covering: usize,
}

impl Darting {
    /// Begins to throw darts that are at least `spacing` apart. `kind` is the number of the type: each type has its own
    /// random numbers. `in_scan_order` takes points row by row, and the rows show (section 4.2).
    pub fn new(mesh: &TriMesh, spacing: f64, kind: u32, seed: u64, in_scan_order: bool) -> Self {
        let stage = DartingPhase::Areas(RunningSums::with_capacity(mesh.triangles().len()));
        let random = Random::new(
            seed,
            Purpose::Dart,
            u64::from(kind) << 1 | u64::from(in_scan_order),
        );
        let accepted = Accepted::new(mesh, spacing);
        Self {
            spacing,
            in_scan_order,
            random,
            accepted,
            stage,
        }
    }

    /// Works on about `amount` triangles, darts or fragments. Returns whether all is done.
    pub fn advance(&mut self, mesh: &TriMesh, amount: usize) -> bool {
        self.stage = match std::mem::replace(&mut self.stage, DartingPhase::Done) {
            DartingPhase::Areas(sums) => self.areas(mesh, sums, amount),
            DartingPhase::Throw { sums, left, points } => {
                self.throw(mesh, (sums, left, points), amount)
            }
            DartingPhase::Scan(points) => self.scan(mesh, points, amount),
            DartingPhase::Cover(cover) => self.cover(mesh, cover, amount),
            DartingPhase::Done => DartingPhase::Done,
        };
        matches!(self.stage, DartingPhase::Done)
    }

    /// The darts so far.
    pub fn points(&self) -> &[SurfacePoint] {
        &self.accepted.points
    }

    fn areas(&mut self, mesh: &TriMesh, mut sums: RunningSums, amount: usize) -> DartingPhase {
        let all = mesh.triangles().len();
        let end = all.min(sums.len() + amount.max(1));
        for t in sums.len()..end {
            sums.push(mesh.area_of(t as u32));
        }
        if end < all {
            return DartingPhase::Areas(sums);
        }
        sums.index();
        let area = sums.total() / (self.spacing * self.spacing);
        let share = if self.in_scan_order { SCANNED } else { THROWN };
        let left = (share * area).ceil() as usize;
        DartingPhase::Throw {
            sums,
            left,
            points: Vec::new(),
        }
    }

    fn throw(
        &mut self,
        mesh: &TriMesh,
        (sums, left, mut points): (RunningSums, usize, Vec<SurfacePoint>),
        amount: usize,
    ) -> DartingPhase {
        let now = left.min(amount.max(1));
        for _ in 0..now {
            let point = anywhere(mesh, &sums, &mut self.random);
            match self.in_scan_order {
                true => points.push(point),
                false => self.accepted.offer(point),
            }
        }
        if now < left {
            let left = left - now;
            return DartingPhase::Throw { sums, left, points };
        }
        points.sort_by_key(|point| Reverse(scan_key(point.at, self.spacing)));
        DartingPhase::Scan(points)
    }

    fn scan(
        &mut self,
        mesh: &TriMesh,
        mut points: Vec<SurfacePoint>,
        amount: usize,
    ) -> DartingPhase {
        for point in points
            .split_off(points.len().saturating_sub(amount.max(1)))
            .into_iter()
            .rev()
        {
            self.accepted.offer(point);
        }
        match points.is_empty() {
            true => DartingPhase::Cover(Cover::new(mesh)),
            false => DartingPhase::Scan(points),
        }
    }

    fn cover(&mut self, mesh: &TriMesh, mut cover: Cover, amount: usize) -> DartingPhase {
        let end = cover.now.len().min(cover.at + amount.max(1));
        for k in cover.at..end {
            let fragment = cover.now[k];
            let corners = fragment.places(mesh);
            if self.accepted.covers(mesh, &fragment, corners) {
                continue;
            }
            let weights = fragment.draw(&mut self.random);
            self.accepted
                .offer(SurfacePoint::new(mesh, fragment.triangle, weights));
            if longest(corners) > SHORTEST * self.spacing {
                cover.next.extend(fragment.quarters());
            }
        }
        cover.at = end;
        if end == cover.now.len() {
            cover = Cover {
                now: cover.next,
                at: 0,
                next: Vec::new(),
                rounds: cover.rounds + 1,
            };
        }
        match cover.now.is_empty() || cover.rounds > MOST_ROUNDS {
            true => DartingPhase::Done,
            false => DartingPhase::Cover(cover),
        }
    }
}

/// The key of scan order: narrow rows along x, one after the other along z.
pub(super) fn scan_key(at: DVec3, spacing: f64) -> (u64, u64) {
    (rank((at.z / (ROW * spacing)).floor()), rank(at.x))
}

/// A point of the surface, uniform by area.
pub(super) fn anywhere(mesh: &TriMesh, sums: &RunningSums, random: &mut Random) -> SurfacePoint {
    let triangle = sums.item(random.unit() * sums.total());
    SurfacePoint::new(mesh, triangle as u32, WHOLE.draw(random))
}

const WHOLE: Fragment = Fragment {
    triangle: 0,
    corners: [DVec3::X, DVec3::Y, DVec3::Z],
};

impl Cover {
    fn new(mesh: &TriMesh) -> Self {
        let whole = |triangle| Fragment { triangle, ..WHOLE };
        Self {
            now: (0..mesh.triangles().len() as u32).map(whole).collect(),
            at: 0,
            next: Vec::new(),
            rounds: 0,
        }
    }
}

impl Fragment {
    /// The weights of a point in it, uniform by area.
    fn draw(&self, random: &mut Random) -> DVec3 {
        let [mut a, mut b] = [random.unit(), random.unit()];
        if a + b > 1.0 {
            (a, b) = (1.0 - a, 1.0 - b);
        }
        let [p, q, r] = self.corners;
        p + a * (q - p) + b * (r - p)
    }

    fn places(&self, mesh: &TriMesh) -> [DVec3; 3] {
        let corners = mesh.corners(self.triangle);
        self.corners
            .map(|w| corners[0] * w.x + corners[1] * w.y + corners[2] * w.z)
    }

    fn normals(&self, mesh: &TriMesh) -> [DVec3; 3] {
        self.corners
            .map(|weights| mesh.normal_at(self.triangle, weights))
    }

    fn quarters(&self) -> [Self; 4] {
        let [a, b, c] = self.corners;
        let [d, e, f] = [0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)];
        [[a, d, f], [d, b, e], [f, e, c], [d, e, f]].map(|corners| Self { corners, ..*self })
    }
}

/// The longest side of a triangle.
fn longest([a, b, c]: [DVec3; 3]) -> f64 {
    a.distance_squared(b)
        .max(b.distance_squared(c))
        .max(c.distance_squared(a))
        .sqrt()
}

impl Accepted {
    fn new(mesh: &TriMesh, spacing: f64) -> Self {
        Self {
            points: Vec::new(),
            hash: SurfaceHash::new(mesh.bounds(), spacing),
            square: spacing * spacing,
            spacing,
            covering: 0,
        }
    }

    /// Takes a point if no dart of its side is nearer than the least distance.
    fn offer(&mut self, point: SurfacePoint) {
        let (points, square) = (&self.points, self.square);
        let is_near = |k: usize| {
            let other: &SurfacePoint = &points[k];
            other.at.distance_squared(point.at) < square && same_side(other.normal, point.normal)
        };
        if !self.hash.any_near(point.at, self.spacing, is_near) {
            self.hash.push_at(point.at);
            self.points.push(point);
        }
    }

    /// Whether the disk of a single dart covers the fragment, which has these corners.
    fn covers(&mut self, mesh: &TriMesh, fragment: &Fragment, corners: [DVec3; 3]) -> bool {
        let normals = OnceCell::new();
        let points = &self.points;
        let reaches = |k: usize| {
            let dart = &points[k];
            let is_near = |c: &DVec3| dart.at.distance_squared(*c) < self.square;
            let normals = || normals.get_or_init(|| fragment.normals(mesh)).iter();
            corners.iter().all(is_near) && normals().all(|&n| same_side(dart.normal, n))
        };
        if self.covering < points.len() && reaches(self.covering) {
            return true;
        }
        let mut covering = self.covering;
        let found = self.hash.any_near(corners[0], self.spacing, |k| {
            covering = k;
            reaches(k)
        });
        if found {
            self.covering = covering;
        }
        found
    }
}
