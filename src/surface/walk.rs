//! Walking over a surface, straight on.

use super::frame::rotated;
use super::{SurfacePoint, TriMesh, Turn};
use glam::{DVec2, DVec3};

/// Where a walk has led.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walked {
    /// Its end.
    pub to: SurfacePoint,
    /// Carries vectors of the frame at its start into that at its end, along the way.
    pub turn: Turn,
    /// It met the border, and went on along it.
    pub slid: bool,
}

/// The most edges that a walk crosses.
const MOST_EDGES: usize = 10_000;
/// What is left of a step that has come to its end, as a share of it.
const END: f64 = 1e-12;

impl TriMesh {
    /// Goes from a point by a vector of its frame, triangle by triangle: over each edge the rest of the way is turned
    /// about it into the next triangle's plane (the straightest path: Polthier, Schmies 1998, Straightest Geodesics on
    /// Polyhedral Surfaces). At the border it goes on along it, as far as it leads that way.
    pub fn walk(&self, from: &SurfacePoint, by: DVec2) -> Walked {
        let start = from.frame();
        let mut walker = Walker::new(self, from, start.out(by));
        let length = by.length();
        let slid = length > 0.0 && length.is_finite() && walker.go(length);
        let to = walker.end();
        // A second vector has been carried along: what it has become tells the turn.
        let end = to.frame();
        let carried = end.within(rotated(
            walker.carried,
            self.face_normal(to.triangle),
            to.normal,
        ));
        Walked {
            to,
            turn: Turn(carried.normalize_or(DVec2::X)),
            slid,
        }
    }
}

struct Walker<'a> {
    mesh: &'a TriMesh,
    triangle: u32,
    at: DVec3,
    /// Unit vector in the triangle's plane.
    heading: DVec3,
    /// The x axis of the frame at the start, in the triangle's plane.
    carried: DVec3,
    /// The edge just come over, which is not crossed again at once.
    entered: Option<usize>,
}

impl<'a> Walker<'a> {
    fn new(mesh: &'a TriMesh, from: &SurfacePoint, by: DVec3) -> Self {
        let face = mesh.face_normal(from.triangle);
        let into = |v: DVec3| rotated(v, from.normal, face);
        Self {
            mesh,
            triangle: from.triangle,
            at: from.at,
            heading: into(by).normalize_or_zero(),
            carried: into(from.frame().x),
            entered: None,
        }
    }

    fn end(&self) -> SurfacePoint {
        // Within rounding of the triangle: back into it.
        let weights = self.mesh.weights(self.triangle, self.at).max(DVec3::ZERO);
        let weights = weights / (weights.x + weights.y + weights.z);
        SurfacePoint::new(self.mesh, self.triangle, weights)
    }

    /// True where it met the border.
    fn go(&mut self, length: f64) -> bool {
        let (mut left, mut slid) = (length, false);
        for _ in 0..MOST_EDGES {
            let Some((edge, far)) = self.exit() else {
                return slid;
            };
            if far >= left {
                self.at += self.heading * left;
                return slid;
            }
            self.at += self.heading * far;
            left -= far;
            if left <= END * length {
                return slid;
            }
            match self.mesh.across(self.triangle, edge) {
                Some((next, entered)) => self.cross(next, entered),
                None => {
                    slid = true;
                    left *= self.slide(edge);
                    if left <= END * length {
                        return slid;
                    }
                }
            }
        }
        slid
    }

    /// The edge that it leaves the triangle by, and how far that is.
    fn exit(&self) -> Option<(usize, f64)> {
        let corners = self.mesh.corners(self.triangle);
        let normal = self.mesh.face_normal(self.triangle);
        let mut best: Option<(usize, f64)> = None;
        for k in (0..3).filter(|&k| Some(k) != self.entered) {
            let inward = normal.cross(corners[(k + 1) % 3] - corners[k]);
            let speed = -inward.dot(self.heading);
            // Along the edge, or away from it.
            if speed <= 1e-14 * inward.length() {
                continue;
            }
            let far = (inward.dot(self.at - corners[k]) / speed).max(0.0);
            if best.is_none_or(|(_, least)| far < least) {
                best = Some((k, far));
            }
        }
        best
    }

    /// Into the next triangle, with all vectors turned about the edge.
    fn cross(&mut self, next: u32, entered: usize) {
        let (from, to) = (
            self.mesh.face_normal(self.triangle),
            self.mesh.face_normal(next),
        );
        self.heading = rotated(self.heading, from, to);
        self.carried = rotated(self.carried, from, to);
        // What rounding has put out of the plane.
        self.heading = (self.heading - to * to.dot(self.heading)).normalize_or_zero();
        (self.triangle, self.entered) = (next, Some(entered));
    }

    /// On along the border; how much of the way leads along it.
    fn slide(&mut self, edge: usize) -> f64 {
        let corners = self.mesh.corners(self.triangle);
        let along = (corners[(edge + 1) % 3] - corners[edge]).normalize_or_zero();
        let share = along.dot(self.heading);
        self.heading = along * share.signum();
        self.entered = Some(edge);
        share.abs()
    }
}
