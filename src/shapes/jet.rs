//! Forward differentiation: numbers with their gradients in space.

use glam::DVec3;
use std::ops::{Add, Mul, Neg, Sub};

/// A value at a point of space, and its gradient there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet {
    pub value: f64,
    pub slope: DVec3,
}

impl Jet {
    pub fn new(value: f64, slope: DVec3) -> Self {
        Self { value, slope }
    }

    /// Applies a function, given its value and its derivative.
    pub fn map(self, value: f64, derivative: f64) -> Self {
        Self::new(value, self.slope * derivative)
    }

    pub fn squared(self) -> Self {
        self.map(self.value * self.value, 2.0 * self.value)
    }

    /// The square root; at 0 its gradient is taken as 0.
    pub fn root(self) -> Self {
        let root = self.value.max(0.0).sqrt();
        self.map(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    pub fn inverse(self) -> Self {
        let inverse = 1.0 / self.value;
        self.map(inverse, -inverse * inverse)
    }

    pub fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    /// A smooth version of the absolute value, which is `round` at 0.
    pub fn soft_abs(self, round: f64) -> Self {
        (self.squared() + round * round).root()
    }

    /// exp(-x^2).
    pub fn bell(self) -> Self {
        let bell = libm::exp(-self.value * self.value);
        self.map(bell, -2.0 * self.value * bell)
    }

    pub fn max(self, least: f64) -> Self {
        if self.value < least {
            Self::new(least, DVec3::ZERO)
        } else {
            self
        }
    }

    /// The minimum of two values. Where they differ by less than `k`, it is smooth and somewhat smaller than both.
    pub fn join(self, other: Self, k: f64) -> Self {
        let (a, b) = if other.value < self.value {
            (other, self)
        } else {
            (self, other)
        };
        let near = (k - (b.value - a.value)).max(0.0) / k;
        let share = 0.5 * near * near;
        Self::new(
            a.value - share * near * k / 3.0,
            a.slope + (b.slope - a.slope) * share,
        )
    }

    /// The minimum of two values, rounded only where their gradients differ in direction, so that nothing swells
    /// where one part ends in the other.
    pub fn weld(self, other: Self, k: f64) -> Self {
        let alike = self.slope.dot(other.slope);
        let lengths = self.slope.length() * other.slope.length();
        let apart = 1.0 - alike / lengths.max(1e-9);
        self.join(other, k * apart.clamp(1e-6, 1.0))
    }

    /// The maximum of two values, rounded as in [`Self::join`].
    pub fn cut(self, other: Self, k: f64) -> Self {
        -(-self).join(-other, k)
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.slope + other.slope)
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.slope - other.slope)
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.value * other.value,
            self.slope * other.value + other.slope * self.value,
        )
    }
}

impl Add<f64> for Jet {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        Self::new(self.value + other, self.slope)
    }
}

impl Sub<f64> for Jet {
    type Output = Self;
    fn sub(self, other: f64) -> Self {
        Self::new(self.value - other, self.slope)
    }
}

impl Mul<f64> for Jet {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        Self::new(self.value * other, self.slope * other)
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

/// A point whose coordinates may be functions of the queried point. All gradients are taken with respect to the queried
/// point.
#[derive(Clone, Copy, Debug)]
pub(super) struct JetPoint {
    pub x: Jet,
    pub y: Jet,
    pub z: Jet,
}

impl JetPoint {
    pub fn new(p: DVec3) -> Self {
        Self {
            x: Jet::new(p.x, DVec3::X),
            y: Jet::new(p.y, DVec3::Y),
            z: Jet::new(p.z, DVec3::Z),
        }
    }

    pub fn place(&self) -> DVec3 {
        DVec3::new(self.x.value, self.y.value, self.z.value)
    }

    /// The distance to a fixed point.
    pub fn distance(&self, q: DVec3) -> Jet {
        let d = self.place() - q;
        let length = d.length();
        if length == 0.0 {
            return Jet::new(0.0, DVec3::ZERO);
        }
        let u = d / length;
        let slope = self.x.slope * u.x + self.y.slope * u.y + self.z.slope * u.z;
        Jet::new(length, slope)
    }
}

/// The length of a vector with two components.
pub(super) fn length(a: Jet, b: Jet) -> Jet {
    (a.squared() + b.squared()).root()
}
