//! The physics of packings: pairs of bubbles, the integrators, and the forces and potentials they follow.

use crate::common::packed;
use bubblestone::domain::{Domain, Outline};
use bubblestone::field::{CellKind, FieldBuilder, FieldParams, Fields};
use bubblestone::generators::ALL;
use bubblestone::mesh::Mesh;
use bubblestone::metrics::smallest_angles;
use bubblestone::notice::{Arg, Code};
use bubblestone::packing::force::{Pair, bubble_force, bubble_potential};
use bubblestone::packing::{
    BoundaryCondition, CornerBubbles, GivenCell, History, Integrator, Packing, PackingParams,
    Particle, Physics, Population, Start,
};
use bubblestone::studio::Studio;
use glam::DVec2;

/// The size of all cells.
const SIZE: f64 = 32.0;

/// A square of 512.
fn square() -> Domain {
    let corners = [(0.0, 0.0), (512.0, 0.0), (512.0, 512.0), (0.0, 512.0)];
    Domain::from_checked(&Outline {
        rings: vec![corners.map(DVec2::from).to_vec()],
        ..Outline::default()
    })
}

fn fields(domain: &Domain, kind: CellKind) -> Fields {
    let params = FieldParams {
        size: SIZE,
        kind,
        ..FieldParams::default()
    };
    FieldBuilder::build(domain, params)
}

/// A held bubble and a free one, `w` stable distances apart, far from all walls.
fn two(w: f64, integrator: Integrator, physics: Physics) -> PackingParams {
    let place = |x: f64| DVec2::new(x, 256.0);
    let cell = |centre, is_held| GivenCell { centre, is_held };
    PackingParams {
        boundary: BoundaryCondition::Open,
        population: Population::Off,
        given: vec![
            cell(place(128.0), true),
            cell(place(128.0 + w * SIZE), false),
        ],
        integrator,
        physics,
        ..PackingParams::DEFAULT
    }
}

/// The distances of two bubbles after each step, in stable distances.
fn distances(params: PackingParams) -> Vec<f64> {
    let domain = square();
    let fields = fields(&domain, CellKind::Circle);
    let mut packing = Packing::new(&domain, &fields, params).unwrap();
    let mut found = Vec::new();
    while !packing.done() {
        packing.step(&domain, &fields);
        let cells = packing.particles();
        found.push(cells[0].centre.distance(cells[1].centre) / SIZE);
    }
    found
}

#[test]
fn the_force_is_that_of_the_papers() {
    assert_eq!(bubble_force(0.0), 9.0 / 8.0);
    assert!(bubble_force(1.0).abs() < 1e-12 && bubble_force(1.5).abs() < 1e-12);
    assert!(bubble_force(1.5 - 1e-9).abs() < 1e-8 && bubble_potential(1.5) == 0.0);
    let strongest = bubble_force(19.0 / 15.0);
    for k in 0..500 {
        let w = 1.0 + f64::from(k) / 1000.0;
        assert!(bubble_force(w) >= strongest, "{w}");
        let slope = (bubble_potential(w + 1e-6) - bubble_potential(w - 1e-6)) / 2e-6;
        assert!((slope + bubble_force(w)).abs() < 1e-6, "{w}");
    }
}

#[test]
fn without_damping_a_bubble_parts_from_0_713_on_and_not_from_0_723() {
    let physics = Physics {
        damping: Some(0.0),
        time_step: Some(0.05),
        most_steps: 4000,
        force_end: 0.0,
        ..Physics::DEFAULT
    };
    let far = |w: f64| distances(two(w, Integrator::RungeKutta, physics));
    let parted = far(0.713);
    assert!(
        parted.iter().skip(1000).all(|&w| w > 1.5),
        "{:?}",
        parted.last()
    );
    let held = far(0.723);
    assert!(held.len() == 4000 && held.iter().all(|&w| w < 1.5));
}

#[test]
fn explicit_euler_rests_rings_or_flies_by_its_step() {
    let with = |integrator, step: f64, most_steps: u32| {
        let physics = Physics {
            damping: Some(0.5),
            time_step: Some(step),
            most_steps,
            // The run goes on, however still it is.
            move_end: 0.0,
            ..Physics::DEFAULT
        };
        distances(two(0.9, integrator, physics))
    };
    let is_at_rest = |all: &[f64]| all.iter().all(|w| (w - 1.0).abs() < 0.02);
    assert!(is_at_rest(&with(Integrator::Euler, 0.2, 200)[100..]));
    let rings = with(Integrator::Euler, 0.55, 1100);
    let last = &rings[1000..];
    let range = last
        .iter()
        .fold((9.0_f64, 0.0_f64), |(a, b), &w| (a.min(w), b.max(w)));
    assert!(range.1 - range.0 > 0.3 && range.1 < 1.5, "{range:?}");
    let flies = with(Integrator::Euler, 1.0, 1000);
    assert!(flies[200..].iter().all(|&w| w.is_finite() && w > 1.5));
    for integrator in [Integrator::SemiImplicit, Integrator::RungeKutta] {
        let rests = with(integrator, 1.0, 40);
        assert!(is_at_rest(&rests[20..]), "{integrator:?} {rests:?}");
    }
}

#[test]
fn an_explosion_stays_finite_and_is_noted() {
    let domain = square();
    for (damping, mass, boundary) in [
        (0.5, 1.0, BoundaryCondition::Wall),
        (10.0, 0.1, BoundaryCondition::Wall),
        (10.0, 0.1, BoundaryCondition::Open),
    ] {
        for integrator in [Integrator::Euler, Integrator::RungeKutta] {
            let physics = Physics {
                damping: Some(damping),
                mass,
                stiffness: 10.0,
                time_step: Some(2.0),
                ..Physics::DEFAULT
            };
            let params = PackingParams {
                boundary,
                integrator,
                physics,
                ..PackingParams::DEFAULT
            };
            let fields = fields(&domain, CellKind::Square);
            let mut packing = Packing::new(&domain, &fields, params).unwrap();
            while !packing.done() {
                let report = packing.step(&domain, &fields);
                assert!(report.largest_move.is_finite() && report.largest_force.is_finite());
                assert!(packing.energy_parts(&domain).sum().is_finite());
            }
            assert!(
                packing
                    .particles()
                    .iter()
                    .all(|cell| cell.centre.is_finite())
            );
            assert!(
                packing.report().flown_at > 0,
                "{damping} {mass} {integrator:?}"
            );
        }
    }
}

#[test]
fn mass_and_stiffness_only_scale_time() {
    let with = |mass, stiffness, damping, step| {
        let physics = Physics {
            damping: Some(damping),
            mass,
            stiffness,
            time_step: Some(step),
            move_end: 0.0,
            most_steps: 60,
            ..Physics::DEFAULT
        };
        distances(two(0.6, Integrator::RungeKutta, physics))
    };
    let plain = with(1.0, 1.0, 0.5, 0.1);
    let heavy = with(4.0, 1.0, 1.0, 0.2);
    let stiff = with(1.0, 4.0, 1.0, 0.05);
    for k in 0..plain.len() {
        assert!((plain[k] - heavy[k]).abs() < 1e-9 && (plain[k] - stiff[k]).abs() < 1e-9);
    }
}

/// The barrier between two wells of a square, in k0: the lowest saddle on the way around a corner.
fn barrier(corners: CornerBubbles) -> f64 {
    let cell = Particle {
        id: 0,
        centre: DVec2::ZERO,
        kind: CellKind::Square,
        size: 1.0,
        aspect: 1.0,
        axis: DVec2::X,
        fixed: false,
    };
    let pair = Pair::new(&cell, &cell).with(corners);
    let least = |along: DVec2| {
        let at = |k: u32| pair.potential(along * (0.8 + f64::from(k) * 1e-4));
        (0..8000).map(at).fold(f64::INFINITY, f64::min)
    };
    let well = pair.potential(DVec2::X);
    assert!((least(DVec2::X) - well).abs() < 1e-7, "wells are at w = 1");
    least(DVec2::ONE.normalize()) - well
}

#[test]
fn the_barrier_between_wells_grows_with_the_weight_of_corners() {
    let with = |weight| barrier(CornerBubbles::new(weight, std::f64::consts::SQRT_2 - 1.0));
    for (weight, wanted) in [(0.0, 0.0), (0.05, 0.0090)] {
        assert!(
            (with(weight) - wanted).abs() < 1e-4,
            "{weight}: {}",
            with(weight)
        );
    }
    let papers = barrier(CornerBubbles::PAPERS);
    assert!((papers - 0.0460).abs() < 1e-4, "{papers}");
}

#[test]
fn the_energy_of_all_parts_falls_while_that_of_the_pairs_may_rise() {
    let domain = square();
    let fields = fields(&domain, CellKind::Circle);
    let physics = Physics {
        damping: Some(0.5),
        time_step: Some(0.05),
        most_steps: 400,
        ..Physics::DEFAULT
    };
    let params = PackingParams {
        start: Start::Random,
        count: 40,
        population: Population::Off,
        integrator: Integrator::RungeKutta,
        physics,
        ..PackingParams::DEFAULT
    };
    let mut packing = Packing::new(&domain, &fields, params).unwrap();
    let mut last = packing.energy_parts(&domain);
    let mut rises = 0;
    while !packing.done() {
        packing.step(&domain, &fields);
        let parts = packing.energy_parts(&domain);
        let sum = parts.sum();
        assert!(sum <= last.sum() + 1e-6 * sum.abs(), "{last:?} {parts:?}");
        rises += u32::from(parts.pairs > last.pairs);
        last = parts;
    }
    assert!(rises > 0 && packing.particles().len() == 40);
}

#[test]
fn given_cells_and_no_others_are_packed() {
    let domain = square();
    let fields = fields(&domain, CellKind::Circle);
    let cell = |x, y, is_held| GivenCell {
        centre: DVec2::new(x, y),
        is_held,
    };
    let mut params = PackingParams {
        population: Population::Off,
        given: vec![
            cell(100.0, 100.0, true),
            cell(140.0, 100.0, false),
            cell(600.0, 100.0, false),
        ],
        jolt: 0.3,
        ..PackingParams::DEFAULT
    };
    let jolted = |params: &PackingParams| Packing::new(&domain, &fields, params.clone()).unwrap();
    let first = jolted(&params);
    assert_eq!((first.left_out(), first.particles().len()), (1, 2));
    let [held, free] = first.particles()[..] else {
        panic!("two cells");
    };
    assert!(held.fixed && held.centre == DVec2::splat(100.0));
    let by = free.centre.distance(DVec2::new(140.0, 100.0));
    assert!(!free.fixed && by > 0.0 && by <= 0.3 * SIZE);
    assert_eq!(first.hash(), jolted(&params).hash());
    params.seed = 2;
    assert_ne!(first.hash(), jolted(&params).hash());
    params.boundary = BoundaryCondition::Open;
    let open = jolted(&params);
    assert_eq!((open.left_out(), open.particles().len()), (0, 3));
    assert_eq!(open.particles_within(&domain).len(), 2);
}

#[test]
fn the_plain_rule_adds_no_cell_in_a_hole_and_ours_does() {
    // A grid at rest with one place empty: every cell touches another.
    let domain = Domain::torus(8.0 * SIZE, &[]);
    let fields = fields(&domain, CellKind::Square);
    let place = |k: u32| SIZE * (DVec2::new(f64::from(k % 8), f64::from(k / 8)) + 0.5);
    let given = (0..64).filter(|&k| k != 27).map(|k| GivenCell {
        centre: place(k),
        is_held: false,
    });
    let params = |population| PackingParams {
        population,
        given: given.clone().collect(),
        ..PackingParams::DEFAULT
    };
    let count = |population| {
        let mut packing = Packing::new(&domain, &fields, params(population)).unwrap();
        while !packing.done() {
            packing.step(&domain, &fields);
        }
        let came = packing.changes().iter().filter(|change| change.came);
        assert_eq!(came.count(), packing.report().added as usize);
        packing.particles().len()
    };
    assert_eq!(count(Population::Opposite), 63);
    assert_eq!(count(Population::Slots), 64);
}

#[test]
fn thresholds_that_cross_give_no_rest() {
    let domain = square();
    let fields = fields(&domain, CellKind::Circle);
    let physics = Physics {
        crowded: Some(1.0),
        roomy: Some(0.5),
        ..Physics::DEFAULT
    };
    let params = PackingParams {
        population: Population::Opposite,
        physics,
        ..PackingParams::DEFAULT
    };
    let mut packing = Packing::new(&domain, &fields, params).unwrap();
    while !packing.done() {
        packing.step(&domain, &fields);
    }
    let looks = |came| {
        let changes = packing.changes().iter().filter(move |c| c.came == came);
        changes
            .map(|c| c.step)
            .collect::<std::collections::BTreeSet<u32>>()
    };
    let both: Vec<u32> = looks(true).intersection(&looks(false)).copied().collect();
    assert!(both.len() >= 3, "{both:?}");
}

#[test]
fn the_numbers_of_cells_are_those_of_their_forces() {
    let domain = square();
    let fields = fields(&domain, CellKind::Square);
    let mut packing = Packing::new(&domain, &fields, PackingParams::DEFAULT).unwrap();
    for _ in 0..5 {
        packing.step(&domain, &fields);
    }
    let numbers = packing.numbers(&domain);
    let mut loads = packing.net_forces(&domain);
    loads.sort_by_key(|(cell, _)| cell.id);
    assert_eq!(numbers.len(), loads.len());
    for (cell, (particle, load)) in numbers.iter().zip(&loads) {
        assert_eq!(cell.id, particle.id);
        assert!(cell.force.distance(load.force) < 1e-12);
        assert!((cell.energy - load.energy).abs() < 1e-12);
        assert!(cell.smallest().is_some_and(|w| w > 0.5 && w < 1.2));
        let sides = cell.neighbours.iter().filter(|near| near.w < 1.2).count();
        assert!((2..=5).contains(&sides), "{sides}");
    }
}

/// The hashes after each step, and the number of steps to the end.
fn all_hashes(domain: &Domain, fields: &Fields, params: &PackingParams) -> Vec<String> {
    let mut packing = Packing::new(domain, fields, params.clone()).unwrap();
    let mut hashes = vec![packing.hash()];
    while !packing.done() {
        packing.step(domain, fields);
        hashes.push(packing.hash());
    }
    hashes
}

#[test]
fn any_step_has_the_same_state_forward_and_back() {
    let domain = square();
    for (kind, integrator, variance) in [
        (CellKind::Circle, Integrator::SemiImplicit, 0.3),
        (CellKind::Square, Integrator::RungeKutta, 0.2),
    ] {
        let fields = fields(&domain, kind);
        let params = PackingParams {
            start: Start::Quadtree,
            integrator,
            variance,
            physics: Physics {
                // Late steps cool, and the run goes on beyond them.
                cooling: Some(0.97),
                move_end: 0.0,
                most_steps: 130,
                ..Physics::DEFAULT
            },
            ..PackingParams::DEFAULT
        };
        let hashes = all_hashes(&domain, &fields, &params);
        assert_eq!(hashes.len(), 131);
        let first = Packing::new(&domain, &fields, params).unwrap();
        let mut history = History::new(first);
        let mut furthest = 0;
        for step in [
            12, 9, 10, 11, 101, 100, 99, 130, 5, 500, 0, 100, 101, 102, 31, 30, 29, 130,
        ] {
            history.ask(step);
            let mut slices = 0;
            let advance = |packing: &mut Packing| {
                packing.step(&domain, &fields);
            };
            while !history.advance(advance) {
                // Looking at a state on the way changes nothing.
                history.packing_mut().energy_parts(&domain);
                history.packing_mut().net_forces(&domain);
                slices += 1;
            }
            let step = step.min(130);
            let packing = history.packing();
            assert_eq!(packing.report().step, step);
            assert_eq!(packing.hash(), hashes[step as usize], "{kind:?} {step}");
            assert_eq!(packing.samples().len(), step as usize);
            assert!(slices <= 10 || step > furthest, "{slices} slices to {step}");
            furthest = furthest.max(step);
        }
    }
}

#[test]
fn a_studio_holds_any_step_and_lets_go() {
    let mut studio = packed("size=128&cs=12&kind=circle");
    let end = studio.progress();
    let hash = |studio: &mut Studio| studio.engine_mut().steps().unwrap().state_hash();
    let last = hash(&mut studio);
    let hold = |studio: &mut Studio, step| {
        let rewind = studio.engine_mut().rewind().unwrap();
        rewind.hold(step);
        while !rewind.reach(&mut || 0.0, 0.0) {}
    };
    hold(&mut studio, Some(7));
    assert_eq!(studio.progress().steps, 7);
    let seventh = hash(&mut studio);
    let view = studio.engine_mut().view("packed").to_vec();
    hold(&mut studio, Some(u32::MAX));
    assert_eq!((studio.progress(), hash(&mut studio)), (end, last.clone()));
    assert_ne!(studio.engine_mut().view("packed"), view);
    hold(&mut studio, Some(7));
    assert_eq!(hash(&mut studio), seventh);
    assert_eq!(studio.engine_mut().view("packed"), view);
    let steps = studio.engine_mut().steps().unwrap();
    assert_eq!(steps.numbers().len(), studio.progress().cells);
    hold(&mut studio, None);
    assert_eq!((studio.progress(), hash(&mut studio)), (end, last));
}

#[test]
fn a_studio_goes_on_from_a_held_step() {
    let clock = &mut || 0.0;
    let mut studio = Studio::new(ALL, ALL.recipe("size=128&cs=12").0);
    studio.finish(clock).unwrap();
    let (digest, end) = (studio.engine().digest(), studio.progress());
    // The first way back makes the states, and later ones take them up.
    for (step, most_slices) in [(17, u32::MAX), (12, 10), (13, 10), (17, 10)] {
        let rewind = studio.engine_mut().rewind().unwrap();
        rewind.hold(Some(step));
        let mut slices = 0;
        while !rewind.reach(&mut || 0.0, 0.0) {
            slices += 1;
        }
        assert!(slices <= most_slices, "{slices} slices to {step}");
        let held = studio.engine_mut().steps().unwrap().state_hash();
        studio.restart();
        assert_eq!((studio.stage(), studio.progress().steps), ("packing", step));
        let steps = studio.engine_mut().steps().unwrap();
        assert_eq!(steps.state_hash(), held);
        studio.step(clock);
        assert_eq!(studio.progress().steps, step + 1);
    }
    studio.finish(clock).unwrap();
    assert_eq!((studio.engine().digest(), studio.progress()), (digest, end));
    // A packing that is held at its end has no step to go on from.
    let rewind = studio.engine_mut().rewind().unwrap();
    rewind.hold(Some(u32::MAX));
    while !rewind.reach(clock, 0.0) {}
    studio.restart();
    assert_eq!(studio.progress().steps, 0);
}

#[test]
fn a_recipe_of_one_or_two_bubbles_ends_in_a_picture() {
    for (link, cells) in [
        ("given=0.5,0.5,1", 1),
        ("given=0.4,0.5,1;0.6,0.5,0", 2),
        ("edge=open&given=0.4,0.5,1;0.6,0.5,0;1.2,0.5,0", 3),
        ("edge=open&cells=packed&given=0.5,0.5,0", 1),
        ("tile=1&given=0.5,0.5,1;0.99,0.5,0", 2),
    ] {
        let mut studio = packed(&format!("size=128&cs=24&outline=square&pop=off&{link}"));
        assert_eq!(studio.progress().cells, cells, "{link}");
        studio.finish(&mut || 0.0).expect(link);
        assert!(studio.picture().is_some(), "{link}");
    }
}

#[test]
fn what_does_not_fit_or_hold_is_said() {
    let said = |link: &str| -> Vec<Code> {
        let studio = packed(&format!("size=128&cs=24&outline=square&{link}"));
        let remarks = studio.engine().remarks();
        let all = remarks.into_iter().chain(studio.problem().cloned());
        all.map(|notice| notice.code).collect()
    };
    assert_eq!(said("given=0.5,0.5,0;-0.2,0.5,0"), [Code::GivenOutside]);
    assert_eq!(said("given=-0.2,0.5,0"), [Code::NoCells]);
    assert_eq!(said("move=euler&damp=10&dt=1"), [Code::FlewApart]);
    assert_eq!(said("move=euler&dt=0.1"), []);
}

#[test]
fn given_cells_are_checked_where_they_enter() {
    let refused = |text: &str| {
        let mut recipe = ALL.recipe("").0;
        let why = recipe.set("given", text).unwrap_err();
        let [.., (_, Arg::Part(part))] = &why.args[..] else {
            panic!("{why}");
        };
        part.code
    };
    let many: Vec<String> = (0..257).map(|k| format!("0.{k:03},0.5,0")).collect();
    for (text, code) in [
        ("0.5,0.5,2", Code::RowBubble),
        ("0.5,0.5", Code::RowBubble),
        ("2,0.5,0", Code::RowOutside),
        ("0.5,x,0", Code::NotANumber),
        ("0.5,0.5,0;0.5,0.5,1", Code::RowTwice),
        (&many.join(";"), Code::TooManyPoints),
    ] {
        assert_eq!(refused(text), code, "{text:.20}");
    }
    let mut recipe = ALL.recipe("").0;
    assert_eq!(recipe.set("given", &many[..256].join(";")), Ok(vec![]));
    let (again, notices) = ALL.recipe(&recipe.link());
    assert_eq!((again, notices), (recipe, vec![]));
}

#[test]
fn most_triangles_of_a_honeycomb_have_wide_angles() {
    let domain = square();
    let fields = fields(&domain, CellKind::Circle);
    let mut packing = Packing::new(&domain, &fields, PackingParams::DEFAULT).unwrap();
    while !packing.done() {
        packing.step(&domain, &fields);
    }
    let mesh = Mesh::build(&domain, &packing.particles());
    let angles = smallest_angles(&domain, &mesh);
    assert_eq!(angles.len(), mesh.faces.len());
    assert!(angles.iter().all(|angle| (0.0..=60.0).contains(angle)));
    // A honeycomb is of nearly equilateral triangles.
    let wide = angles.iter().filter(|angle| **angle > 44.0).count();
    assert!(2 * wide > angles.len());
}

#[test]
fn a_step_that_is_asked_for_before_its_fields_are_made_is_held() {
    let of_two = "outline=square&size=128&kind=square&cs=32&dir=constant&edge=open&pop=off";
    let recipe = ALL.recipe(&format!("{of_two}&given=0.4,0.5,1;0.6,0.5,0")).0;
    let mut studio = Studio::new(ALL, recipe);
    studio.engine_mut().rewind().unwrap().hold(Some(0));
    // On a slow machine each slice ends at once.
    let mut now = 0.0;
    let slow = &mut || {
        now += 100.0;
        now
    };
    while ["domain", "fields"].contains(&studio.stage()) {
        studio.tick(slow, 0.0, 0);
    }
    let rewind = studio.engine_mut().rewind().unwrap();
    while !rewind.reach(slow, 0.0) {}
    let cells = studio.engine_mut().steps().unwrap().numbers();
    assert_eq!((studio.progress().steps, cells.len()), (0, 2));
    assert!(cells.iter().all(|cell| cell.energy != 0.0), "{cells:?}");
}
