//! Notices that only a native program can get. The WebAssembly module takes no lines beside rings and no camera
//! to correct, and its tests have no time for too many triangles or cells. `node/shipped.test.mjs` makes the
//! module give all other notices, and reads from this file which ones it can leave out.

use super::lines::outline;
use bubblestone::building::{
    CircularArc, Draft, DraftArc, DraftFace, FaceSurface, MOST_FACES, MOST_SIDES, Module, Path,
    Piece, Rule, Sweep, write_json,
};
use bubblestone::generators::pavement::{self, PavementRecipe};
use bubblestone::generators::{ALL, GivenFile};
use bubblestone::modelfiles::Reading;
use bubblestone::notice::{Arg, Code, Notice};
use bubblestone::recipe::Recipe;
use bubblestone::scene::Camera;
use bubblestone::studio::Studio;
use bubblestone::surface_field::fit::check_count;
use bubblestone::trimesh::TriMesh;
use bubblestone::trimesh::refine::Refining;
use glam::{DVec2, DVec3};

fn codes(notices: &[Notice]) -> Vec<Code> {
    notices.iter().map(|notice| notice.code).collect()
}

#[test]
fn a_camera_is_mended() {
    let read = |text| codes(&Camera::default().read(text).1);
    assert_eq!(read("20,none"), [Code::CameraNumber]);
    assert_eq!(read("0,0,1,30,0,0,0,0"), [Code::CameraNumbers]);
}

#[test]
fn lines_beside_rings_are_refused() {
    let refused = |lines| {
        let mut recipe = pavement::recipe("").0;
        recipe.set_polygon(&outline(lines)).unwrap_err()
    };
    let short = refused(vec![vec![DVec2::splat(150.0); 2]]);
    assert_eq!(short.code, Code::LineShort);
    let [(_, Arg::Part(line))] = &short.args[..] else {
        panic!("{short}");
    };
    assert_eq!(line.code, Code::Line);
    let line = |count: usize, y: f64| -> Vec<DVec2> {
        let x = |k: usize| 110.0 + 0.1 * k as f64;
        (0..count).map(|k| DVec2::new(x(k), y)).collect()
    };
    assert_eq!(refused(vec![line(513, 130.0)]).code, Code::LinePoints);
    let many = (0..65).map(|k| line(2, 110.0 + f64::from(k)));
    assert_eq!(refused(many.collect()).code, Code::LinesRefused);
}

#[test]
fn too_much_for_a_machine_is_refused() {
    assert_eq!(check_count(1e6).unwrap_err().code, Code::SurfaceCells);
    let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let triangle = TriMesh::new(corners, vec![[0, 1, 2]]).expect("a mesh");
    let refined = Refining::evenly(triangle, 1e-6).finish_all();
    assert_eq!(
        refined.err().map(|why| why.code),
        Some(Code::RefinedTooMany)
    );
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    text += &"f 1 2 3\n".repeat(2_000_001);
    let read = Reading::read("a.obj", text.into_bytes());
    assert_eq!(read.err().map(|why| why.code), Some(Code::ModelTooLarge));
}

/// The codes of why a building's file is refused, or of the remarks on it.
fn said_of(text: &str, link: &str) -> Vec<Code> {
    let link = format!("make=masonry&size=128{link}");
    let ends = ["laying", "bodies", "light", "done"];
    said_of_file(&link, ("building.json", text), &ends)
}

/// The codes of why a file is refused, or of the remarks on it when one of these stages is reached.
fn said_of_file(link: &str, (name, text): (&str, &str), ends: &[&str]) -> Vec<Code> {
    let recipe: Recipe = ALL.recipe(link).0;
    let mut studio = Studio::new(ALL, recipe);
    let file = GivenFile::whole(name, text.as_bytes().to_vec());
    studio.open_file(None, file).expect("a file");
    while studio.problem().is_none() && !ends.contains(&studio.stage()) {
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
    }
    let problem = studio.problem().cloned();
    let remarks = studio.engine().remarks();
    codes(&problem.into_iter().chain(remarks).collect::<Vec<Notice>>())
}

#[test]
fn a_fan_of_needles_is_paved_on_a_simpler_surface() {
    use std::fmt::Write;
    let said = |rim: u32| {
        let mut text = String::from("v 0 0 0\n");
        for k in 0..rim {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(rim);
            let (x, z) = (libm::cos(angle), -libm::sin(angle));
            writeln!(
                text,
                "v {x:.7} 0 {z:.7}\nf 1 {} {}",
                k + 2,
                (k + 1) % rim + 2
            )
            .expect("text");
        }
        let link = "make=surface&form=file&cn=60&size=128";
        said_of_file(link, ("disc.obj", &text), &["cells", "done"])
    };
    assert_eq!(said(30_000), [Code::ModelNeedles]);
    assert_eq!(said(6_000), []);
}

#[test]
fn a_huge_model_is_made_coarser() {
    use std::fmt::Write;
    let said = |squares: usize| {
        let mut text = String::new();
        let side = squares + 1;
        for k in 0..side * side {
            writeln!(text, "v {} 0 {}", k % side, k / side).expect("text");
        }
        for k in (0..squares * side).filter(|k| k % side < squares) {
            let [a, b, c, d] = [k, k + side, k + side + 1, k + 1].map(|v| v + 1);
            writeln!(text, "f {a} {b} {c} {d}").expect("text");
        }
        let link = "make=surface&form=file&cn=60&size=128";
        said_of_file(link, ("flat.obj", &text), &["packing", "done"])
    };
    assert_eq!(said(255), []);
    assert_eq!(said(257), [Code::ModelCoarser]);
}

/// A building by rule with something changed.
fn changed(rule: Rule, change: impl FnOnce(&mut Draft)) -> Vec<Code> {
    let mut draft = rule.draft(&Module::NORMAL, &[]);
    change(&mut draft);
    said_of(&write_json(&draft), "")
}

#[test]
fn files_that_are_no_buildings_are_refused() {
    let good = write_json(&Rule::Block.draft(&Module::NORMAL, &[]));
    assert_eq!(said_of(&good, ""), []);
    assert_eq!(said_of(&good[..40], ""), [Code::BuildingJson]);
    for (from, to, code) in [
        ("\"version\":1", "\"version\":2", Code::BuildingVersion),
        ("\"unit\":\"m\"", "\"unit\":\"mm\"", Code::BuildingUnit),
        ("\"v\":", "\"w\":", Code::BuildingField),
        ("\"param\"", "\"other\"", Code::BuildingNoSurface),
    ] {
        assert_eq!(said_of(&good.replacen(from, to, 1), ""), [code]);
    }
    let map = "v 5e5 0 0\nv 500003 0 0\nv 500003 3 0\nv 5e5 3 0\nf 1 2 3 4\n";
    assert_eq!(said_of(map, "")[..1], [Code::BuildingMoved]);
    let block = |change: fn(&mut Draft)| changed(Rule::Block, change);
    let far = block(|draft| draft.vertices[0].x = 20_000.0);
    assert_eq!(far, [Code::BuildingNumber]);
    assert_eq!(block(|draft| draft.faces.clear()), [Code::BuildingEmpty]);
    let many = block(|draft| draft.faces = vec![draft.faces[0].clone(); MOST_FACES + 1]);
    assert_eq!(many, [Code::BuildingFaces]);
    let sides = block(|draft| draft.vertices.resize(MOST_SIDES + 1, DVec3::ZERO));
    assert_eq!(sides, [Code::BuildingSides]);
    let vertex = block(|draft| draft.faces[2].loops[0][1] = 99);
    assert_eq!(vertex, [Code::BuildingVertex]);
    let short = block(|draft| draft.faces[0].loops[0].truncate(2));
    assert_eq!(short, [Code::BuildingLoop]);
}

#[test]
fn bad_arcs_and_surfaces_are_told_apart() {
    let arc = |change: fn(&mut DraftArc)| changed(Rule::Gate, |draft| change(&mut draft.arcs[0]));
    assert_eq!(arc(|arc| arc.axis = DVec3::ZERO), [Code::BuildingArcAxis]);
    assert_eq!(arc(|arc| arc.centre.x += 0.1), [Code::BuildingArcRadius]);
    assert_eq!(arc(|arc| arc.centre.z += 0.1), [Code::BuildingArcPlane]);
    let twice = changed(Rule::Gate, |draft| draft.arcs.push(draft.arcs[0]));
    assert_eq!(twice, [Code::BuildingArcTwice]);
    let swept = |pieces: Vec<Piece>, direction: DVec3| {
        changed(Rule::Block, |draft| {
            draft.faces[0].surface =
                Some(FaceSurface::Sweep(Sweep::new(Path::new(pieces), direction)));
        })
    };
    let line = |from: f64, to: f64| Piece::Line {
        from: DVec3::X * from,
        to: DVec3::X * to,
    };
    let turn = Piece::Line {
        from: DVec3::X,
        to: DVec3::X + DVec3::Z,
    };
    let up = DVec3::Y;
    assert_eq!(swept(vec![line(1.0, 1.0)], up), [Code::BuildingNoLength]);
    assert_eq!(
        swept(vec![line(0.0, 1.0)], 2.0 * up),
        [Code::BuildingDirection]
    );
    assert_eq!(
        swept(vec![line(0.0, 1.0), line(1.1, 2.0)], up),
        [Code::BuildingGap]
    );
    assert_eq!(swept(vec![line(0.0, 1.0), turn], up), [Code::BuildingKink]);
    let tower =
        |change: fn(&mut DraftFace)| changed(Rule::Tower, |draft| change(&mut draft.faces[0]));
    assert_eq!(
        tower(|face| face.loops.truncate(1)),
        [Code::BuildingUnbounded]
    );
    let turned = tower(|face| {
        if let Some(FaceSurface::Sweep(sweep)) = &face.surface
            && let [Piece::Arc(arc), ..] = sweep.profile().pieces()
        {
            let arc = Piece::Arc(CircularArc {
                to: arc.from + 9.0,
                ..*arc
            });
            face.surface = Some(FaceSurface::Sweep(Sweep::new(
                Path::new(vec![arc]),
                sweep.direction(),
            )));
        }
    });
    assert_eq!(turned, [Code::BuildingTurns]);
}

/// Moves a flat face's surface along its normal (metres).
fn moved(face: &mut DraftFace, by: f64) {
    let frame = face.surface.as_ref().expect("a surface").frame(0.0, 0.0);
    face.surface = Some(FaceSurface::flat(
        frame.origin + frame.normal * by,
        frame.s,
        frame.t,
    ));
}

#[test]
fn faces_that_do_not_fit_together_are_told_apart() {
    let block = |change: fn(&mut Draft)| changed(Rule::Block, change);
    assert_eq!(
        block(|draft| moved(&mut draft.faces[4], 0.002)),
        [Code::BuildingOff]
    );
    let alone = |change: fn(&mut DraftFace)| {
        changed(Rule::Block, |draft| {
            draft.faces.truncate(1);
            change(&mut draft.faces[0]);
        })
    };
    assert_eq!(
        alone(|face| face.loops[0].swap(0, 1)),
        [Code::BuildingCrossing]
    );
    assert_eq!(
        alone(|face| face.loops[0].reverse()),
        [Code::BuildingInsideOut]
    );
    let turned = block(|draft| draft.faces[4].loops[0].reverse());
    assert_eq!(turned, [Code::BuildingTurned]);
    let three = block(|draft| {
        let [a, b] = [draft.faces[0].loops[0][0], draft.faces[0].loops[0][1]];
        let first = draft.vertices.len() as u32;
        for v in [a, b] {
            draft.vertices.push(draft.vertices[v as usize] + DVec3::Z);
        }
        let mut face = draft.faces[0].clone();
        face.surface = Some(FaceSurface::flat(
            draft.vertices[a as usize],
            DVec3::Z,
            DVec3::X,
        ));
        face.loops = vec![vec![a, first, first + 1, b]];
        draft.faces.push(face);
    });
    assert_eq!(three, [Code::BuildingManifold]);
}

#[test]
fn what_is_odd_about_a_building_is_told() {
    let named = changed(Rule::Block, |draft| {
        draft.edge_flips.push([0, 99]);
        draft.corner_flips.push(77);
        draft.arcs.push(DraftArc {
            from: 0,
            to: 2,
            centre: (draft.vertices[0] + draft.vertices[2]) * 0.5,
            axis: DVec3::Z,
        });
    });
    assert_eq!(
        named,
        [
            Code::BuildingUnusedArc,
            Code::BuildingNoEdge,
            Code::BuildingNoCorner
        ]
    );
    let open = changed(Rule::Block, |draft| drop(draft.faces.remove(4)));
    assert_eq!(open, [Code::BuildingOpen]);
    let pinched = changed(Rule::Block, |draft| {
        let most = draft
            .vertices
            .iter()
            .fold(DVec3::ZERO, |most, v| most.max(*v));
        let by = DVec3::new(2.0 * most.x, most.y, 2.0 * most.z);
        let first = draft.vertices.len() as u32;
        let other: Vec<DVec3> = draft.vertices.iter().map(|v| *v + by).collect();
        draft.vertices.extend(other);
        for mut face in draft.faces.clone() {
            face.loops.iter_mut().flatten().for_each(|v| *v += first);
            let frame = face.surface.as_ref().expect("a surface").frame(0.0, 0.0);
            face.surface = Some(FaceSurface::flat(frame.origin + by, frame.s, frame.t));
            draft.faces.push(face);
        }
    });
    assert!(pinched.contains(&Code::BuildingPinched));
    let sheet = |thickness: f64| {
        changed(Rule::Sheet, |draft| {
            draft.faces[0].thickness = Some(thickness)
        })
    };
    assert_eq!(sheet(0.05), [Code::MasonryTooThin]);
    assert!(sheet(0.1).contains(&Code::MasonryThin));
    let house = write_json(&Rule::LHouse.draft(&Module::NORMAL, &[]));
    let uneven = said_of(&house, "&module=own&w=180&h=500&joint=10");
    for code in [
        Code::MasonryNear,
        Code::MasonryCourses,
        Code::MasonryColumns,
    ] {
        assert!(uneven.contains(&code), "{}", code.word());
    }
}

/// The codes of the remarks on a plan with these openings.
fn said_of_plan(plan: &str, openings: &str) -> Vec<Code> {
    let link = format!("make=masonry&size=128&building=plan&plan={plan}&openings={openings}");
    let (recipe, notices) = ALL.recipe(&link);
    assert_eq!(codes(&notices), []);
    let mut studio = Studio::new(ALL, recipe);
    while !["laying", "bodies", "light", "done"].contains(&studio.stage()) {
        assert_eq!(studio.problem(), None);
        studio.tick(&mut || 0.0, 0.0, u32::MAX);
    }
    codes(&studio.engine().remarks())
}

#[test]
fn faults_of_plans_are_told() {
    const YARD: &str = "0,0,30,0,30,-20,0,-20,0,0";
    assert_eq!(said_of_plan(YARD, "1,4,8,6,8,0"), []);
    for (plan, code) in [
        ("0,0,9,0,0,0", Code::DrawnFew),
        ("0,0,1,0,1,9", Code::DrawnShort),
        ("0,0,20,0,0,5", Code::DrawnSharp),
        ("0,0,20,0,20,-20,10,-20,10,10", Code::DrawnCrossing),
        ("-130,0,-100,0", Code::DrawnFar),
    ] {
        assert_eq!(said_of_plan(plan, ""), [code]);
    }
    for (plan, told) in [(YARD, vec![]), ("0,0,30,0", vec![Code::DrawnRoofless])] {
        assert_eq!(said_of_plan(plan, "1,4,8,6,8,0&plan_pitch=30"), told);
    }
    for (opening, code) in [
        ("1,4,8,6,3,0", Code::DrawnNumber),
        ("5,4,8,6,8,0", Code::DrawnNoWall),
        ("1,3,8,6,8,0", Code::DrawnBeyond),
        ("2,4,8,13,8,0", Code::DrawnFull),
        ("1,4,8,6,8,0;1,6,8,6,8,0", Code::DrawnOver),
        ("1,4,8,6,20,0", Code::DrawnHigh),
    ] {
        assert_eq!(said_of_plan(YARD, opening), [code]);
    }
    let many = said_of_plan(YARD, &["9,4,8,6,8,0"; 12].join(";"));
    assert_eq!((many.len(), many[8]), (9, Code::DrawnMore));
}

#[test]
fn rows_that_are_no_plan_or_opening_are_refused() {
    let mut recipe = ALL.recipe("make=masonry&building=plan&plan=0,0,30,0").0;
    for (key, text) in [
        ("plan", "1,2"),
        ("plan", "1,2,3"),
        ("plan", "0,0,9,0;0,9,9,9"),
        ("openings", "1,2,3"),
        ("openings", "1,2,3,4,5,6,7"),
    ] {
        let before = recipe.link();
        let why = recipe.set(key, text).expect_err(text);
        assert_eq!(why.code, Code::ListUnreadable, "{text}");
        assert_eq!(recipe.link(), before);
    }
    let many: Vec<String> = (0..65).map(|k| format!("{},{}", 3 * k, k % 2)).collect();
    assert!(recipe.set("plan", &many.join(",")).is_err());
    assert!(recipe.set("plan", &many[..64].join(",")).is_ok());
}
