//! Properties of the views' scenes.

use super::colours::type_of;
use super::diagrams::{Diagram, DiagramWork, STATES, Texture, clipped, lines, map_scene, occupied};
use super::figures::size;
use super::tests::laid;
use super::views::MasonryView;
use super::{MASONRY, MasonryEngine};
use crate::building::FaceId;
use crate::generators::scene_picture::SceneSource;
use crate::generators::{Engine, SeenLabel, TurnOrder};
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::{CellSort, Feature, Laying};
use crate::masonry::occupancy::Bitmap;
use crate::masonry::plan::{GridLine, is_wall, region};
use crate::scene::Scene;
use std::collections::BTreeSet;

pub(super) fn engine(link: &str) -> MasonryEngine {
    let pattern = match link.contains("pattern=") {
        true => "",
        false => "&pattern=bricks",
    };
    laid(&format!("make=masonry&size=128{pattern}&{link}")).expect("a building")
}

pub(super) fn laying(engine: &MasonryEngine) -> &Laying {
    engine.made.cells.made().expect("cells")
}

fn scene(engine: &MasonryEngine, view: MasonryView) -> Scene {
    diagram(engine, view).scene
}

fn diagram(engine: &MasonryEngine, view: MasonryView) -> Diagram {
    let site = engine.made.site.made().expect("a site");
    let blocks = engine.made.laid.params();
    let mut work = DiagramWork::new(site, blocks, laying(engine).cells());
    loop {
        if let Some(diagram) = work.advance(view, laying(engine), (site, blocks)) {
            return diagram;
        }
    }
}

/// The ids of a scene without 0, which bodies without an id have (mortar, for one).
fn ids(scene: &Scene) -> BTreeSet<u32> {
    let ids = scene.instances.iter().map(|instance| instance.id);
    ids.filter(|&id| id > 0).collect()
}

#[test]
fn bodies_of_views_have_ids_of_cells_or_features() {
    for link in ["building=gate", "building=tower", "building=ring"] {
        let engine = engine(link);
        let laying = laying(&engine);
        let (cells, features) = (laying.cells().len(), laying.order().len());
        for (view, most) in [
            (MasonryView::Features, cells),
            (MasonryView::Sizes, cells),
            (MasonryView::Occupancy, features),
            (MasonryView::Clipping, cells),
            (MasonryView::Plan, features),
            (MasonryView::Parity, features),
            (MasonryView::Seams, features),
        ] {
            let scene = scene(&engine, view);
            let ids = ids(&scene);
            assert_eq!(scene.fault(), None, "{link} {view:?}");
            assert!(ids.len() > 4, "{link} {view:?}: {ids:?}");
            assert!(ids.iter().all(|&id| id as usize <= most), "{link} {view:?}");
        }
    }
}

#[test]
fn lines_are_those_of_the_plan() {
    let engine = engine("building=gate");
    let laying = laying(&engine);
    let lines = lines(laying);
    for face in laying.textured_faces() {
        let grid = laying.plan().grid(face);
        let own = lines.iter().filter(|line| line.face == face);
        assert_eq!(own.clone().count(), grid.s.len() + grid.t.len());
        let rows = own.filter(|line| line.is_row).map(|line| line.at);
        assert_eq!(rows.collect::<Vec<f64>>(), grid.row_lines());
    }
    // The springing of the arch lies on a line of both walls.
    let front = |line: &&GridLine| {
        line.is_row && line.is_opening && is_wall(laying.building().face(line.face))
    };
    assert!(lines.iter().filter(front).count() >= 4);
    let faces: BTreeSet<FaceId> = laying.textured_faces().collect();
    let shown = ids(&scene(&engine, MasonryView::Plan));
    assert_eq!(shown.len(), faces.len());
}

#[test]
fn rows_of_edges_point_both_ways_in_turn() {
    let engine = engine("building=ring");
    let laying = laying(&engine);
    let rows = laying.pointings();
    let mut edges: Vec<_> = rows.iter().map(|row| row.edge).collect();
    edges.dedup();
    assert_eq!(edges.len(), 5);
    for pair in rows.windows(2).filter(|w| w[0].edge == w[1].edge) {
        let [below, above] = [0, 1].map(|k| pair[k].sides[0].0);
        assert_ne!(below, above, "{:?}", pair[0].edge);
    }
    assert!(
        rows.iter()
            .all(|row| row.sides[0].1.area() > row.sides[1].1.area())
    );
    let changed = laying.plan().changed(laying.building());
    assert_eq!(changed.len(), 1);
    assert!(changed.iter().all(|(face, [from, to])| {
        let [low, high] = laying.building().face(*face).bounds();
        *from >= low.x - 1e-6 && *to <= high.x + 1e-6 && from < to
    }));
}

#[test]
fn pixels_are_free_or_claimed_as_in_the_maps() {
    for link in ["building=gate", "building=tower"] {
        let engine = engine(link);
        let laying = laying(&engine);
        let diagram = diagram(&engine, MasonryView::Occupancy);
        let counts = diagram.claimed.expect("pixels");
        let pixels =
            |map: &Bitmap| (map.empty_area() / (map.pixel() * map.pixel())).round() as usize;
        let (mut free, mut all) = (0, 0);
        for face in laying.textured_faces() {
            let map = laying.face_map(face).bitmap();
            let whole = Bitmap::new(&region(laying.building().face(face)), map.pixel());
            free += pixels(map);
            all += pixels(&whole);
        }
        assert_eq!(counts.free, free);
        assert_eq!(counts.free + counts.by.iter().sum::<usize>(), all);
        assert!(counts.by.iter().all(|&pixels| pixels > 100), "{counts:?}");
    }
}

#[test]
fn maps_of_faces_are_free_then_claimed_around_then_full() {
    for link in [
        "building=gate",
        "building=tower",
        "building=steps&pattern=diagonal",
    ] {
        let engine = engine(link);
        let laying = laying(&engine);
        for face in laying.textured_faces() {
            let [before, after] = occupied(laying, face);
            assert!(
                0.0 < before && before <= after && after > 0.9,
                "{link} {face:?}: {before} {after}"
            );
            let scenes = [0, 1, 2].map(|state| map_scene(laying, face, state));
            assert!(scenes.iter().all(|scene| scene.fault().is_none()));
            // Free pixels have no hatching.
            let [free, some, full] = scenes.each_ref().map(|scene| scene.lines.len());
            assert!(free == 0 && 0 < some && some <= full, "{link} {face:?}");
            let far = scenes[1].bodies[0].radius;
            assert!((0.9..1.1).contains(&far), "{far}");
        }
        let walls = laying
            .textured_faces()
            .filter(|&face| is_wall(laying.building().face(face)));
        let shares = walls.map(|face| occupied(laying, face));
        // At least two walls owe more than a fifth of their pixels to their own cells.
        assert!(
            shares
                .filter(|[before, after]| before + 0.2 < *after)
                .count()
                > 1
        );
    }
}

#[test]
fn a_face_with_a_map_has_its_states_while_maps_are_shown() {
    let mut engine = engine("building=block");
    let face = laying(&engine).textured_faces().last().expect("a face");
    let order = laying(&engine).order();
    let place = order
        .iter()
        .position(|&feature| feature == Feature::Face(face));
    let id = place.expect("a face") as u32 + 1;
    engine.view("seams");
    assert_eq!(engine.states(id), [""; 0]);
    engine.view("occupancy");
    assert_eq!(engine.states(id), STATES);
    assert_eq!(engine.states(1), [""; 0], "a corner");
    let words: Vec<_> = engine.measures(id).iter().map(|(word, _)| *word).collect();
    assert_eq!(words, ["feature", "number", "before", "after"]);
    assert!(engine.made.step_scene("occupancy", (id, 2)).is_some());
    for none in [(id, 3), (1, 0), (0, 0), (9_999, 1)] {
        assert!(
            engine.made.step_scene("occupancy", none).is_none(),
            "{none:?}"
        );
    }
}

#[test]
fn what_was_cut_off_and_what_is_left_make_the_place() {
    let engine = engine("building=gate");
    let laying = laying(&engine);
    let mut count = 0;
    for (number, cell) in (0..).zip(laying.cells()) {
        let Some(place) = &cell.unclipped else {
            assert!(clipped(laying, (number, cell)).is_empty());
            continue;
        };
        let Feature::Face(face) = cell.feature else {
            panic!("{cell:?}")
        };
        count += 1;
        let own = cell.claims.iter().filter(|(on, _)| *on == face);
        let left: f64 = own.map(|(_, claim)| claim.shared_area(place)).sum();
        let parts = clipped(laying, (number, cell));
        let cut: f64 = parts.iter().map(|part| part.part.area()).sum();
        // Small parts do not count, and parts under two claims count twice.
        let ratio = (left + cut) / place.area();
        assert!((0.85..1.15).contains(&ratio), "{ratio} {cell:?}");
        assert!(parts.iter().all(|part| part.face == face));
    }
    assert!(count > 10, "{count}");
}

#[test]
fn a_texture_breaks_at_edges_where_cells_do_not() {
    let engine = engine("building=block");
    let Texture { bricks, broken } = Texture::new(laying(&engine));
    assert!(broken > 20 && bricks > 2 * broken, "{broken} of {bricks}");
    // The cells stand to the right of the texture, with a gap between, and both are in sight.
    let scene = scene(&engine, MasonryView::Seams);
    let ends = |is_of: fn(f32) -> bool| {
        let own = scene
            .instances
            .iter()
            .map(|instance| scene.ball_of(instance).0.x);
        let own = own.filter(|&x| is_of(x));
        own.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        })
    };
    let ([from, left], [right, to]) = (ends(|x| x < 0.0), ends(|x| x > 0.0));
    assert!(
        right - left > 0.05 && from > -0.62 && to < 0.62,
        "{from} {left} {right} {to}"
    );
}

#[test]
fn labels_of_visible_features_stand_on_bodies() {
    let mut engine = engine("building=gabled");
    let mut labels = |view: &str| {
        let order = TurnOrder {
            subject: String::new(),
            camera: MASONRY.camera(),
            size: [200, 200],
            how: format!("still+nothing+{view}"),
        };
        let frames = engine.frames().expect("frames");
        while !frames
            .turn(&order, &mut || 0.0, f64::INFINITY)
            .expect("a frame")
            .done
        {}
        let labels = frames.labels();
        // Panes of glass are no blocks, and blocks of edges have the labels of both faces.
        let mut is_on_own = |SeenLabel {
                                 text,
                                 pixel: [x, y],
                             }: &SeenLabel| {
            let body = frames.body_at(*x as usize, *y as usize);
            let mut words = body.into_iter().flat_map(|body| body.words);
            words.any(|(of, word)| of == "labels" && &word == text)
        };
        let on_own = labels.iter().filter(|label| is_on_own(label)).count();
        assert!(3 * on_own >= labels.len(), "{on_own} of {labels:?}");
        labels
    };
    let texts = labels("features").into_iter().map(|label| label.text);
    let texts: BTreeSet<String> = texts.collect();
    assert!(
        ["Roof", "Window", "Window, Sill"]
            .iter()
            .all(|&text| texts.contains(text)),
        "{texts:?}"
    );
    assert_eq!(labels("sizes"), []);
}

#[test]
fn bodies_are_told_by_the_view_that_shows_them() {
    let mut engine = engine("building=gabled");
    engine.view("features");
    let cells = laying(&engine).cells();
    let sill = cells.iter().position(|cell| {
        let labels = cell.feature.labels(laying(&engine).building());
        matches!(cell.feature, Feature::Edge(_)) && labels.iter().any(|label| label == "Window")
    });
    let id = sill.expect("a window") as u32 + 1;
    let figures: Vec<_> = engine.measures(id).iter().map(|(word, _)| *word).collect();
    let all = [
        "length", "height", "depth", "sort", "course", "feature", "number",
    ];
    assert!(figures.iter().all(|word| all.contains(word)), "{figures:?}");
    assert!(figures.len() >= 6);
    let words = engine.named(id);
    assert!(
        words
            .iter()
            .any(|(of, word)| *of == "labels" && word.contains("Window"))
    );
    assert!(
        words
            .iter()
            .any(|(of, word)| *of == "node" && !word.is_empty())
    );
    engine.view("parity");
    let figures = engine.measures(1);
    assert_eq!(figures, [("feature", 0.0), ("number", 0.0)]);
    engine.view("polygons");
    assert_eq!(engine.measures(1)[0], ("feature", 2.0));
    assert_eq!(engine.measures(9_999_999), []);
}

#[test]
fn whole_bricks_are_told_with_the_size_of_a_brick() {
    let engine = engine("building=block");
    let cells = laying(&engine).cells().iter();
    let whole = cells
        .filter(|cell| cell.sort == CellSort::Whole && !matches!(cell.feature, Feature::Corner(_)));
    let mut kinds = BTreeSet::new();
    for cell in whole {
        let told = size(cell);
        let of = |word: &str| told.iter().find(|(known, _)| *known == word).unwrap().1;
        // Sides on faces have no joint, so they are up to 10 mm longer.
        let near = |word: &str, wanted: f64| (of(word) - wanted).abs() < 11.0;
        assert!(
            near("length", 240.0) && near("height", 75.0) && near("depth", 118.0),
            "{cell:?} {told:?}"
        );
        kinds.insert(type_of(cell.feature));
    }
    assert_eq!(kinds, BTreeSet::from([1, 2]));
}

#[test]
fn places_of_rows_lie_on_their_walls() {
    let engine = engine("building=gabled");
    let laying = laying(&engine);
    let inside =
        |(face, place): &(FaceId, Footprint)| laying.face_map(*face).has_inside(place, 0.98);
    let rows = laying.pointings();
    assert!(rows.len() > 100);
    assert!(rows.iter().flat_map(|row| &row.sides).all(inside));
}
