//! Lines drawn on a surface.

use crate::order;
use crate::trimesh::{Search, SurfacePoint, TriMesh};
use glam::DVec3;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// A line drawn on a surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stroke {
    /// Its points, close together: see [`Stroke::through`].
    pub points: Vec<SurfacePoint>,
    /// Its half-width: at this distance from the line its share has fallen to 1 / e.
    pub width: f64,
}

/// Coordinates of a stroke in a recipe count steps; this many span the longest side of the mesh's bounding box.
const STEPS: f64 = 4096.0;
/// Rounds of tightening a path that was found along edges.
const ROUNDS: usize = 60;
/// A path is taut when no point moves by more than this share of its spacing.
const TAUT: f64 = 1e-3;
/// The most points of a path between two places.
const MOST: usize = 2000;

impl Stroke {
    /// The shortest path through places on a mesh, one after the other. A place in another part of the mesh is left
    /// out.
    pub fn through(mesh: &TriMesh, places: &[SurfacePoint], width: f64) -> Self {
        let mut points: Vec<SurfacePoint> = Vec::new();
        for place in places {
            let Some(last) = points.last() else {
                points.push(*place);
                continue;
            };
            if let Some(path) = mesh.shortest_path(last, place) {
                points.extend(path.into_iter().skip(1));
            }
        }
        Self { points, width }
    }

    /// The stroke as whole numbers: its width and its places, in steps (4096 for the longest side of the mesh's
    /// bounding box). So the stroke can be found again when the same model is divided into other triangles.
    pub fn row(&self, mesh: &TriMesh) -> Vec<i64> {
        let (lo, side) = mesh.bounding_cube();
        let steps = |x: f64| (x / side * STEPS).round() as i64;
        let mut row = vec![steps(self.width)];
        let mut last = None;
        for p in &self.points {
            let place = (p.at - lo).to_array().map(steps);
            if last != Some(place) {
                row.extend(place);
            }
            last = Some(place);
        }
        row
    }

    /// The stroke of a row of whole numbers: the nearest places on the mesh, joined by shortest paths. Nothing if the
    /// row does not describe a stroke.
    pub fn from_row(mesh: &TriMesh, search: &Search, row: &[i64]) -> Option<Self> {
        let (&width, places) = row.split_first()?;
        let fits = |&x: &i64| (-64..=STEPS as i64 + 64).contains(&x);
        if places.is_empty() || places.len() % 3 != 0 || width < 0 || !row.iter().all(fits) {
            return None;
        }
        let (lo, side) = mesh.bounding_cube();
        let each = places.chunks_exact(3).map(|p| {
            let at = DVec3::new(p[0] as f64, p[1] as f64, p[2] as f64);
            search.closest(mesh, lo + at * (side / STEPS))
        });
        let places: Vec<SurfacePoint> = each.collect();
        Some(Self::through(mesh, &places, width as f64 * side / STEPS))
    }

    /// The line with fewer points, so that its row is short. All dropped points are within a distance of it (Douglas,
    /// Peucker 1973).
    pub fn simplified(&self, within: f64) -> Self {
        let mut kept = vec![false; self.points.len()];
        let mut open = vec![(0, self.points.len().saturating_sub(1))];
        while let Some((a, b)) = open.pop() {
            if self.points.is_empty() {
                break;
            }
            (kept[a], kept[b]) = (true, true);
            let (from, by) = (self.points[a].at, self.points[b].at - self.points[a].at);
            let mut most = (within, None);
            for k in a + 1..b {
                let off = distance(self.points[k].at, from, by);
                if off > most.0 {
                    most = (off, Some(k));
                }
            }
            if let Some(k) = most.1 {
                open.extend([(a, k), (k, b)]);
            }
        }
        let points = self.points.iter().zip(kept).filter(|p| p.1);
        Self {
            points: points.map(|p| *p.0).collect(),
            width: self.width,
        }
    }
}

/// The distance of a point from a segment.
pub(super) fn distance(p: DVec3, from: DVec3, by: DVec3) -> f64 {
    let square = by.length_squared();
    let t = if square > 0.0 {
        (p - from).dot(by) / square
    } else {
        0.0
    };
    p.distance(from + t.clamp(0.0, 1.0) * by)
}

impl TriMesh {
    /// The shortest path from one place to another along the surface, with both ends. Nothing if they lie in
    /// different parts. The path is found along edges first, then tightened.
    pub fn shortest_path(
        &self,
        from: &SurfacePoint,
        to: &SurfacePoint,
    ) -> Option<Vec<SurfacePoint>> {
        if from.triangle == to.triangle {
            return Some(vec![*from, *to]);
        }
        let along = self.along_edges(from, to)?;
        let length: f64 = along.windows(2).map(|w| w[0].at.distance(w[1].at)).sum();
        if length == 0.0 {
            return Some(vec![*from, *to]);
        }
        let step = length / along.len().min(MOST) as f64;
        let mut path = respaced(self, &along, step);
        for _ in 0..ROUNDS {
            if !self.tighten(&mut path, TAUT * step) {
                break;
            }
            path = respaced(self, &path, step);
        }
        Some(path)
    }

    /// Ten times, moves each inner point along the surface to the middle of its neighbours. True if a point moved by
    /// more than `least`.
    fn tighten(&self, path: &mut [SurfacePoint], least: f64) -> bool {
        let mut moved = false;
        for _ in 0..10 {
            for k in 1..path.len().saturating_sub(1) {
                let middle = 0.5 * (path[k - 1].at + path[k + 1].at);
                let by = path[k].frame().within(middle - path[k].at);
                moved |= by.length() > least;
                path[k] = self.walk(&path[k], by).to;
            }
        }
        moved
    }

    /// The shortest path over the edges; `None` if there is none.
    fn along_edges(&self, from: &SurfacePoint, to: &SurfacePoint) -> Option<Vec<SurfacePoint>> {
        let mut search = EdgeSearch::begin(self, from, to);
        let last = search.find()?;
        let mut path = vec![*to];
        for v in search.walk_back(last) {
            path.push(self.vertex_point(v)?);
        }
        path.push(*from);
        path.reverse();
        Some(path)
    }

    /// A vertex as a place in the first triangle around it.
    pub fn vertex_point(&self, vertex: u32) -> Option<SurfacePoint> {
        let (triangle, corner) = self.fan(vertex).next()?;
        let mut weights = DVec3::ZERO;
        weights[corner] = 1.0;
        Some(SurfacePoint::new(self, triangle, weights))
    }
}

/// A search over the edges for the shortest path between two places, by A*. Equal distances go by the vertex index.
struct EdgeSearch<'a> {
    mesh: &'a TriMesh,
    to: &'a SurfacePoint,
    /// For each vertex reached, the length of the path to it, and the vertex before it; the first comes before itself.
    best: BTreeMap<u32, (f64, u32)>,
    open: BinaryHeap<Reverse<(u64, u32)>>,
}

impl<'a> EdgeSearch<'a> {
    fn begin(mesh: &'a TriMesh, from: &SurfacePoint, to: &'a SurfacePoint) -> Self {
        let mut search = Self {
            mesh,
            to,
            best: BTreeMap::new(),
            open: BinaryHeap::new(),
        };
        for &v in &mesh.triangles()[from.triangle as usize] {
            search.reach(v, search.place(v).distance(from.at), v);
        }
        search
    }

    fn place(&self, v: u32) -> DVec3 {
        self.mesh.positions()[v as usize]
    }

    /// The rank of a vertex at this distance: paths to the goal have at least the rest of the way before them.
    fn rank(&self, v: u32, far: f64) -> u64 {
        order::rank(far + self.place(v).distance(self.to.at))
    }

    /// Notes a path to a vertex, if it is the shortest so far.
    fn reach(&mut self, v: u32, far: f64, before: u32) {
        if self.best.get(&v).is_none_or(|old| far < old.0) {
            self.best.insert(v, (far, before));
            self.open.push(Reverse((self.rank(v, far), v)));
        }
    }

    /// The corner of the goal's triangle at the end of the shortest path.
    fn find(&mut self) -> Option<u32> {
        let goals = self.mesh.triangles()[self.to.triangle as usize];
        while let Some(Reverse((rank, v))) = self.open.pop() {
            let (far, _) = self.best[&v];
            // A shorter path may have been found since.
            if rank > self.rank(v, far) {
                continue;
            }
            if goals.contains(&v) {
                return Some(v);
            }
            for (t, k) in self.mesh.fan(v) {
                let corners = self.mesh.triangles()[t as usize];
                for other in [corners[(k + 1) % 3], corners[(k + 2) % 3]] {
                    let next = far + self.place(v).distance(self.place(other));
                    self.reach(other, next, v);
                }
            }
        }
        None
    }

    /// The vertices of the path to a vertex, from its end to its start.
    fn walk_back(&self, end: u32) -> impl Iterator<Item = u32> {
        std::iter::successors(Some(end), |v| {
            let (_, before) = self.best[v];
            (before != *v).then_some(before)
        })
    }
}

/// Points spaced evenly along a path, about `step` apart, with both ends. Each is a short walk from the one before.
fn respaced(mesh: &TriMesh, path: &[SurfacePoint], step: f64) -> Vec<SurfacePoint> {
    let length: f64 = path.windows(2).map(|w| w[0].at.distance(w[1].at)).sum();
    let count = (length / step).ceil().max(1.0);
    let gap = length / count;
    let mut points = vec![path[0]];
    let (mut passed, mut next) = (0.0, gap);
    for w in path.windows(2) {
        let far = w[0].at.distance(w[1].at);
        while next <= passed + far && (points.len() as f64) < count {
            let by = w[0].frame().within(w[1].at - w[0].at);
            let by = by.normalize_or_zero() * (next - passed);
            points.push(mesh.walk(&w[0], by).to);
            next += gap;
        }
        passed += far;
    }
    points.push(path[path.len() - 1]);
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trimesh::samples;

    fn length(path: &[SurfacePoint]) -> f64 {
        path.windows(2).map(|w| w[0].at.distance(w[1].at)).sum()
    }

    #[test]
    fn paths_are_about_as_short_as_can_be() {
        let ball = samples::ball(4);
        let search = Search::new(&ball);
        for k in 0..20 {
            let t = f64::from(k);
            let [a, b] = [t, 2.0 * t + 1.3].map(|s| {
                let p = DVec3::new(libm::sin(s), libm::cos(1.4 * s), libm::cos(s)).normalize();
                search.closest(&ball, p)
            });
            let path = ball.shortest_path(&a, &b).expect("one part");
            assert_eq!((path[0], *path.last().unwrap()), (a, b));
            let exact = libm::acos(a.at.normalize().dot(b.at.normalize()));
            let ratio = length(&path) / exact;
            assert!(ratio < 1.01 && ratio > 0.99, "{k}: {ratio}");
        }
    }

    #[test]
    fn strokes_are_found_again_on_another_mesh_of_the_same_model() {
        let (coarse, fine) = (samples::torus(48, 20), samples::torus(101, 43));
        let search = Search::new(&coarse);
        let places = [(1.2, 0.35, 0.0), (0.9, 0.4, 0.9), (0.0, 0.3, 1.3)];
        let places = places.map(|p| search.closest(&coarse, p.into()));
        let stroke = Stroke::through(&coarse, &places, 0.1).simplified(0.005);
        let row = stroke.row(&coarse);
        assert!(row.len() < 60, "{}", row.len());
        let again = Stroke::from_row(&fine, &Search::new(&fine), &row).expect("a stroke");
        assert!((again.width - 0.1).abs() < 1e-3);
        let (a, b) = (length(&stroke.points), length(&again.points));
        assert!((a / b - 1.0).abs() < 0.02, "{a} {b}");
        for p in &stroke.points {
            let off = again
                .points
                .windows(2)
                .map(|w| distance(p.at, w[0].at, w[1].at - w[0].at));
            assert!(off.fold(f64::INFINITY, f64::min) < 0.02);
        }
    }

    #[test]
    fn numbers_that_are_no_stroke_give_none() {
        let mesh = samples::ball(1);
        let search = Search::new(&mesh);
        for row in [
            &[][..],
            &[5],
            &[5, 1, 2],
            &[-5, 1, 2, 3],
            &[5, 1, 2, 99_999],
        ] {
            assert_eq!(Stroke::from_row(&mesh, &search, row), None, "{row:?}");
        }
    }

    #[test]
    fn there_is_no_path_to_another_part() {
        let ball = samples::ball(1);
        let n = ball.positions().len() as u32;
        let moved = ball.positions().iter().map(|&p| p + 3.0 * DVec3::X);
        let positions = ball.positions().iter().copied().chain(moved).collect();
        let more = ball.triangles().iter().map(|t| t.map(|v| v + n));
        let triangles = ball.triangles().iter().copied().chain(more).collect();
        let two = TriMesh::new(positions, triangles).unwrap();
        let [a, b] = [0, n].map(|v| two.vertex_point(v).unwrap());
        assert_eq!(two.shortest_path(&a, &b), None);
        assert_eq!(Stroke::through(&two, &[a, b], 0.1).points, [a]);
    }
}
