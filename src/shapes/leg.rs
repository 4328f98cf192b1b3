//! A dinosaur's leg that stands on its toes: thigh, knee, shin, ankle, and toes with knuckles and tapered tips.

use super::bone::Bone;
use super::canal::Canal;
use super::form::{Cut, Ends, Form};
use super::jet::{Jet, JetPoint};
use glam::DVec3;

pub(super) struct Leg {
    /// From the hip to the ball of the foot.
    limb: Canal,
    /// Thigh and calf.
    muscles: [Canal; 2],
    knee: (DVec3, f64),
    toes: Vec<Toe>,
    /// The radius of the edge around the cut at the hip.
    edge: f64,
}

struct Toe {
    canal: Canal,
    /// Balls on top of the joints.
    knuckles: Vec<(DVec3, f64)>,
    claw: Bone,
}

/// The ratio of the limb's depth to its width.
const DEEPER: f64 = 1.14;
/// The radii of smooth joins: between parts of the limb, between toes, and at knuckles.
const JOIN: f64 = 0.07;
const WEB: f64 = 0.03;
const KNUCKLE: f64 = 0.018;
/// The balls of a claw from root to point: place along the toe as a share of its length, height, and radius.
const CLAW: [(f64, f64, f64); 5] = [
    (0.93, 0.034, 0.018),
    (1.02, 0.038, 0.018),
    (1.11, 0.035, 0.0135),
    (1.19, 0.024, 0.008),
    (1.25, 0.008, 0.0012),
];
/// The middle lines of the toes meet this far behind the ball of the foot.
const BEHIND: f64 = 0.045;

/// The places of the joints; `ball` is that of the foot.
struct Joints {
    hip: DVec3,
    knee: DVec3,
    ankle: DVec3,
    ball: DVec3,
}

/// The balls that a part is drawn through, with their radii.
type Balls<const N: usize> = [(DVec3, f64); N];

fn between(a: DVec3, b: DVec3, t: f64) -> DVec3 {
    a + (b - a) * t
}

/// A place that is moved to the back.
fn back(p: DVec3, by: f64) -> DVec3 {
    p - DVec3::Z * by
}

impl Joints {
    fn new(bend: f64) -> Self {
        // The thigh leans forward, the shin back, and the foot forward again.
        let lean = |angle: f64| DVec3::new(0.0, libm::cos(angle), libm::sin(angle));
        let thigh = lean(-0.6 * bend) * 0.40;
        let shin = lean(0.75 * bend + 0.04) * 0.37;
        let foot = lean(-(0.8 * bend + 0.22)) * 0.17;
        let ball = DVec3::new(0.0, 0.072, 0.03);
        let longer = (1.03 - ball.y) / (thigh + shin + foot).y;
        let ankle = ball + foot * longer;
        let knee = ankle + shin * longer;
        Self {
            hip: knee + thigh * longer,
            knee,
            ankle,
            ball,
        }
    }

    fn limb(&self) -> Balls<8> {
        let Self {
            hip,
            knee,
            ankle,
            ball,
        } = *self;
        [
            (hip, 0.172),
            (between(hip, knee, 0.45), 0.146),
            (between(hip, knee, 0.82), 0.104),
            (between(knee, ankle, 0.14), 0.1),
            (between(knee, ankle, 0.48), 0.085),
            (between(knee, ankle, 0.85), 0.068),
            (between(ankle, ball, 0.3), 0.068),
            (ball, 0.076),
        ]
    }

    fn haunch(&self) -> Balls<3> {
        let (hip, knee) = (self.hip, self.knee);
        [
            (back(hip, 0.05), 0.15),
            (back(between(hip, knee, 0.5), 0.062), 0.112),
            (back(between(hip, knee, 0.92), 0.04), 0.06),
        ]
    }

    fn calf(&self) -> Balls<4> {
        let (knee, ankle) = (self.knee, self.ankle);
        [
            (back(between(knee, ankle, 0.08), 0.03), 0.062),
            (back(between(knee, ankle, 0.33), 0.045), 0.07),
            (back(between(knee, ankle, 0.66), 0.036), 0.042),
            (back(between(knee, ankle, 0.95), 0.026), 0.036),
        ]
    }
}

impl Leg {
    /// The leg for the numbers `[toes, spread, bend, girth, reach]`; the toes point to z.
    pub fn new(n: &[f64], ends: Ends) -> Self {
        let (count, spread, bend, girth, reach) = (
            n[0] as usize,
            n[1].to_radians(),
            n[2].to_radians(),
            n[3],
            n[4],
        );
        let joints = Joints::new(bend);
        let thick = |balls: &[(DVec3, f64)]| {
            let thick: Vec<_> = balls.iter().map(|&(p, r)| (p, r * girth)).collect();
            Canal::through(&thick, 6)
        };
        let middle = 0.5 * (count as f64 - 1.0);
        let toe = |k: usize| {
            let aside = k as f64 - middle;
            toe(joints.ball, aside * spread, aside.abs(), reach, girth)
        };
        Self {
            limb: thick(&joints.limb()),
            muscles: [thick(&joints.haunch()), thick(&joints.calf())],
            knee: (joints.knee + DVec3::new(0.0, 0.0, 0.035), 0.068 * girth),
            toes: (0..count).map(toe).collect(),
            edge: match ends {
                Ends::Round => 0.07,
                Ends::Cut => 0.02,
            },
        }
    }

    fn knee(&self, p: &JetPoint) -> Jet {
        p.distance(self.knee.0) - self.knee.1
    }
}

/// A toe at an angle to the foot; toes farther from the middle one are shorter.
fn toe(ball: DVec3, angle: f64, aside: f64, reach: f64, girth: f64) -> Toe {
    let length = reach * (0.395 - 0.032 * aside);
    let out = DVec3::new(libm::sin(angle), 0.0, libm::cos(angle));
    let start = DVec3::new(ball.x, 0.0, ball.z - BEHIND);
    let thick = (0.8 + 0.2 * girth) * (1.0 - 0.04 * aside);
    // Place along the toe as a share of its length, height, and radius.
    let along = [
        (0.0, 0.078, 0.060),
        (0.25, 0.077, 0.053),
        (0.48, 0.063, 0.0485),
        (0.70, 0.050, 0.0435),
        (0.86, 0.039, 0.035),
        (1.0, 0.022, 0.023),
    ];
    let balls = along.map(|(t, y, r)| (start + out * (t * length) + DVec3::Y * y, r * thick));
    let canal = Canal::through(&balls, 6);
    let knuckles = [
        (0.36, 0.092, 0.037),
        (0.575, 0.075, 0.0345),
        (0.775, 0.060, 0.030),
    ];
    let knuckles = knuckles
        .map(|(t, y, r)| (start + out * (t * length) + DVec3::Y * y * thick, r * thick))
        .to_vec();
    let claw = CLAW.map(|(t, y, r)| (start + out * (t * length) + DVec3::Y * y, r * thick));
    Toe {
        canal,
        knuckles,
        claw: Canal::through(&claw, 3).bone(),
    }
}

impl Toe {
    fn at(&self, p: &JetPoint) -> Jet {
        let mut toe = self.canal.at(p);
        for &(middle, radius) in &self.knuckles {
            toe = toe.join(p.distance(middle) - radius, KNUCKLE);
        }
        toe
    }

    /// A lower bound of the distance.
    fn far(&self, p: DVec3) -> f64 {
        self.canal.far(p) - KNUCKLE
    }
}

impl Form for Leg {
    fn at(&self, p: JetPoint) -> Jet {
        let place = p.place();
        let slim = JetPoint {
            x: p.x * DEEPER,
            ..p
        };
        let [haunch, calf] = &self.muscles;
        let mut leg = self.limb.at(&slim);
        // The knee and the muscles lie above this height.
        if place.y > 0.1 {
            leg = leg.join(self.knee(&slim), JOIN);
            leg = haunch.join_to(leg, &slim, JOIN);
            leg = calf.join_to(leg, &slim, JOIN);
        }
        let mut toes: Option<Jet> = None;
        for toe in &self.toes {
            let far = toe.far(place);
            // Skip toes that are too far away to change the result.
            if far > leg.value + JOIN || toes.is_some_and(|toes| far > toes.value + WEB) {
                continue;
            }
            let at = toe.at(&p);
            toes = Some(toes.map_or(at, |toes| toes.join(at, WEB)));
        }
        if let Some(toes) = toes {
            leg = leg.join(toes, JOIN);
        }
        leg.cut(-p.y, 0.03).cut(p.y - 1.0, self.edge)
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let slim = DVec3::new(1.0 / DEEPER, 1.0, 1.0);
        let (mut lo, mut hi) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for canal in [&self.limb].into_iter().chain(&self.muscles) {
            let (a, b) = canal.bounds();
            (lo, hi) = (lo.min(a * slim), hi.max(b * slim));
        }
        for toe in &self.toes {
            (lo, hi) = (lo.min(toe.canal.bounds().0), hi.max(toe.canal.bounds().1));
        }
        (DVec3::new(lo.x, 0.0, lo.z), DVec3::new(hi.x, 1.0, hi.z))
    }

    fn coarsest(&self) -> f64 {
        let tips = self.toes.iter().map(|toe| toe.canal.radii().0);
        0.85 * tips.fold(0.025, f64::min)
    }

    fn steepest(&self) -> f64 {
        DEEPER
    }

    fn bones(&self) -> Vec<Bone> {
        let mut limb = self.limb.bone();
        let kept = limb.points.iter().filter(|p| p.y <= 1.0).count();
        let above = limb.points.len() - kept;
        limb.points.drain(..above);
        limb.radii.drain(..above);
        let toes = self.toes.iter().map(|toe| toe.canal.bone());
        std::iter::once(limb).chain(toes).collect()
    }

    fn cuts(&self) -> Vec<Cut> {
        vec![Cut {
            at: DVec3::Y,
            out: DVec3::Y,
        }]
    }

    fn claws(&self) -> Vec<Bone> {
        self.toes.iter().map(|toe| toe.claw.clone()).collect()
    }
}
