//! A letter of thick strokes with rounded edges.

use super::bone::Bone;
use super::form::Form;
use super::glyphs::strokes;
use super::jet::{Jet, JetPoint, length};
use glam::{DVec2, DVec3};

pub(super) struct Letter {
    strokes: Vec<Vec<DVec2>>,
    /// Half the width of a stroke, half the depth, and the radius of the edges.
    half: f64,
    deep: f64,
    round: f64,
    lean: f64,
    scale: f64,
    wide: f64,
}

/// The radius of the smooth join between strokes, as a part of their half width.
const JOIN: f64 = 0.7;

impl Letter {
    /// The letter for the numbers `[letter, weight, depth, round, lean]`.
    pub fn new(n: &[f64]) -> Self {
        let (half, deep) = (0.5 * n[1], 0.5 * n[2]);
        let mut strokes = strokes(n[0] as usize - 1);
        let scale = 1.0 - 2.0 * half;
        let lean = libm::tan(n[4].to_radians());
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for p in strokes.iter_mut().flatten() {
            *p *= scale;
            p.y += half;
            let x = p.x + lean * (p.y - 0.5);
            (least, most) = (least.min(x), most.max(x));
        }
        for p in strokes.iter_mut().flatten() {
            p.x -= 0.5 * (least + most);
        }
        let wide = 0.5 * (most - least) + half * (1.0 + lean * lean).sqrt();
        Self {
            strokes,
            half,
            deep,
            round: n[3] * half.min(deep),
            lean,
            scale: 1.0 / (2.0 * wide).max(1.0),
            wide,
        }
    }

    fn placed(&self, p: DVec2) -> DVec3 {
        DVec3::new(p.x + self.lean * (p.y - 0.5), p.y, 0.0) * self.scale
    }
}

/// The distance to a polyline.
fn distance(line: &[DVec2], x: Jet, y: Jet) -> Jet {
    let p = DVec2::new(x.value, y.value);
    let mut best = (f64::INFINITY, DVec2::ZERO);
    for pair in line.windows(2) {
        let way = pair[1] - pair[0];
        let t = ((p - pair[0]).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        let foot = pair[0] + way * t;
        let far = (p - foot).length_squared();
        if far < best.0 {
            best = (far, foot);
        }
    }
    length(x - best.1.x, y - best.1.y)
}

impl Form for Letter {
    fn at(&self, p: JetPoint) -> Jet {
        let up = 1.0 / self.scale;
        let (y, z) = (p.y * up, p.z * up);
        let x = p.x * up - (y - 0.5) * self.lean;
        let k = JOIN * self.half;
        let mut flat: Option<Jet> = None;
        for line in &self.strokes {
            let d = distance(line, x, y) - self.half;
            flat = Some(flat.map_or(d, |flat| flat.weld(d, k)));
        }
        let Some(flat) = flat else {
            return Jet::new(1.0, DVec3::ZERO);
        };
        let (a, b) = (flat + self.round, z.abs() - (self.deep - self.round));
        let edge = if a.value > 0.0 && b.value > 0.0 {
            length(a, b)
        } else if a.value > b.value {
            a
        } else {
            b
        };
        (edge - self.round) * self.scale
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let x = self.wide * self.scale;
        let z = self.deep * self.scale;
        (DVec3::new(-x, 0.0, -z), DVec3::new(x, self.scale, z))
    }

    fn coarsest(&self) -> f64 {
        (0.5 * self.half).min(1.1 * self.round) * self.scale
    }

    fn steepest(&self) -> f64 {
        1.0 + self.lean.abs()
    }

    fn bones(&self) -> Vec<Bone> {
        let bone = |line: &Vec<DVec2>| Bone {
            points: line.iter().map(|&p| self.placed(p)).collect(),
            radii: vec![self.half * self.scale; line.len()],
            closed: false,
        };
        self.strokes.iter().map(bone).collect()
    }
}
