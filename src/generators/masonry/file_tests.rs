//! Buildings of files: their units, and the sentences about files that cannot be laid.

use super::MasonryEngine;
use super::colours::{GLASS_ROW, MORTAR_ROW};
use super::params::BuildingParams;
use super::schema::keys;
use super::site::SiteBuild;
use super::stages::LAYING;
use super::tests::recipe;
use crate::building::obj::FileSpace;
use crate::building::{DrawnPlan, Module};
use crate::generators::{Engine, Files, GivenFile, Meshes};
use crate::notice::{Arg, Code, Notice};

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
fn a_file_of_unusual_size_is_asked_about_its_unit() {
    let told = |size: [f64; 3]| {
        let notice = laid_file("large.obj", &box_of(size)).expect_err("a sentence");
        let text = notice.to_string();
        assert!(!text.contains('{'), "{text}");
        text
    };
    let millimetres = told([3000.0, 2400.0, 3000.5]);
    assert!(
        millimetres.contains("3000 by 2400 by 3000.5 metres")
            && millimetres.contains("Millimetres (mm) would fit"),
        "{millimetres}"
    );
    // Beyond the farthest coordinate, too.
    let far = told([12_000.0, 2400.0, 3000.5]);
    assert!(far.contains("Millimetres (mm) would fit"), "{far}");
    let centimetres = told([600.0, 270.0, 450.0]);
    assert!(
        centimetres.contains("Centimetres (cm) would fit"),
        "{centimetres}"
    );
    let link = "make=masonry&pattern=bricks&unit=mm";
    let nothing = engine_with_file(link, "large.obj", &box_of([3e6; 3]), LAYING).err();
    let nothing = nothing.expect("a sentence").to_string();
    assert!(nothing.contains("would be needed"), "{nothing}");
    // A building on a map is moved, unless one of its vertices stays far away.
    let lines = box_of([3.0; 3]);
    let away = lines.replace("v ", "v 2000");
    laid_file("away.obj", &away).expect("a building");
    let torn = lines.replacen("v ", "v 10000000000000000000", 1);
    let torn = laid_file("torn.obj", &torn).expect_err("a sentence");
    let torn = torn.to_string();
    assert!(torn.contains("Vertex") && torn.contains("origin"), "{torn}");
}

#[test]
fn a_building_may_be_in_another_unit_and_on_its_side() {
    let draft = |link: &str, content: &str| {
        let engine = engine_with_file(link, "box.obj", content, LAYING).expect("a building");
        engine.building().expect("a building")
    };
    let metres = box_of([6.096, 3.048, 9.144]);
    let usual = draft("make=masonry&pattern=bricks", &metres);
    for (unit, size) in [
        ("cm", [609.6, 304.8, 914.4]),
        ("mm", [6096.0, 3048.0, 9144.0]),
        ("in", [240.0, 120.0, 360.0]),
        ("ft", [20.0, 10.0, 30.0]),
    ] {
        let link = format!("make=masonry&pattern=bricks&unit={unit}");
        assert_eq!(draft(&link, &box_of(size)), usual, "{unit}");
    }
    // Turned by a quarter about x: what was y is z, and z is -y.
    let lines = metres.lines().map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        match words[0] {
            "v" => format!("v {} -{} {}\n", words[1], words[3], words[2]),
            _ => format!("{line}\n"),
        }
    });
    let link = "make=masonry&pattern=bricks&up=z";
    assert_eq!(draft(link, &lines.collect::<String>()), usual);
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
