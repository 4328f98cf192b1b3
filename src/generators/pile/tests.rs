//! Properties of the generator's table, and of the piles of its presets and of recipes at random.

use super::quality::assert_good;
use super::schema::{FILE, NONE, ROWS, TYPE_KEYS, keys};
use super::{PILE, PileEngine, SCHEMA};
use crate::component::{ComponentKind, FINISHES};
use crate::generators::rows::numbered::check_row;
use crate::generators::{ALL, Engine, Files, GivenFile, Preset};
use crate::notice::{Arg, Code, Notice};
use crate::pile::fixture::deepest_overlap;
use crate::pile::{Dart, Fate, Kind, same_side};
use crate::pile_shape::PileShape;
use crate::random::{Purpose, Random};
use crate::recipe::{NamedFile, Recipe};
use crate::shapes::Shape;
use crate::trimesh::running_sums::RunningSums;
use crate::trimesh::{SurfacePoint, TriMesh, testing};
use glam::DVec3;

/// Points of the shape whose distance from the nearest dart is checked.
const PROBES: usize = 2_000;

/// The engine of a recipe, up to its bodies; or the sentence with which it stopped.
pub(super) fn settled(recipe: &Recipe) -> Result<PileEngine, Notice> {
    let mut engine = PileEngine::new(recipe);
    while engine.is_forming() {
        if let Some(notice) = engine.failure() {
            return Err(notice.clone());
        }
        engine.advance();
    }
    Ok(engine)
}

pub(super) fn recipe(link: &str) -> Recipe {
    let (recipe, notices) = ALL.recipe(link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    recipe
}

#[test]
fn there_is_a_word_for_each_component_shape_and_finish() {
    let words = |key: &str| {
        let row = SCHEMA.row(key).expect("a row");
        let words = row.choices.iter().map(|choice| choice.word);
        words.filter(|&word| ![FILE, NONE, "own"].contains(&word))
    };
    for own in TYPE_KEYS {
        let of_type = words(own.component.0).map(ComponentKind::of_word);
        let kinds: Vec<_> = of_type.collect();
        assert!(kinds.iter().all(Option::is_some));
        assert_eq!(kinds.len(), ComponentKind::ALL.len());
        let finishes: Vec<&str> = words(own.finish.0).collect();
        assert_eq!(finishes.len(), FINISHES.len());
        let has = |word: &str| finishes.contains(&word);
        assert!(FINISHES.iter().all(|finish| has(finish.word)));
    }
    let forms: Vec<&str> = words("form").collect();
    let all = PileShape::ALL.map(PileShape::word);
    let all = all.into_iter().chain(Shape::ALL.map(Shape::word));
    assert_eq!(forms, all.collect::<Vec<_>>());
}

#[test]
fn there_is_a_row_for_each_number_of_a_pile_shape() {
    for shape in PileShape::ALL {
        let own = |row: &&crate::recipe::Parameter| {
            let of = row.shown_for;
            of.is_some_and(|(key, of)| key == keys::FORM && of == [shape.word()])
        };
        let rows: Vec<_> = ROWS.iter().filter(own).collect();
        assert_eq!(rows.len(), shape.numbers().len(), "{}", shape.word());
        for (row, number) in rows.iter().zip(shape.numbers()) {
            assert_eq!(row.key.0, format!("{}_{}", shape.word(), number.word));
            check_row(row, number);
        }
    }
}

/// Points of a mesh, uniform by area.
pub(super) fn points_of(mesh: &TriMesh, count: usize) -> Vec<SurfacePoint> {
    let sums = RunningSums::of_areas(mesh);
    let mut random = Random::new(9, Purpose::Scatter, 0);
    let point = |_| {
        let triangle = sums.item(random.unit() * sums.total());
        let [a, b] = [random.unit(), random.unit()];
        let [a, b] = if a + b > 1.0 {
            [1.0 - a, 1.0 - b]
        } else {
            [a, b]
        };
        let weights = DVec3::new(a, b, 1.0 - a - b);
        SurfacePoint::new(mesh, triangle as u32, weights)
    };
    (0..count).map(point).collect()
}

/// The darts of a type on the surface itself, by place along x, so that near ones are found soon.
fn sorted(darts: &[Dart], kind: u32) -> Vec<Dart> {
    let own = |dart: &&Dart| dart.kind == kind && dart.layer == 0;
    let mut own: Vec<Dart> = darts.iter().filter(own).copied().collect();
    own.sort_by(|a, b| a.at.x.total_cmp(&b.at.x));
    own
}

/// The distance from a place to the nearest dart on the same side of the shape, if it is below `reach`.
fn nearest(darts: &[Dart], (at, normal): (DVec3, DVec3), reach: f64) -> f64 {
    let first = darts.partition_point(|dart| dart.at.x < at.x - reach);
    let near = darts[first..].iter();
    let near = near.take_while(|dart| dart.at.x <= at.x + reach);
    let near = near.filter(|dart| dart.at != at && same_side(dart.normal, normal));
    near.map(|dart| dart.at.distance(at))
        .fold(f64::INFINITY, f64::min)
}

/// Darts of one type are at least a spacing apart, and no place of the shape is farther than a spacing from all of
/// them.
fn assert_even(engine: &PileEngine, name: &str) {
    let placed = engine.made.placed.made().expect("darts");
    let mesh = &engine.made.site.made().expect("a shape").mesh;
    let probes = points_of(mesh, PROBES);
    for (kind, own) in (0..).zip(placed.kinds.iter()) {
        let darts = sorted(&placed.darts, kind);
        let spacing = own.spacing();
        for dart in &darts {
            let away = nearest(&darts, (dart.at, dart.normal), 2.0 * spacing);
            assert!(away >= spacing, "{name}: {away} of {spacing}");
        }
        for probe in &probes {
            let away = nearest(&darts, (probe.at, probe.normal), 1.01 * spacing);
            assert!(
                away <= 1.005 * spacing,
                "{name}: a hole of {away} of {spacing}"
            );
        }
    }
}

/// Bodies overlap by no more than is allowed, and each is within its range; each dart has a fate.
fn assert_settled(engine: &PileEngine, name: &str) {
    let placed = engine.made.placed.made().expect("darts");
    let pile = engine.made.settled.made().expect("bodies");
    let kinds: &[Kind] = &placed.kinds;
    let params = engine.made.settled.params();
    let limit = params.offset + params.removal;
    if params.method == crate::pile::Method::Exact {
        let deepest = deepest_overlap(pile.bodies(), kinds);
        assert!(deepest <= limit + 1e-4, "{name}: {deepest} of {limit}");
    }
    for body in pile.bodies().iter().filter(|b| b.fate == Fate::Kept) {
        let (low, high) = body.range;
        assert!(low <= body.t && body.t <= high, "{name}: {}", body.t);
        assert!(body.place().is_finite());
    }
    let counts = [Fate::Kept, Fate::Merged, Fate::Walls, Fate::Removed];
    let counts = counts.map(|fate| engine.made.count(fate));
    assert_eq!(counts.iter().sum::<usize>(), placed.darts.len(), "{name}");
    assert!(counts[0] > 0, "{name} is empty");
}

#[test]
fn piles_of_even_presets_are_even_tight_and_in_bounds() {
    assert_presets(PILE.presets.iter().step_by(2));
}

#[test]
fn piles_of_odd_presets_are_even_tight_and_in_bounds() {
    assert_presets(PILE.presets.iter().skip(1).step_by(2));
}

/// Presets give no notice: neither about their links, nor about their sizes. Two tests share them, so that two cores
/// work.
fn assert_presets(presets: impl Iterator<Item = &'static Preset>) {
    for preset in presets {
        let recipe = recipe(preset.link);
        assert_eq!(recipe.link(), preset.link, "{}", preset.name);
        assert!(!preset.link.contains("size="), "{}", preset.name);
        let engine = settled(&recipe).expect(preset.name);
        assert_eq!(engine.remarks(), [], "{}", preset.name);
        assert_even(&engine, preset.name);
        assert_settled(&engine, preset.name);
        assert_good(&engine, preset);
    }
}

/// The code of the sentence with which a recipe stops.
fn stopped(link: &str) -> Code {
    match settled(&recipe(link)) {
        Ok(_) => panic!("{link} has a pile"),
        Err(notice) => notice.code,
    }
}

/// Two cubes that overlap, as an OBJ file.
fn crossing_cubes(size: f64, corners: [DVec3; 2]) -> String {
    let (places, triangles) = testing::cube(1);
    let vertex = |p: DVec3| format!("v {} {} {}\n", p.x, p.y, p.z);
    let mut text = String::new();
    for (corner, first) in corners.into_iter().zip([1, 1 + places.len() as u32]) {
        text.extend(places.iter().map(|p| vertex(corner + size * *p)));
        let face = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| v + first);
            format!("f {a} {b} {c}\n")
        };
        text.extend(triangles.iter().map(face));
    }
    text
}

/// The place where a file's component crosses itself, as the refusal says it.
fn crossing(content: &str, up: &str) -> DVec3 {
    let file = GivenFile::whole("a.obj", content.as_bytes().to_vec());
    let named = NamedFile::new(file.digest(), "a.obj").text();
    let link = format!("make=pile&variants=1&c1=file&file1={named}&up1={up}");
    let mut engine = PileEngine::new(&recipe(&link));
    engine.give(file);
    while engine.failure().is_none() {
        engine.advance();
    }
    let notice = engine.failure().expect("a refusal");
    assert_eq!(notice.code, Code::ComponentCrossing, "{notice}");
    let at = notice.args.iter().find(|(name, _)| *name == "at");
    let Some((_, Arg::Text(at))) = at else {
        panic!("{notice}");
    };
    let numbers: Vec<f64> = at.split(", ").map(|v| v.parse().unwrap()).collect();
    DVec3::from_slice(&numbers)
}

#[test]
fn the_place_where_a_component_crosses_itself_is_that_in_the_file() {
    let first = DVec3::new(10.0, -20.0, 30.0);
    for (size, home) in [(1.0, DVec3::ZERO), (1.0, first), (0.002, 0.001 * first)] {
        let corners = [home, home + size * DVec3::new(0.5, 0.25, 0.125)];
        for up in ["y", "z"] {
            let at = crossing(&crossing_cubes(size, corners), up);
            for corner in corners {
                let local = (at - corner) / size - 0.5;
                let off = local.abs().max_element() - 0.5;
                assert!(off.abs() < 0.03, "{size} {up}: {at}");
            }
        }
    }
}

#[test]
fn impossible_piles_are_refused_before_any_dart_is_thrown() {
    assert_eq!(
        stopped("make=pile&c1=leaf&sigma1=0.3&ps=20"),
        Code::PileMany
    );
    assert_eq!(stopped("make=pile&c1=ball&sigma1=8&ps=6"), Code::PileFew);
    assert_eq!(
        stopped("make=pile&c1=ball&k1=5&sigma1=0.3&ps=5"),
        Code::PileTooLarge
    );
}

#[test]
fn a_pile_of_few_bodies_has_a_remark() {
    let codes = |link: &str| {
        let engine = settled(&recipe(link)).expect("a pile");
        let codes: Vec<Code> = engine.remarks().iter().map(|notice| notice.code).collect();
        (engine.made.count(Fate::Kept), codes)
    };
    let link = "make=pile&c1=pebble&variants=1&form=heap&ps=5";
    let (kept, notices) = codes(&format!("{link}&k1=2"));
    assert!(kept < 20, "{kept}");
    assert!(notices.contains(&Code::PileSparse), "{notices:?}");
    // A longer range and a smaller size help, as the sentence says.
    let (more, notices) = codes(&format!("{link}&k1=1.8&l1=6"));
    assert!(more >= 20, "{more}");
    assert!(!notices.contains(&Code::PileSparse), "{notices:?}");
}

#[test]
fn the_spacing_of_the_sentence_fits() {
    let link = "make=pile&c1=rice&ps=30&sigma1=";
    let Err(notice) = settled(&recipe(&format!("{link}0.5"))) else {
        panic!("no refusal");
    };
    let fits = notice.args.iter().find(|(name, _)| *name == "fits");
    let Some((_, Arg::Text(fits))) = fits else {
        panic!("{notice}");
    };
    let mut engine = PileEngine::new(&recipe(&format!("{link}{fits}")));
    while engine.at().is_some_and(|at| at < 3) {
        assert_eq!(engine.failure(), None);
        engine.advance();
    }
}

/// A range of length 0 leaves bodies where their darts are.
#[test]
fn without_a_range_bodies_stay_at_their_darts() {
    let engine = settled(&recipe("make=pile&c1=pebble&l1=0&ps=6&sigma1=2")).expect("a pile");
    let pile = engine.made.settled.made().expect("bodies");
    let kept = pile.bodies().iter().filter(|b| b.fate == Fate::Kept);
    let moved = kept.filter(|body| body.t.abs() > 1e-9).count();
    assert_eq!(moved, 0);
}

#[test]
fn bodies_end_at_the_cut_sides_of_ground() {
    for form in ["stairs", "slope", "terrain"] {
        let link = format!("make=pile&c1=rice&variants=2&ps=7&form={form}");
        let engine = settled(&recipe(&link)).expect("a pile");
        let kinds = &engine.made.placed.made().expect("darts").kinds;
        let site = engine.made.site.made().expect("a shape");
        let (mut low, high) = site.mesh.bounds();
        low.y = site.floor();
        let bodies = engine.made.settled.made().expect("bodies").bodies();
        for body in bodies.iter().filter(|b| b.fate == Fate::Kept) {
            let slack = 0.05 * body.radius(kinds);
            for &point in &body.shape(kinds).points {
                let at = body.place() + body.turn * (body.scale * point);
                let beyond = (low - at).max(at - high);
                assert!(beyond.x.max(beyond.z) <= slack, "{form}: {at}");
                assert!(low.y - at.y <= slack, "{form}: {at}");
            }
        }
        let [kept, walls] = [Fate::Kept, Fate::Walls].map(|fate| engine.made.count(fate));
        assert!(walls > 0 && walls < kept, "{form}: {walls} of {kept}");
    }
}

#[test]
fn components_stay_while_others_change() {
    let mut engine = settled(&recipe("make=pile&c1=ball&ps=5&variants=2")).expect("a pile");
    let runs = |engine: &PileEngine| engine.runs();
    let before = runs(&engine);
    engine.ask(&recipe("make=pile&c1=ball&ps=5&variants=2&offset=0.1"));
    engine.take_up();
    while engine.is_forming() {
        engine.advance();
    }
    let after = runs(&engine);
    assert_eq!(before[..3], after[..3]);
    assert_eq!(after[3], before[3] + 1);
}

#[test]
fn steps_that_are_made_again_take_their_bodies_from_the_last_run() {
    let again = |engine: &mut PileEngine| {
        while engine.is_forming() {
            engine.advance();
        }
        let settled = engine.made.settled.made().expect("bodies");
        settled.bodies().to_vec()
    };
    let mut engine = settled(&recipe("make=pile&c1=ball&ps=5")).expect("a pile");
    let (first, digest) = (again(&mut engine), engine.digest());
    engine.forget_steps();
    assert_eq!(again(&mut engine), first);
    assert_eq!(engine.digest(), digest);
    // A body that was moved in between tells that no place was searched.
    engine.forget_steps();
    let mut moved = first.clone();
    let body = moved.iter_mut().find(|body| body.fate == Fate::Kept);
    body.expect("a body").t += 0.25;
    engine.made.known.as_mut().expect("bodies").1 = moved.clone().into();
    assert_eq!(again(&mut engine), moved);
    // Another recipe has bodies of its own.
    let other = recipe("make=pile&c1=ball&ps=5&seed=2");
    engine.forget_steps();
    engine.ask(&other);
    engine.take_up();
    again(&mut engine);
    assert_eq!(engine.digest(), settled(&other).expect("a pile").digest());
}

#[test]
fn wishes_at_random_end_in_a_pile_or_a_sentence() {
    let forms = [
        "riceball", "heap", "bowl", "openbox", "terrain", "sphere", "torus", "letter",
    ];
    for k in 0..12 {
        let mut random = Random::new(4, Purpose::Attribute, k);
        let mut pick = |words: &[&str]| words[random.below(words.len())].to_owned();
        let kinds = ["rice", "pebble", "ball", "box", "nut", "leaf"];
        let (one, two) = (pick(&kinds), pick(&["none", "ball", "chestnut"]));
        let link = format!(
            "make=pile&c1={one}&c2={two}&k2=1.3&form={}&ps={}&layers={}&variants=2&offset={}&order={}",
            pick(&forms),
            pick(&["5", "7"]),
            pick(&["1", "2"]),
            pick(&["0", "0.2"]),
            pick(&["random", "scan"]),
        );
        match settled(&recipe(&link)) {
            Ok(engine) => {
                assert_even(&engine, &link);
                assert_settled(&engine, &link);
            }
            Err(notice) => println!("{link}: {notice}"),
        }
    }
}
