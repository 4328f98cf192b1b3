//! Upright walls over a plan: a block, a ring of walls, a single wall.

use super::Module;
use super::drafting::{Drafting, flat_surface};
use crate::building::draft::{Draft, DraftFace};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// The place over a point of a plan. The plan's y runs towards -z, so a plan that is counter-clockwise in x and y is so
/// seen from above, too.
pub(super) fn over(p: DVec2, y: f64) -> DVec3 {
    DVec3::new(p.x, y, -p.y)
}

/// The plan at a height.
fn level(plan: &[DVec2], y: f64) -> Vec<DVec3> {
    plan.iter().map(|&p| over(p, y)).collect()
}

/// The plan at a height, clockwise seen from above.
pub(super) fn turned(plan: &[DVec2], y: f64) -> Vec<DVec3> {
    let mut level = level(plan, y);
    level.reverse();
    level
}

/// The sides of a plan, each from its left end to its right end seen from outside.
pub(super) fn sides(plan: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    let next = plan.iter().cycle().skip(1);
    plan.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// Adds a wall without openings over each side of a plan.
fn add_walls(to: &mut Drafting, plan: &[DVec2], top: f64) {
    for [a, b] in sides(plan) {
        to.flat(
            &[],
            &[vec![over(a, 0.0), over(b, 0.0), over(b, top), over(a, top)]],
        );
    }
}

/// A rectangle of whole modules, less a joint, around the origin.
fn rectangle(module: &Module, length: f64, width: f64) -> Vec<DVec2> {
    let half = 0.5 * DVec2::new(module.pier(length), module.pier(width));
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    corners.map(|corner| DVec2::from(corner) * half).to_vec()
}

pub(super) fn block(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let (plan, top) = (rectangle(module, n[0], n[1]), module.top(n[2]));
    add_walls(&mut to, &plan, top);
    to.flat(&[], &[level(&plan, top)]);
    to.flat(&[], &[turned(&plan, 0.0)]);
    to.on_ground()
}

pub(super) fn ring(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let (top, count) = (module.top(n[2]), n[0]);
    let sine = libm::sin(PI / count);
    let radius = module.pier(n[1]) / (2.0 * sine);
    // The thickness is measured at right angles to the walls.
    let inner = radius - module.pier(n[3]) / libm::cos(PI / count);
    let circle = |radius: f64| -> Vec<DVec2> {
        let corner = |k: u32| {
            let (sin, cos) = libm::sincos(TAU * (f64::from(k) - 0.5) / count - 0.5 * PI);
            DVec2::new(cos, sin) * radius
        };
        (0..count as u32).map(corner).collect()
    };
    let (outside, mut inside) = (circle(radius), circle(inner));
    add_walls(&mut to, &outside, top);
    inside.reverse();
    add_walls(&mut to, &inside, top);
    to.flat(&[], &[level(&outside, top), level(&inside, top)]);
    to.flat(&[], &[turned(&outside, 0.0), turned(&inside, 0.0)]);
    to.on_ground()
}

pub(super) fn sheet(module: &Module, n: &[f64]) -> Draft {
    let mut to = Drafting::default();
    let (half, top) = (0.5 * module.pier(n[0]), module.top(n[1]));
    let corners = [(-half, 0.0), (half, 0.0), (half, top), (-half, top)];
    let corners = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    let surface = flat_surface(&corners);
    to.face(&[], surface, &[corners]);
    let thickness = Some(module.pier(n[2]));
    to.draft
        .faces
        .iter_mut()
        .for_each(|face: &mut DraftFace| face.thickness = thickness);
    to.on_ground()
}
