//! Properties of the parts beside the masonry.

use super::*;
use crate::building::draft::ExtraMesh;
use crate::building::labels;
use crate::trimesh::{Search, TriMesh};

#[test]
fn rails_are_closed_and_right_side_out() {
    let draft = Rule::Steps.draft(&Module::NORMAL, &[]);
    let [rail] = &draft.extras[..] else {
        panic!("{:?}", draft.extras.len());
    };
    assert_eq!((&rail.name[..], &rail.material[..]), ("rail", "iron"));
    let mesh = TriMesh::new(rail.positions.clone(), rail.triangles.clone()).unwrap();
    assert!(mesh.closed().unwrap().volume() > 0.0);
    assert_eq!(mesh.parts().1, 6);
}

#[test]
fn each_opening_has_a_pane_or_a_door_that_looks_outwards() {
    for rule in [Rule::Gabled, Rule::LHouse, Rule::Wall, Rule::Tower] {
        let draft = rule.draft(&Module::NORMAL, &[]);
        let sills = draft
            .faces
            .iter()
            .filter(|face| face.labels.iter().any(|l| l == labels::SILL));
        let mut parts = 0;
        let is_one = |extra: &&ExtraMesh| ["pane", "door"].contains(&&extra.name[..]);
        for extra in draft.extras.iter().filter(is_one) {
            let mesh = TriMesh::new(extra.positions.clone(), extra.triangles.clone()).unwrap();
            parts += mesh.parts().1;
            if rule == Rule::Wall {
                continue;
            }
            for triangle in 0..mesh.triangles().len() as u32 {
                let middle: glam::DVec3 = mesh.corners(triangle).iter().sum::<glam::DVec3>() / 3.0;
                // All walls of these buildings look away from the building's middle, except those at an L's inner
                // corner.
                let outward = mesh.face_normal(triangle).dot(middle);
                assert!(outward > 0.0 || rule == Rule::LHouse, "{rule:?} {middle}");
            }
        }
        assert_eq!(parts, sills.count(), "{rule:?}");
    }
}

/// Both houses keep their door without windows.
#[test]
fn a_house_has_one_door_whatever_its_windows() {
    for (rule, place) in [(Rule::LHouse, 5), (Rule::Gabled, 4)] {
        for windows in 0..=6 {
            let mut own = rule.fitted(&[]);
            own[place] = f64::from(windows);
            let draft = rule.draft(&Module::NORMAL, &own);
            let doors = draft.extras.iter().filter(|extra| extra.name == "door");
            let doors = doors.map(|extra| {
                let mesh = TriMesh::new(extra.positions.clone(), extra.triangles.clone());
                mesh.unwrap().parts().1
            });
            assert_eq!(doors.sum::<usize>(), 1, "{rule:?} {windows}");
        }
    }
}

#[test]
fn frames_and_bars_stand_in_their_openings() {
    let normal = Module::NORMAL;
    // The bricks of a model house.
    let model = Module {
        half: normal.half / 8.0,
        course: normal.course / 8.0,
        joint: normal.joint / 8.0,
    };
    for rule in [Rule::Gabled, Rule::LHouse, Rule::Wall, Rule::Tower] {
        for (module, most) in [(&normal, 0.025), (&model, 0.0125)] {
            let draft = rule.draft(module, &[]);
            let mesh_of = |names: [&str; 2]| {
                let parts = draft.extras.iter().filter(|e| names.contains(&&e.name[..]));
                let (mut positions, mut triangles) = (Vec::new(), Vec::new());
                for extra in parts {
                    let first = positions.len() as u32;
                    positions.extend_from_slice(&extra.positions);
                    triangles.extend(extra.triangles.iter().map(|t| t.map(|v| v + first)));
                }
                TriMesh::new(positions, triangles).unwrap()
            };
            let (frames, panes) = (mesh_of(["frame", "boards"]), mesh_of(["pane", "door"]));
            let search = Search::new(&panes);
            let places = frames.positions().iter();
            let away = places.map(|&p| search.closest(&panes, p).at.distance(p));
            // Half of the thickness of a bar, and a corner of the upright bar in the arc.
            let farthest = away.fold(0.0, f64::max);
            assert!((1e-3..most).contains(&farthest), "{rule:?} {farthest}");
            for bar in (0..frames.triangles().len() as u32).step_by(12) {
                let sides = (bar..bar + 12).map(|t| frames.corners(t));
                let volume: f64 = sides.map(|[a, b, c]| a.dot(b.cross(c))).sum();
                assert!(volume > 0.0, "{rule:?} {bar}");
            }
        }
    }
}

#[test]
fn all_rules_have_their_words_and_ranges() {
    for rule in Rule::ALL {
        assert_eq!(Rule::of_word(rule.word()), Some(rule));
        for number in rule.numbers() {
            assert_eq!(
                number.fitted(number.default),
                number.default,
                "{rule:?} {}",
                number.word
            );
        }
        let wild = rule.draft(&Module::NORMAL, &[f64::NAN, 1e9, -1e9, f64::INFINITY]);
        assert!(crate::building::Building::new(&wild).is_ok(), "{rule:?}");
    }
}
