//! The benchmarks, the same natively and in WebAssembly. Times are in milliseconds by the caller's clock. Each
//! is the shortest of several runs, because other programs have disturbed that one least.

#[cfg(house)]
mod frames;
#[cfg(house)]
pub mod masonry;
#[cfg(house)]
pub mod pile;
#[cfg(house)]
pub mod scene;
#[cfg(house)]
#[path = "surface.rs"]
pub mod surface;

use bubblestone::domain::{Domain, Outline};
use bubblestone::export::StageTime;
use bubblestone::field::{FieldBuilder, FieldParams, Fields};
use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, Pavement};
use bubblestone::packing::{
    BoundaryCondition, Integrator, Packing, PackingParams, Population, Start,
};
use bubblestone::solid::Stencil;
#[cfg(target_arch = "wasm32")]
use bubblestone::solid::{Solid, Solids, control_mesh as solid_mesh};
use bubblestone::studio::Studio;
use glam::{DVec2, Vec3};

/// A clock in milliseconds.
pub type Clock<'a> = &'a mut dyn FnMut() -> f64;

/// A measurement's name and milliseconds.
#[derive(Clone, Debug)]
pub struct Timing {
    /// The name of the benchmark.
    pub name: String,
    /// The shortest of its runs.
    pub ms: f64,
}

/// The number of stones that are subdivided.
pub const STONES: usize = 500;
/// Loop steps on each stone: 24 triangles become 1,536.
pub const LEVELS: u32 = 3;

/// The parameters of fig. 14 (a) of Itoh, Miyata, Shimada (2003), on a square.
const SKIN: &str = "outline=square&kind=ellipse&ca=1.5&stone=skin&tc=0.2&dr=0";

/// Runs all benchmarks.
pub fn run(clock: Clock) -> Vec<Timing> {
    let mut timings = Vec::new();
    for cells in [500, 3_000, 30_000] {
        packing_step(cells, Integrator::SemiImplicit, clock, &mut timings);
    }
    for cells in [500, 50_000] {
        packing_step(cells, Integrator::RungeKutta, clock, &mut timings);
    }
    #[cfg(house)]
    {
        whole_way("ring", &ring(), 2_000, clock, &mut timings);
        surface::whole_way(2_000, clock, &mut timings);
    }
    for cells in [400, 3_000] {
        whole_way("square", &square(), cells, clock, &mut timings);
        whole_way("ring", &ring(), cells, clock, &mut timings);
    }
    timings.push(subdivision(clock));
    timings.push(skin(clock));
    stages(clock, &mut timings);
    for light in ["parallel", "point"] {
        timings.push(moved_light(light, clock));
    }
    #[cfg(house)]
    {
        timings.extend(scene::timings(clock));
        timings.extend(pile::timings(clock));
        timings.extend(masonry::timings(clock));
    }
    timings
}

fn shortest(times: impl IntoIterator<Item = f64>) -> f64 {
    times.into_iter().fold(f64::INFINITY, f64::min)
}

/// A ring in a picture of 512; its hole is half as wide.
fn ring() -> Outline {
    let circle = |radius: f64, sense: f64| {
        (0..180)
            .map(|k| {
                let turn = sense * std::f64::consts::TAU * f64::from(k) / 180.0;
                DVec2::splat(256.0) + radius * DVec2::new(libm::cos(turn), libm::sin(turn))
            })
            .collect()
    };
    Outline {
        rings: vec![circle(250.0, 1.0), circle(125.0, -1.0)],
        ..Outline::default()
    }
}

/// A square in a picture of 512.
fn square() -> Outline {
    let corners = [(32.0, 32.0), (480.0, 32.0), (480.0, 480.0), (32.0, 480.0)];
    Outline {
        rings: vec![corners.map(|(x, y)| DVec2::new(x, y)).to_vec()],
        ..Outline::default()
    }
}

/// The side of squares of which `cells` fill an outline.
fn side_of(domain: &Domain, cells: u32) -> f64 {
    (domain.area() / f64::from(cells)).sqrt()
}

fn fields(domain: &Domain, size: f64) -> Fields {
    let params = FieldParams {
        size,
        ..FieldParams::default()
    };
    FieldBuilder::build(domain, params)
}

/// Times one step with about `cells` cells, and its part for each thousand of them.
fn packing_step(cells: u32, integrator: Integrator, clock: Clock, timings: &mut Vec<Timing>) {
    const STEPS: u32 = 8;
    let domain = Domain::from_checked(&ring());
    let fields = fields(&domain, side_of(&domain, cells));
    let params = PackingParams {
        boundary: BoundaryCondition::Wall,
        start: Start::Stream,
        integrator,
        population: Population::Off,
        variance: 0.0,
        seed: 1,
        ..PackingParams::DEFAULT
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
    let what = match integrator {
        Integrator::SemiImplicit => "packing step",
        Integrator::RungeKutta => "Runge-Kutta step",
        Integrator::Euler => "explicit Euler step",
    };
    timings.push(Timing {
        name: format!("{what}, {cells} cells"),
        ms,
    });
    timings.push(Timing {
        name: format!("{what}, a thousand of {cells} cells"),
        ms: 1000.0 * ms / first.report().cells as f64,
    });
}

/// Times the way from an outline to about `cells` fitted cells, and the direction field's part of it.
pub fn whole_way(
    name: &str,
    outline: &Outline,
    cells: u32,
    clock: Clock,
    timings: &mut Vec<Timing>,
) {
    let size = side_of(&Domain::from_checked(outline), cells);
    let (recipe, _) = pavement::recipe(&format!("cs={size:.2}"));
    let mut whole = Vec::new();
    let mut field = Vec::new();
    for _ in 0..9 {
        let Ok((engine, _)) = Pavement::with_outline(&recipe, outline) else {
            return;
        };
        let mut studio = Studio::with_engine(ALL, recipe.clone(), Box::new(engine));
        let has_cells = |studio: &Studio| {
            let made = studio.engine().products();
            made.is_some_and(|made| !made.cells.is_empty())
        };
        let start = clock();
        while !has_cells(&studio) && studio.problem().is_none() {
            studio.tick(clock, 0.0, 1);
        }
        whole.push(clock() - start);
        let stages = studio.milliseconds();
        field.extend(stages.iter().find(|t| t.stage == "fields").map(|t| t.ms));
    }
    timings.push(Timing {
        name: format!("outline to fitted cells, {name}, {cells} cells"),
        ms: shortest(whole),
    });
    timings.push(Timing {
        name: format!("direction field of these, {name}, {cells} cells"),
        ms: shortest(field),
    });
}

/// A box with a point in the middle of each face: 14 points, 24 triangles.
pub fn control_mesh() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let sign = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
    let corner = |k: usize| Vec3::new(sign(k & 1), sign(k & 2), sign(k & 4));
    let mut points: Vec<Vec3> = (0..8).map(corner).collect();
    // The corners of each face in order around it, seen from outside.
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

/// Subdivides all stones three times and computes the weights anew each time.
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
        // The result is used, so that no compiler drops the work.
        assert!(reach.is_finite());
        time
    });
    Timing {
        name: format!("subdivision, {STONES} stones, {LEVELS} times"),
        ms: shortest(times),
    }
}

/// The mesh that other programs subdivide for comparison: the prism of a skin cell with six corners. Also the
/// number of steps, and the number of prisms that gives as many triangles as the cells of [`SKIN`].
#[cfg(target_arch = "wasm32")]
pub fn skin_mesh() -> (Solid, u32, usize) {
    const STEPS: u32 = 4;
    let mut studio = Studio::new(ALL, pavement::recipe(SKIN).0);
    // If the recipe fails, there are no cells to count.
    let _ = studio.finish(&mut || 0.0);
    let mut solids = Solids::new();
    let Some(made) = studio.engine().products() else {
        return Default::default();
    };
    let (params, cells) = (made.stones, made.scales);
    let triangles: usize = cells
        .iter()
        .map(|cell| solids.solid(cell, &params).triangles.len())
        .sum();
    let six = cells
        .iter()
        .find_map(|cell| solid_mesh(cell, &params).filter(|mesh| mesh.triangles.len() == 18));
    let mesh = six.unwrap_or_default();
    let each = mesh.triangles.len().max(1) << (2 * STEPS);
    (mesh, STEPS, triangles.div_ceil(each))
}

/// Times the whole skin of [`SKIN`]: prisms, subdivision, noise, planes.
fn skin(clock: Clock) -> Timing {
    let recipe = pavement::recipe(SKIN).0;
    let times = (0..5).map(|_| {
        let mut studio = Studio::new(ALL, recipe.clone());
        // A run that fails shows as a time that is too short.
        let _ = studio.finish(clock);
        let stages = studio.milliseconds();
        let of_skin = |t: &&StageTime| ["planes", "weather"].contains(&t.stage);
        stages.iter().filter(of_skin).map(|t| t.ms).sum()
    });
    Timing {
        name: "skin of fig. 14 (a)".to_owned(),
        ms: shortest(times),
    }
}

/// Times every stage of the default recipe, and of one with small cells.
fn stages(clock: Clock, timings: &mut Vec<Timing>) {
    for link in ["", "cs=8"] {
        let (recipe, _) = pavement::recipe(link);
        let runs: Vec<_> = (0..5)
            .map(|_| {
                let mut studio = Studio::new(ALL, recipe.clone());
                // A run that fails shows as times that are too short.
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

/// Times the shading of the default picture, with another light each time.
fn moved_light(light: &str, clock: Clock) -> Timing {
    let link = |k: usize| format!("light={light}&az={}&lx=0.{k:02}", 25 * k);
    let mut studio = Studio::new(ALL, pavement::recipe(&link(0)).0);
    let times = (0..14).map(|k| {
        studio.set_recipe(pavement::recipe(&link(k)).0);
        let start = clock();
        let _ = studio.finish(clock);
        clock() - start
    });
    // The first runs make the pavement, and their code may not be compiled yet.
    let times = times.skip(3);
    Timing {
        name: format!("light moved, {light}"),
        ms: shortest(times),
    }
}
