//! Steps between two square columns with caps, and rails.

use super::Module;
use super::drafting::Drafting;
use crate::building::draft::Draft;
use crate::building::labels::{self, COLUMN, STEP};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The height of rails above the steps, and their radius (metres).
const RAIL: [f64; 2] = [0.85, 0.025];
/// Sides of a rail.
const SIDES: u32 = 8;
/// The height of a column's cap in courses, and how far it overhangs the column in modules.
const CAP: [f64; 2] = [2.0, 1.0];

pub(super) fn steps(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let [count, width, tread, riser, column, height] = [n[0], n[1], n[2], n[3], n[4], n[5]];
    let half = 0.5 * module.pier(width);
    let depth = count * tread * module.half;
    flight(&mut to, module, [count, tread, riser], half);
    // Columns stand a joint beside the lowest steps.
    for side in [1.0, -1.0] {
        let middle = side * (0.5 * width + 0.5 * column + CAP[1]) * module.half;
        let front = 0.5 * depth - 0.5 * module.joint;
        let centre = DVec2::new(middle, front - (0.5 * column + CAP[1]) * module.half);
        add_column(&mut to, module, centre, [column, height]);
        let x = side * (half - 2.0 * RAIL[1]);
        let rise = riser * count * module.course;
        add_rail(&mut to, x, [0.5 * depth, -0.5 * depth], rise);
    }
    to.on_ground()
}

/// The steps, rising towards -z.
fn flight(to: &mut Drafting, module: &Module, [count, tread, riser]: [f64; 3], half: f64) {
    let joint = 0.5 * module.joint;
    let front = 0.5 * count * tread * module.half - joint;
    let back = -0.5 * count * tread * module.half + joint;
    let at = |z: f64, y: f64| DVec2::new(z, y);
    let mut profile = vec![at(back, 0.0)];
    for k in 0..count as u32 {
        let z = front - f64::from(k) * tread * module.half;
        let y = |k: u32| {
            if k == 0 {
                0.0
            } else {
                module.top(f64::from(k) * riser)
            }
        };
        profile.extend([at(z, y(k)), at(z, y(k + 1))]);
    }
    profile.push(at(back, module.top(count * riser)));
    let place = |x: f64, p: DVec2| DVec3::new(x, p.y, p.x);
    for side in [1.0, -1.0] {
        let ring: Vec<DVec3> = profile.iter().map(|&p| place(side * half, p)).collect();
        to.panel(&[STEP], &ring, DVec3::X * side);
    }
    let next = profile.iter().cycle().skip(1);
    for (&a, &b) in profile.iter().zip(next) {
        let corners = [
            place(half, a),
            place(half, b),
            place(-half, b),
            place(-half, a),
        ];
        // The profile is counter-clockwise in z and y, so its outside is to the right.
        let outward = DVec3::new(0.0, a.x - b.x, b.y - a.y);
        to.panel(&[STEP], &corners, outward);
    }
}

/// A column with a cap that overhangs it.
fn add_column(to: &mut Drafting, module: &Module, centre: DVec2, [width, height]: [f64; 2]) {
    let square = |modules: f64, y: f64| -> Vec<DVec3> {
        let half = 0.5 * module.pier(modules);
        let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
        let corner = |(x, z)| DVec3::new(centre.x + half * x, y, centre.y + half * z);
        corners.map(corner).to_vec()
    };
    // The cap's underside is the top of a gap in the masonry: a joint higher than a solid's top.
    let neck = (height - CAP[0]) * module.course;
    let top = module.top(height);
    let cap = width + 2.0 * CAP[1];
    let walls = |to: &mut Drafting, (label, modules): (&str, f64), from: f64, end: f64| {
        let (low, high) = (square(modules, from), square(modules, end));
        for k in 0..4 {
            let next = (k + 1) % 4;
            to.flat(&[label], &[vec![low[k], low[next], high[next], high[k]]]);
        }
    };
    walls(to, (COLUMN, width), 0.0, neck);
    walls(to, (labels::CAP, cap), neck, top);
    let back = |mut ring: Vec<DVec3>| {
        ring.reverse();
        ring
    };
    to.flat(&[labels::CAP], &[square(cap, top)]);
    to.flat(
        &[labels::CAP],
        &[back(square(cap, neck)), square(width, neck)],
    );
    to.flat(&[COLUMN], &[back(square(width, 0.0))]);
}

/// A hand rail along one side of the steps, with a post at each end.
fn add_rail(to: &mut Drafting, x: f64, [front, back]: [f64; 2], rise: f64) {
    let [height, radius] = RAIL;
    let low = DVec3::new(x, 0.0, front - 2.0 * radius);
    let high = DVec3::new(x, rise, back + 2.0 * radius);
    let up = DVec3::Y * height;
    for (from, end) in [(low, low + up), (high, high + up), (low + up, high + up)] {
        add_bar(to, from, end, radius);
    }
}

/// A closed prism around a line.
fn add_bar(to: &mut Drafting, from: DVec3, end: DVec3, radius: f64) {
    let axis = (end - from).normalize();
    let x = crate::building::facets::perpendicular(axis);
    let y = axis.cross(x);
    let mut positions = Vec::new();
    for k in 0..SIDES {
        let (sin, cos) = libm::sincos(TAU * f64::from(k) / f64::from(SIDES));
        let out = (x * cos + y * sin) * radius;
        positions.extend([from + out, end + out]);
    }
    let mut triangles = Vec::new();
    for k in 0..SIDES {
        let [a, b] = [2 * k, 2 * ((k + 1) % SIDES)];
        triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
        if k > 1 {
            triangles.extend([[0, 2 * k, 2 * (k - 1)], [1, 2 * (k - 1) + 1, 2 * k + 1]]);
        }
    }
    to.extra("rail", "iron", &positions, triangles.into_iter());
}
