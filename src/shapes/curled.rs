//! Shapes along one curve: torus, knot, horn and tail.

use super::bone::Bone;
use super::canal::Canal;
use super::form::{Cut, Ends, Form};
use super::jet::{Jet, JetPoint};
use glam::DVec3;
use std::f64::consts::TAU;

/// A canal, stretched in height. If the canal is open, its start is cut off flat: the root.
pub(super) struct Curled {
    /// The canal before it is stretched.
    canal: Canal,
    stretch: f64,
    root: Option<Root>,
    bounds: (DVec3, DVec3),
}

struct Root {
    at: DVec3,
    /// The direction into the shape.
    inward: DVec3,
    /// The radius of its rounded edge.
    round: f64,
    /// Samples in a unit of length.
    samples: f64,
}

/// The radius of the root's edge, as a part of the root's own radius: for round ends, and for cuts.
const ROUND: [f64; 2] = [0.7, 0.12];
/// The balls of a horny tip: distance beyond the end of the curve, and radius. Both are multiples of the radius at that
/// end.
const TIP: [[f64; 2]; 6] = [
    [-1.2, 0.8],
    [-0.2, 0.86],
    [0.8, 0.8],
    [1.9, 0.58],
    [3.0, 0.3],
    [3.9, 0.04],
];

impl Curled {
    /// Scales the canal so that the largest side is 1, and puts it on y = 0 with its middle over the origin.
    fn new(canal: Canal, stretch: f64, end: Option<Ends>) -> Self {
        let closed = end.is_none();
        let tall = DVec3::new(1.0, stretch, 1.0);
        let (lo, hi) = box_of(&canal, closed);
        let (low, high) = (lo * tall, hi * tall);
        let scale = 1.0 / (high - low).max_element();
        let middle = 0.5 * (lo + hi);
        let canal = canal.placed(DVec3::new(-middle.x, -lo.y, -middle.z), scale);
        let root = end.map(|end| {
            let share = match end {
                Ends::Round => ROUND[0],
                Ends::Cut => ROUND[1],
            };
            let bone = canal.bone();
            let (at, inward) = canal.start();
            Root {
                at,
                inward,
                round: share * bone.radii[0],
                samples: 1.0 / (bone.points[1] - at).length(),
            }
        });
        let (lo, hi) = box_of(&canal, closed);
        Self {
            bounds: (lo * tall, hi * tall),
            canal,
            stretch,
            root,
        }
    }
}

/// The bounding box of a canal. If the canal is open, the part that is cut off at the root does not count.
fn box_of(canal: &Canal, closed: bool) -> (DVec3, DVec3) {
    if closed {
        return canal.bounds();
    }
    let bone = canal.bone();
    let last = bone.points.len() - 1;
    let tip = (bone.points[last], bone.radii[last]);
    let mut bounds = (tip.0 - tip.1, tip.0 + tip.1);
    for k in 0..last {
        // Each ball touches the surface along a circle. The faster radii grow, the farther back the circle lies.
        let way = bone.points[k + 1] - bone.points[k];
        let growth = (bone.radii[k + 1] - bone.radii[k]) / way.length();
        let along = way.normalize_or(DVec3::Y);
        let radius = bone.radii[k] * (1.0 - growth * growth).max(0.0).sqrt();
        let middle = bone.points[k] - along * (bone.radii[k] * growth);
        let flat = (DVec3::ONE - along * along).max(DVec3::ZERO);
        let reach = DVec3::new(flat.x.sqrt(), flat.y.sqrt(), flat.z.sqrt()) * radius;
        bounds = (bounds.0.min(middle - reach), bounds.1.max(middle + reach));
    }
    bounds
}

impl Form for Curled {
    fn at(&self, p: JetPoint) -> Jet {
        let p = JetPoint {
            y: p.y * (1.0 / self.stretch),
            ..p
        };
        let foot = self.canal.foot(p.place());
        let tube = p.distance(foot.middle) - foot.radius;
        match &self.root {
            Some(root) if foot.along < 1.3 * root.round * root.samples => {
                let from = p.place() - root.at;
                let n = root.inward;
                let slope = p.x.slope * n.x + p.y.slope * n.y + p.z.slope * n.z;
                tube.cut(Jet::new(-from.dot(n), -slope), root.round)
            }
            _ => tube,
        }
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        self.bounds
    }

    fn coarsest(&self) -> f64 {
        let narrow = (0.85 * self.canal.radii().0).min(0.55 * self.canal.gap());
        (narrow * self.stretch.min(1.0)).min(0.06)
    }

    fn steepest(&self) -> f64 {
        (1.0 / self.stretch).max(1.0)
    }

    fn bones(&self) -> Vec<Bone> {
        let mut bone = self.canal.bone();
        for p in &mut bone.points {
            p.y *= self.stretch;
        }
        vec![bone]
    }

    fn cuts(&self) -> Vec<Cut> {
        let cut = |root: &Root| Cut {
            at: root.at,
            out: -root.inward,
        };
        self.root.iter().map(cut).collect()
    }

    fn claws(&self) -> Vec<Bone> {
        let bone = self.canal.bone();
        let [.., before, end] = &bone.points[..] else {
            return Vec::new();
        };
        let (Some(radius), Some(_)) = (bone.radii.last(), &self.root) else {
            return Vec::new();
        };
        let out = (*end - *before).normalize_or(DVec3::Y);
        vec![Bone {
            points: TIP.map(|[t, _]| *end + out * (t * radius)).to_vec(),
            radii: TIP.map(|[_, r]| r * radius).to_vec(),
            closed: false,
        }]
    }
}

/// The torus for the numbers `[tube, height, waves, swell]`.
pub(super) fn torus(n: &[f64]) -> Curled {
    let (tube, height, waves, swell) = (n[0], n[1], n[2], n[3]);
    let samples = 64 + 16 * waves as usize;
    // Limit the waves: they may bend at most twice as sharply as the ring.
    let swell = if waves == 0.0 {
        0.0
    } else {
        (2.0 * swell / (waves * waves)).min(0.3 * swell)
    };
    let points = (0..samples).map(|k| {
        let angle = TAU * k as f64 / samples as f64;
        let r = 1.0 + swell * libm::cos(waves * angle);
        DVec3::new(r * libm::cos(angle), 0.0, r * libm::sin(angle))
    });
    let canal = Canal::new(points.collect(), vec![1.0; samples], true);
    // The bends of waves may leave less room for the tube.
    let canal = canal.thicker(tube.min(0.95 * canal.room()));
    Curled::new(canal, height, None)
}

/// The knot for the numbers `[turns, lobes, tube, swing, height]`. If turns and lobes have a common divisor, there is
/// one lobe more.
pub(super) fn knot(n: &[f64]) -> Curled {
    let (turns, mut lobes, tube, swing, height) = (n[0], n[1], n[2], n[3], n[4]);
    if (2..=3).any(|d| turns % f64::from(d) == 0.0 && lobes % f64::from(d) == 0.0) {
        lobes += 1.0;
    }
    let samples = 24 * (turns as usize + lobes as usize) + 32;
    let points = (0..samples).map(|k| {
        let angle = TAU * k as f64 / samples as f64;
        let (around, along) = (turns * angle, lobes * angle);
        let r = 1.0 + swing * libm::cos(along);
        let z = swing * height * libm::sin(along);
        DVec3::new(r * libm::sin(around), r * libm::cos(around), z)
    });
    let canal = Canal::new(points.collect(), vec![1.0; samples], true);
    let canal = canal.thicker(tube * canal.room());
    Curled::new(canal, 1.0, None)
}

/// Samples along a curve.
const SAMPLES: usize = 160;

/// The horn for the numbers `[turns, rise, taper, girth]`: a logarithmic spiral, which looks the same at every size.
pub(super) fn horn(n: &[f64], ends: Ends) -> Curled {
    let (turns, rise, taper, girth) = (n[0], n[1], n[2], n[3]);
    let shrink = -libm::log(taper) / (TAU * turns);
    let points: Vec<(DVec3, f64)> = (0..=SAMPLES)
        .map(|k| {
            // Samples at even steps of the length.
            let t = k as f64 / SAMPLES as f64;
            let size = 1.0 - (1.0 - taper) * t;
            let angle = -libm::log(size) / shrink;
            let p = DVec3::new(libm::cos(angle), libm::sin(angle), -rise) * size;
            (p, size)
        })
        .collect();
    let (points, radii): (Vec<DVec3>, Vec<f64>) = points.into_iter().unzip();
    let length: f64 = points.windows(2).map(|w| (w[1] - w[0]).length()).sum();
    let canal = Canal::new(points, radii, false);
    let room = canal.room().min(0.3 * length).min(0.62);
    Curled::new(canal.thicker(girth * room), 1.0, Some(ends))
}

/// The tail for the numbers `[curl, taper, girth, lift]`: flat on the ground at first, then more and more curled.
pub(super) fn tail(n: &[f64], ends: Ends) -> Curled {
    let (curl, taper, girth, lift) = (n[0].to_radians(), n[1], n[2], n[3]);
    let mut p = DVec3::ZERO;
    let step = 1.0 / SAMPLES as f64;
    let (mut points, mut radii) = (Vec::new(), Vec::new());
    for k in 0..=SAMPLES {
        let t = k as f64 * step;
        points.push(p);
        radii.push(0.5 * girth * (1.0 - (1.0 - taper) * libm::pow(t, 0.9)));
        // Each step takes the direction at its middle.
        let m = t + 0.5 * step;
        let angle = curl * libm::pow(m, 1.7);
        let out = 0.75 * lift * m;
        let flat = (1.0 - out * out).max(0.2).sqrt();
        p += DVec3::new(flat * libm::cos(angle), flat * libm::sin(angle), out) * step;
    }
    let canal = Canal::new(points, radii, false);
    Curled::new(
        canal.thicker((0.8 * canal.room()).min(1.0)),
        1.0,
        Some(ends),
    )
}
