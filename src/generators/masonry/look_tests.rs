//! Tests of the mortar behind stones, and of the weather where people walk.

use super::colours::{BRICK_ROW, MOSS_ROW};
use super::site::BuildingSite;
use super::tests::laid;
use super::weather::{Noise, Weather};
use crate::building::labels::{CAP, DOOR, SILL, STEP};
use crate::building::{Face, FaceId};
use crate::masonry::laying::{Feature, MasonryCell};
use crate::material::WeatherParams;
use crate::scene::Surfel;
use glam::DVec3;

/// A site with its cells, and the places of its mortar (metres).
fn with_mortar<T>(link: &str, of: impl Fn(&BuildingSite, &[MasonryCell], &[DVec3]) -> T) -> T {
    let engine = laid(link).expect("a building");
    let site = engine.made.site.made().expect("a site");
    let cells = engine.made.cells.made().expect("cells").cells();
    let wall = engine.made.laid.made().expect("blocks");
    // The mortar comes first.
    let places = wall.bodies[0].levels[0].positions.iter();
    let places = places.map(|p| p.as_dvec3() / site.fit.scale + site.fit.middle);
    of(site, cells, &places.collect::<Vec<DVec3>>())
}

#[test]
fn mortar_lies_far_behind_rounded_stones() {
    let depth = |words: &str| {
        let link = format!("make=masonry&building=block&ground=none&{words}");
        with_mortar(&link, |site, _, mortar| {
            let most = |xs: &mut dyn Iterator<Item = f64>| xs.fold(f64::MIN, f64::max);
            let vertices = site.building.vertices().iter();
            most(&mut vertices.map(|v| v.position.x)) - most(&mut mortar.iter().map(|p| p.x))
        })
    };
    let stone = "pattern=ashlar&module=ashlar&walls=honey";
    for (rough, wanted) in [
        (0.0, 0.006),
        (0.15, 0.011),
        (0.3, 0.022),
        (0.5, 0.022),
        (1.0, 0.022),
    ] {
        let found = depth(&format!("{stone}&rough={rough}"));
        assert!((found - wanted).abs() < 1e-4, "{rough} {found}");
    }
    let bricks = depth("pattern=bricks&rough=1");
    assert!((bricks - 0.006).abs() < 1e-4, "{bricks}");
}

/// The front of a straight stone on a round tower lies behind the surface in its middle, and mortar lies behind that.
#[test]
fn no_stone_of_a_round_tower_vanishes_in_the_mortar() {
    let link = "make=masonry&building=tower&pattern=ashlar&module=ashlar&rough=0.5&walls=honey";
    with_mortar(link, |site, cells, mortar| {
        let off_axis = |p: DVec3| p.with_y(0.0).length();
        let radius = mortar.iter().map(|&p| off_axis(p)).fold(0.0, f64::max);
        let is_round = |id: FaceId| !site.building.face(id).surface.is_flat();
        let mut looked_at = 0;
        for cell in cells {
            let [low, high] = cell.claimed.bounds();
            let looks_out = low.midpoint(high).dot(cell.outwards) > 0.0;
            if !matches!(cell.feature, Feature::Face(id) if is_round(id)) || !looks_out {
                continue;
            }
            let along = cell.claimed.vertices().iter().map(|p| p.dot(cell.outwards));
            let front = along.fold(f64::MIN, f64::max);
            assert!(front - radius > 0.02, "{front} {radius}");
            looked_at += 1;
        }
        assert!(looked_at > 100, "{looked_at}");
    });
}

#[test]
fn no_moss_grows_where_people_walk() {
    let mossy = |link: &str, is_asked: &dyn Fn(&Face) -> bool| {
        let engine = laid(link).expect("a building");
        let site = engine.made.site.made().expect("a site");
        let params = WeatherParams {
            moss: 1.0,
            ..WeatherParams::default()
        };
        let weather = Weather::new(params, site);
        let noise = Noise {
            patches: 2.0,
            fine: 0.0,
            stripes: 0.0,
            own: 0.0,
        };
        let faces = site.building.faces().iter().filter(|face| is_asked(face));
        let found = faces.filter_map(|face| {
            let [low, high] = face.bounds();
            let middle = low.midpoint(high);
            let frame = face.surface.frame(middle.x, middle.y);
            let mut surfel = Surfel {
                position: site.fit.place(frame.origin),
                normal: frame.normal.as_vec3(),
                colour: [100.0; 3],
                material: BRICK_ROW,
                open: 1.0,
            };
            let at = surfel.position / site.fit.scale as f32;
            let worn = weather.apply(&mut surfel, at, &noise);
            let is_up = frame.normal.y > 0.9;
            is_up.then_some((
                surfel.material == MOSS_ROW,
                worn > 0.5,
                surfel.colour[0] > 100.0,
            ))
        });
        found.collect::<Vec<(bool, bool, bool)>>()
    };
    let steps = "make=masonry&building=steps&pattern=bricks";
    let treads = mossy(steps, &|face| face.has_label(STEP));
    assert!(treads.len() > 2 && treads.iter().all(|&found| found == (false, true, true)));
    let caps = mossy(steps, &|face| face.has_label(CAP));
    assert!(
        !caps.is_empty()
            && caps
                .iter()
                .all(|&(is_mossy, is_worn, _)| is_mossy && !is_worn)
    );
    let house = "make=masonry&building=gabled";
    let thresholds = mossy(house, &|face| face.has_label(SILL) && face.has_label(DOOR));
    assert!(!thresholds.is_empty() && thresholds.iter().all(|&found| found == (false, true, true)));
    let sills = mossy(house, &|face| face.has_label(SILL) && !face.has_label(DOOR));
    assert!(
        !sills.is_empty()
            && sills
                .iter()
                .all(|&(is_mossy, is_worn, _)| is_mossy && !is_worn)
    );
}
