//! Lines inside a body that its skin follows.

use glam::{DVec2, DVec3};

/// A polyline inside a body, from head to tail, with the body's radius at each of its points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bone {
    /// Its points, in the mesh's units.
    pub points: Vec<DVec3>,
    /// The body's radius at each point; where there are fewer, the last one, and none means a share of the body.
    pub radii: Vec<f64>,
}

/// Segments that are looked at together.
const GROUP: usize = 8;
/// Beyond how many radii a bone's word counts less: by e at once and a half this.
const FADE: f64 = 4.0;

/// What bones say at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BoneWord {
    /// How near the nearest one is: 1 at its radius, less beyond.
    pub near: f64,
    /// Weight by bone (they sum to 1) and its direction, as told to `said`.
    pub along: f64,
}

#[derive(Clone, Debug)]
struct Segment {
    from: DVec3,
    by: DVec3,
    /// 1 / length^2.
    inverse: f64,
    tangents: [DVec3; 2],
    radii: [f64; 2],
    along: [f64; 2],
}

/// Bones, ready to be asked.
#[derive(Clone, Debug, Default)]
pub(super) struct Bones {
    bones: Vec<Vec<Segment>>,
    /// Of each bone balls around its groups of segments.
    balls: Vec<Vec<(DVec3, f64)>>,
}

/// The nearest place of a bone.
#[derive(Clone, Copy, Debug)]
struct Foot {
    square: f64,
    segment: usize,
    t: f64,
}

impl Bones {
    /// Of a body with a diagonal of this length. A bone that begins within another one goes on from there.
    pub fn new(bones: &[Bone], diagonal: f64) -> Self {
        let mut all = Self::default();
        for bone in bones {
            let start = bone.points.first().map_or(0.0, |&p| all.attached(p));
            let segments = segments(bone, start, 0.065 * diagonal);
            if segments.is_empty() {
                continue;
            }
            let balls = segments.chunks(GROUP).map(ball).collect();
            all.bones.push(segments);
            all.balls.push(balls);
        }
        let each = all.bones.iter().flatten();
        let longest = each.map(|s| s.along[1]).fold(0.0, f64::max);
        for segment in all.bones.iter_mut().flatten() {
            segment.along = segment.along.map(|a| a / longest.max(f64::MIN_POSITIVE));
        }
        all
    }

    pub fn is_empty(&self) -> bool {
        self.bones.is_empty()
    }

    /// How far along the bones so far a point is that lies within one of them.
    fn attached(&self, p: DVec3) -> f64 {
        let mut best = (1.0, 0.0);
        for k in 0..self.bones.len() {
            let foot = self.foot(k, p);
            let segment = &self.bones[k][foot.segment];
            let ratio = foot.square / square(mixed(segment.radii, foot.t));
            if ratio < best.0 {
                best = (ratio, mixed(segment.along, foot.t));
            }
        }
        best.1
    }

    fn foot(&self, bone: usize, p: DVec3) -> Foot {
        let mut best = Foot {
            square: f64::INFINITY,
            segment: 0,
            t: 0.0,
        };
        let mut near = f64::INFINITY;
        let groups = self.balls[bone].iter().zip(self.bones[bone].chunks(GROUP));
        for (g, (&(middle, radius), segments)) in groups.enumerate() {
            if p.distance_squared(middle) > square(near + radius) {
                continue;
            }
            for (k, s) in segments.iter().enumerate() {
                let t = ((p - s.from).dot(s.by) * s.inverse).clamp(0.0, 1.0);
                let square = p.distance_squared(s.from + t * s.by);
                if square < best.square {
                    best = Foot {
                        square,
                        segment: g * GROUP + k,
                        t,
                    };
                }
            }
            near = best.square.sqrt();
        }
        best
    }

    /// What they say at a place: each bone's weight (they sum to 1) and direction goes to `said`. A bone counts as
    /// exp(-(d / radius)^2), so that what one says turns smoothly into what the next one does.
    pub fn ask(&self, p: DVec3, mut said: impl FnMut(f64, DVec3)) -> BoneWord {
        let mut feet = [(f64::INFINITY, 0, 0.0); MOST];
        let mut least = f64::INFINITY;
        for (k, foot_of) in feet.iter_mut().enumerate().take(self.bones.len()) {
            let foot = self.foot(k, p);
            let radius = mixed(self.bones[k][foot.segment].radii, foot.t);
            let ratio = foot.square / square(radius);
            *foot_of = (ratio, foot.segment, foot.t);
            least = least.min(ratio);
        }
        let weight = |ratio: f64| {
            let off = ratio - least;
            if off < 40.0 { libm::exp(-off) } else { 0.0 }
        };
        let feet = &feet[..self.bones.len().min(MOST)];
        let sum: f64 = feet.iter().map(|f| weight(f.0)).sum();
        let mut along = 0.0;
        for (bone, &(ratio, segment, t)) in self.bones.iter().zip(feet) {
            let share = weight(ratio) / sum;
            if share > 0.0 {
                let s = &bone[segment];
                let tangent = s.tangents[0].lerp(s.tangents[1], t);
                said(share, tangent.normalize_or(s.by.normalize()));
                along += share * mixed(s.along, t);
            }
        }
        let beyond = (least - 1.0).max(0.0) / FADE;
        BoneWord {
            near: libm::exp(-beyond),
            along,
        }
    }
}

/// More bones than these say nothing.
const MOST: usize = 32;

fn square(x: f64) -> f64 {
    x * x
}

fn mixed([a, b]: [f64; 2], t: f64) -> f64 {
    a + (b - a) * t
}

fn segments(bone: &Bone, start: f64, plain: f64) -> Vec<Segment> {
    let mut points: Vec<(DVec3, f64)> = Vec::new();
    for (k, &p) in bone.points.iter().enumerate() {
        let radius = bone.radii.get(k).or(bone.radii.last()).copied();
        let radius = radius
            .filter(|r| r.is_finite() && *r > 0.0)
            .unwrap_or(plain);
        if p.is_finite() && points.last().is_none_or(|&(last, _)| last != p) {
            points.push((p, radius.max(f64::MIN_POSITIVE)));
        }
    }
    let way = |k: usize| (points[k + 1].0 - points[k].0).normalize_or_zero();
    let count = points.len().saturating_sub(1);
    let tangent = |k: usize| match k {
        0 => way(0),
        k if k == count => way(k - 1),
        k => (way(k - 1) + way(k)).normalize_or(way(k)),
    };
    let mut along = start;
    let mut segments = Vec::with_capacity(count);
    for k in 0..count {
        let ((from, r), (to, s)) = (points[k], points[k + 1]);
        let by = to - from;
        let next = along + by.length();
        segments.push(Segment {
            from,
            by,
            inverse: 1.0 / by.length_squared(),
            tangents: [tangent(k), tangent(k + 1)],
            radii: [r, s],
            along: [along, next],
        });
        along = next;
    }
    segments
}

fn ball(segments: &[Segment]) -> (DVec3, f64) {
    let ends = || segments.iter().flat_map(|s| [s.from, s.from + s.by]);
    let middle = ends().sum::<DVec3>() / (2 * segments.len()) as f64;
    let radius = ends().map(|p| p.distance(middle)).fold(0.0, f64::max);
    (middle, radius)
}

/// What bones say at a vertex, in its frame.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BoneSource {
    /// How much it counts ...
    pub held: f64,
    /// ... times the representation vector, and times the vector itself.
    pub load: DVec2,
    pub flow: DVec2,
    /// How far from head to tail, 0..1.
    pub along: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fork() -> Bones {
        let leg = Bone {
            points: (0..=20)
                .map(|k| DVec3::Y * (2.0 - 0.1 * f64::from(k)))
                .collect(),
            radii: vec![0.4],
        };
        let toe = |x: f64| Bone {
            points: vec![DVec3::new(0.0, 0.1, 0.0), DVec3::new(x, 0.0, 1.0)],
            radii: vec![0.2, 0.1],
        };
        Bones::new(&[leg, toe(0.5), toe(-0.5)], 3.0)
    }

    #[test]
    fn each_place_hears_its_own_bone() {
        let bones = fork();
        let heard = |p: DVec3| {
            let mut sum = DVec3::ZERO;
            let word = bones.ask(p, |w, d| sum += w * d);
            (sum, word)
        };
        let (direction, word) = heard(DVec3::new(0.4, 1.5, 0.0));
        assert!(direction.dot(DVec3::NEG_Y) > 0.99, "{direction}");
        // Legs are 2 long, toes 1.1 more; they begin at 1.9.
        assert!(
            (word.along - 0.5 / (1.9 + 1.122)).abs() < 0.01,
            "{}",
            word.along
        );
        assert!(word.near > 0.99);
        let (direction, word) = heard(DVec3::new(0.5, 0.1, 0.95));
        assert!(direction.dot(DVec3::new(0.5, -0.1, 1.0).normalize()) > 0.99);
        assert!(word.along > 0.9);
        assert!(heard(DVec3::X * 9.0).1.near < 1e-6);
    }

    #[test]
    fn what_they_say_changes_smoothly() {
        let bones = fork();
        let mut last: Option<DVec3> = None;
        for k in 0..=2000 {
            let t = f64::from(k) / 2000.0;
            let p = DVec3::new(0.25 * t, 0.6 - 0.5 * t, 0.3 + 0.5 * t);
            let mut sum = DVec3::ZERO;
            bones.ask(p, |w, d| sum += w * d);
            if let Some(last) = last {
                assert!(sum.distance(last) < 0.01, "{t}: {last} {sum}");
            }
            last = Some(sum);
        }
    }

    #[test]
    fn nothing_comes_of_bad_bones() {
        let bad = [
            Bone::default(),
            Bone {
                points: vec![DVec3::ONE; 3],
                radii: vec![1.0],
            },
            Bone {
                points: vec![DVec3::NAN, DVec3::ONE],
                radii: vec![f64::NAN],
            },
        ];
        assert!(Bones::new(&bad, 1.0).is_empty());
    }
}
