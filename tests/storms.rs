//! A storm of acts on one studio, as visitors do them: they change the recipe in the midst of the work, open files, look at
//! any view, point at bodies, go back and forward through the steps, and save. Nothing breaks, and the result is that of the last
//! recipe.
//!
//! More of it, from another start: `BUBBLESTONE_RECIPES=2000 BUBBLESTONE_SEED=7 cargo test --release --test storms`.

// Tests in WebAssembly are built without the feature `house`.
#![cfg(not(target_arch = "wasm32"))]

mod common;
mod strangers;

use bubblestone::export::{MapKind, MeshFormat, MeshOrder};
use bubblestone::generators::{ALL, GivenFile, TurnOrder};
use bubblestone::random::Random;
use bubblestone::recipe::{Parameter, Recipe};
use bubblestone::scene::Camera;
use bubblestone::studio::Studio;
use common::number;
use glam::DVec2;
use strangers::{buildings, files, mended, try_all, wild, wild_building, wild_pile};

/// The number of acts in a storm.
const ACTS: usize = 60;
/// The most slices of work in most acts.
const SLICES: usize = 24;
/// Pixels of a frame.
const FRAME: [usize; 2] = [40, 30];
/// The parameters that decide how long the work takes.
const COSTLY: [&str; 4] = ["size", "cs", "cn", "ps"];

type Act = fn(&mut Random, &mut Studio);

/// All acts, the frequent ones several times.
const CHOICES: [(&str, Act); 20] = [
    ("work", work),
    ("work", work),
    ("work", work),
    ("work", work),
    ("recipe", take_another_recipe),
    ("recipe", take_another_recipe),
    ("value", take_another_value),
    ("value", take_another_value),
    ("file", open_a_file),
    ("restart", |_, studio| studio.restart()),
    ("live", |random, studio| {
        studio.set_live(random.below(2) == 0);
    }),
    ("step", |_, studio| studio.step(&mut || 0.0)),
    ("hold", hold_a_step),
    ("draw", draw),
    ("measure", measure),
    ("join", join_cells),
    ("save", save),
    ("turn", turn),
    ("turn", turn),
    ("turn", turn),
];

fn pick<T: Copy>(random: &mut Random, from: &[T]) -> T {
    from[random.below(from.len())]
}

/// A recipe of any generator that takes little time.
fn any_recipe(random: &mut Random) -> Recipe {
    let link = match random.below(8) {
        0 | 1 => format!("size=128&cs={}", 12 + random.below(30)),
        2 | 3 => wild(random),
        4 => wild_pile(random),
        5 | 6 => wild_building(random),
        _ => {
            let presets: Vec<_> = ALL.iter().flat_map(|one| one.presets).collect();
            let link = pick(random, &presets).link;
            format!("{link}&size=128&cs=24&cn=80&ps=4&variants=2")
        }
    };
    mended(&link)
}

/// A word of any view of the generator at work.
fn any_view(random: &mut Random, studio: &Studio) -> &'static str {
    let views = studio.generator().views;
    pick(random, &[views.bases, views.overlays].concat())
}

fn work(random: &mut Random, studio: &mut Studio) {
    for _ in 0..1 + random.below(SLICES) * random.below(SLICES) {
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
    }
}

/// Takes another recipe, mostly of the same generator: its stages then go on with what they have made.
fn take_another_recipe(random: &mut Random, studio: &mut Studio) {
    let word = studio.recipe().schema().word;
    let mut recipe = any_recipe(random);
    for _ in 0..8 {
        if recipe.schema().word == word {
            break;
        }
        recipe = any_recipe(random);
    }
    studio.set_recipe(recipe);
}

fn take_another_value(random: &mut Random, studio: &mut Studio) {
    let mut recipe = studio.recipe().clone();
    let rows = recipe.schema().rows;
    let row = &rows[random.below(rows.len())];
    let value = another_value(random, row);
    if !COSTLY.contains(&row.key.0) && recipe.set(row.key.0, &value).is_ok() {
        studio.set_recipe(recipe);
    }
}

fn another_value(random: &mut Random, row: &Parameter) -> String {
    match row.choices {
        [] => number(random, (row.min, row.max)).to_string(),
        choices => choices[random.below(choices.len())].word.to_owned(),
    }
}

/// Models of all kinds, and buildings.
fn all_files() -> Vec<GivenFile> {
    let all = [files(), buildings()].concat().into_iter();
    all.map(|(name, bytes)| GivenFile::whole(name, bytes))
        .collect()
}

/// Opens a file in the first role. Pavements have none, and not every generator reads every file.
fn open_a_file(random: &mut Random, studio: &mut Studio) {
    let mut files = all_files();
    let _ = studio.open_file(None, files.swap_remove(random.below(files.len())));
}

fn hold_a_step(random: &mut Random, studio: &mut Studio) {
    let step = (random.below(3) > 0).then(|| random.below(40) as u32);
    if let Some(rewind) = studio.engine_mut().rewind() {
        rewind.hold(step);
        for _ in 0..random.below(SLICES) {
            rewind.reach(&mut || 0.0, 0.0);
        }
    }
}

fn draw(random: &mut Random, studio: &mut Studio) {
    let views = [any_view(random, studio), any_view(random, studio)].join("+");
    for _ in 0..random.below(SLICES) {
        studio.engine_mut().prepare(&views, &mut || 0.0, 0.0);
    }
    studio.engine_mut().view(&views);
}

fn measure(random: &mut Random, studio: &mut Studio) {
    let view = any_view(random, studio);
    let place = DVec2::new(random.unit(), random.unit()) * studio.side() as f64;
    if let Some(cells) = studio.engine_mut().inspect() {
        cells.probe(place);
        cells.histograms();
        cells.height_range();
        cells.absences(view);
        cells.svg();
    }
    if let Some(outlines) = studio.engine_mut().outlines() {
        outlines.part(place);
        outlines.rings();
    }
    studio.engine_mut().energy();
    studio.report();
}

fn join_cells(random: &mut Random, studio: &mut Studio) {
    if let Some(steps) = studio.engine_mut().steps() {
        for _ in 0..random.below(SLICES) {
            steps.join(&mut || 0.0, 0.0);
        }
        steps.joined();
        steps.numbers();
        steps.energy_parts();
        steps.state_hash();
    }
}

/// Works on mesh files and on maps. Both refuse unfinished pictures.
fn save(random: &mut Random, studio: &mut Studio) {
    let order = MeshOrder {
        format: pick(random, &[MeshFormat::Glb, MeshFormat::Obj]),
        detail: random.below(3),
        images: None,
        joined: random.below(2) == 0,
    };
    let slices = random.below(SLICES);
    if let Ok(meshes) = studio.meshes() {
        (0..slices).all(|_| meshes.mesh_file(&order, &mut || 0.0, 0.0).is_ok());
        meshes.mesh_size(&order);
        meshes.places();
        meshes.building();
    }
    if let Ok(maps) = studio.maps() {
        let order = (1, &[MapKind::Height][..]);
        (0..slices).all(|_| maps.picture_file(order, &mut || 0.0, 0.0).is_ok());
    }
}

/// Works on a frame of all bodies or of a step in the making of one, and points at a pixel of it.
fn turn(random: &mut Random, studio: &mut Studio) {
    let view = any_view(random, studio);
    let quality = pick(random, &["moving", "still", "fine"]);
    let cut = pick(random, &["", "+whole=0.2,0.1,1,0.3", "+through=0,0,1,0"]);
    let subject = match random.below(3) {
        0 => format!("{}:{}", 1 + random.below(60), random.below(6)),
        _ => String::new(),
    };
    let order = TurnOrder {
        subject,
        camera: Camera::default(),
        size: FRAME,
        how: format!("{quality}+floor+{view}{cut}"),
    };
    let slices = random.below(SLICES) * random.below(SLICES);
    let [x, y] = FRAME.map(|side| random.below(side));
    let Ok(frames) = studio.frames() else { return };
    (0..slices).all(|_| frames.turn(&order, &mut || 0.0, 0.0).is_ok());
    let body = frames.body_at(x, y);
    frames.making(body.map_or(1, |body| body.id));
    frames.caption(view);
    frames.labels();
    if let Some(place) = frames.place_at(x, y) {
        frames.pixel_of(place);
    }
}

/// Saves all files of a finished picture, and points at its bodies.
fn take_all(random: &mut Random, studio: &mut Studio) {
    for (format, joined) in [
        (MeshFormat::Glb, false),
        (MeshFormat::Glb, true),
        (MeshFormat::Obj, false),
    ] {
        let order = MeshOrder {
            format,
            detail: 4,
            images: None,
            joined,
        };
        if let Ok(meshes) = studio.meshes() {
            let file = meshes.mesh_file(&order, &mut || 0.0, f64::INFINITY);
            assert!(file.is_ok_and(|file| file.done), "{order:?}");
        }
    }
    let order = TurnOrder {
        subject: String::new(),
        camera: studio.generator().camera(),
        size: FRAME,
        how: "moving+floor".to_owned(),
    };
    let Ok(frames) = studio.frames() else { return };
    assert!(
        frames
            .turn(&order, &mut || 0.0, f64::INFINITY)
            .is_ok_and(|frame| frame.done)
    );
    for _ in 0..40 {
        let [x, y] = FRAME.map(|side| random.below(side));
        if let Some(body) = frames.body_at(x, y) {
            frames.making(body.id);
        }
    }
}

/// Works up to the end and returns the digest, or the sentence of a refusal. The files of earlier generators are gone, so
/// all are given again.
fn end_of(studio: &mut Studio) -> String {
    if let Ok(given) = studio.files() {
        all_files().into_iter().for_each(|file| given.give(file));
    }
    match studio.finish(&mut || 0.0) {
        Ok(()) => studio.digest(),
        Err(why) => why.to_string(),
    }
}

#[test]
fn whatever_is_done_in_whatever_order_the_end_is_that_of_the_recipe() {
    try_all(20, |random| {
        let mut studio = Studio::new(ALL, any_recipe(random));
        for _ in 0..ACTS {
            let (word, act) = pick(random, &CHOICES);
            println!("{word} {} #{}", studio.stage(), studio.recipe().link());
            act(random, &mut studio);
        }
        studio.set_live(false);
        if let Some(rewind) = studio.engine_mut().rewind() {
            rewind.hold(None);
        }
        let end = end_of(&mut studio);
        let fresh = end_of(&mut Studio::new(ALL, studio.recipe().clone()));
        assert_eq!(end, fresh, "#{}", studio.recipe().link());
        if studio.stage() == "done" {
            take_all(random, &mut studio);
        }
        end
    });
}
