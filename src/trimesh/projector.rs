//! Finds the closest point of a surface.

use super::{SurfacePoint, TriMesh};
use crate::order::rank;
use glam::DVec3;

/// The side of a cube of the grid, over the side of a triangle of mean area.
const SIDE: f64 = 1.5;
/// The most cubes of the grid, and the most entries in them, for each triangle.
const CUBES: usize = 4;
const MEMBERS: usize = 16;
/// Triangles in a slice.
const SLICE: usize = 1 << 15;
/// The closest point may lie on a triangle that faces away only if all others are more than this many times as far.
const BACK: f64 = 4.0;

/// A grid over the triangles of a surface, to find closest points.
#[derive(Clone, Debug)]
pub struct Projector {
    low: DVec3,
    side: f64,
    counts: [usize; 3],
    /// Where the triangles of each cube begin in `members`.
    starts: Vec<u32>,
    members: Vec<u32>,
    stage: Stage,
    at: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    Count,
    Sort,
    Done,
}

impl Projector {
    /// An empty grid over a surface.
    pub fn new(mesh: &TriMesh) -> Self {
        let count = mesh.triangles().len().max(1);
        let side = SIDE * (mesh.area() / count as f64).sqrt();
        let mut new = Self {
            low: mesh.bounds().0,
            side: side.max(1e-6 * mesh.diagonal()),
            counts: [1; 3],
            starts: Vec::new(),
            members: Vec::new(),
            stage: Stage::Count,
            at: 0,
        };
        new.lay(mesh);
        new
    }

    /// Sets the counts of cubes for the current side, or for the next larger one that does not give too many.
    fn lay(&mut self, mesh: &TriMesh) {
        let (low, high) = mesh.bounds();
        loop {
            let counts = ((high - low) / self.side).floor() + DVec3::ONE;
            if counts.x * counts.y * counts.z <= (CUBES * mesh.triangles().len() + 64) as f64 {
                self.counts = counts.to_array().map(|n| n as usize);
                break;
            }
            self.side *= 1.25;
        }
        self.starts = vec![0; self.counts.iter().product::<usize>() + 2];
        self.at = 0;
    }

    /// Puts one more slice of triangles into the grid; true when all are in it.
    pub fn advance(&mut self, mesh: &TriMesh) -> bool {
        let count = mesh.triangles().len();
        let range = self.at..count.min(self.at + SLICE);
        self.at = range.end;
        match self.stage {
            Stage::Count => {
                let mut sum = 0;
                for t in range {
                    self.cubes_of(mesh, t as u32, |grid, cube| {
                        grid.starts[cube + 2] += 1;
                        sum += 1;
                    });
                }
                self.members.resize(self.members.len() + sum, 0);
                if self.members.len() > MEMBERS * count + 64 {
                    self.side *= 2.0;
                    self.members.clear();
                    self.lay(mesh);
                } else if self.at == count {
                    for cube in 1..self.starts.len() {
                        self.starts[cube] += self.starts[cube - 1];
                    }
                    (self.stage, self.at) = (Stage::Sort, 0);
                }
            }
            Stage::Sort => {
                for t in range {
                    self.cubes_of(mesh, t as u32, |grid, cube| {
                        let place = &mut grid.starts[cube + 1];
                        grid.members[*place as usize] = t as u32;
                        *place += 1;
                    });
                }
                if self.at == count {
                    self.stage = Stage::Done;
                }
            }
            Stage::Done => {}
        }
        self.stage == Stage::Done
    }

    /// Makes the whole grid at once.
    pub fn build(mesh: &TriMesh) -> Self {
        let mut new = Self::new(mesh);
        while !new.advance(mesh) {}
        new
    }

    fn cube_at(&self, p: DVec3) -> [usize; 3] {
        let at = ((p - self.low) / self.side).to_array();
        [0, 1, 2].map(|k| (at[k].max(0.0) as usize).min(self.counts[k] - 1))
    }

    fn number(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// Calls `with` for each cube that meets the bounding box of a triangle.
    fn cubes_of(&mut self, mesh: &TriMesh, t: u32, mut with: impl FnMut(&mut Self, usize)) {
        let [a, b, c] = mesh.corners(t);
        let [low, high] = [a.min(b).min(c), a.max(b).max(c)].map(|p| self.cube_at(p));
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                for x in low[0]..=high[0] {
                    let cube = self.number([x, y, z]);
                    with(self, cube);
                }
            }
        }
    }

    /// The point of the surface that is closest to `p`; among equals, that of the triangle with the least number.
    /// Triangles that face away from `normal` are passed over, unless all others are much farther away. A zero normal
    /// passes over none.
    pub fn closest(&self, mesh: &TriMesh, p: DVec3, normal: DVec3) -> SurfacePoint {
        let middle = self.cube_at(p);
        let most = self.counts.into_iter().max().unwrap_or(1);
        let mut front = Best::NONE;
        let mut any = Best::NONE;
        for reach in 0..most {
            self.shell(middle, reach, |t| {
                let found = Best::of(mesh, t, p);
                any.take(found);
                if mesh.face_normal(t).dot(normal) >= 0.0 {
                    front.take(found);
                }
            });
            // All cubes up to this distance have been searched.
            let seen = reach as f64 * self.side;
            let is_far = any.distance() * BACK < front.distance();
            if front.distance() <= seen || (is_far && any.distance() * BACK <= seen) {
                break;
            }
        }
        let best = if any.distance() * BACK < front.distance() {
            any
        } else {
            front
        };
        SurfacePoint::new(mesh, best.triangle, best.weights)
    }

    /// The point of a triangle that is closest to one in space.
    pub(crate) fn on_triangle(mesh: &TriMesh, triangle: u32, p: DVec3) -> DVec3 {
        let corners = mesh.corners(triangle);
        let weights = closest(corners, p);
        corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z
    }

    /// The point of this surface for a point of a simpler one.
    pub fn carry(&self, mesh: &TriMesh, point: &SurfacePoint) -> SurfacePoint {
        self.closest(mesh, point.at, point.normal)
    }

    /// Calls `with` for all triangles within a radius of a point, and for some others. A triangle may come more than
    /// once.
    pub fn within(&self, p: DVec3, radius: f64, mut with: impl FnMut(u32)) {
        let [low, high] = [-radius, radius].map(|by| self.cube_at(p + DVec3::splat(by)));
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                let [first, last] = [low[0], high[0]].map(|x| self.number([x, y, z]));
                // The cubes of a row lie one after the other.
                let members = self.starts[first] as usize..self.starts[last + 1] as usize;
                self.members[members].iter().for_each(|&t| with(t));
            }
        }
    }

    /// Calls `with` for all triangles in cubes at Chebyshev distance `reach` from the middle one.
    fn shell(&self, middle: [usize; 3], reach: usize, mut with: impl FnMut(u32)) {
        let span = |k: usize| {
            let end = (middle[k] + reach).min(self.counts[k] - 1);
            middle[k].saturating_sub(reach)..=end
        };
        for z in span(2) {
            for y in span(1) {
                let is_end = z.abs_diff(middle[2]) == reach || y.abs_diff(middle[1]) == reach;
                let row = span(0);
                let inner = (2 * reach).max(1);
                // A row inside the shell has only its two ends on it.
                let step = if is_end { 1 } else { inner };
                let first = if is_end {
                    *row.start()
                } else {
                    match middle[0].checked_sub(reach) {
                        Some(first) => first,
                        None => middle[0] + reach,
                    }
                };
                for x in (first..=*row.end()).step_by(step) {
                    let cube = self.number([x, y, z]);
                    let members = self.starts[cube] as usize..self.starts[cube + 1] as usize;
                    self.members[members].iter().for_each(|&t| with(t));
                }
            }
        }
    }
}

/// The closest point so far.
#[derive(Clone, Copy)]
struct Best {
    square: f64,
    triangle: u32,
    weights: DVec3,
}

impl Best {
    const NONE: Self = Self {
        square: f64::INFINITY,
        triangle: 0,
        weights: DVec3::X,
    };

    fn of(mesh: &TriMesh, triangle: u32, p: DVec3) -> Self {
        let corners = mesh.corners(triangle);
        let weights = closest(corners, p);
        let at = corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z;
        Self {
            square: (at - p).length_squared(),
            triangle,
            weights,
        }
    }

    fn take(&mut self, other: Self) {
        let order = |best: &Self| (rank(best.square), best.triangle);
        if order(&other) < order(self) {
            *self = other;
        }
    }

    fn distance(&self) -> f64 {
        self.square.sqrt()
    }
}

/// The weights of the closest point of a triangle (Ericson 2005, Real-Time Collision Detection, section 5.1.5).
fn closest([a, b, c]: [DVec3; 3], p: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let [pa, pb, pc] = [a, b, c].map(|corner| p - corner);
    let (d1, d2) = (ab.dot(pa), ac.dot(pa));
    if d1 <= 0.0 && d2 <= 0.0 {
        return DVec3::X;
    }
    let (d3, d4) = (ab.dot(pb), ac.dot(pb));
    if d3 >= 0.0 && d4 <= d3 {
        return DVec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return DVec3::new(1.0 - v, v, 0.0);
    }
    let (d5, d6) = (ab.dot(pc), ac.dot(pc));
    if d6 >= 0.0 && d5 <= d6 {
        return DVec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return DVec3::new(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    let (along, back) = (d4 - d3, d5 - d6);
    if va <= 0.0 && along >= 0.0 && back >= 0.0 {
        let w = along / (along + back);
        return DVec3::new(0.0, 1.0 - w, w);
    }
    DVec3::new(va, vb, vc) / (va + vb + vc)
}

#[cfg(test)]
mod tests {
    use super::super::testing::{self, mesh};
    use super::super::{Simplifying, way};
    use super::*;

    #[test]
    fn the_closest_point_is_that_of_all_triangles() {
        for soup in [
            testing::blob(3),
            testing::tube(40, 1),
            testing::two_holes(1),
            testing::flat(5),
        ] {
            let mesh = mesh(soup);
            let projector = Projector::build(&mesh);
            let (low, high) = mesh.bounds();
            let mut chance = testing::chance(12);
            for k in 0..400 {
                let part = DVec3::from([0; 3].map(|_| 1.4 * chance.unit() - 0.2));
                let scale = if k % 9 == 0 { 30.0 } else { 1.0 };
                let p = low + (high - low) * part * scale;
                let all = 0..mesh.triangles().len() as u32;
                let least = all
                    .map(|t| Best::of(&mesh, t, p).square)
                    .fold(f64::INFINITY, f64::min);
                let found = projector.closest(&mesh, p, DVec3::ZERO);
                let square = (found.at - p).length_squared();
                assert!(
                    (square - least).abs() <= 1e-9 * (least + 1e-9),
                    "{p} {square} {least}"
                );
            }
        }
    }

    #[test]
    fn a_point_stays_on_its_side_of_a_thin_sheet() {
        // A plate whose thickness is a hundredth of its side.
        let (positions, triangles) = testing::cube(20);
        let flat = positions.iter().map(|p| DVec3::new(p.x, 0.01 * p.y, p.z));
        let plate = mesh((flat.collect(), triangles));
        let projector = Projector::build(&plate);
        let p = DVec3::new(0.52, 0.004, 0.47);
        for up in [1.0, -1.0] {
            let found = projector.closest(&plate, p, DVec3::Y * up);
            assert!(found.normal.y * up > 0.9 && (found.at.x - p.x).abs() < 1e-12);
        }
    }

    #[test]
    fn points_of_a_simple_surface_are_carried_to_the_full_one() {
        let full = mesh(testing::blob(5));
        let simple = Simplifying::new(full.clone(), 600, f64::INFINITY).finish();
        let projector = Projector::build(&full);
        let mut chance = testing::chance(3);
        for t in 0..simple.triangles().len() as u32 {
            let (u, v) = (chance.unit(), 0.5 * chance.unit());
            let weights = DVec3::new(u * (1.0 - v), (1.0 - u) * (1.0 - v), v);
            let point = SurfacePoint::new(&simple, t, weights);
            let on = projector.carry(&full, &point);
            assert!((on.at - point.at).length() < 0.03);
            assert!(on.normal.dot(point.normal) > 0.8);
            assert!(on.weights(&full).min_element() > -1e-9 && way(&on, &on).is_some());
        }
    }
}
