//! The measurements, the same natively and in WebAssembly. Times are milliseconds by the caller's
//! clock; each is the shortest of several runs, which other programs have disturbed least.

use bubblestone::domain::{Domain, Outline};
use bubblestone::field::{FieldBuilder, FieldParams, Fields};
use bubblestone::packing::{Edge, Integrator, Packing, PackingParams, Population, Start};
use bubblestone::recipe::Recipe;
use bubblestone::solid::Stencil;
use bubblestone::studio::Studio;
use glam::{DVec2, Vec3};

/// A clock in milliseconds.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// A measurement's name and milliseconds.
#[derive(Clone, Debug)]
pub struct Timing {
    /// What was measured.
    pub name: String,
    /// The shortest of its runs.
    pub ms: f64,
}

/// Stones that are subdivided, and how many times.
pub const STONES: usize = 500;
/// Loop steps on each stone: 24 triangles become 1,536.
pub const LEVELS: u32 = 3;

/// All measurements.
pub fn run(clock: Clock) -> Vec<Timing> {
    let mut timings = Vec::new();
    for cells in [500, 3_000, 30_000] {
        packing_step(cells, clock, &mut timings);
    }
    timings.push(subdivision(clock));
    stages(clock, &mut timings);
    for light in ["parallel", "point"] {
        timings.push(moved_light(light, clock));
    }
    timings
}

fn shortest(times: impl IntoIterator<Item = f64>) -> f64 {
    times.into_iter().fold(f64::INFINITY, f64::min)
}

/// A ring, its hole half as wide, in a picture of 512.
fn ring() -> Domain {
    let circle = |radius: f64, sense: f64| {
        (0..180)
            .map(|k| {
                let turn = sense * std::f64::consts::TAU * f64::from(k) / 180.0;
                DVec2::splat(256.0) + radius * DVec2::new(libm::cos(turn), libm::sin(turn))
            })
            .collect()
    };
    Domain::from_checked(&Outline {
        outer: circle(250.0, 1.0),
        holes: vec![circle(125.0, -1.0)],
        ..Outline::default()
    })
}

fn fields(domain: &Domain, size: f64) -> Fields {
    let params = FieldParams {
        size,
        ..FieldParams::default()
    };
    FieldBuilder::build(domain, params)
}

/// One step of about `cells` cells, and its part for each thousand of them.
fn packing_step(cells: usize, clock: Clock, timings: &mut Vec<Timing>) {
    const STEPS: u32 = 8;
    let domain = ring();
    let fields = fields(&domain, (domain.area() / cells as f64).sqrt());
    let params = PackingParams {
        edge: Edge::Wall,
        start: Start::Stream,
        integrator: Integrator::SemiImplicit,
        population: Population::Off,
        variance: 0.0,
        seed: 1,
    };
    let Ok(first) = Packing::new(&domain, &fields, params) else {
        return;
    };
    let times = (0..9).map(|_| {
        let mut packing = first.clone();
        let start = clock();
        for _ in 0..STEPS {
            packing.step(&domain, &fields);
        }
        (clock() - start) / f64::from(STEPS)
    });
    let ms = shortest(times);
    timings.push(Timing {
        name: format!("packing step, {cells} cells"),
        ms,
    });
    timings.push(Timing {
        name: format!("packing step, a thousand of {cells} cells"),
        ms: 1000.0 * ms / first.report().cells as f64,
    });
}

/// A box with a point in the middle of each face: 14 points, 24 triangles.
pub fn control_mesh() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let sign = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
    let corner = |k: usize| Vec3::new(sign(k & 1), sign(k & 2), sign(k & 4));
    let mut points: Vec<Vec3> = (0..8).map(corner).collect();
    // The corners of each face in a circle, seen from outside.
    let faces: [[u32; 4]; 6] = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let mut triangles = Vec::new();
    for face in faces {
        let middle = points.len() as u32;
        points.push(face.iter().map(|&c| points[c as usize]).sum::<Vec3>() / 4.0);
        triangles.extend((0..4).map(|k| [face[k], face[(k + 1) % 4], middle]));
    }
    (points, triangles)
}

/// All stones three times, the weights worked out anew.
fn subdivision(clock: Clock) -> Timing {
    let (points, triangles) = control_mesh();
    let stones: Vec<Vec<Vec3>> = (0..STONES)
        .map(|k| {
            let stretch = Vec3::new(1.0, 1.0 + k as f32 / STONES as f32, 0.7);
            points.iter().map(|&p| p * stretch).collect()
        })
        .collect();
    let mut refined = Vec::new();
    let times = (0..9).map(|_| {
        let start = clock();
        let stencil = Stencil::new(points.len(), &triangles, LEVELS);
        let mut reach = Vec3::ZERO;
        for stone in &stones {
            stencil.apply_to(stone, &mut refined);
            reach = reach.max(refined[refined.len() - 1]);
        }
        let time = clock() - start;
        // Looked at, so that no compiler leaves the work out.
        assert!(reach.is_finite());
        time
    });
    Timing {
        name: format!("subdivision, {STONES} stones, {LEVELS} times"),
        ms: shortest(times),
    }
}

/// Every stage of the default recipe and of one with small cells.
fn stages(clock: Clock, timings: &mut Vec<Timing>) {
    for link in ["", "cs=8"] {
        let (recipe, _) = Recipe::from_link(link);
        let runs: Vec<_> = (0..5)
            .map(|_| {
                let mut studio = Studio::new(recipe.clone());
                // A run that fails shows as missing time.
                let _ = studio.finish(clock);
                studio.milliseconds()
            })
            .collect();
        for k in 0..runs[0].len() {
            let name = match link {
                "" => format!("{}, default recipe", runs[0][k].stage),
                _ => format!("{}, {link}", runs[0][k].stage),
            };
            let ms = shortest(runs.iter().map(|run| run[k].ms));
            timings.push(Timing { name, ms });
        }
    }
}

/// The default picture shaded anew, each time with the light elsewhere.
fn moved_light(light: &str, clock: Clock) -> Timing {
    let link = |k: usize| format!("light={light}&az={}&lx=0.{k:02}", 25 * k);
    let mut studio = Studio::new(Recipe::from_link(&link(0)).0);
    let times = (0..14).map(|k| {
        studio.set_recipe(Recipe::from_link(&link(k)).0);
        let start = clock();
        let _ = studio.finish(clock);
        clock() - start
    });
    // The first ones make the pavement, and find the code not yet compiled.
    let times = times.skip(3);
    Timing {
        name: format!("light moved, {light}"),
        ms: shortest(times),
    }
}
