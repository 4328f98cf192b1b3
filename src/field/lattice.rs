//! Lattices of cells that repeat with the space.
//!
//! If the direction is constant on a torus, the rows must meet themselves behind the seam in both directions.
//! The sides of the picture are lattice vectors only for some angles and sizes; the nearest of these is
//! taken. In the plane every lattice fits.

use super::CellKind;
use crate::planar::Space;
use glam::DVec2;

/// Distance of hexagonal rows, in cell widths.
const ROW: f64 = 0.866_025_403_784_438_6;

/// A lattice of cells: their size, their aspect ratio, and the unit vector along their rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    pub size: f64,
    pub aspect: f64,
    pub along: DVec2,
}

/// The nearest lattice that repeats with the space; `None` in the plane, where nothing repeats.
pub(super) fn fitted(space: Space, kind: CellKind, asked: Lattice) -> Option<Lattice> {
    let side = space.period()?;
    Some(match kind {
        CellKind::Square => squares(asked, side),
        _ => rows(kind, asked, side),
    })
}

fn squares(asked: Lattice, side: f64) -> Lattice {
    // Steps are (p, q) / (p^2 + q^2) of the side, with the nearest whole p and q.
    let steps = (asked.along * side / asked.size).round();
    let steps = if steps == DVec2::ZERO {
        DVec2::X
    } else {
        steps
    };
    Lattice {
        size: side / steps.length(),
        aspect: 1.0,
        along: steps.normalize(),
    }
}

/// The nearest lattice of cells in rows. One unit is a cell's length along the rows and a row's distance across.
/// Hexagonal rows are shifted by half a cell, so they use half a length and need an even sum of steps.
fn rows(kind: CellKind, asked: Lattice, side: f64) -> Lattice {
    let root = asked.aspect.sqrt();
    let even = !kind.has_corners();
    let (length, width) = (asked.size * root, asked.size / root);
    let (unit, row) = if even {
        (length / 2.0, width * ROW)
    } else {
        (length, width)
    };
    let (unit, row) = nearest(asked.along, unit, row, side, even);
    let (length, width) = if even {
        (2.0 * unit.length(), row / ROW)
    } else {
        (unit.length(), row)
    };
    Lattice {
        size: (length * width).sqrt(),
        aspect: if kind.is_stretched() {
            (length / width).clamp(1.0, 5.0)
        } else {
            1.0
        },
        along: unit.normalize(),
    }
}

/// The step along the rows, as a vector, and the rows' distance. A line along (a, b), coprime whole numbers, closes on
/// the torus. The step is the side over m |(a, b)|, the distance the side over n |(a, b)|, with whole m and n.
fn nearest(along: DVec2, unit: f64, row: f64, side: f64, even: bool) -> (DVec2, f64) {
    let most = ((side / unit.min(row)) as i64).clamp(1, 200);
    let mut best = (f64::INFINITY, DVec2::X * unit, row);
    for direction in directions(along, most) {
        let vector = DVec2::from(direction.map(|v| v as f64));
        let length = vector.length();
        let turn = along.perp_dot(vector) / length;
        let asked = [side / (unit * length), side / (row * length)];
        for counts in counts(asked).filter(|&c| !even || sums_are_even(direction, c)) {
            let [m, n] = counts.map(|v| v as f64);
            let stretch = libm::log(m / asked[0]);
            let spread = libm::log(n / asked[1]);
            let cost = stretch * stretch + spread * spread + 2.0 * turn * turn;
            if cost < best.0 {
                let unit = vector * (side / (m * length * length));
                best = (cost, unit, side / (n * length));
            }
        }
    }
    (best.1, best.2)
}

/// Coprime whole numbers near a direction: for each number up to `most` on the longer axis, the nearest number on the
/// other axis and both its neighbours. No other can be nearer.
fn directions(along: DVec2, most: i64) -> impl Iterator<Item = [i64; 2]> {
    let is_steep = along.x.abs() < along.y.abs();
    let tilt = if is_steep {
        along.x / along.y
    } else {
        along.y / along.x
    };
    let beside = move |a: i64| {
        let middle = (a as f64 * tilt).round() as i64;
        (middle - 1..=middle + 1).map(move |b| if is_steep { [b, a] } else { [a, b] })
    };
    let is_ahead = move |v: [i64; 2]| DVec2::from(v.map(|v| v as f64)).dot(along) > 0.0;
    (-most..=most)
        .flat_map(beside)
        .filter(move |&[x, y]| divisor(x, y) == 1 && is_ahead([x, y]))
}

/// Pairs of whole numbers near the asked ones.
fn counts(asked: [f64; 2]) -> impl Iterator<Item = [i64; 2]> {
    let [first, second] = asked.map(multiples);
    first
        .into_iter()
        .flat_map(move |m| second.map(|n| [m.into(), n.into()]))
}

fn multiples(asked: f64) -> [u32; 3] {
    let middle = (asked.round() as u32).max(2);
    [middle - 1, middle, middle + 1]
}

/// Whether both sides of the picture are even sums of steps along and across the rows, as shifted rows need.
fn sums_are_even([x, y]: [i64; 2], [m, n]: [i64; 2]) -> bool {
    (m * x + n * y) % 2 == 0 && (m * y + n * x) % 2 == 0
}

fn divisor(a: i64, b: i64) -> i64 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::unit_vector;

    /// Whether (x, y) is an integer combination of the lattice's two vectors.
    fn repeats(kind: CellKind, lattice: Lattice, p: DVec2) -> bool {
        let root = lattice.aspect.sqrt();
        let (length, width) = (lattice.size * root, lattice.size / root);
        let (u, v) = (
            p.dot(lattice.along) / length,
            p.perp_dot(lattice.along) / width,
        );
        let whole = |x: f64| (x - x.round()).abs() < 1e-6;
        if kind.has_corners() {
            return whole(u) && whole(v);
        }
        let (u, v) = (2.0 * u, v / ROW);
        whole(u) && whole(v) && (u.round() + v.round()) as i64 % 2 == 0
    }

    #[test]
    fn the_sides_are_sums_of_steps_and_little_changes() {
        let side = 512.0;
        for kind in [CellKind::Square, CellKind::Rectangle, CellKind::Ellipse] {
            for size in [8.0, 23.0, 37.0] {
                for degrees in [-88.0, -45.0, -10.0, 0.0, 17.0, 45.0, 63.0, 90.0_f64] {
                    let angle = degrees.to_radians();
                    let asked = Lattice {
                        size,
                        aspect: if kind.is_stretched() { 2.0 } else { 1.0 },
                        along: unit_vector(angle),
                    };
                    let got = fitted(Space::torus(side), kind, asked).unwrap();
                    let said = format!("{kind:?} {size} {degrees}: {got:?}");
                    assert!(repeats(kind, got, DVec2::X * side), "{said}");
                    assert!(repeats(kind, got, DVec2::Y * side), "{said}");
                    let change = libm::log(got.size / size).abs();
                    assert!(change < 0.15, "{said}");
                    assert!(got.along.dot(asked.along) > 0.99, "{said}");
                }
            }
        }
    }

    #[test]
    fn squares_along_the_axes_and_tilted_ones_are_exact() {
        let asked = |degrees: f64| Lattice {
            size: 23.0,
            aspect: 1.0,
            along: unit_vector(degrees.to_radians()),
        };
        let got = |degrees| fitted(Space::torus(512.0), CellKind::Square, asked(degrees)).unwrap();
        assert_eq!(got(0.0).size, 512.0 / 22.0);
        assert_eq!(got(18.0).along, DVec2::new(21.0, 7.0).normalize());
    }
}
