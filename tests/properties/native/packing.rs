//! Properties of packings and their cells on many outlines.

use bubblestone::cells::{Cell, fitted, packed};
use bubblestone::domain::{Domain, Outline, signed_area};
use bubblestone::field::{CellKind, FieldBuilder, FieldParams, Fields};
use bubblestone::mesh::Mesh;
use bubblestone::packing::{
    BoundaryCondition, Integrator, Packing, PackingParams, Particle, Physics, Population, Start,
    StepReport,
};
use glam::DVec2;

const SIZES: [f64; 2] = [23.0, 8.0];

const PARAMS: PackingParams = PackingParams {
    boundary: BoundaryCondition::Wall,
    start: Start::Stream,
    integrator: Integrator::SemiImplicit,
    population: Population::Slots,
    variance: 0.0,
    seed: 1,
    count: 0,
    given: Vec::new(),
    jolt: 0.0,
    physics: Physics::DEFAULT,
};

fn ring(value: &serde_json::Value) -> Vec<DVec2> {
    let points = value.as_array().expect("a ring").iter();
    points
        .map(|p| DVec2::new(p[0].as_f64().unwrap(), p[1].as_f64().unwrap()))
        .collect()
}

/// The outlines in tests/data, by name.
fn outlines() -> Vec<(String, Domain)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|word| word == "json"))
        .collect();
    files.sort();
    files
        .into_iter()
        .map(|file| {
            let text = std::fs::read_to_string(&file).unwrap();
            let value: serde_json::Value = serde_json::from_str(&text).unwrap();
            let rings = |name: &str| value[name].as_array().unwrap().iter().map(ring);
            let outline = Outline {
                rings: std::iter::once(ring(&value["outer"]))
                    .chain(rings("holes"))
                    .collect(),
                ..Outline::default()
            };
            let (checked, _) = outline.check(512.0).unwrap();
            let name = value["name"].as_str().unwrap().to_owned();
            (name, Domain::from_checked(&checked))
        })
        .collect()
}

fn fields(domain: &Domain, size: f64) -> Fields {
    let params = FieldParams {
        size,
        ..FieldParams::default()
    };
    FieldBuilder::build(domain, params)
}

fn run(domain: &Domain, fields: &Fields, params: PackingParams) -> (Vec<Particle>, StepReport) {
    let mut packing = Packing::new(domain, fields, params).unwrap();
    while !packing.done() {
        let report = packing.step(domain, fields);
        assert!(report.largest_move.is_finite() && report.largest_force.is_finite());
    }
    (packing.particles(), packing.report())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn contains(ring: &[DVec2], p: DVec2) -> bool {
    let mut inside = false;
    for k in 0..ring.len() {
        let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            inside = !inside;
        }
    }
    inside
}

/// Asserts that every cell is a ring inside the outline, and that together they cover it once.
fn assert_fills(name: &str, domain: &Domain, cells: &[Cell]) {
    let mut sum = 0.0;
    for cell in cells {
        let area = signed_area(&cell.ring);
        assert!(
            cell.ring.len() >= 3 && area > 0.0,
            "{name}: cell {} has area {area}",
            cell.id
        );
        sum += area;
        for &p in &cell.ring {
            let depth = domain.nearest(p).distance;
            assert!(
                depth > -2e-3,
                "{name}: {p} of cell {} lies {depth} outside",
                cell.id
            );
        }
    }
    assert!(
        (sum / domain.area() - 1.0).abs() < 1e-4,
        "{name}: cells {sum}, outline {}",
        domain.area()
    );
    let (lo, hi) = domain.bounds();
    let mut wrong = 0;
    for k in 0..900 {
        let t = DVec2::new(f64::from(k % 30) + 0.513, f64::from(k / 30) + 0.487) / 30.0;
        let p = lo + (hi - lo) * t;
        if domain.nearest(p).distance.abs() > 0.01 {
            let count = cells.iter().filter(|c| contains(&c.ring, p)).count();
            wrong += usize::from(count != usize::from(domain.contains(p)));
        }
    }
    // A point on a side of two cells may count for both or for neither.
    assert!(
        wrong <= 2,
        "{name}: {wrong} of 900 points are not in just one cell"
    );
}

#[test]
fn fitted_cells_fill_every_outline() {
    for size in SIZES {
        let mut steps = Vec::new();
        for (name, domain) in outlines() {
            let fields = fields(&domain, size);
            let (particles, report) = run(&domain, &fields, PARAMS);
            assert!(report.converged && report.step <= 200, "{name}: {report:?}");
            steps.push(f64::from(report.step));
            let cells = fitted(&domain, &particles);
            assert_fills(&name, &domain, &cells);
            let areas: Vec<f64> = cells.iter().map(|c| signed_area(&c.ring)).collect();
            let typical = median(areas.clone());
            let small = areas.iter().filter(|&&a| a < 0.5 * typical).count();
            assert!(
                small as f64 <= 0.04 * areas.len() as f64,
                "{name}: {small} small cells"
            );
            let expected = domain.area() / (size * size);
            let ratio = cells.len() as f64 / expected;
            assert!(
                (0.8..1.35).contains(&ratio),
                "{name}: {ratio} of the cells expected"
            );
        }
        let typical = median(steps);
        assert!(typical <= 60.0, "median steps {typical} at size {size}");
    }
}

#[test]
fn cells_of_very_different_sizes_fill_every_outline_too() {
    for (name, domain) in outlines() {
        for (size, variance, linear, radial) in [
            (23.0, 0.3, 0.0, 0.0),
            (9.0, 0.5, 0.6, 0.5),
            (70.0, 0.4, -0.8, -0.5),
        ] {
            let params = FieldParams {
                linear: DVec2::new(linear, 0.2),
                radial,
                ..fields(&domain, size).params().clone()
            };
            let fields = FieldBuilder::build(&domain, params);
            let params = PackingParams { variance, ..PARAMS };
            let (particles, report) = run(&domain, &fields, params);
            assert!(report.step <= 200);
            assert_fills(
                &format!("{name} {size}"),
                &domain,
                &fitted(&domain, &particles),
            );
        }
    }
}

#[test]
fn packed_squares_cover_the_outlines() {
    for (name, domain) in outlines() {
        let fields = fields(&domain, 23.0);
        let (particles, _) = run(&domain, &fields, PARAMS);
        let cells = packed(&particles);
        let (lo, hi) = domain.bounds();
        let (mut inside, mut covered, mut twice) = (0, 0, 0);
        for k in 0..10_000 {
            let t = DVec2::new(f64::from(k % 100) + 0.5, f64::from(k / 100) + 0.5) / 100.0;
            let p = lo + (hi - lo) * t;
            if domain.contains(p) {
                let count = cells.iter().filter(|c| contains(&c.ring, p)).count();
                inside += 1;
                covered += usize::from(count > 0);
                twice += count.saturating_sub(1);
            }
        }
        let share = |n: usize| n as f64 / f64::from(inside);
        assert!(share(covered) > 0.88, "{name}: coverage {}", share(covered));
        assert!(share(twice) < 0.11, "{name}: overlap {}", share(twice));
    }
}

#[test]
fn every_way_of_packing_ends_in_a_valid_packing() {
    let domain = outlines()
        .into_iter()
        .find(|(name, _)| name == "plaza")
        .unwrap()
        .1;
    for size in [150.0, 40.0, 15.0] {
        let fields = fields(&domain, size);
        for boundary in [BoundaryCondition::Wall, BoundaryCondition::On] {
            for start in [Start::Stream, Start::Quadtree] {
                for integrator in [Integrator::SemiImplicit, Integrator::RungeKutta] {
                    for population in [Population::Slots, Population::Smallest, Population::Off] {
                        let params = PackingParams {
                            boundary,
                            start,
                            integrator,
                            population,
                            variance: if start == Start::Stream { 0.2 } else { 0.0 },
                            seed: 5,
                            ..PARAMS
                        };
                        let (particles, report) = run(&domain, &fields, params.clone());
                        assert!(report.step <= 200);
                        let cells = fitted(&domain, &particles);
                        assert_fills(&format!("{size} {params:?}"), &domain, &cells);
                    }
                }
            }
        }
    }
}

#[test]
fn the_same_packing_comes_out_every_time_and_another_for_another_seed() {
    let domain = outlines()
        .into_iter()
        .find(|(name, _)| name == "road_s")
        .unwrap()
        .1;
    let fields = fields(&domain, 18.0);
    let with = |seed| PackingParams {
        variance: 0.3,
        seed,
        ..PARAMS
    };
    let first = run(&domain, &fields, with(1));
    assert_eq!(first, run(&domain, &fields, with(1)));
    assert_ne!(first.0, run(&domain, &fields, with(2)).0);
}

#[test]
fn relaxing_lowers_the_energy() {
    let domain = outlines()
        .into_iter()
        .find(|(name, _)| name == "star")
        .unwrap()
        .1;
    let fields = fields(&domain, 15.0);
    let params = PackingParams {
        start: Start::Quadtree,
        population: Population::Off,
        ..PARAMS
    };
    let mut packing = Packing::new(&domain, &fields, params).unwrap();
    let before = packing.energy(&domain);
    while !packing.done() {
        packing.step(&domain, &fields);
    }
    assert!(
        packing.energy(&domain) < before,
        "{before} to {}",
        packing.energy(&domain)
    );
}

#[test]
fn sizes_have_the_variance_asked_for() {
    let domain = outlines()
        .into_iter()
        .find(|(name, _)| name == "square")
        .unwrap()
        .1;
    let fields = fields(&domain, 12.0);
    let params = PackingParams {
        variance: 0.3,
        population: Population::Off,
        ..PARAMS
    };
    let (particles, _) = run(&domain, &fields, params);
    let n = particles.len() as f64;
    let mean = particles.iter().map(|p| p.size / 12.0).sum::<f64>() / n;
    let square = particles
        .iter()
        .map(|p| (p.size / 12.0 - mean) * (p.size / 12.0 - mean))
        .sum::<f64>()
        / n;
    assert!(
        (mean - 1.0).abs() < 0.03 && (square.sqrt() - 0.3).abs() < 0.03,
        "{mean} {square}"
    );
}

#[test]
fn centres_on_the_boundary_stay_there() {
    for (name, domain) in outlines() {
        let fields = fields(&domain, 20.0);
        let (particles, _) = run(
            &domain,
            &fields,
            PackingParams {
                boundary: BoundaryCondition::On,
                ..PARAMS
            },
        );
        let fixed: Vec<_> = particles.iter().filter(|p| p.fixed).collect();
        assert!(fixed.len() > 8, "{name}: {} on the boundary", fixed.len());
        for p in fixed {
            assert!(
                domain.nearest(p.centre).distance.abs() < 1e-6,
                "{name}: {}",
                p.centre
            );
        }
        let mesh = Mesh::build(&domain, &particles);
        let quads = mesh.faces.iter().filter(|f| f.nodes().len() == 4).count();
        assert!(
            2 * quads > mesh.faces.len(),
            "{name}: {quads} quads of {}",
            mesh.faces.len()
        );
        for face in &mesh.faces {
            let corners: Vec<DVec2> = face
                .nodes()
                .iter()
                .map(|&k| mesh.vertices[k as usize])
                .collect();
            assert!(signed_area(&corners) > 0.0, "{name}");
        }
        assert_fills(&name, &domain, &fitted(&domain, &particles));
    }
}

#[test]
fn too_many_cells_get_a_sentence() {
    let (_, domain) = outlines().swap_remove(0);
    let fields = fields(&domain, 0.5);
    let why = Packing::new(&domain, &fields, PARAMS).unwrap_err();
    assert!(why.to_string().contains("Choose larger cells"), "{why}");
}

/// A line in the middle of a tile does not separate cells across the tile's edges.
#[test]
fn cells_keep_apart_over_the_edges_of_a_tile_with_a_line() {
    for [from, to] in [
        [(150.0, 60.0), (160.0, 240.0)],
        [(60.0, 90.0), (240.0, 180.0)],
        [(40.0, 160.0), (250.0, 120.0)],
    ] {
        let line = [from, to].map(DVec2::from).to_vec();
        let torus = Domain::torus(300.0, &[line]);
        for kind in [CellKind::Square, CellKind::Circle] {
            let params = FieldParams {
                size: 20.0,
                kind,
                ..FieldParams::default()
            };
            let fields = FieldBuilder::build(&torus, params);
            let first = Packing::new(&torus, &fields, PARAMS).unwrap().particles();
            assert!(least_way(&torus, &first) > 0.5 * 20.0);
            // Cells that repel each other come to rest apart.
            let (last, _) = run(&torus, &fields, PARAMS);
            assert!(least_way(&torus, &last) > 0.75 * 20.0, "{kind:?}");
        }
    }
}

/// The least distance of two centres that no line separates.
fn least_way(torus: &Domain, particles: &[Particle]) -> f64 {
    let mut least = f64::INFINITY;
    for (k, a) in particles.iter().enumerate() {
        for b in &particles[..k] {
            let way = torus.space().shortest(b.centre - a.centre);
            if !torus.crosses_line(a.centre, a.centre + way) {
                least = least.min(way.length());
            }
        }
    }
    least
}
