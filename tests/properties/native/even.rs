//! Cells are even: no wedges, no rows with doubled stones, and thin tips are packed, too.

use bubblestone::cells::{Cell, fitted};
use bubblestone::domain::{Domain, Outline, signed_area};
use bubblestone::field::{FieldBuilder, FieldParams, Fields};
use bubblestone::metrics::CellMetrics;
use bubblestone::packing::{
    BoundaryCondition, Integrator, Packing, PackingParams, Population, Start,
};
use glam::DVec2;

const SIDE: f64 = 256.0;

fn arc(middle: DVec2, radius: f64, from: f64, to: f64, steps: u32) -> impl Iterator<Item = DVec2> {
    (0..steps).map(move |k| {
        let angle = from + (to - from) * f64::from(k) / f64::from(steps);
        middle + radius * DVec2::new(libm::cos(angle), libm::sin(angle))
    })
}

fn circle(radius: f64) -> Vec<DVec2> {
    let turn = std::f64::consts::TAU;
    arc(DVec2::splat(SIDE / 2.0), radius, 0.0, turn, 90).collect()
}

fn domain(rings: Vec<Vec<DVec2>>) -> Domain {
    let outline = Outline {
        rings,
        ..Outline::default()
    };
    Domain::from_checked(&outline.check(SIDE).unwrap().0)
}

fn ring() -> Domain {
    domain(vec![circle(116.0), circle(52.0)])
}

/// Two arcs that meet in two tips of 13 degrees.
fn crescent() -> Domain {
    let outer = arc(DVec2::new(128.0, 128.0), 120.0, 0.9, 5.4, 60);
    let mut ring: Vec<DVec2> = outer.collect();
    let middle = DVec2::new(158.0, 128.0);
    let tip = DVec2::new(128.0, 128.0) + 120.0 * DVec2::new(libm::cos(5.4), libm::sin(5.4));
    let way = tip - middle;
    let angle = libm::atan2(way.y, way.x);
    let first = ring[0] - middle;
    let last = libm::atan2(first.y, first.x);
    ring.push(tip);
    let inner = arc(
        middle,
        way.length(),
        angle,
        last - std::f64::consts::TAU,
        60,
    );
    ring.extend(inner.skip(1));
    domain(vec![ring])
}

/// A square with a round hole and a square one.
fn holes() -> Domain {
    let square = |lo: f64, hi: f64| {
        let corners = [(lo, lo), (hi, lo), (hi, hi), (lo, hi)];
        corners.map(DVec2::from).to_vec()
    };
    let mut round = circle(30.0);
    round.iter_mut().for_each(|p| *p += DVec2::new(40.0, 40.0));
    domain(vec![square(10.0, 246.0), square(50.0, 100.0), round])
}

fn made(domain: &Domain, size: f64, variance: f64) -> (Fields, Packing, Vec<Cell>) {
    let params = FieldParams {
        size,
        side: SIDE,
        ..FieldParams::default()
    };
    let fields = FieldBuilder::build(domain, params);
    let params = PackingParams {
        boundary: BoundaryCondition::Wall,
        start: Start::Stream,
        integrator: Integrator::SemiImplicit,
        population: Population::Slots,
        variance,
        seed: 1,
        ..PackingParams::DEFAULT
    };
    let mut packing = Packing::new(domain, &fields, params).unwrap();
    while !packing.done() {
        packing.step(domain, &fields);
    }
    let cells = fitted(domain, &packing.particles());
    (fields, packing, cells)
}

#[test]
fn no_cell_is_a_wedge() {
    for domain in [ring(), holes()] {
        for size in [9.0, 11.5, 13.0, 19.0] {
            let (fields, _, cells) = made(&domain, size, 0.0);
            let sides = CellMetrics::new(&domain, &fields, &cells).sides;
            assert_eq!(sides[..4], [0; 4], "{size}");
        }
    }
}

#[test]
fn rows_of_a_ring_have_no_double_stones() {
    let domain = ring();
    let (fields, _, cells) = made(&domain, 11.5, 0.0);
    let mean = domain.area() / cells.len() as f64;
    let areas = cells.iter().map(|c| signed_area(&c.ring) / mean);
    let largest = areas.fold(0.0, f64::max);
    assert!(largest < 1.5, "{largest}");
    let spread = CellMetrics::new(&domain, &fields, &cells).area_cv;
    assert!(spread < 0.125, "{spread}");
}

#[test]
fn thin_tips_are_packed() {
    let domain = crescent();
    for size in [8.0, 13.0] {
        let (_, packing, _) = made(&domain, size, 0.0);
        let particles = packing.particles();
        for k in 0..256 * 256 {
            let p = DVec2::new(f64::from(k % 256), f64::from(k / 256)) + 0.5;
            if domain.nearest(p).distance < 0.3 * size {
                continue;
            }
            let ways = particles.iter().map(|q| q.centre.distance(p) / size);
            let nearest = ways.fold(f64::INFINITY, f64::min);
            assert!(nearest < 1.0, "{size}: nothing near {p}, {nearest}");
        }
    }
}

#[test]
fn larger_cells_take_more_of_the_way_to_their_neighbours() {
    let domain = holes();
    let (fields, _, cells) = made(&domain, 13.0, 0.2);
    let metrics = CellMetrics::new(&domain, &fields, &cells);
    assert!(metrics.size_error < 0.215, "{}", metrics.size_error);
}
