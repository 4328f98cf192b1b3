//! The figures of the chapters have the same numbers natively as in WebAssembly. `learn.txt` has them at each stop, and
//! `learn-links.txt` the packings that they show. `node/figures.test.mjs` writes and compares both lists.

use crate::common::packed;
use bubblestone::generators::{JoinedCells, Steps};
use bubblestone::packing::CellNumbers;
use bubblestone::studio::Studio;
use glam::DVec2;

const STOPS: &str = include_str!("../../learn.txt");
const LINKS: &str = include_str!("../../learn-links.txt");

/// A packing of a figure.
struct Shown {
    figure: &'static str,
    /// Steps of a packing (`step`), the layers of a finished one (`layer`), or places of a walk (`walk`).
    steps: &'static str,
    /// The place that is looked at, in sides of the picture.
    place: DVec2,
    link: &'static str,
}

/// A line of `learn-links.txt`.
fn shown(line: &'static str) -> Shown {
    let mut parts = line.splitn(4, ' ');
    let mut next = || parts.next().expect("four parts");
    let (figure, steps) = (next(), next());
    let (x, y) = next().split_once(',').expect("x,y");
    let place = DVec2::new(number(x), number(y));
    Shown {
        figure,
        steps,
        place,
        link: next(),
    }
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// The hash of a packing's state, and its numbers.
type State = (String, Vec<f64>);

fn is_hash(word: &str) -> bool {
    word.len() == 16 && word.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// The states that a line of `learn.txt` names, one for each packing.
fn states(words: &[&str]) -> Vec<State> {
    let mut states: Vec<State> = Vec::new();
    for word in words {
        if is_hash(word) {
            states.push(((*word).to_owned(), Vec::new()));
        } else {
            let (_, numbers) = states.last_mut().expect("a hash first");
            numbers.push(number(word));
        }
    }
    states
}

/// Two cells: their distance in stable distances, and the force on the second one along the line between them.
fn of_pair(cells: &[CellNumbers]) -> [f64; 2] {
    let [first, second] = cells else {
        panic!("{} cells", cells.len());
    };
    let apart = (second.centre.x - first.centre.x) / first.size;
    [apart, second.force.x]
}

/// The number of Delaunay's triangles, the median of the mesh's smallest angles, and Delaunay's smallest angle.
fn of_joined(joined: &JoinedCells) -> [f64; 3] {
    let angles = joined.triangles.iter().flat_map(|one| one.angles);
    let least = angles.fold(f64::INFINITY, f64::min);
    let middle = joined.middle_angle.unwrap_or_default();
    [joined.triangles.len() as f64, middle, least]
}

/// As many numbers of a packing at its present step as the list has.
fn numbers(studio: &mut Studio, count: usize) -> Vec<f64> {
    let last_move = studio.progress().largest_move;
    let steps = studio.engine_mut().steps().expect("steps");
    let (cells, energy) = (steps.numbers(), steps.energy_parts());
    let mut numbers = match count {
        4 if cells.len() == 2 => of_pair(&cells).to_vec(),
        _ => vec![cells.len() as f64],
    };
    match count {
        4 if cells.len() == 2 => numbers.extend([energy.pairs, energy.motion]),
        5 | 8 => numbers.extend([energy.pairs, energy.walls, energy.motion, last_move]),
        _ => {}
    }
    if numbers.len() < count {
        numbers.extend(of_joined(joined(steps)));
    }
    numbers
}

fn joined(steps: &mut dyn Steps) -> &JoinedCells {
    while !steps.join(&mut || 0.0, 0.0) {}
    steps.joined().expect("joined cells")
}

/// The state of a packing that has ended, at a step of it or at its end.
fn state(studio: &mut Studio, step: Option<u32>, count: usize) -> State {
    let rewind = studio.engine_mut().rewind().expect("steps");
    rewind.hold(step);
    while !rewind.reach(&mut || 0.0, 0.0) {}
    let hash = studio.engine_mut().steps().expect("numbers").state_hash();
    (hash, numbers(studio, count))
}

/// The direction at a place, and its certainty.
fn direction(studio: &Studio, place: DVec2) -> [f64; 3] {
    let products = studio.engine().products().expect("a pavement");
    let (domain, fields) = products.domain.zip(products.fields).expect("fields");
    let sum = fields.direction_sum(domain, place * studio.side() as f64);
    [sum.direction.x, sum.direction.y, sum.certainty]
}

/// Compares a packing at a stop with its golden state. The hash of a walk is that of drawn directions, which the list's
/// other tests compare.
fn compare(one: &Shown, studio: &mut Studio, step: u32, golden: &State) {
    let link = one.link;
    if one.steps == "walk" {
        let found = direction(studio, one.place);
        assert_eq!(found[..], golden.1[..3], "{link}");
        return;
    }
    let step = (one.steps == "step").then_some(step);
    let found = state(studio, step, golden.1.len());
    assert_eq!(found, *golden, "{step:?} of {link}");
}

#[test]
fn figures_have_the_golden_numbers() {
    let stops: Vec<Vec<&str>> = STOPS.lines().map(|l| l.split(' ').collect()).collect();
    let links: Vec<Shown> = LINKS.lines().map(shown).collect();
    let mut seen = 0;
    for figure in links.chunk_by(|a, b| a.figure == b.figure) {
        let mut studios: Vec<Studio> = figure.iter().map(|one| packed(one.link)).collect();
        for stop in stops.iter().filter(|stop| stop[0] == figure[0].figure) {
            let golden = states(&stop[3..]);
            assert_eq!(golden.len(), figure.len(), "{}", stop[0]);
            let step = stop[2].parse().expect("a step");
            for ((one, studio), golden) in figure.iter().zip(&mut studios).zip(&golden) {
                compare(one, studio, step, golden);
            }
            seen += 1;
        }
    }
    assert_eq!(seen, stops.len());
}
