//! Bricks on random buildings: right-angled and many-sided plans, sides of fractions of a module, niches for windows.
//!
//! To run more of them: `BUBBLESTONE_RECIPES=1000 cargo test --lib random_buildings`.

use super::{Laying, LayingParams, Measures};
use crate::building::{Building, Draft, DraftFace, FaceSurface, Module};
use crate::masonry::plan::{PlanWarning, is_wall, thicknesses};
use crate::masonry::tree::PRESETS;
use crate::random::{Purpose, Random};
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;
use std::sync::Arc;

const MODULE: Module = Module::NORMAL;

/// A length of `least` to `most` modules, mostly with a fraction (metres).
fn length(random: &mut Random, least: f64, most: f64) -> f64 {
    let modules = least + random.unit() * (most - least);
    let is_whole = random.below(4) == 0;
    MODULE.half * if is_whole { modules.round() } else { modules }
}

/// The corners (x, z) of a plan, counter-clockwise seen from above: 4 to 12 right-angled walls, or 5, 7 or 9 equal
/// ones.
fn plan(random: &mut Random) -> Vec<DVec2> {
    if random.below(3) == 0 {
        let count = [5, 7, 9][random.below(3)];
        let radius =
            length(random, 8.0, 16.0) / (2.0 * libm::sin(std::f64::consts::PI / count as f64));
        let corner = |k: usize| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / count as f64);
            radius * DVec2::new(cos, -sin)
        };
        return (0..count).map(corner).collect();
    }
    // Stairs between two walls at a right angle.
    let steps = 1 + random.below(5);
    let mut sides = || -> Vec<f64> { (0..steps).map(|_| length(random, 7.0, 14.0)).collect() };
    let (along, across) = (sides(), sides());
    let mut at = DVec2::new(along.iter().sum(), 0.0);
    let mut corners = vec![DVec2::ZERO, at];
    for (x, z) in along.iter().zip(&across) {
        at.y -= z;
        corners.push(at);
        at.x -= x;
        corners.push(at);
    }
    corners.pop();
    corners.push(DVec2::new(0.0, at.y));
    corners
}

/// A flat face with this normal, its loops counter-clockwise, holes clockwise.
fn face(draft: &mut Draft, label: &str, normal: DVec3, loops: &[Vec<DVec3>]) {
    let first = loops[0][0];
    let way = (loops[0][1] - first).normalize();
    let (s, t) = if normal.y.abs() < 0.5 {
        (DVec3::Y.cross(normal), DVec3::Y)
    } else {
        (way, normal.cross(way))
    };
    let mut vertex = |p: DVec3| {
        draft.vertices.push(p);
        draft.vertices.len() as u32 - 1
    };
    let loops = loops
        .iter()
        .map(|ring| ring.iter().map(|&p| vertex(p)).collect());
    let face = DraftFace {
        labels: [label]
            .iter()
            .filter(|label| !label.is_empty())
            .map(|&label| label.to_owned())
            .collect(),
        loops: loops.collect(),
        surface: Some(FaceSurface::flat(
            first - DVec3::Y * first.y * (1.0 - normal.y.abs()),
            s,
            t,
        )),
        thickness: None,
    };
    draft.faces.push(face);
}

/// The ends of the openings of a wall (metres).
fn openings(random: &mut Random, length_of_wall: f64) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    let mut at = length(random, 4.0, 6.0);
    while found.len() < 3 && random.below(4) > 0 {
        let end = at + length(random, 4.0, 8.0);
        if end + 4.0 * MODULE.half > length_of_wall {
            break;
        }
        found.push([at, end]);
        at = end + length(random, 4.0, 8.0);
    }
    found
}

/// The reveals of an opening and its glass. The corners of its front and of its back run up along the side where the
/// opening begins, and down along the other one.
fn niche(draft: &mut Draft, along: DVec3, normal: DVec3, [front, back]: [[DVec3; 4]; 2]) {
    let [a, b, c, d] = front;
    let [e, f, g, h] = back;
    let rows: [(&str, DVec3, [DVec3; 4]); 5] = [
        ("Window", DVec3::Y, [a, d, h, e]),
        ("Window", -DVec3::Y, [f, g, c, b]),
        ("Window", along, [a, e, f, b]),
        ("Window", -along, [h, d, c, g]),
        ("Glass", normal, [e, h, g, f]),
    ];
    for (label, normal, ring) in rows {
        face(draft, label, normal, &[ring.to_vec()]);
    }
}

/// A body with a flat top over a plan. Openings are niches.
fn house(random: &mut Random) -> Draft {
    let corners = plan(random);
    let courses = 20.0 + random.below(8) as f64;
    let height = courses * MODULE.course;
    let sill = (5 + random.below(3)) as f64 * MODULE.course;
    let head = sill + (6 + random.below(5)) as f64 * MODULE.course;
    let mut draft = Draft::default();
    let at = |p: DVec2, y: f64| DVec3::new(p.x, y, p.y);
    let mut left = 20;
    for k in 0..corners.len() {
        let (from, to) = (
            at(corners[k], 0.0),
            at(corners[(k + 1) % corners.len()], 0.0),
        );
        let along = (to - from).normalize();
        let normal = along.cross(DVec3::Y);
        let mut holes = openings(random, from.distance(to));
        holes.truncate(left);
        left -= holes.len();
        let up = DVec3::Y * height;
        let mut loops = vec![vec![from, to, to + up, from + up]];
        let depth = MODULE.half * (1 + random.below(2)) as f64;
        for &[a, b] in &holes {
            let q = |s: f64, t: f64, z: f64| from + along * s + DVec3::Y * t - normal * z;
            let [front, back] =
                [0.0, depth].map(|z| [q(a, sill, z), q(a, head, z), q(b, head, z), q(b, sill, z)]);
            loops.push(front.to_vec());
            niche(&mut draft, along, normal, [front, back]);
        }
        face(&mut draft, "", normal, &loops);
    }
    face(
        &mut draft,
        "",
        DVec3::Y,
        &[corners.iter().map(|&p| at(p, height)).collect()],
    );
    face(
        &mut draft,
        "",
        -DVec3::Y,
        &[corners.iter().rev().map(|&p| at(p, 0.0)).collect()],
    );
    draft
}

/// The faults of the bricks on a random building.
fn faults(seed: u64) -> Vec<String> {
    let mut random = Random::new(seed, Purpose::Scatter, 0);
    let building = Arc::new(Building::new(&house(&mut random)).expect("a building"));
    let thick = thicknesses(&building).expect("a mesh");
    let params = LayingParams {
        module: MODULE,
        is_by_hand: false,
        seed,
    };
    let thickness = |face: crate::building::FaceId| thick[face.index()];
    let mut laying =
        Laying::new(building.clone(), PRESETS[1].tree(), params, thickness).expect("a plan");
    while !laying.advance(64) {}
    let (plan, found) = (laying.plan(), Measures::new(&laying));
    let mut faults = Vec::new();
    let mut wrong = |is_wrong: bool, what: &str, value: f64| {
        if is_wrong {
            faults.push(format!("{seed}: {what} {value}"));
        }
    };
    let told = |warning: &&PlanWarning| matches!(warning, PlanWarning::Conflict(_));
    let told = plan.warnings.iter().filter(told).count();
    wrong(
        found.conflicts != told,
        "conflicts that are not told",
        found.conflicts as f64,
    );
    let places: BTreeSet<_> = plan
        .changes
        .iter()
        .map(|change| (change.wall, change.interval))
        .collect();
    wrong(
        places.len() < plan.changes.len(),
        "changes of one interval",
        plan.changes.len() as f64,
    );
    wrong(found.shared_volume > 1e-3, "overlap", found.shared_volume);
    wrong(found.gap > 3e-3, "gap", found.gap);
    wrong(found.course < 0.9999, "courses", found.course);
    for id in building.face_ids().filter(|&id| is_wall(building.face(id))) {
        // Jambs are one or two modules deep, and one column may be too few or too many there.
        let is_jamb = building
            .face(id)
            .labels
            .iter()
            .any(|label| label == "Window");
        for w in plan.grid(id).s.windows(2).filter(|_| !is_jamb) {
            let ratio = (w[1] - w[0]) / MODULE.half;
            wrong(!(0.85..=1.15).contains(&ratio), "a column", ratio);
        }
    }
    wrong(
        !laying.warnings().is_empty(),
        "warnings of the tree",
        laying.warnings().len() as f64,
    );
    faults
}

/// Asserts that cases have no faults: `usual` of them, or as many as BUBBLESTONE_RECIPES says.
pub(super) fn assert_all(usual: u64, faults: impl FnMut(u64) -> Vec<String>) {
    let wished = std::env::var("BUBBLESTONE_RECIPES").ok();
    let count = wished.and_then(|count| count.parse().ok()).unwrap_or(usual);
    let faults: Vec<String> = (0..count).flat_map(faults).collect();
    assert_eq!(faults, [] as [String; 0]);
}

#[test]
fn random_buildings_are_laid_without_gaps_or_overlaps() {
    assert_all(30, faults);
}
