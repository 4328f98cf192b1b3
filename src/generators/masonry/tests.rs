//! Properties of the generator's table, and of the blocks of buildings by rule.

use super::colours::{GLASS_ROW, MORTAR_ROW};
use super::params::BuildingParams;
use super::schema::{FILE, ROWS, keys};
use super::site::SiteBuild;
use super::stages::LAYING;
use super::{MASONRY, MasonryEngine};
use crate::building::obj::FileSpace;
use crate::building::{DrawnPlan, Module, Rule};
use crate::export::{DETAILS, MeshFormat, MeshOrder};
use crate::generators::{Engine, Files, GivenFile, Meshes, Viewing};
use crate::masonry::laying::LayingPass;
use crate::masonry::tree::{PatternGenerator, TreePreset};
use crate::notice::{Arg, Code, Notice};
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
            assert_eq!((row.min, row.max), (number.least, number.most));
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

/// An engine with a building from this file, up to a stage; or the sentence with which it stopped.
fn engine_of_file(name: &str, content: &str, stage: usize) -> Result<MasonryEngine, Notice> {
    engine_with_file("make=masonry&pattern=bricks", name, content, stage)
}

/// An engine with the recipe of a link and the building of a file, up to a stage; or the sentence with which it stopped.
fn engine_with_file(
    link: &str,
    name: &str,
    content: &str,
    stage: usize,
) -> Result<MasonryEngine, Notice> {
    let file = GivenFile::whole(name, content.as_bytes().to_vec());
    let mut recipe = recipe(link);
    let row = file.named().row();
    let rules = super::SCHEMA.rules;
    rules
        .draw(&mut recipe, keys::MODEL, Some(vec![row]))
        .expect("a file");
    let mut engine = MasonryEngine::new(&recipe);
    Files::give(&mut engine, file);
    while engine.at().is_some_and(|at| at < stage) {
        if let Some(notice) = engine.failure() {
            return Err(notice.clone());
        }
        engine.advance();
    }
    Ok(engine)
}

/// The number of cells of a building from this file; or the sentence with which the engine stopped.
fn laid_file(name: &str, content: &str) -> Result<usize, Notice> {
    let engine = engine_of_file(name, content, LAYING)?;
    Ok(engine.made.cells.made().expect("cells").cells().len())
}

/// A box as an OBJ file (metres).
fn box_of([x, y, z]: [f64; 3]) -> String {
    let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    let side = |k: usize, of: usize, length: f64| if k & of > 0 { length } else { 0.0 };
    let vertices =
        (0..8).map(|k| format!("v {} {} {}\n", side(k, 1, x), side(k, 2, y), side(k, 4, z)));
    vertices.collect::<String>() + faces
}

#[test]
fn the_module_of_the_sentence_about_too_many_blocks_fits() {
    let file = box_of([40.0, 20.0, 40.0]);
    let site = |module: Module| {
        let params = BuildingParams {
            rule: None,
            space: FileSpace::METRES,
            plan: DrawnPlan::default(),
            module,
        };
        let mut work = None;
        loop {
            match SiteBuild::advance(&params, &mut work, Some(file.as_bytes())) {
                Ok(None) => (),
                Ok(Some(site)) => return Ok(site),
                Err(notice) => return Err(notice),
            }
        }
    };
    let notice = site(Module::NORMAL).err().expect("too many blocks");
    assert_eq!(notice.code, Code::MasonryMany);
    let metres = |name: &str| {
        let arg = notice.args.iter().find(|(known, _)| *known == name);
        match arg.map(|(_, arg)| arg) {
            Some(Arg::Text(text)) => 1e-3 * text.parse::<f64>().expect("a number"),
            _ => panic!("{name}"),
        }
    };
    let module = Module {
        half: metres("fits"),
        course: metres("course"),
        ..Module::NORMAL
    };
    assert!(site(module).is_ok());
}

#[test]
fn a_file_in_millimetres_is_asked_about_its_unit() {
    let notice = laid_file("mm.obj", &box_of([3000.0, 2400.0, 3000.5])).expect_err("a sentence");
    let text = notice.to_string();
    assert!(
        text.contains("3000 by 2400 by 3000.5 metres") && text.contains("in millimetres?"),
        "{text}"
    );
    assert!(!text.contains('{'), "{text}");
}

#[test]
fn a_building_may_be_in_another_unit_and_on_its_side() {
    let draft = |link: &str, content: &str| {
        let engine = engine_with_file(link, "box.obj", content, LAYING).expect("a building");
        engine.building().expect("a building")
    };
    let metres = box_of([3.0, 2.54, 6.096]);
    let usual = draft("make=masonry&pattern=bricks&building=file", &metres);
    for (unit, size) in [
        ("cm", [300.0, 254.0, 609.6]),
        ("mm", [3000.0, 2540.0, 6096.0]),
        ("in", [3.0 / 0.0254, 100.0, 240.0]),
        ("ft", [3.0 / 0.3048, 2.54 / 0.3048, 20.0]),
    ] {
        let link = format!("make=masonry&pattern=bricks&building=file&unit={unit}");
        let own = draft(&link, &box_of(size));
        let is_exact = unit == "cm" || unit == "mm";
        assert!(!is_exact || own == usual, "{unit}");
        let corner = own.contains("2.54") && own.contains("6.096");
        assert!(corner, "{unit}: {own}");
    }
    // Turned by a quarter about x: what was y is z, and z is -y.
    let lines = metres.lines().map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        match words[0] {
            "v" => format!("v {} -{} {}\n", words[1], words[3], words[2]),
            _ => format!("{line}\n"),
        }
    });
    let link = "make=masonry&pattern=bricks&building=file&up=z";
    assert_eq!(draft(link, &lines.collect::<String>()), usual);
}

#[test]
fn a_file_that_is_far_too_large_is_asked_about_its_unit() {
    let notice = laid_file("mm.obj", &box_of([12_000.0, 2400.0, 3000.5])).expect_err("a sentence");
    let text = notice.to_string();
    assert!(
        text.contains("Vertex 2 ") && text.contains("unit"),
        "{text}"
    );
}

#[test]
fn polygons_that_clash_are_told_apart() {
    let refused = |content: &str| {
        let notice = laid_file("clash.obj", content).expect_err("a sentence");
        notice.to_string()
    };
    let cube = box_of([2.0; 3]);
    let turned = refused(&cube.replace("f 1 3 4 2", "f 2 4 3 1"));
    assert!(
        turned.contains("vertices 1 and 2, polygons 1 and 3 run the same way"),
        "{turned}"
    );
    let beside = cube.lines().map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        match words[0] {
            "v" => format!(
                "v {} {} {}\n",
                2.0 + words[1].parse::<f64>().unwrap(),
                words[2],
                words[3]
            ),
            _ => {
                let own = words[1..]
                    .iter()
                    .map(|v| format!(" {}", 8 + v.parse::<u32>().unwrap()));
                format!("f{}\n", own.collect::<String>())
            }
        }
    });
    let two = refused(&(cube.clone() + &beside.collect::<String>()));
    assert!(two.contains("4 polygons meet; at most two may"), "{two}");
    let twice = refused(&(cube.clone() + "f 4 2 1 3\n"));
    assert!(
        twice.contains("Polygons 1 and 7 have the same vertices"),
        "{twice}"
    );
    let itself = refused("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 3 0\nf 1 2 3 1 2 4 5\n");
    assert!(
        itself.contains("Polygon 1 runs twice from vertex 1 to vertex 2"),
        "{itself}"
    );
}

#[test]
fn buildings_of_files_are_laid_or_refused_with_a_sentence() {
    assert!(laid_file("box.obj", &box_of([2.0, 1.0, 1.5])).expect("blocks") > 100);
    let refused = |name, content: &str| laid_file(name, content).map_err(|notice| notice.code);
    assert_eq!(
        refused("text.json", "{\"version\":1,"),
        Err(Code::BuildingJson)
    );
    let empty = r#"{"version":1,"unit":"m","v":[],"faces":[]}"#;
    let marked = format!("\u{FEFF}{empty}");
    for text in [empty, &marked] {
        assert_eq!(refused("empty.json", text), Err(Code::BuildingEmpty));
    }
    assert_eq!(
        refused("thin.obj", &box_of([1.0, 1.0, 0.03])),
        Err(Code::MasonryNarrow)
    );
    assert_eq!(
        refused("small.obj", &box_of([0.04; 3])),
        Err(Code::MasonryLarge)
    );
}

/// Parts of a building's scene, without its blocks, by their rows in the table of materials.
fn materials_of(content: &str) -> Vec<u8> {
    let engine = engine_of_file("box.obj", content, LAYING + 1).expect("a building");
    let wall = engine.made.laid.made().expect("blocks");
    let parts = wall.instances.iter().filter(|part| part.id == 0);
    parts
        .filter_map(|part| Some(part.paint?.material))
        .collect()
}

#[test]
fn faces_of_a_file_that_are_named_glass_look_like_glass() {
    let walls = box_of([2.0, 1.0, 1.5]);
    assert_eq!(materials_of(&walls), [MORTAR_ROW]);
    let front = walls.replace("f 5 6 8 7\n", "g Glass\nf 5 6 8 7\ng Wall\n");
    assert_eq!(materials_of(&front), [MORTAR_ROW, GLASS_ROW]);
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
