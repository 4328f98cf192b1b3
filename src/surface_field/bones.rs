//! Skeleton curves inside a body, which directions on its skin follow.

use glam::{DVec2, DVec3};

/// A skeleton curve: a polyline inside a body, from head to tail, with the body's radius at its points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bone {
    /// Its points, in the mesh's units.
    pub points: Vec<DVec3>,
    /// The body's radius at each point. If there are fewer radii than points, the last one holds for the rest;
    /// without any, the radius is a share of the body's diagonal.
    pub radii: Vec<f64>,
}

/// Segments in one bounding ball.
const GROUP: usize = 8;
/// Beyond its radius r, at the distance d from its line, a bone's constraint has the weight exp(-(d^2 / r^2 - 1) /
/// FADE).
const FADE: f64 = 4.0;

/// The constraint of all bones at a place, without its direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BoneConstraint {
    /// How near the nearest bone is: 1 within its radius, falling to 0 beyond it.
    pub near: f64,
    /// How far along the bones the place is, from head (0) to tail (1): the mean over all bones by their weights.
    pub along: f64,
}

#[derive(Clone, Debug)]
struct BoneSegment {
    from: DVec3,
    by: DVec3,
    /// One over the squared length.
    inverse: f64,
    tangents: [DVec3; 2],
    radii: [f64; 2],
    along: [f64; 2],
}

/// All bones of a body, prepared for queries.
#[derive(Clone, Debug, Default)]
pub(super) struct Bones {
    bones: Vec<Vec<BoneSegment>>,
    /// For each bone, bounding balls around its groups of segments: centre and radius.
    balls: Vec<Vec<(DVec3, f64)>>,
    /// The greatest length along the bones.
    longest: f64,
}

/// The length along a body's bones from the head to any place in the body.
pub struct AlongBones(Bones);

impl AlongBones {
    /// Prepares the bones of a body whose bounding box has this diagonal; `None` if there are no bones.
    pub fn new(bones: &[Bone], diagonal: f64) -> Option<Self> {
        let bones = Bones::new(bones, diagonal);
        (!bones.is_empty()).then_some(Self(bones))
    }

    /// The length from the head to a place, in the body's units.
    pub fn at(&self, p: DVec3) -> f64 {
        self.0.longest * self.0.ask(p, |_, _| {}).along
    }
}

/// The last queried place and its distance to each bone. They bound the distances of the next place.
#[derive(Clone, Copy, Debug)]
pub(super) struct LastPlace {
    at: DVec3,
    near: [f64; MOST],
}

impl Default for LastPlace {
    fn default() -> Self {
        Self {
            at: DVec3::ZERO,
            near: [f64::INFINITY; MOST],
        }
    }
}

/// The closest point of a bone.
#[derive(Clone, Copy, Debug)]
struct ClosestBonePoint {
    square: f64,
    segment: usize,
    t: f64,
}

impl Bones {
    /// Prepares the bones of a body whose bounding box has this diagonal. A bone that begins inside another one goes
    /// on counting its length from there.
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
        all.longest = longest;
        all
    }

    pub fn is_empty(&self) -> bool {
        self.bones.is_empty()
    }

    /// The length along the bones at a point inside one of them; 0 outside all bones.
    fn attached(&self, p: DVec3) -> f64 {
        let mut best = (1.0, 0.0);
        for k in 0..self.bones.len() {
            let foot = self.foot(k, p, f64::INFINITY);
            let segment = &self.bones[k][foot.segment];
            let ratio = foot.square / square(mixed(segment.radii, foot.t));
            if ratio < best.0 {
                best = (ratio, mixed(segment.along, foot.t));
            }
        }
        best.1
    }

    /// The closest point of a bone, which is at most `near` away.
    fn foot(&self, bone: usize, p: DVec3, mut near: f64) -> ClosestBonePoint {
        let mut best = ClosestBonePoint {
            square: f64::INFINITY,
            segment: 0,
            t: 0.0,
        };
        let groups = self.balls[bone].iter().zip(self.bones[bone].chunks(GROUP));
        for (g, (&(middle, radius), segments)) in groups.enumerate() {
            // With reserve for rounding.
            if p.distance_squared(middle) > square((1.0 + 1e-9) * (near + radius)) {
                continue;
            }
            for (k, s) in segments.iter().enumerate() {
                let t = ((p - s.from).dot(s.by) * s.inverse).clamp(0.0, 1.0);
                let square = p.distance_squared(s.from + t * s.by);
                if square < best.square {
                    best = ClosestBonePoint {
                        square,
                        segment: g * GROUP + k,
                        t,
                    };
                }
            }
            near = near.min(best.square.sqrt());
        }
        best
    }

    /// Queries the bones at a place. `said` gets each bone's weight and its unit direction; the weights sum to 1. A
    /// weight is proportional to exp(-(d / radius)^2), so directions blend smoothly from one bone to the next.
    pub fn ask(&self, p: DVec3, said: impl FnMut(f64, DVec3)) -> BoneConstraint {
        self.ask_after(&mut LastPlace::default(), p, said)
    }

    /// Like [`Self::ask`], but faster if the last place was near.
    pub fn ask_after(
        &self,
        last: &mut LastPlace,
        p: DVec3,
        mut said: impl FnMut(f64, DVec3),
    ) -> BoneConstraint {
        let moved = p.distance(last.at);
        last.at = p;
        let mut feet = [(f64::INFINITY, 0, 0.0); MOST];
        let mut least = f64::INFINITY;
        for (k, foot_of) in feet.iter_mut().enumerate().take(self.bones.len()) {
            let near = &mut last.near[k];
            let foot = self.foot(k, p, *near + moved);
            *near = foot.square.sqrt();
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
        BoneConstraint {
            near: libm::exp(-beyond),
            along,
        }
    }
}

/// The most bones; further ones have no influence.
const MOST: usize = 32;

fn square(x: f64) -> f64 {
    x * x
}

fn mixed([a, b]: [f64; 2], t: f64) -> f64 {
    a + (b - a) * t
}

fn segments(bone: &Bone, start: f64, plain: f64) -> Vec<BoneSegment> {
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
        segments.push(BoneSegment {
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

fn ball(segments: &[BoneSegment]) -> (DVec3, f64) {
    let ends = || segments.iter().flat_map(|s| [s.from, s.from + s.by]);
    let middle = ends().sum::<DVec3>() / (2 * segments.len()) as f64;
    let radius = ends().map(|p| p.distance(middle)).fold(0.0, f64::max);
    (middle, radius)
}

/// The constraint of the bones at a vertex, in its frame.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct BoneSource {
    /// The weight.
    pub held: f64,
    /// The weight times the representation vector.
    pub load: DVec2,
    /// The weight times the direction itself.
    pub flow: DVec2,
    /// How far along the bones the vertex is, from head (0) to tail (1).
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
        // The leg is 2 long and the toes 1.1 more; the toes begin at 1.9.
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
