//! A cylinder, with or without caps: rings of vertices that are sewn together.

use super::bone::Bone;
use crate::trimesh::{ROW, Soup, VertexRing};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

pub(super) struct Drum {
    height: f64,
    top: f64,
    belly: f64,
    caps: bool,
    scale: f64,
}

/// Samples of the wall's outline.
const SAMPLES: usize = 256;
impl Drum {
    /// The drum for the numbers `[height, top, belly, caps]`.
    pub fn new(n: &[f64]) -> Self {
        let mut drum = Self {
            height: 2.0 * n[0],
            top: n[1],
            belly: n[2],
            caps: n[3] != 0.0,
            scale: 1.0,
        };
        let radii = (0..=SAMPLES).map(|k| drum.radius(k as f64 / SAMPLES as f64));
        let most = radii.fold(0.0, f64::max);
        drum.scale = 1.0 / drum.height.max(2.0 * most);
        drum
    }

    /// The radius at a height from 0 (bottom) to 1 (top).
    fn radius(&self, t: f64) -> f64 {
        (1.0 + (self.top - 1.0) * t + 4.0 * self.belly * t * (1.0 - t)) * self.scale
    }

    pub fn bones(&self) -> Vec<Bone> {
        let at = (0..=16).map(|k| f64::from(k) / 16.0);
        let (points, radii) = at
            .map(|t| (DVec3::Y * (t * self.height * self.scale), self.radius(t)))
            .unzip();
        vec![Bone {
            points,
            radii,
            closed: false,
        }]
    }

    /// The outline of the wall in even steps: distance from the axis, and height.
    fn outline(&self, step: f64) -> Vec<DVec2> {
        let at = |t: f64| DVec2::new(self.radius(t), t * self.height * self.scale);
        let fine: Vec<DVec2> = (0..=SAMPLES)
            .map(|k| at(k as f64 / SAMPLES as f64))
            .collect();
        let mut along = vec![0.0];
        for pair in fine.windows(2) {
            along.push(along[along.len() - 1] + (pair[1] - pair[0]).length());
        }
        let length = along[SAMPLES];
        let count = (length / step).round().max(1.0);
        let mut k = 0;
        (0..=count as usize)
            .map(|row| {
                let wanted = length * row as f64 / count;
                while k + 2 < along.len() && along[k + 1] < wanted {
                    k += 1;
                }
                let share = (wanted - along[k]) / (along[k + 1] - along[k]);
                fine[k] + (fine[k + 1] - fine[k]) * share.clamp(0.0, 1.0)
            })
            .collect()
    }

    pub fn build(&self, edge: f64) -> Soup {
        let height = self.height * self.scale;
        let wide = 2.0 * self.outline(0.01).iter().fold(0.0, |most, p| p.x.max(most));
        let step = edge * (2.0 * wide * wide + height * height).sqrt();
        let wall = self.outline(ROW * step);
        let mut sewing = Sewing::new(step);
        let cap = |radius: f64| {
            let count = (radius / (ROW * step)).round().max(1.0);
            move |k: usize| radius * k as f64 / count
        };
        let count = |radius: f64| (radius / (ROW * step)).round().max(1.0) as usize;
        let (below, above) = (wall[0], wall[wall.len() - 1]);
        if self.caps {
            let at = cap(below.x);
            for k in 0..count(below.x) {
                sewing.ring(DVec2::new(at(k), below.y));
            }
        }
        for &p in &wall {
            sewing.ring(p);
        }
        if self.caps {
            let at = cap(above.x);
            for k in (0..count(above.x)).rev() {
                sewing.ring(DVec2::new(at(k), above.y));
            }
        }
        sewing.made
    }
}

/// Rings of vertices about the y axis, each joined to the one before by triangles.
struct Sewing {
    step: f64,
    made: Soup,
    last: Option<VertexRing>,
}

impl Sewing {
    fn new(step: f64) -> Self {
        Self {
            step,
            made: Soup::default(),
            last: None,
        }
    }

    /// Adds a ring of this radius and height; a radius of 0 gives a single vertex.
    fn ring(&mut self, at: DVec2) {
        let mut count = match at.x {
            0.0 => 1,
            r => ((TAU * r / self.step).round() as usize).max(6),
        };
        if let Some(last) = &self.last {
            // Keep the count of the ring before if it is nearly right: that makes no irregular vertices.
            if last.count > 1 && count > 1 && last.count.abs_diff(count) * 20 <= count {
                count = last.count;
            }
        }
        let ring = self.made.ring(at, count, self.last.as_ref());
        if let Some(last) = &self.last {
            self.made.sew(last, &ring);
        }
        self.last = Some(ring);
    }
}
