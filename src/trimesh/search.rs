//! Finds the point of a mesh that is nearest to a point in space, and the first hit of a ray.
//!
//! The search tree is a hierarchy of boxes over the triangles in the order of a Morton curve (Lauterbach et al. 2009,
//! Fast BVH Construction on GPUs). A radix sort makes that order, so all the work is loops that can be cut anywhere.

use super::sorting::Sorting;
use super::{NONE, SurfacePoint, TriMesh};
use crate::order::{greater, lesser};
use glam::DVec3;

/// Triangles in a leaf.
const LEAF: usize = 8;
/// The curve has 2^BITS steps along each axis. The bits of the three axes together take three rounds of the sort.
const BITS: u32 = 10;
/// Rounding may make the distance to a box too large by less than this factor.
const SLACK: f64 = 1.0 + 1e-12;
/// The rounding error of a squared distance to a plane is less than this share of the squared distance to a corner on
/// it.
const ROUNDING: f64 = 1e-14;

/// The tolerance of barycentric weights. With it, a ray through an edge meets at least one of the edge's triangles.
const NEAR_EDGE: f64 = 1e-12;

/// Room for the open nodes of a search: one on each level, in the largest tree.
const DEEP: usize = 24;

/// A point moves to triangles that face the other way only if those that face its own way are more than this many times
/// as far away.
const BACK: f64 = 4.0;

/// The hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The point that is hit.
    pub point: SurfacePoint,
    /// The distance along the ray, in lengths of its direction.
    pub along: f64,
}

/// The nearest place so far.
#[derive(Clone, Copy)]
struct Found {
    square: f64,
    /// The index of the triangle; [`NONE`] if nothing is found.
    triangle: u32,
    weights: DVec3,
}

impl Found {
    const NONE: Self = Self {
        square: f64::INFINITY,
        triangle: NONE,
        weights: DVec3::X,
    };

    fn point(&self, mesh: &TriMesh) -> SurfacePoint {
        let triangle = if self.triangle == NONE {
            0
        } else {
            self.triangle
        };
        SurfacePoint::new(mesh, triangle, self.weights)
    }
}

/// The search tree of one mesh.
#[derive(Clone, Debug)]
pub struct Search {
    triangles: Vec<u32>,
    /// The tree as a heap: the box of node k holds those of nodes 2k and 2k + 1. The last half are the leaves.
    boxes: Vec<(DVec3, DVec3)>,
    stage: TreeStage,
    at: usize,
}

/// A search tree in progress.
#[derive(Clone, Debug)]
enum TreeStage {
    /// The codes of the triangles along the curve, with their indices.
    Codes(Vec<(u64, u32)>),
    Sort(Sorting),
    Leaves,
    /// The boxes of the tree are made, from the leaves up.
    Up,
    Done,
}

/// Nodes that are still to be searched, each with a lower bound of its distance (squared for the nearest place).
struct OpenNodes(Vec<(f64, usize)>);

impl OpenNodes {
    /// The root.
    fn new() -> Self {
        let mut nodes = Vec::with_capacity(DEEP);
        nodes.push((0.0, 1));
        Self(nodes)
    }

    /// Opens the children of a node, the nearer one to be searched first. Children at infinity are left out.
    fn split(&mut self, node: usize, far: impl Fn(usize) -> f64) {
        let (a, b) = (2 * node, 2 * node + 1);
        let (to_a, to_b) = (far(a), far(b));
        let (farther, nearer) = if to_a < to_b {
            ((to_b, b), (to_a, a))
        } else {
            ((to_a, a), (to_b, b))
        };
        for child in [farther, nearer] {
            if child.0 < f64::INFINITY {
                self.0.push(child);
            }
        }
    }
}

/// A search for the place nearest to a point, which can be cut into slices.
pub(crate) struct NearestWalk {
    p: DVec3,
    open: OpenNodes,
    best: Found,
}

impl NearestWalk {
    /// Starts at a point. Only places nearer than `radius` count.
    pub fn new(p: DVec3, radius: f64) -> Self {
        let limit = Found {
            square: radius * radius,
            ..Found::NONE
        };
        Self::below(p, limit)
    }

    fn below(p: DVec3, best: Found) -> Self {
        let open = OpenNodes::new();
        Self { p, open, best }
    }

    /// Goes on among all triangles; true at the end. Each box and triangle that is looked at takes one off `amount`, and
    /// the search pauses when nothing is left of it.
    pub fn advance(&mut self, search: &Search, mesh: &TriMesh, amount: &mut usize) -> bool {
        self.pass(search, mesh, amount, |_| true)
    }

    /// The nearest place, once the search is at its end; `None` if there is none within the radius.
    pub fn found(&self, mesh: &TriMesh) -> Option<SurfacePoint> {
        (self.best.triangle != NONE).then(|| self.best.point(mesh))
    }

    /// Does as [`Self::advance`], but among the triangles for which `wanted` is true.
    fn pass(
        &mut self,
        search: &Search,
        mesh: &TriMesh,
        amount: &mut usize,
        wanted: impl Fn(u32) -> bool,
    ) -> bool {
        let (p, best) = (self.p, &mut self.best);
        let leaves = search.boxes.len() / 2;
        while *amount > 0 {
            let Some((near, node)) = self.open.0.pop() else {
                return true;
            };
            *amount -= 1;
            if near > best.square * SLACK {
                continue;
            }
            if node < leaves {
                self.open.split(node, |child| search.square(child, p));
                continue;
            }
            let leaf = search.leaf(node - leaves);
            *amount = amount.saturating_sub(leaf.len());
            for &t in leaf.iter().filter(|&&t| wanted(t)) {
                let corners = mesh.corners(t);
                // A triangle is no nearer than its plane.
                let off = p - corners[0];
                let height = mesh.face_normal(t).dot(off);
                if height * height > best.square * SLACK + ROUNDING * off.length_squared() {
                    continue;
                }
                let weights = nearest_weights(corners, p);
                let at = corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z;
                let square = at.distance_squared(p);
                if square < best.square || (square == best.square && t < best.triangle) {
                    *best = Found {
                        square,
                        triangle: t,
                        weights,
                    };
                }
            }
        }
        self.open.0.is_empty()
    }
}

const NOTHING: (DVec3, DVec3) = (DVec3::INFINITY, DVec3::NEG_INFINITY);

impl Search {
    /// Makes the whole tree; [`Search::begin`] and [`Search::advance`] make it in slices.
    pub fn new(mesh: &TriMesh) -> Self {
        let mut search = Self::begin(mesh);
        while !search.advance(mesh, usize::MAX) {}
        search
    }

    /// Starts an empty tree.
    pub fn begin(mesh: &TriMesh) -> Self {
        let count = mesh.triangles().len();
        let leaves = count.div_ceil(LEAF).next_power_of_two();
        Self {
            triangles: Vec::with_capacity(count),
            boxes: vec![NOTHING; 2 * leaves],
            stage: TreeStage::Codes(Vec::with_capacity(count)),
            at: 0,
        }
    }

    /// Works on at most `amount` triangles; true when the tree is complete.
    pub fn advance(&mut self, mesh: &TriMesh, amount: usize) -> bool {
        let leaves = self.boxes.len() / 2;
        // How many triangles, leaves or boxes the stage works on. The sort makes its own slices.
        let all = match self.stage {
            TreeStage::Codes(_) => mesh.triangles().len(),
            TreeStage::Leaves => leaves,
            TreeStage::Up => leaves - 1,
            TreeStage::Sort(_) | TreeStage::Done => 0,
        };
        let end = all.min(self.at.saturating_add(amount.max(1)));
        self.stage = match std::mem::replace(&mut self.stage, TreeStage::Done) {
            TreeStage::Codes(mut codes) => {
                push_codes(mesh, end, &mut codes);
                match end == all {
                    true => TreeStage::Sort(Sorting::new(codes)),
                    false => TreeStage::Codes(codes),
                }
            }
            TreeStage::Sort(mut sorting) => match sorting.advance() {
                Some(sorted) => {
                    self.triangles.extend(sorted.iter().map(|&(_, t)| t));
                    TreeStage::Leaves
                }
                None => TreeStage::Sort(sorting),
            },
            TreeStage::Leaves => {
                self.leaves(mesh, end);
                if end == all {
                    TreeStage::Up
                } else {
                    TreeStage::Leaves
                }
            }
            TreeStage::Up => {
                self.up(end);
                if end == all {
                    TreeStage::Done
                } else {
                    TreeStage::Up
                }
            }
            TreeStage::Done => TreeStage::Done,
        };
        self.at = if end == all { 0 } else { end };
        matches!(self.stage, TreeStage::Done)
    }

    fn leaves(&mut self, mesh: &TriMesh, end: usize) {
        let leaves = self.boxes.len() / 2;
        for leaf in self.at..end {
            let mut all = NOTHING;
            for &t in self.leaf(leaf) {
                for p in mesh.corners(t) {
                    all = (all.0.min(p), all.1.max(p));
                }
            }
            self.boxes[leaves + leaf] = all;
        }
    }

    fn up(&mut self, end: usize) {
        let leaves = self.boxes.len() / 2;
        for node in self.at..end {
            let node = leaves - 1 - node;
            let [a, b] = [self.boxes[2 * node], self.boxes[2 * node + 1]];
            self.boxes[node] = (a.0.min(b.0), a.1.max(b.1));
        }
    }

    fn leaf(&self, leaf: usize) -> &[u32] {
        let count = self.triangles.len();
        &self.triangles[(leaf * LEAF).min(count)..((leaf + 1) * LEAF).min(count)]
    }

    /// The point of the mesh nearest to `p`. Among equally near ones, that of the triangle with the least number.
    pub fn closest(&self, mesh: &TriMesh, p: DVec3) -> SurfacePoint {
        self.nearest(mesh, p, Found::NONE, |_| true).point(mesh)
    }

    /// The nearest place among triangles that face the same side as `normal`, unless all of them are much farther
    /// away. So a point stays on its side of a thin sheet. A zero normal allows all triangles.
    pub fn closest_facing(&self, mesh: &TriMesh, p: DVec3, normal: DVec3) -> SurfacePoint {
        let faces = |t: u32| mesh.face_normal(t).dot(normal) >= 0.0;
        let any = self.nearest(mesh, p, Found::NONE, |_| true);
        if any.triangle == NONE || faces(any.triangle) {
            return any.point(mesh);
        }
        let limit = Found {
            square: any.square * (BACK * BACK * SLACK),
            ..Found::NONE
        };
        let front = self.nearest(mesh, p, limit, faces);
        let is_far = front.triangle == NONE || any.square.sqrt() * BACK < front.square.sqrt();
        if is_far { any } else { front }.point(mesh)
    }

    /// The nearest place on the triangles for which `wanted` is true, if it is nearer than `best`; else `best`.
    fn nearest(
        &self,
        mesh: &TriMesh,
        p: DVec3,
        best: Found,
        wanted: impl Fn(u32) -> bool,
    ) -> Found {
        let mut walk = NearestWalk::below(p, best);
        walk.pass(self, mesh, &mut { usize::MAX }, wanted);
        walk.best
    }

    /// Whether `test` is true for a triangle near `p`. It is called for all triangles that are at most `radius` away,
    /// and for some others, until it returns true.
    pub fn any_within(&self, p: DVec3, radius: f64, mut test: impl FnMut(u32) -> bool) -> bool {
        let mut open = vec![1];
        let leaves = self.boxes.len() / 2;
        while let Some(node) = open.pop() {
            if self.square(node, p) > radius * radius * SLACK {
                continue;
            }
            if node < leaves {
                open.extend([2 * node, 2 * node + 1]);
            } else if self.leaf(node - leaves).iter().any(|&t| test(t)) {
                return true;
            }
        }
        false
    }

    fn square(&self, node: usize, p: DVec3) -> f64 {
        let (lo, hi) = self.boxes[node];
        if lo.x > hi.x {
            return f64::INFINITY;
        }
        p.distance_squared(p.max(lo).min(hi))
    }

    /// The first hit of a ray on a triangle for which `wanted` is true, from either side.
    pub fn ray(
        &self,
        mesh: &TriMesh,
        from: DVec3,
        along: DVec3,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Hit> {
        self.ray_within(mesh, (from, along), f64::INFINITY, wanted)
    }

    /// The first hit of a ray no farther than `most`, in lengths of its direction.
    pub fn ray_within(
        &self,
        mesh: &TriMesh,
        (from, along): (DVec3, DVec3),
        most: f64,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Hit> {
        let inverse = along.recip();
        let mut best = (most, NONE, DVec3::ZERO);
        let mut open = OpenNodes::new();
        let leaves = self.boxes.len() / 2;
        while let Some((near, node)) = open.0.pop() {
            if near > best.0 {
                continue;
            }
            if node < leaves {
                open.split(node, |child| self.entry(child, from, inverse));
                continue;
            }
            for &t in self.leaf(node - leaves) {
                if wanted(t)
                    && let Some((far, w)) = meets(mesh.corners(t), from, along)
                    && (far < best.0 || (far == best.0 && t < best.1))
                {
                    best = (far, t, w);
                }
            }
        }
        (best.1 != NONE).then(|| Hit {
            point: SurfacePoint::new(mesh, best.1, best.2),
            along: best.0,
        })
    }

    /// Where a ray enters a box; infinity if it misses it.
    fn entry(&self, node: usize, from: DVec3, inverse: DVec3) -> f64 {
        let (lo, hi) = self.boxes[node];
        let (mut first, mut last) = (0.0_f64, f64::INFINITY);
        for k in 0..3 {
            if inverse[k].is_finite() {
                let (a, b) = (
                    (lo[k] - from[k]) * inverse[k],
                    (hi[k] - from[k]) * inverse[k],
                );
                first = greater(first, lesser(a, b) / SLACK);
                last = lesser(last, greater(a, b) * SLACK);
            } else if from[k] < lo[k] || from[k] > hi[k] {
                return f64::INFINITY;
            }
        }
        if first <= last { first } else { f64::INFINITY }
    }
}

/// Adds the codes of triangles along the curve, up to the triangle `end`.
fn push_codes(mesh: &TriMesh, end: usize, codes: &mut Vec<(u64, u32)>) {
    let (lo, hi) = mesh.bounds();
    let side = (hi - lo).max_element().max(f64::MIN_POSITIVE);
    let most = ((1 << BITS) - 1) as f64;
    for t in codes.len() as u32..end as u32 {
        let [a, b, c] = mesh.corners(t);
        let place = ((a + b + c) / 3.0 - lo) / side * most;
        let [x, y, z] = place.to_array().map(|x| spread(x as u32));
        codes.push((u64::from(x | y << 1 | z << 2), t));
    }
}

/// Puts two zero bits between neighbouring bits.
fn spread(x: u32) -> u32 {
    let mut spread = 0;
    for bit in 0..BITS {
        spread |= (x >> bit & 1) << (3 * bit);
    }
    spread
}

/// The place in a triangle nearest to a point.
pub(crate) fn nearest_in(corners: [DVec3; 3], p: DVec3) -> DVec3 {
    let weights = nearest_weights(corners, p);
    corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z
}

/// The weights of the place in a triangle nearest to a point (Ericson 2005, Real-Time Collision Detection, 5.1.5).
fn nearest_weights([a, b, c]: [DVec3; 3], p: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (ab.dot(p - a), ac.dot(p - a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return DVec3::X;
    }
    let (d3, d4) = (ab.dot(p - b), ac.dot(p - b));
    if d3 >= 0.0 && d4 <= d3 {
        return DVec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return DVec3::new(1.0 - v, v, 0.0);
    }
    let (d5, d6) = (ab.dot(p - c), ac.dot(p - c));
    if d6 >= 0.0 && d5 <= d6 {
        return DVec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return DVec3::new(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return DVec3::new(0.0, 1.0 - w, w);
    }
    let sum = va + vb + vc;
    DVec3::new(va, vb, vc) / sum
}

/// The distance along a ray at which it meets a triangle, and the weights there (Moller, Trumbore 1997, Fast, Minimum
/// Storage Ray-Triangle Intersection).
fn meets([a, b, c]: [DVec3; 3], from: DVec3, along: DVec3) -> Option<(f64, DVec3)> {
    let (e, f) = (b - a, c - a);
    let across = along.cross(f);
    let volume = e.dot(across);
    if volume == 0.0 {
        return None;
    }
    let off = from - a;
    let u = off.dot(across) / volume;
    // Most triangles of a leaf are missed, about half of them by this test.
    if u < -NEAR_EDGE {
        return None;
    }
    let q = off.cross(e);
    let v = along.dot(q) / volume;
    let far = f.dot(q) / volume;
    let within = u >= -NEAR_EDGE && v >= -NEAR_EDGE && u + v <= 1.0 + NEAR_EDGE && far >= 0.0;
    within.then(|| {
        let w = DVec3::new(1.0 - u - v, u, v).max(DVec3::ZERO);
        (far, w / (w.x + w.y + w.z))
    })
}

#[cfg(test)]
mod tests {
    use super::super::testing::{self, mesh};
    use super::super::{Simplifying, log, samples};
    use super::*;

    fn probes() -> impl Iterator<Item = DVec3> {
        (0..300).map(|k| {
            let t = f64::from(k);
            let r = 0.1 + 1.7 * t / 300.0;
            r * DVec3::new(libm::sin(t), libm::sin(1.7 * t), libm::cos(2.3 * t))
        })
    }

    #[test]
    fn the_closest_place_is_that_of_all_triangles() {
        for mesh in [samples::blob(3), samples::torus(30, 12), samples::ball(0)] {
            let mut search = Search::begin(&mesh);
            while !search.advance(&mesh, 7) {}
            assert_eq!(search.triangles, Search::new(&mesh).triangles);
            for p in probes() {
                let found = search.closest(&mesh, p);
                let least = (0..mesh.triangles().len() as u32)
                    .map(|t| {
                        let c = mesh.corners(t);
                        let w = nearest_weights(c, p);
                        (c[0] * w.x + c[1] * w.y + c[2] * w.z).distance(p)
                    })
                    .fold(f64::INFINITY, f64::min);
                assert!((found.at.distance(p) - least).abs() < 1e-12, "{p}");
                let weights = found.weights(&mesh);
                assert!(weights.min_element() > -1e-9);
            }
            // At a vertex all its triangles are equally near.
            for (v, &p) in mesh.positions().iter().enumerate() {
                let first = mesh.fan(v as u32).map(|(t, _)| t).min().unwrap();
                assert_eq!(search.closest(&mesh, p).triangle, first);
            }
        }
    }

    #[test]
    fn a_search_can_be_cut_anywhere() {
        // All triangles of a ball are equally far from its middle.
        let mesh = samples::ball(3);
        let (search, count) = (Search::new(&mesh), mesh.triangles().len());
        for (p, least) in [(DVec3::ZERO, count / 50), (DVec3::new(2.0, 0.1, 0.3), 1)] {
            let mut walk = NearestWalk::new(p, f64::INFINITY);
            let mut slices = 1;
            while !walk.advance(&search, &mesh, &mut { 50 }) {
                slices += 1;
            }
            assert_eq!(walk.found(&mesh), Some(search.closest(&mesh, p)));
            assert!((least..=count / 10).contains(&slices), "{slices}");
        }
    }

    #[test]
    fn rays_meet_what_all_triangles_say() {
        let mesh = samples::torus(30, 12);
        let search = Search::new(&mesh);
        let mut met = 0;
        for p in probes() {
            let along = DVec3::new(0.3, 0.2, 0.1) - p;
            let hit = search.ray(&mesh, p, along, |_| true);
            let least = (0..mesh.triangles().len() as u32)
                .filter_map(|t| meets(mesh.corners(t), p, along))
                .map(|(far, _)| far)
                .fold(f64::INFINITY, f64::min);
            assert_eq!(hit.map_or(f64::INFINITY, |h| h.along), least);
            if let Some(hit) = hit {
                met += 1;
                assert!((hit.point.at - (p + along * hit.along)).length() < 1e-9);
            }
        }
        assert!(met > 100, "{met}");
        let down = search.ray(&mesh, DVec3::new(1.0, 2.0, 0.0), DVec3::NEG_Y, |t| {
            mesh.face_normal(t).y < 0.0
        });
        assert!((down.unwrap().along - 2.4).abs() < 0.02);
    }

    #[test]
    fn a_point_stays_on_its_side_of_a_thin_sheet() {
        // A plate whose thickness is a hundredth of its side.
        let (positions, triangles) = testing::cube(20);
        let flat = positions.iter().map(|p| DVec3::new(p.x, 0.01 * p.y, p.z));
        let plate = mesh((flat.collect(), triangles));
        let search = Search::new(&plate);
        let p = DVec3::new(0.52, 0.004, 0.47);
        for up in [1.0, -1.0] {
            let found = search.closest_facing(&plate, p, DVec3::Y * up);
            assert!(found.normal.y * up > 0.9 && (found.at.x - p.x).abs() < 1e-12);
        }
    }

    #[test]
    fn points_of_a_simple_surface_are_carried_to_the_full_one() {
        let full = mesh(testing::blob(5));
        let simple = Simplifying::new(full.clone(), 600, f64::INFINITY).finish();
        let search = Search::new(&full);
        let mut chance = testing::chance(3);
        for t in 0..simple.triangles().len() as u32 {
            let (u, v) = (chance.unit(), 0.5 * chance.unit());
            let weights = DVec3::new(u * (1.0 - v), (1.0 - u) * (1.0 - v), v);
            let point = SurfacePoint::new(&simple, t, weights);
            let on = search.closest_facing(&full, point.at, point.normal);
            assert!((on.at - point.at).length() < 0.03);
            assert!(on.normal.dot(point.normal) > 0.8);
            assert!(on.weights(&full).min_element() > -1e-9 && log(&on, &on).is_some());
        }
    }

    #[test]
    fn all_triangles_within_a_radius_are_found() {
        let mesh = samples::blob(3);
        let search = Search::new(&mesh);
        for p in probes() {
            let mut seen = vec![false; mesh.triangles().len()];
            let stopped = search.any_within(p, 0.4, |t| {
                seen[t as usize] = true;
                false
            });
            assert!(!stopped);
            for (t, seen) in (0..).zip(seen) {
                let near = nearest_in(mesh.corners(t), p).distance(p) < 0.4;
                assert!(seen || !near, "{p} {t}");
                assert!(!near || search.any_within(p, 0.4, |other| other == t));
            }
        }
    }
}
