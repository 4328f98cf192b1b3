//! A fish: a body with a lens-shaped cross-section, and fins thick enough to pack on. It swims towards -x.

use super::bone::Bone;
use super::canal::Canal;
use super::form::Form;
use super::jet::{Jet, JetPoint};
use glam::DVec3;

pub(super) struct Fish {
    body: Canal,
    /// Half the height; the length is 1.
    half: f64,
    /// The factor that stretches the width so that each side of the lens becomes an arc of a circle.
    narrow: f64,
    /// The fins in the middle plane, each with the radius of its smooth join to the body.
    fins: Vec<(Canal, f64)>,
    /// The fin at one side, in a space that is stretched across. The other side mirrors it.
    side: Canal,
    eye: (DVec3, f64),
    /// Radii of the body at even steps along x.
    radii: Vec<f64>,
    swim: f64,
    /// The lowest and the highest point.
    low: f64,
    high: f64,
}

/// The distance of each arc's centre from the middle plane, as a part of the arc's radius. Two arcs make the lens.
const LENS: f64 = 0.32;
/// The radius of the lens' rounded edges.
const EDGE: f64 = 0.016;
/// The ratio of breadth to thickness: of fins in the middle plane, and of fins at the sides.
const THIN: f64 = 2.2;
const SIDE_THIN: f64 = 2.0;
/// The strength of the body's bend to the side, for an angle with tangent 1.
const BEND: f64 = 0.55;
/// Steps in the table of radii.
const SAMPLES: usize = 128;
/// Where the bend to the side begins.
const NECK: f64 = -0.15;

/// A ball in the plane between both sides: its middle and its radius.
fn ball(x: f64, y: f64, r: f64) -> (DVec3, f64) {
    (DVec3::new(x, y, 0.0), r)
}

/// The body without fins. `half` is half of its height, and `larger` the radius of its largest ball.
fn trunk(half: f64, larger: f64) -> Canal {
    let body = [
        (-0.462, -0.06, 0.17),
        (-0.41, -0.035, 0.43),
        (-0.315, 0.0, 0.73),
        (-0.19, 0.01, 0.95),
        (-0.06, 0.01, 1.0),
        (0.08, 0.01, 0.86),
        (0.19, 0.01, 0.6),
        (0.28, 0.0, 0.36),
        (0.35, 0.0, 0.27),
    ];
    let body = body.map(|(x, y, r)| ball(x, y * half, r * larger));
    Canal::through(&body, 6)
}

/// The tail and the fins of the back and the belly, each with the radius of its smooth join to the body.
fn thin_fins(half: f64, tail: f64, fins: f64) -> Vec<(Canal, f64)> {
    let lobe = |up: f64| {
        let (s, u) = (tail, tail * up);
        [
            ball(0.30, 0.012 * up, 0.045),
            ball(0.31 + 0.055 * s, 0.060 * u, 0.066 * s),
            ball(0.31 + 0.090 * s, 0.130 * u, 0.064 * s),
            ball(0.31 + 0.150 * s, 0.220 * u, 0.040 * s),
        ]
    };
    let web = [
        ball(0.3, 0.0, 0.05),
        ball(0.31 + 0.055 * tail, 0.0, 0.05 * tail),
    ];
    let back = [
        ball(-0.16, 0.84 * half, 0.075),
        ball(-0.085, half + 0.025 * fins, 0.080 * fins),
        ball(0.005, 0.96 * half + 0.036 * fins, 0.068 * fins),
        ball(0.085, 0.80 * half + 0.042 * fins, 0.054 * fins),
        ball(0.155, 0.60 * half + 0.055 * fins, 0.040 * fins),
    ];
    let behind = [
        ball(0.09, -0.72 * half, 0.055),
        ball(0.140, -0.66 * half - 0.035 * fins, 0.05 * fins),
        ball(0.195, -0.5 * half - 0.080 * fins, 0.040 * fins),
    ];
    let below = [
        ball(-0.11, -0.9 * half, 0.055),
        ball(-0.065, -half - 0.025 * fins, 0.048 * fins),
        ball(-0.01, -0.98 * half - 0.07 * fins, 0.040 * fins),
    ];
    let through = |balls: &[(DVec3, f64)]| Canal::through(balls, 6);
    vec![
        (through(&lobe(1.0)), 0.03),
        (through(&lobe(-0.94)), 0.03),
        (through(&web), 0.03),
        (through(&back), 0.03),
        (through(&behind), 0.025),
        (through(&below), 0.025),
    ]
}

impl Fish {
    /// The fish for the numbers `[height, width, tail, fins, swim]`.
    pub fn new(n: &[f64]) -> Self {
        let (half, width, tail, fins) = (0.5 * n[0], n[1], n[2], n[3]);
        // Two overlapping circles make the lens. They are larger than the wanted height, because the lens is lower.
        let larger = half / (1.0 - LENS * LENS).sqrt();
        let through_fins = thin_fins(half, tail, fins);
        let narrow = ((1.0 - LENS) / (1.0 + LENS)).sqrt() / width;
        let (mut low, mut high) = (-half, half);
        for (fin, _) in &through_fins {
            let (a, b) = fin.bounds();
            (low, high) = (low.min(a.y), high.max(b.y));
        }
        let body = trunk(half, larger);
        let middle = 0.01 * half * DVec3::Y;
        let radius = |k: usize| {
            body.foot(middle + DVec3::X * (k as f64 / SAMPLES as f64 - 0.5))
                .radius
        };
        let mut fish = Self {
            radii: (0..=SAMPLES).map(radius).collect(),
            side: body.clone(),
            body,
            half,
            narrow,
            fins: through_fins,
            eye: (DVec3::ZERO, 0.0),
            swim: libm::tan(n[4].to_radians()) * BEND,
            low,
            high,
        };
        let eye = DVec3::new(-0.375, 0.17 * half, fish.skin(-0.375, 0.17 * half) - 0.004);
        fish.eye = (eye, 0.013 + 0.05 * half);
        fish.side = fish.side_fin(fins);
        fish
    }

    /// The fin at one side.
    fn side_fin(&self, fins: f64) -> Canal {
        // The balls of the fin come farther and farther out of the skin. They are placed in a space that is stretched
        // across, so that a flat fin is round there.
        let root = self.skin(-0.225, -0.2 * self.half) - 0.012;
        let on_side = |x: f64, y: f64, out: f64, r: f64| {
            let z = self.skin(x, y) + out;
            (DVec3::new(x, y, root + (z - root) * SIDE_THIN), r)
        };
        let side = [
            on_side(-0.225, -0.2 * self.half, -0.012, 0.042),
            on_side(-0.175, -0.3 * self.half, 0.012, 0.048 * fins),
            on_side(
                -0.175 + 0.09 * fins,
                -0.48 * self.half,
                0.03 + 0.032 * fins,
                0.038 * fins,
            ),
        ];
        Canal::through(&side, 6)
    }

    /// How far the fish bends to the side at x.
    fn aside(&self, x: Jet) -> Jet {
        (x - NECK).squared() * self.swim - self.swim * 0.12
    }

    /// Maps a point of the straight fish to the shape.
    fn placed(&self, p: DVec3) -> DVec3 {
        let aside = self.aside(Jet::new(p.x, DVec3::ZERO)).value;
        DVec3::new(p.x, p.y - self.low, p.z + aside)
    }

    fn body(&self, p: &JetPoint) -> Jet {
        let round = p.z.soft_abs(EDGE) - EDGE;
        let z = round * self.narrow + self.radius(p.x) * LENS;
        self.body.at(&JetPoint { z, ..*p })
    }

    /// The radius of the body at x.
    fn radius(&self, x: Jet) -> Jet {
        let last = self.radii.len() - 1;
        let at = ((x.value + 0.5) * last as f64).clamp(0.0, last as f64);
        let k = (at as usize).min(last - 1);
        let rise = self.radii[k + 1] - self.radii[k];
        let slope = if at > 0.0 && at < last as f64 {
            rise * last as f64
        } else {
            0.0
        };
        x.map(self.radii[k] + rise * (at - k as f64), slope)
    }

    /// The distance of the skin from a point of the middle plane.
    fn skin(&self, x: f64, y: f64) -> f64 {
        let (mut inside, mut outside) = (0.0, self.half);
        for _ in 0..40 {
            let z = 0.5 * (inside + outside);
            match self.body(&JetPoint::new(DVec3::new(x, y, z))).value < 0.0 {
                true => inside = z,
                false => outside = z,
            }
        }
        inside
    }
}

impl Form for Fish {
    fn at(&self, p: JetPoint) -> Jet {
        let p = JetPoint {
            y: p.y + self.low,
            z: p.z - self.aside(p.x),
            ..p
        };
        let mut fish = self.body(&p);
        let thin = JetPoint { z: p.z * THIN, ..p };
        for (fin, k) in &self.fins {
            fish = fin.join_to(fish, &thin, *k);
        }
        let beside = p.z.abs();
        let flap = JetPoint {
            z: (beside - self.side.start().0.z) * SIDE_THIN + self.side.start().0.z,
            ..p
        };
        fish = self.side.join_to(fish, &flap, 0.02);
        let eye = JetPoint { z: beside, ..p }.distance(self.eye.0) - self.eye.1;
        fish.join(eye, 0.012)
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let (tail, head) = (self.placed(DVec3::X * 0.45), self.placed(DVec3::X * -0.5));
        let middle = self.placed(DVec3::X * NECK);
        let z = self.side.bounds().1.z;
        let right = tail.x.max(self.fins[0].0.bounds().1.x);
        let (back, front) = (
            middle.z.min(tail.z).min(head.z),
            middle.z.max(tail.z).max(head.z),
        );
        (
            DVec3::new(-0.5, 0.0, back - z),
            DVec3::new(right, self.high - self.low, front + z),
        )
    }

    fn coarsest(&self) -> f64 {
        let least = self.fins.iter().map(|(fin, _)| fin.radii().0);
        0.9 * least.fold(f64::INFINITY, f64::min) / THIN
    }

    fn steepest(&self) -> f64 {
        self.narrow.max(THIN) * 1.4
    }

    fn bones(&self) -> Vec<Bone> {
        let fins = self.fins.iter().map(|(fin, _)| (fin, THIN));
        let mut bones = vec![self.body.bone()];
        for r in &mut bones[0].radii {
            *r *= (1.0 - LENS * LENS).sqrt();
        }
        for (fin, thin) in fins {
            let mut bone = fin.bone();
            for r in &mut bone.radii {
                *r /= thin;
            }
            bones.push(bone);
        }
        for sign in [1.0, -1.0] {
            let mut bone = self.side.bone();
            let start = self.side.start().0.z;
            for (p, r) in bone.points.iter_mut().zip(&mut bone.radii) {
                p.z = sign * ((p.z - start) / SIDE_THIN + start);
                *r /= SIDE_THIN;
            }
            bones.push(bone);
        }
        for bone in &mut bones {
            for p in &mut bone.points {
                *p = self.placed(*p);
            }
        }
        bones
    }
}
