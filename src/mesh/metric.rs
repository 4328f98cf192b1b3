//! The metric of lengths and angles for stretched cells.

use glam::DVec2;

/// A symmetric 2 x 2 matrix with determinant 1, in which a stretched cell is as long as wide. It preserves
/// areas, so the cross product of two vectors is the same in every metric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Metric {
    /// The Euclidean metric, of squares and circles.
    pub const EUCLIDEAN: Self = Self {
        xx: 1.0,
        xy: 0.0,
        yy: 1.0,
    };

    /// The metric of cells `aspect` times as long (along the unit vector `axis`) as wide.
    pub fn new(axis: DVec2, aspect: f64) -> Self {
        if aspect == 1.0 || axis == DVec2::ZERO {
            return Self::EUCLIDEAN;
        }
        let (along, across) = (1.0 / aspect, aspect);
        Self {
            xx: along * axis.x * axis.x + across * axis.y * axis.y,
            xy: (along - across) * axis.x * axis.y,
            yy: along * axis.y * axis.y + across * axis.x * axis.x,
        }
    }

    /// The mean of several metrics, scaled to determinant 1.
    pub fn mean(several: [Self; 4]) -> Self {
        if several == [Self::EUCLIDEAN; 4] {
            return Self::EUCLIDEAN;
        }
        let [a, b, c, d] = several;
        let xx = a.xx + b.xx + c.xx + d.xx;
        let xy = a.xy + b.xy + c.xy + d.xy;
        let yy = a.yy + b.yy + c.yy + d.yy;
        let scale = 1.0 / (xx * yy - xy * xy).sqrt();
        Self {
            xx: xx * scale,
            xy: xy * scale,
            yy: yy * scale,
        }
    }

    /// The inner product of two vectors.
    pub fn dot(&self, u: DVec2, v: DVec2) -> f64 {
        self.xx * u.x * v.x + self.xy * (u.x * v.y + u.y * v.x) + self.yy * u.y * v.y
    }

    /// The length of a vector.
    pub fn length(&self, u: DVec2) -> f64 {
        self.dot(u, u).sqrt()
    }
}
