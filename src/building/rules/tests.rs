//! Properties of the parts beside the masonry.

use super::*;
use crate::building::labels;
use crate::trimesh::TriMesh;

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
        for extra in draft.extras.iter().filter(|extra| extra.name != "frame") {
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
