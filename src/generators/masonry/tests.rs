//! Properties of the generator's table, and of the blocks of buildings by rule.

use super::schema::{FILE, ROWS, keys};
use super::stages::LAYING;
use super::{MASONRY, MasonryEngine};
use crate::building::Rule;
use crate::export::{DETAILS, MeshFormat, MeshOrder};
use crate::generators::rows::numbered::check_row;
use crate::generators::{Engine, Meshes, Viewing};
use crate::masonry::laying::LayingPass;
use crate::masonry::tree::{PatternGenerator, TreePreset};
use crate::notice::Notice;
use crate::recipe::{Kind, Recipe};
use std::collections::BTreeSet;

pub(super) fn recipe(link: &str) -> Recipe {
    let (recipe, notices) = Recipe::from_link(&[&super::SCHEMA], link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    recipe
}

/// The engine of a recipe, up to its blocks; or the sentence with which it stopped.
pub(super) fn laid(link: &str) -> Result<MasonryEngine, Notice> {
    let mut engine = MasonryEngine::new(&recipe(link));
    while engine
        .at()
        .is_some_and(|at| at < super::stages::WORDS.len() - 1)
    {
        if let Some(notice) = engine.failure() {
            return Err(notice.clone());
        }
        engine.advance();
    }
    Ok(engine)
}

#[test]
fn there_is_a_word_for_each_building_and_a_row_for_each_of_its_numbers() {
    let row = super::SCHEMA.row("building").expect("a row");
    let words = row.choices.iter().map(|choice| choice.word);
    let words: Vec<&str> = words.filter(|&word| word != FILE).collect();
    assert_eq!(words, Rule::ALL.map(Rule::word));
    for rule in Rule::ALL {
        let own = |row: &&crate::recipe::Parameter| {
            let of = row.shown_for;
            let is_own = of.is_some_and(|(key, of)| key == keys::BUILDING && of == [rule.word()]);
            is_own && row.kind != Kind::Text
        };
        let rows: Vec<_> = ROWS.iter().filter(own).collect();
        assert_eq!(rows.len(), rule.numbers().len(), "{}", rule.word());
        for (row, number) in rows.iter().zip(rule.numbers()) {
            assert_eq!(row.key.0, format!("{}_{}", rule.word(), number.word));
            check_row(row, number);
        }
    }
}

#[test]
fn there_is_a_tree_for_each_pattern() {
    let row = super::SCHEMA.row("pattern").expect("a row");
    let mut words = row.choices.iter().map(|choice| choice.word);
    assert!(words.all(|word| TreePreset::of_word(word).is_some()));
}

#[test]
fn every_building_has_a_block_for_each_cell() {
    for rule in Rule::ALL {
        let link = format!("make=masonry&building={}", rule.word());
        let engine = laid(&link).expect("a building");
        let cells = engine.made.cells.made().expect("cells").cells();
        let scene = engine.made.shared.scene().expect("blocks");
        let drawn = scene
            .instances
            .iter()
            .filter(|instance| instance.id > 0)
            .count();
        assert_eq!(scene.fault(), None);
        assert!(
            drawn * 100 >= cells.len() * 98,
            "{}: {drawn} of {}",
            rule.word(),
            cells.len()
        );
        assert!(!cells.is_empty());
    }
}

/// The passes that lay cells, in order, each with the number of cells laid up to its end.
fn ends_of_passes(link: &str) -> Vec<(LayingPass, usize)> {
    let engine = laid(link).expect("a building");
    let cells = engine.made.cells.made().expect("cells").cells();
    let passes = cells.chunk_by(|a, b| a.pass() == b.pass());
    let mut count = 0;
    let ends = passes.map(|own| {
        count += own.len();
        (own[0].pass(), count)
    });
    ends.collect()
}

/// The steps of a laying, as a viewer counts them.
fn steps(link: &str) -> Vec<u32> {
    let mut engine = MasonryEngine::new(&recipe(link));
    let mut steps = Vec::new();
    while engine.at().is_some_and(|at| at <= LAYING) {
        engine.advance();
        steps.push(engine.progress().steps);
    }
    steps.dedup();
    steps
}

#[test]
fn presets_stop_at_the_ends_of_passes() {
    let all = [
        ("cube-laid", LayingPass::Edges),
        ("steps-corners", LayingPass::Corners),
        ("steps-edges", LayingPass::Edges),
        ("steps-panels", LayingPass::Panels),
    ];
    let mut stopped = Vec::new();
    for preset in MASONRY.presets {
        let step = Viewing::read(preset.view, &MASONRY)
            .0
            .and_then(|view| view.step);
        let Some(step) = step else { continue };
        let ends = ends_of_passes(preset.link);
        let end = ends.iter().find(|(_, end)| *end == step as usize);
        let (pass, _) = end.unwrap_or_else(|| panic!("{}: {step} of {ends:?}", preset.name));
        assert!(steps(preset.link).contains(&step), "{}", preset.name);
        stopped.push((preset.name, *pass));
    }
    assert_eq!(stopped, all);
}

#[test]
fn each_pass_ends_with_a_step() {
    let link = "make=masonry&building=steps&pattern=diagonal";
    let (ends, steps) = (ends_of_passes(link), steps(link));
    assert_eq!(ends.len(), 4);
    assert!(ends.iter().all(|(_, end)| steps.contains(&(*end as u32))));
    assert!(steps.len() > 100 && steps.is_sorted());
}

#[test]
fn a_single_wall_of_two_half_bricks_or_more_is_a_solid() {
    for (thickness, faces) in [(1, 1), (2, 6), (5, 6)] {
        for pattern in ["coped", "ashlar&module=ashlar"] {
            let link = format!("building=sheet&sheet_thickness={thickness}&pattern={pattern}");
            let engine = laid(&format!("make=masonry&size=128&{link}")).expect(&link);
            let site = engine.made.site.made().expect("a site");
            assert_eq!(site.building.faces().len(), faces, "{link}");
            let laying = engine.made.cells.made().expect("cells");
            let mut cells = laying.cells().iter();
            let has_coping = cells.any(|cell| cell.generator == PatternGenerator::Coping);
            assert_eq!(has_coping, faces > 1 && pattern == "coped", "{link}");
        }
    }
}

#[test]
fn blocks_are_counted_one_after_the_other() {
    let mut engine = MasonryEngine::new(&recipe("make=masonry&building=sheet&pattern=bricks"));
    let mut counts = Vec::new();
    while engine.at().is_some_and(|at| at <= LAYING) {
        counts.push(engine.progress().steps);
        engine.advance();
    }
    assert!(counts.is_sorted(), "{counts:?}");
    assert_eq!((counts[0], engine.progress().steps > 0), (0, true));
}

#[test]
fn weather_and_ground_lay_no_block_again() {
    let mut engine =
        laid("make=masonry&building=block&moss=0.2&ground=gravel").expect("a building");
    let (runs, digest) = (engine.runs(), engine.digest());
    let changed = |engine: &mut MasonryEngine, link: &str| {
        engine.ask(&recipe(link));
        engine.take_up();
        while engine.at().is_some_and(|at| at < super::stages::BLOCKS + 1) {
            engine.advance();
        }
        engine
            .runs()
            .into_iter()
            .zip(&runs)
            .map(|(now, was)| now > *was)
            .collect::<Vec<_>>()
    };
    let moss = changed(
        &mut engine,
        "make=masonry&building=block&moss=0.7&ground=gravel",
    );
    assert_eq!(moss[..4], [false, false, false, true]);
    assert_ne!(engine.digest(), digest);
    let ground = changed(
        &mut engine,
        "make=masonry&building=block&moss=0.2&ground=grass",
    );
    assert_eq!(ground[..4], [false, false, false, true]);
    changed(
        &mut engine,
        "make=masonry&building=block&moss=0.2&ground=gravel",
    );
    assert_eq!(engine.digest(), digest);
}

#[test]
fn the_house_is_a_small_file() {
    let mut engine = MasonryEngine::new(&recipe("make=masonry&size=128"));
    while engine.at().is_some() {
        engine.advance();
    }
    let order = MeshOrder {
        format: MeshFormat::Glb,
        detail: DETAILS[1].1,
        images: None,
        joined: false,
    };
    let estimate = engine.mesh_size(&order).expect("a size").bytes;
    let mut file = Vec::new();
    loop {
        let slice = engine
            .mesh_file(&order, &mut || 0.0, f64::INFINITY)
            .expect("a file");
        file.extend(slice.parts.concat());
        if slice.done {
            break;
        }
    }
    let bytes = file.len();
    assert!(bytes <= 2_000_000, "{bytes}");
    assert!(
        (0.5..2.0).contains(&(estimate / bytes as f64)),
        "{estimate} {bytes}"
    );
    let length = u32::from_le_bytes(file[12..16].try_into().expect("four bytes")) as usize;
    let json: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).expect("JSON");
    // Lengths are metres: the house is 5.5 m long, and its longest side is 1 in the scene.
    let scale = json["nodes"][0]["scale"][0].as_f64().expect("a scale");
    assert!((5.0..9.0).contains(&scale), "{scale}");
    let list = |key: &str| json[key].as_array().expect("a list").iter();
    let parts: BTreeSet<_> = list("nodes")
        .filter_map(|node| node["name"].as_str())
        .collect();
    for name in ["mortar", "glass", "wood", "ground", "edge_12"] {
        assert!(parts.contains(name), "{name}");
    }
    let is_clear = |material: &&serde_json::Value| material["alphaMode"] == "BLEND";
    let clear: BTreeSet<_> = list("materials")
        .filter(is_clear)
        .map(|one| one["name"].as_str())
        .collect();
    assert_eq!(clear, BTreeSet::from([Some("glass")]));
}
