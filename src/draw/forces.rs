//! Drawings of the net force on each packed cell, and of its potential energy.

use super::layer::CASING;
use super::over::{self, fill_by_scale, lines_of, shapes};
use super::stages::{line_width, mean};
use super::{Colour, Layer};
use crate::packing::{NetForce, Particle};

const ARROW: Colour = [1.0, 0.36, 0.66, 1.0];
/// An arrow's length for a force of 1, in cell sizes.
const LENGTH: f64 = 2.2;
/// The upper limit of an arrow's length, in cell sizes.
const LONGEST: f64 = 1.3;
/// Smaller forces, in cell sizes, are not drawn.
const LEAST: f64 = 0.002;

/// Colours from cells held by their neighbours to cells pressed by them: at the energy of rest, at half of it, and at
/// zero or above.
const HELD: Colour = [0.05, 0.28, 0.50, 0.72];
const HALF: Colour = [0.98, 0.90, 0.55, 0.72];
const PUSHED: Colour = [0.90, 0.16, 0.08, 0.72];
/// The energy of a cell among neighbours at rest, in its k0: with corners and without.
const REST: [f64; 2] = [-0.20, -0.145];
const STEPS: usize = 24;

/// The net force on each cell as an arrow. Its length is the root of the force, so that weak forces are
/// visible.
pub fn forces(loads: &[(Particle, NetForce)]) -> Vec<Layer> {
    let size = mean(loads.iter().map(|(p, _)| p.size));
    let width = 0.9 * line_width(size);
    let (mut shafts, mut heads, mut rims) = (Vec::new(), Vec::new(), Vec::new());
    for (particle, load) in loads {
        if !is_seen(particle, load) {
            continue;
        }
        let force = load.force.length();
        let length = particle.size * (LENGTH * force.sqrt()).min(LONGEST);
        let along = load.force / force;
        let head = (0.5 * length).min(5.0 * width);
        let tip = particle.centre + along * length;
        let neck = tip - along * head;
        let triangle = |reach: f64| {
            let across = along.perp() * (0.5 * head + reach);
            vec![
                tip + along * (1.5 * reach),
                neck - along * reach + across,
                neck - along * reach - across,
            ]
        };
        shafts.push(vec![particle.centre, neck]);
        heads.push(triangle(0.0));
        rims.push(triangle(0.5 * width + 0.3));
    }
    let [rim, shaft] = Layer::cased(shafts, ARROW, width);
    let [rims, heads] =
        [(rims, CASING), (heads, ARROW)].map(|(r, colour)| Layer::fill(r, colour, 0.0));
    vec![rim, rims, shaft, heads]
}

/// Whether no force is large enough for an arrow.
pub fn at_rest(loads: &[(Particle, NetForce)]) -> bool {
    !loads.iter().any(|(particle, load)| is_seen(particle, load))
}

fn is_seen(particle: &Particle, load: &NetForce) -> bool {
    !particle.fixed && load.force.length() >= LEAST
}

/// Each cell filled by its energy: blue if its neighbours hold it, red if they press it. Curves suit a board with
/// `scale` pixels along a unit.
pub fn energy(loads: &[(Particle, NetForce)], scale: usize) -> Vec<Layer> {
    let rings = shapes(&mut loads.iter().map(|(p, _)| p), 0.94, scale);
    let share = |(particle, load): &(Particle, NetForce)| {
        let rest = REST[usize::from(!particle.kind.has_corners())];
        (1.0 - load.energy / rest) as f32
    };
    let shares: Vec<f32> = loads.iter().map(share).collect();
    let filled = fill_by_scale(&rings, &shares, &over::scale([HELD, HALF, PUSHED], STEPS));
    let width = line_width(mean(loads.iter().map(|(p, _)| p.size)));
    vec![filled, Layer::lines(lines_of(&rings), CASING, 0.8 * width)]
}
