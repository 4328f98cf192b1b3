//! Canal surfaces: the envelopes of balls whose middles and radii change along a curve.

use super::bone::Bone;
use super::jet::{Jet, JetPoint};
use glam::DVec3;

/// A curve with a radius at each of its points, as samples with cubic pieces between them.
#[derive(Clone, Debug)]
pub(super) struct Canal {
    points: Vec<DVec3>,
    radii: Vec<f64>,
    /// The derivatives of point and radius at each sample.
    slopes: Vec<(DVec3, f64)>,
    closed: bool,
    /// The bounding box of all balls.
    bounds: (DVec3, DVec3),
    /// How much nearer to a point a sample that the search skips can be than the visited one beside it.
    reach: f64,
}

/// The search for the nearest sample first visits only one in this many samples.
const STRIDE: usize = 4;
/// Newton steps to the exact foot.
const STEPS: usize = 3;
/// Two places belong to different parts of the curve if the way along the curve is more than this many times their
/// distance.
const RETURNS: f64 = 2.2;
/// The greatest radius of a ball as a part of the curve's radius of curvature, so that the inside of a bend stays
/// smooth.
const BEND: f64 = 0.8;

/// The foot of a point: the ball of a canal that is nearest to it.
pub(super) struct CanalBall {
    /// Its place along the curve, in samples.
    pub along: f64,
    pub middle: DVec3,
    pub radius: f64,
}

impl Canal {
    /// A canal through evenly spaced samples, at least two.
    pub fn new(points: Vec<DVec3>, radii: Vec<f64>, closed: bool) -> Self {
        let n = points.len();
        let slopes = (0..n).map(|i| {
            let (a, b) = if closed {
                ((i + n - 1) % n, (i + 1) % n)
            } else {
                (i.saturating_sub(1), (i + 1).min(n - 1))
            };
            let share = if closed || b - a == 2 { 0.5 } else { 1.0 };
            (
                (points[b] - points[a]) * share,
                (radii[b] - radii[a]) * share,
            )
        });
        Self {
            slopes: slopes.collect(),
            bounds: bounds(&points, &radii),
            reach: reach(&points, &radii, closed),
            points,
            radii,
            closed,
        }
    }

    /// A smooth canal through a few balls, with `per` samples to each gap.
    pub fn through(balls: &[(DVec3, f64)], per: usize) -> Self {
        let (points, radii) = balls.iter().copied().unzip();
        let rough = Self::new(points, radii, false);
        let count = (balls.len() - 1) * per;
        let at = (0..=count).map(|k| {
            let (p, r, ..) = rough.piece(k as f64 / per as f64);
            (p.0, r.0)
        });
        let (points, radii) = at.unzip();
        Self::new(points, radii, false)
    }

    /// Point and radius at a place along the curve, with their derivatives.
    fn piece(&self, along: f64) -> (Motion<DVec3>, Motion<f64>) {
        let n = self.points.len();
        let last = if self.closed { n } else { n - 1 };
        let i = (along.max(0.0) as usize).min(last - 1);
        let j = (i + 1) % n;
        let t = along - i as f64;
        let ((mp, mr), (np, nr)) = (self.slopes[i], self.slopes[j]);
        (
            hermite(t, self.points[i], mp, self.points[j], np),
            hermite(t, self.radii[i], mr, self.radii[j], nr),
        )
    }

    /// The ball in which a point lies deepest, or which is nearest to it.
    pub fn foot(&self, p: DVec3) -> CanalBall {
        let far = |i: usize| (p - self.points[i]).length() - self.radii[i];
        let rough = || (0..self.points.len()).step_by(STRIDE).map(|i| (far(i), i));
        let first = rough().fold(
            (f64::INFINITY, 0),
            |best, one| if one.0 < best.0 { one } else { best },
        );
        let mut best = self.descend(first, far);
        // Other parts of the curve may be nearer between the visited samples.
        for one in rough() {
            if one.0 - self.reach < best.0 && one.1.abs_diff(best.1) > STRIDE {
                let other = self.descend(one, far);
                if other.0 < best.0 {
                    best = other;
                }
            }
        }
        self.refine(p, best.1 as f64)
    }

    /// Goes from a sample to its neighbours as long as these are nearer.
    fn descend(&self, mut best: (f64, usize), far: impl Fn(usize) -> f64) -> (f64, usize) {
        let n = self.points.len();
        let after = |i: usize| {
            if self.closed {
                (i + 1) % n
            } else {
                (i + 1).min(n - 1)
            }
        };
        let before = |i: usize| match i {
            0 if self.closed => n - 1,
            i => i.saturating_sub(1),
        };
        for next in [&after as &dyn Fn(usize) -> usize, &before] {
            for _ in 0..n {
                let i = next(best.1);
                let d = far(i);
                if d >= best.0 {
                    break;
                }
                best = (d, i);
            }
        }
        best
    }

    /// Newton steps from a sample to the least distance.
    fn refine(&self, p: DVec3, start: f64) -> CanalBall {
        let n = self.points.len() as f64;
        let (mut least, mut most) = (start - 1.0, start + 1.0);
        if !self.closed {
            (least, most) = (least.max(0.0), most.min(n - 1.0));
        }
        let within = |t: f64| match self.closed {
            true if t < 0.0 => t + n,
            true if t >= n => t - n,
            _ => t,
        };
        let mut t = start;
        for _ in 0..STEPS {
            let (c, r) = self.piece(within(t));
            let d = p - c.0;
            let length = d.length();
            if length == 0.0 {
                break;
            }
            let u = d / length;
            let along = u.dot(c.1);
            let slope = -along - r.1;
            let bend = (c.1.length_squared() - along * along) / length - u.dot(c.2) - r.2;
            if slope > 0.0 {
                most = t;
            } else {
                least = t;
            }
            let next = t - slope / bend;
            t = if bend > 0.0 && next >= least && next <= most {
                next
            } else {
                0.5 * (least + most)
            };
        }
        let along = within(t);
        let (c, r) = self.piece(along);
        CanalBall {
            along,
            middle: c.0,
            radius: r.0,
        }
    }

    /// The distance to the surface, negative inside. The nearest ball minimises the distance among all balls along the
    /// curve. So the gradient is that of the distance to this one ball, which need not move with the point.
    pub fn at(&self, p: &JetPoint) -> Jet {
        let foot = self.foot(p.place());
        p.distance(foot.middle) - foot.radius
    }

    /// The factor by which the radii may grow until two parts meet, or the inside of a bend folds.
    pub fn room(&self) -> f64 {
        let mut room = f64::INFINITY;
        self.narrows(|width, radii, is_bend| {
            let share = if is_bend { BEND } else { 1.0 };
            room = room.min(share * width / radii);
        });
        room
    }

    /// The narrowest gap between two parts, or across the inside of a bend.
    pub fn gap(&self) -> f64 {
        let mut gap = f64::INFINITY;
        self.narrows(|width, radii, is_bend| {
            let times = if is_bend { 2.0 } else { 1.0 };
            gap = gap.min(times * (width - radii));
        });
        gap
    }

    /// Calls `tell` for each pair of places on different parts, with their distance, the sum of their radii, and false.
    /// Also calls it for each bend, with the radius of curvature, the radius of the ball, and true.
    fn narrows(&self, mut tell: impl FnMut(f64, f64, bool)) {
        let n = self.points.len();
        let mut along = vec![0.0; n + 1];
        for i in 0..n {
            let step = self.points[(i + 1) % n] - self.points[i];
            along[i + 1] = along[i] + step.length();
        }
        for i in 0..n {
            for j in 0..i {
                let mut way = along[i] - along[j];
                if self.closed {
                    way = way.min(along[n] - way);
                }
                let far = (self.points[i] - self.points[j]).length();
                if way > RETURNS * far {
                    tell(far, self.radii[i] + self.radii[j], false);
                }
            }
            let (a, b) = match self.closed {
                true => ((i + n - 1) % n, (i + 1) % n),
                false if i == 0 || i == n - 1 => continue,
                false => (i - 1, i + 1),
            };
            let (u, v) = (
                self.points[i] - self.points[a],
                self.points[b] - self.points[i],
            );
            let chord = self.points[b] - self.points[a];
            let area = u.cross(v).length();
            if area > 0.0 {
                tell(
                    u.length() * v.length() * chord.length() / (2.0 * area),
                    self.radii[i],
                    true,
                );
            }
        }
    }

    /// The same curve with its radii times `by`.
    pub fn thicker(&self, by: f64) -> Self {
        let radii = self.radii.iter().map(|r| r * by).collect();
        Self::new(self.points.clone(), radii, self.closed)
    }

    /// The same canal, moved and then scaled.
    pub fn placed(&self, by: DVec3, scale: f64) -> Self {
        let points = self.points.iter().map(|&p| (p + by) * scale).collect();
        let radii = self.radii.iter().map(|r| r * scale).collect();
        Self::new(points, radii, self.closed)
    }

    /// The bounding box of all balls.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.bounds
    }

    /// A lower bound of the distance from a point to the surface.
    pub fn far(&self, p: DVec3) -> f64 {
        let (lo, hi) = self.bounds;
        (lo - p).max(p - hi).max(DVec3::ZERO).length()
    }

    /// Joins another form smoothly with this canal, where the canal is near enough to change it.
    pub fn join_to(&self, other: Jet, p: &JetPoint, k: f64) -> Jet {
        if self.far(p.place()) >= other.value + k {
            return other;
        }
        other.join(self.at(p), k)
    }

    /// The least and the greatest radius.
    pub fn radii(&self) -> (f64, f64) {
        let none = (f64::INFINITY, 0.0_f64);
        self.radii
            .iter()
            .fold(none, |(a, b), &r| (a.min(r), b.max(r)))
    }

    /// The first point, and the unit vector along the curve there.
    pub fn start(&self) -> (DVec3, DVec3) {
        (self.points[0], self.slopes[0].0.normalize_or(DVec3::Y))
    }

    pub fn bone(&self) -> Bone {
        Bone {
            points: self.points.clone(),
            radii: self.radii.clone(),
            closed: self.closed,
        }
    }
}

/// A value, its first and its second derivative.
type Motion<T> = (T, T, T);

/// The cubic between two values with given first derivatives, at t from 0 to 1.
pub(super) fn hermite<T>(t: f64, a: T, da: T, b: T, db: T) -> Motion<T>
where
    T: Copy
        + std::ops::Add<Output = T>
        + std::ops::Sub<Output = T>
        + std::ops::Mul<f64, Output = T>,
{
    let all = b - a;
    let second = all * 3.0 - da * 2.0 - db;
    let third = da + db - all * 2.0;
    (
        a + (da + (second + third * t) * t) * t,
        da + (second * 2.0 + third * (3.0 * t)) * t,
        second * 2.0 + third * (6.0 * t),
    )
}

fn bounds(points: &[DVec3], radii: &[f64]) -> (DVec3, DVec3) {
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let balls = points.iter().zip(radii);
    balls.fold(none, |(lo, hi), (&p, &r)| (lo.min(p - r), hi.max(p + r)))
}

fn reach(points: &[DVec3], radii: &[f64], closed: bool) -> f64 {
    let n = points.len();
    let last = if closed { n } else { n - 1 };
    let step = |i: usize| {
        let j = (i + 1) % n;
        (points[j] - points[i]).length() + (radii[j] - radii[i]).abs()
    };
    // A sample is at most half a stride from a visited one, but nearly a whole stride at the end of an open curve.
    let steps = if closed { STRIDE / 2 } else { STRIDE - 1 };
    (0..last).map(step).fold(0.0, f64::max) * steps as f64
}
