//! Piles: from darts to places, frames of a pile, and what a physics engine needs to do the same work.

#[cfg(target_arch = "wasm32")]
mod peer;

#[cfg(target_arch = "wasm32")]
pub use peer::Pebbles;

use super::frames::{self, place};
use super::{Clock, Timing, shortest};
use bubblestone::component::{Component, ComponentKind, Original};
use bubblestone::generators::ALL;
use bubblestone::generators::pile::PILE;
use bubblestone::pile::{
    Body, Dart, Darting, Fate, Kind, Method, RefineParams, Refining, SettlingOrder, Shape, Turn,
    expected_darts, merge,
};
use bubblestone::pile_shape::{PileShape, PiledShape};
use bubblestone::studio::Studio;
use bubblestone::trimesh::{Search, TriMesh};
use glam::DVec3;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Half of the bowl's longest side, in halves of a pebble's length: about 1,000 pebbles stay.
const HALF: f64 = 16.0;
/// The number of variants of the pebble.
const VARIANTS: u64 = 8;
/// The length of edges, as a share of the shape's longest side, as piles have it.
const EDGE: f64 = 0.02;
const PARAMS: RefineParams = RefineParams {
    offset: 0.15,
    removal: 0.05,
    order: SettlingOrder::Random,
    is_large_first: true,
    retries: 1,
    method: Method::Exact,
    seed: 1,
};
/// An amount of work that is enough to finish in one call.
const ALL_OF_IT: usize = 1 << 30;

/// The pebbles' variants.
pub fn variants() -> Vec<Component> {
    let original = Arc::new(Original::of_kind(ComponentKind::Pebble));
    (0..VARIANTS).map(|k| original.variant(1, k)).collect()
}

/// A bowl to be filled with pebbles.
pub struct Bowl {
    /// The bowl.
    pub shape: PiledShape,
    /// The surface on which darts are thrown.
    mesh: TriMesh,
    search: Search,
}

impl Bowl {
    /// Returns none if its surface has a fault.
    pub fn new() -> Option<Self> {
        let shape = PileShape::Bowl.build(&[], EDGE).scaled(2.0 * HALF);
        let soup = shape.surface.clone();
        let mesh = TriMesh::new(soup.positions, soup.triangles).ok()?;
        let search = Search::new(&mesh);
        Some(Self {
            shape,
            mesh,
            search,
        })
    }

    /// Throws darts and finds the pebbles' places; returns the pebbles that are kept.
    pub fn filled(&self, kind: &Kind) -> Vec<Body> {
        let darts: Vec<Dart> = darting(&self.mesh, kind.spacing())
            .points()
            .iter()
            .map(|p| Dart {
                kind: 0,
                layer: 0,
                at: p.at,
                normal: p.normal,
                triangle: p.triangle,
            })
            .collect();
        let kinds: Arc<[Kind]> = Arc::new([kind.clone()]);
        let stays = merge(&darts, &kinds);
        let walls = self.shape.walls.clone();
        let mut refining = Refining::new(&self.mesh, &darts, &stays, kinds, walls, PARAMS);
        while !refining.advance(&self.mesh, &self.search, ALL_OF_IT) {}
        let kept = refining.bodies().iter().filter(|b| b.fate == Fate::Kept);
        kept.copied().collect()
    }
}

fn darting(mesh: &TriMesh, spacing: f64) -> Darting {
    let mut darting = Darting::new(mesh, spacing, 0, PARAMS.seed, false);
    while !darting.advance(mesh, ALL_OF_IT) {}
    darting
}

/// The type of the pebbles, with the numbers of the generator's defaults.
pub fn kind(variants: &[Component]) -> Kind {
    Kind {
        shapes: variants.iter().map(Shape::of).collect(),
        scale: 1.0,
        jitter: 0.08,
        density: variants[0].density(),
        turn: Turn {
            ranges: DVec3::splat(TAU),
            is_global: false,
        },
        range: 2.0,
        inward: 0.75,
    }
}

/// Times of everything about piles.
pub fn timings(clock: Clock) -> Vec<Timing> {
    let mut timings = Vec::new();
    bowl(clock, &mut timings);
    for count in [2_000, 20_000] {
        timings.extend(thousand_darts(count, clock));
    }
    searches(clock, &mut timings);
    whole_ways(clock, &mut timings);
    let with =
        |studio: &mut Studio, light: &str| studio.set_recipe(rice_ball(light).recipe().clone());
    timings.extend(frames::timings("rice ball", rice_ball(""), with, clock));
    timings
}

fn timing(name: impl Into<String>, times: impl IntoIterator<Item = f64>) -> Timing {
    Timing {
        name: name.into(),
        ms: shortest(times),
    }
}

fn bowl(clock: Clock, timings: &mut Vec<Timing>) {
    let Some(bowl) = Bowl::new() else { return };
    let variants_made = variants();
    let kind_made = kind(&variants_made);
    let fill = |kind: &Kind| {
        let kept = bowl.filled(kind).len();
        assert!(kept.abs_diff(1_000) < 50, "{kept} pebbles");
    };
    let times = (0..7).map(|_| {
        let start = clock();
        fill(&kind_made);
        clock() - start
    });
    timings.push(timing(
        "a bowl of 1000 pebbles, darts and refinement",
        times,
    ));
    let times = (0..3).map(|_| {
        let start = clock();
        fill(&kind(&variants()));
        clock() - start
    });
    timings.push(timing(
        "a bowl of 1000 pebbles, with the spheres of eight variants",
        times,
    ));
}

/// Times about `count` darts on a bowl's surface with triangles in proportion to their spacing; gives the time of a
/// thousand.
fn thousand_darts(count: u32, clock: Clock) -> Option<Timing> {
    let edge = 0.025 * (2_000.0 / f64::from(count)).sqrt();
    let cap = PileShape::Bowl.build(&[], edge).surface;
    let mesh = TriMesh::new(cap.positions, cap.triangles).ok()?;
    let spacing = (expected_darts(mesh.area(), 1.0) / f64::from(count)).sqrt();
    let times = (0..7).map(|_| {
        let start = clock();
        let darts = darting(&mesh, spacing).points().len();
        let time = clock() - start;
        assert!(darts.abs_diff(count as usize) < count as usize / 10);
        1000.0 * time / darts as f64
    });
    let name = format!("a thousand of {count} darts");
    Some(timing(name, times))
}

/// The rice ball of the presets, with a few other values.
fn rice_ball(others: &str) -> Studio {
    let preset = PILE.presets.iter().find(|p| p.name == "rice-ball");
    let link = preset.map_or("", |preset| preset.link);
    Studio::new(ALL, ALL.recipe(&format!("{link}{others}")).0)
}

/// The ways to find places in the rice ball, with their links: by intervals, and by the paper's golden section, whose
/// cost looks at the nearest body. If it looks at all bodies, it takes 13 times as long, too long for a benchmark.
const SEARCHES: [(&str, &str); 2] = [("exact", "&refine=exact"), ("golden", "&refine=golden")];

/// Times the refinement of the rice ball by each search, from the same darts, and counts the grains that are kept.
fn searches(clock: Clock, timings: &mut Vec<Timing>) {
    let mut studio = rice_ball("&offset=0.4");
    place(&mut studio, clock);
    let mut most = None;
    for ((search, link), runs) in SEARCHES.into_iter().zip([7, 3]) {
        let runs = (0..runs).map(|_| {
            // Another offset lets bodies settle anew, and keeps the darts.
            for link in ["&offset=0.4", link] {
                studio.set_recipe(rice_ball(link).recipe().clone());
                place(&mut studio, clock);
            }
            let stages = studio.milliseconds();
            let stage = stages.iter().find(|t| t.stage == "refine");
            stage.map_or(f64::NAN, |t| t.ms)
        });
        let times: Vec<f64> = runs.collect();
        let kept = studio.progress().cells;
        // The exact search is the first one: no other may keep more.
        assert!(kept <= *most.get_or_insert(kept), "{search} keeps {kept}");
        let name = format!("refinement of the rice ball, {search}: keeps {kept}");
        timings.push(timing(name, times));
    }
}

/// Times the way from a recipe to finished bodies, and a whole pavement beside it.
fn whole_ways(clock: Clock, timings: &mut Vec<Timing>) {
    let times = (0..3).map(|_| {
        let start = clock();
        place(&mut rice_ball(""), clock);
        clock() - start
    });
    timings.push(timing(
        "recipe to finished bodies, rice ball without its picture",
        times,
    ));
    let times = (0..7).map(|_| {
        let start = clock();
        // A run that fails shows as a time that is too short.
        let _ = Studio::new(ALL, ALL.recipe("").0).finish(clock);
        clock() - start
    });
    timings.push(timing("recipe to picture, default pavement", times));
}
