//! Fitted cells at constraint lines and on the periodic picture.

use bubblestone::cells::{Cell, fitted};
use bubblestone::domain::{Domain, Outline, cross, signed_area};
use bubblestone::field::{CellKind, Direction, FieldBuilder, FieldParams};
use bubblestone::packing::{
    BoundaryCondition, Integrator, Packing, PackingParams, Particle, Population, Start,
};
use bubblestone::random::{Purpose, Random};
use glam::DVec2;
use std::collections::HashMap;

const SIDE: f64 = 256.0;

fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn packed(domain: &Domain, size: f64, boundary: BoundaryCondition) -> Vec<Particle> {
    let torus = domain.space().period().is_some();
    let params = FieldParams {
        direction: if torus {
            Direction::Constant
        } else {
            Direction::Boundary
        },
        power: 2,
        size,
        side: SIDE,
        ..FieldParams::default()
    };
    let fields = FieldBuilder::build(domain, params);
    let params = PackingParams {
        boundary,
        start: Start::Stream,
        integrator: Integrator::SemiImplicit,
        population: Population::Slots,
        variance: 0.0,
        seed: 1,
        ..PackingParams::DEFAULT
    };
    let mut packing = Packing::new(domain, &fields, params).unwrap();
    for _ in 0..40 {
        packing.step(domain, &fields);
    }
    packing.particles()
}

/// Whether two sides of a ring that are not neighbours cross.
fn crosses_itself(ring: &[DVec2]) -> bool {
    let n = ring.len();
    let side = |k: usize| [ring[k], ring[(k + 1) % n]];
    (0..n).any(|i| {
        (i + 2..n).any(|j| {
            let ([a, b], [c, d]) = (side(i), side(j));
            let apart = |u: f64, v: f64| (u > 1e-6 && v < -1e-6) || (u < -1e-6 && v > 1e-6);
            apart(cross(a, b, c), cross(a, b, d)) && apart(cross(c, d, a), cross(c, d, b))
        })
    })
}

/// Asserts that cells fill the domain, and that each one is simple and lies in one part.
fn assert_sound(domain: &Domain, cells: &[Cell], what: &str) {
    let area: f64 = cells.iter().map(|c| signed_area(&c.ring)).sum();
    let error = (area / domain.area() - 1.0).abs();
    assert!(error < 1e-6, "{what}: the area is off by {error:e}");
    let mut by_part = vec![0.0; domain.parts()];
    for cell in cells {
        assert!(
            signed_area(&cell.ring) > 0.0,
            "{what}: {} inverted",
            cell.id
        );
        assert!(
            !crosses_itself(&cell.ring),
            "{what}: {} crosses itself {:?}",
            cell.id,
            cell.ring
        );
        // For bent cells, a triangle fan would not do. Instead the test takes a point just inside the middle of
        // every side.
        let mut part = None;
        for (k, &a) in cell.ring.iter().enumerate() {
            let b = cell.ring[(k + 1) % cell.ring.len()];
            let inwards = (b - a).normalize().perp() * 1e-3;
            if a.distance(b) > 0.1 {
                let here = domain.part(a.midpoint(b) + inwards);
                assert_eq!(
                    *part.get_or_insert(here),
                    here,
                    "{what}: {} in two parts {:?}",
                    cell.id,
                    cell.ring
                );
            }
        }
        by_part[part.unwrap_or(0)] += signed_area(&cell.ring);
    }
    for (part, &area) in by_part.iter().enumerate() {
        let steps = 0..(SIDE * SIDE * 16.0) as u32;
        let square = |k: u32| p(f64::from(k % 1024), f64::from(k / 1024)) / 4.0 + 0.125;
        let inside = |q: &DVec2| domain.nearest(*q).distance > 0.0 && domain.part(*q) == part;
        if area == 0.0 {
            let found: Vec<DVec2> = steps.map(square).filter(inside).collect();
            panic!(
                "{what}: part {part} is empty: {} {:?}",
                found.len(),
                found.first()
            );
        }
    }
}

fn random_outline(random: &mut Random) -> Outline {
    let count = 3 + random.below(6);
    let outer = (0..count).map(|k| {
        let angle = (k as f64 + 0.5 * random.unit()) / count as f64 * std::f64::consts::TAU;
        let radius = SIDE * (0.25 + 0.2 * random.unit());
        p(128.0, 128.0) + radius * p(libm::cos(angle), libm::sin(angle))
    });
    let outer = outer.collect();
    let mut point = || p(SIDE * random.unit(), SIDE * random.unit());
    let lines = (0..3).map(|k| (0..2 + k).map(|_| point()).collect());
    Outline {
        rings: vec![outer],
        lines: lines.collect(),
    }
}

#[test]
fn cells_fill_random_outlines_with_random_lines() {
    let mut random = Random::new(3, Purpose::Noise, 0);
    for k in 0..60 {
        let Ok((outline, _)) = random_outline(&mut random).check(SIDE) else {
            continue;
        };
        let domain = Domain::from_checked(&outline);
        let size = [9.0, 14.0, 30.0, 70.0][k % 4];
        let boundary = if k % 3 == 0 {
            BoundaryCondition::On
        } else {
            BoundaryCondition::Wall
        };
        let particles = packed(&domain, size, boundary);
        if particles.is_empty() {
            continue;
        }
        let cells = fitted(&domain, &particles);
        assert_sound(&domain, &cells, &format!("{k}: {outline:?} {size}"));
        assert_eq!(cells, fitted(&domain, &particles));
    }
}

/// The rows of squares on the two sides of a line are shifted against each other; every cell ends at the line.
#[test]
fn each_side_of_a_line_has_its_own_cells() {
    let outline = Outline {
        rings: vec![vec![p(0., 0.), p(200., 0.), p(200., 160.), p(0., 160.)]],
        lines: vec![vec![p(-10., 80.), p(210., 80.)]],
    };
    let domain = Domain::from_checked(&outline.check(SIDE).unwrap().0);
    let mut particles = Vec::new();
    let mut row = |count: u32, y: f64| {
        for k in 0..count {
            let size = 200.0 / f64::from(count);
            particles.push(Particle {
                id: particles.len() as u32,
                centre: p((f64::from(k) + 0.5) * size, y),
                kind: bubblestone::field::CellKind::default(),
                size,
                aspect: 1.0,
                axis: DVec2::X,
                fixed: false,
            });
        }
    };
    for y in [10., 30., 50., 70.] {
        row(10, y);
    }
    for y in [80. + 40. / 3., 120., 160. - 40. / 3.] {
        row(7, y);
    }
    let cells = fitted(&domain, &particles);
    assert_sound(&domain, &cells, "rows");
    assert_eq!(cells.len(), particles.len());
    for cell in &cells {
        let area = signed_area(&cell.ring) / (cell.size * cell.size);
        assert!((0.8..1.2).contains(&area), "{} {area}", cell.id);
    }
}

/// Asserts that every side of every ring is also a side of another ring, up to a period.
fn assert_seamless(domain: &Domain, cells: &[Cell], what: &str) {
    let bits = |q: DVec2| (q.x.to_bits(), q.y.to_bits());
    let mut sides = HashMap::new();
    for cell in cells {
        for (k, &a) in cell.ring.iter().enumerate() {
            let b = cell.ring[(k + 1) % cell.ring.len()];
            let ends = [a, b].map(|q| bits(domain.space().wrap(q)));
            *sides.entry(ends).or_insert(0) += 1;
        }
    }
    for (&[a, b], &count) in &sides {
        assert_eq!(sides.get(&[b, a]), Some(&count), "{what}");
    }
    let area: f64 = cells.iter().map(|c| signed_area(&c.ring)).sum();
    assert!((area - SIDE * SIDE).abs() < 1e-6, "{what}: {area}");
    for cell in cells {
        assert!(signed_area(&cell.ring) > 0.0 && !crosses_itself(&cell.ring));
        assert_eq!(domain.space().wrap(cell.centre), cell.centre);
    }
}

#[test]
fn cells_of_a_torus_meet_over_the_seams() {
    let domain = Domain::torus(SIDE, &[]);
    let mut random = Random::new(5, Purpose::Noise, 0);
    for k in 0..30 {
        // The first lattices are regular, later ones more and more irregular; the number of cells varies from 4
        // to 400.
        let across = [2, 3, 5, 11, 20][k % 5];
        let size = SIDE / f64::from(across);
        let disorder = 0.05 * size * (k / 5) as f64;
        let particles: Vec<Particle> = (0..across * across)
            .map(|id| Particle {
                id,
                centre: domain.space().wrap(
                    p(f64::from(id % across), f64::from(id / across)) * size
                        + disorder * p(random.signed(), random.signed()),
                ),
                kind: CellKind::default(),
                size,
                aspect: 1.0,
                axis: DVec2::X,
                fixed: false,
            })
            .collect();
        let cells = fitted(&domain, &particles);
        assert_eq!(cells.len(), particles.len());
        assert_seamless(&domain, &cells, &format!("{k}"));
        assert_eq!(cells, fitted(&domain, &particles));
    }
    for size in [9.0, 14.0, 30.0, 70.0] {
        let particles = packed(&domain, size, BoundaryCondition::Wall);
        let cells = fitted(&domain, &particles);
        assert_seamless(&domain, &cells, &format!("packed {size}"));
    }
}

/// On a torus, too, cells end at constraint lines and meet across the seams.
#[test]
fn cells_of_a_torus_end_at_lines() {
    let lines = [
        vec![
            vec![p(0., 60.), p(90., 80.), p(256., 60.)],
            vec![p(0., 170.), p(256., 170.)],
        ],
        vec![vec![p(60., 60.), p(180., 70.), p(130., 200.), p(60., 60.)]],
        vec![vec![
            p(200., -40.),
            p(330., 60.),
            p(180., 90.),
            p(200., -40.),
        ]],
    ];
    for lines in lines {
        let domain = Domain::torus(SIDE, &lines);
        assert_eq!(domain.parts(), 2, "{lines:?}");
        // If cells stand on a line at a sharp corner, slivers may be left at the line.
        let sharp = lines[0][0].x == 200.0;
        let conditions = [BoundaryCondition::Wall, BoundaryCondition::On];
        for size in [9.0, 14.0, 30.0] {
            for &boundary in &conditions[..if sharp { 1 } else { 2 }] {
                let particles = packed(&domain, size, boundary);
                let cells = fitted(&domain, &particles);
                let what = format!("{size} {boundary:?} {lines:?}");
                assert_seamless(&domain, &cells, &what);
                assert_sound(&domain, &cells, &what);
                assert_eq!(cells, fitted(&domain, &particles));
            }
        }
    }
}
