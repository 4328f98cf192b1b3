//! Quadric error metrics: squared distances to many planes at once. Garland, Heckbert (1997), Surface
//! Simplification Using Quadric Error Metrics.

use glam::DVec3;

/// The area-weighted sum of the squared distances to some planes: a symmetric matrix, row by row.
#[derive(Clone, Copy, Default)]
pub(crate) struct Quadric([f64; 10]);

impl Quadric {
    /// The quadric of the plane n . x = -d, with a unit normal `n`.
    pub fn of_plane(n: DVec3, d: f64, weight: f64) -> Self {
        let p = [n.x, n.y, n.z, d];
        let [x, y, z, one] = p.map(|v| weight * v);
        let [rx, ry, rz] = [x * n, y * n, z * n];
        Self([
            rx.x,
            rx.y,
            rx.z,
            x * d,
            ry.y,
            ry.z,
            y * d,
            rz.z,
            z * d,
            one * d,
        ])
    }

    /// Adds another quadric.
    pub fn add(&mut self, other: &Self) {
        for (sum, more) in self.0.iter_mut().zip(other.0) {
            *sum += more;
        }
    }

    /// The sum of the planes' weights: their normals are unit vectors.
    pub fn weight(&self) -> f64 {
        self.0[0] + self.0[4] + self.0[7]
    }

    /// The weighted sum of the squared distances at a point.
    pub fn at(&self, p: DVec3) -> f64 {
        let [xx, xy, xz, x, yy, yz, y, zz, z, one] = self.0;
        let squares = xx * p.x * p.x + yy * p.y * p.y + zz * p.z * p.z;
        let mixed = xy * p.x * p.y + xz * p.x * p.z + yz * p.y * p.z;
        squares + 2.0 * (mixed + x * p.x + y * p.y + z * p.z) + one
    }

    /// The point of least value. Along directions in which the value changes by less than `hold` for each unit of
    /// weight, the point stays close to `near`.
    #[cfg(house)]
    pub fn lowest(&self, near: DVec3, hold: f64) -> DVec3 {
        let [xx, xy, xz, x, yy, yz, y, zz, z, _] = self.0;
        let hold = hold * self.weight();
        let rows = [
            DVec3::new(xx + hold, xy, xz),
            DVec3::new(xy, yy + hold, yz),
            DVec3::new(xz, yz, zz + hold),
        ];
        let slope = DVec3::new(
            DVec3::new(xx, xy, xz).dot(near) + x,
            DVec3::new(xy, yy, yz).dot(near) + y,
            DVec3::new(xz, yz, zz).dot(near) + z,
        );
        let [a, b, c] = [
            rows[1].cross(rows[2]),
            rows[2].cross(rows[0]),
            rows[0].cross(rows[1]),
        ];
        let by = (a * slope.x + b * slope.y + c * slope.z) / -rows[0].dot(a);
        if by.is_finite() { near + by } else { near }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_is_least_where_planes_meet() {
        let meet = DVec3::new(1.0, -2.0, 3.0);
        let mut sum = Quadric::default();
        for (normal, weight) in [
            (DVec3::X, 1.0),
            (DVec3::new(0.6, 0.8, 0.0), 2.0),
            (DVec3::new(0.0, 0.6, 0.8), 0.5),
        ] {
            sum.add(&Quadric::of_plane(normal, -normal.dot(meet), weight));
        }
        #[cfg(house)]
        {
            assert!((sum.lowest(meet + DVec3::splat(0.1), 1e-4) - meet).length() < 1e-3);
            let plane = Quadric::of_plane(DVec3::Z, -2.0, 3.0);
            let lowest = plane.lowest(DVec3::new(5.0, 7.0, 9.0), 1e-4);
            assert!((lowest - DVec3::new(5.0, 7.0, 2.0)).length() < 1e-3);
            assert_eq!(Quadric::default().lowest(meet, 1e-4), meet);
        }
        assert!(sum.at(meet).abs() < 1e-12);
        // One unit along x: 1, 2 * 0.36 and 0.
        assert!((sum.at(meet + DVec3::X) - 1.72).abs() < 1e-12);
        assert_eq!(sum.weight(), 3.5);
    }
}
