//! Outlines with several outer rings: every island has its own cells, which fill it.

use crate::paving::OfPavement;
use bubblestone::cells::{Cell, graph};
use bubblestone::domain::{Domain, Outline};
use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, PavementRecipe};
use bubblestone::metrics::CellMetrics;
use bubblestone::studio::Studio;
use glam::DVec2;

const KINDS: [&str; 4] = ["square", "rectangle", "circle", "ellipse"];

fn rectangle(left: f64, top: f64, right: f64, bottom: f64) -> Vec<DVec2> {
    [(left, top), (right, top), (right, bottom), (left, bottom)]
        .map(DVec2::from)
        .to_vec()
}

fn disc(x: f64, y: f64, radius: f64) -> Vec<DVec2> {
    let corner = |k: u32| {
        let t = f64::from(k) * std::f64::consts::TAU / 40.0;
        DVec2::new(x, y) + radius * DVec2::new(libm::cos(t), libm::sin(t))
    };
    (0..40).map(corner).collect()
}

/// Two islands beside each other, with a gap much narrower than a cell.
fn beside() -> Vec<Vec<DVec2>> {
    vec![
        rectangle(20., 20., 118., 236.),
        rectangle(121., 40., 236., 200.),
    ]
}

/// A ring, a disc in its hole, and a speck in the corner.
fn target() -> Vec<Vec<DVec2>> {
    vec![
        disc(128., 128., 110.),
        disc(128., 128., 68.),
        disc(128., 128., 45.),
        rectangle(240., 240., 246., 246.),
    ]
}

/// A letter i in front of a bowl that nearly closes around its dot, and bars.
fn word() -> Vec<Vec<DVec2>> {
    let point = |&(x, y): &(f64, f64)| DVec2::new(x, y);
    let bowl = [
        (90., 30.),
        (130., 30.),
        (130., 90.),
        (190., 90.),
        (190., 30.),
        (230., 30.),
    ];
    let bowl: Vec<DVec2> = bowl
        .iter()
        .chain(&[(230., 130.), (90., 130.)])
        .map(point)
        .collect();
    vec![
        rectangle(30., 90., 62., 230.),
        disc(46., 52., 20.),
        bowl,
        disc(160., 55., 27.),
        rectangle(90., 150., 230., 190.),
        rectangle(90., 194., 230., 198.),
    ]
}

/// A pavement with these rings as its outline, worked on until its cells are made.
fn with_cells(link: &str, rings: &[Vec<DVec2>]) -> Studio {
    let (mut recipe, notices) = pavement::recipe(link);
    assert!(notices.is_empty(), "{notices:?}");
    let outline = Outline {
        rings: rings.to_vec(),
        ..Outline::default()
    };
    recipe.set_polygon(&outline).unwrap();
    // The link describes the same outline.
    let recipe = pavement::recipe(&recipe.link()).0;
    let mut studio = Studio::new(ALL, recipe);
    while !["planes", "done", "error"].contains(&studio.stage()) {
        studio.tick(&mut || 0.0, 0.0, 1);
    }
    assert_eq!(studio.problem(), None, "{link}");
    studio
}

/// The cells of each island.
fn by_island(domain: &Domain, cells: &[Cell]) -> Vec<Vec<Cell>> {
    let mut own = vec![Vec::new(); domain.islands().len()];
    for cell in cells {
        own[domain.island(cell.centre)].push(cell.clone());
    }
    own
}

fn assert_fills(studio: &Studio, what: &str) {
    let domain = studio.pavement().domain.unwrap();
    let cells = studio.pavement().cells;
    assert!(cells.windows(2).all(|w| w[0].id < w[1].id), "{what}");
    for (island, own) in domain.islands().iter().zip(by_island(domain, cells)) {
        assert!(!own.is_empty(), "{what}: an island is empty");
        let cover = CellMetrics::new(island, studio.pavement().fields.unwrap(), &own).cover;
        assert!((cover.coverage - 1.0).abs() < 1e-6, "{what}: {cover:?}");
        assert!(
            cover.overlap < 1e-6 && cover.outside < 1e-6,
            "{what}: {cover:?}"
        );
    }
}

#[test]
fn every_island_is_filled_by_cells_of_its_own() {
    for (name, rings) in [("beside", beside()), ("target", target()), ("word", word())] {
        for kind in KINDS {
            for edge in ["wall", "on"] {
                let link = format!("size=256&cs=13&kind={kind}&edge={edge}");
                let studio = with_cells(&link, &rings);
                assert_fills(&studio, &format!("{name} {link}"));
            }
        }
    }
}

/// The corners of packed cells reach beyond the rim no farther than cells overlap.
#[test]
fn packed_cells_stay_on_their_island() {
    for (name, rings) in [("beside", beside()), ("target", target()), ("word", word())] {
        for kind in KINDS {
            let studio = with_cells(&format!("size=256&cs=13&cells=packed&kind={kind}"), &rings);
            let domain = studio.pavement().domain.unwrap();
            let own = by_island(domain, studio.pavement().cells);
            for (island, cells) in domain.islands().iter().zip(own) {
                assert!(!cells.is_empty(), "{name} {kind}");
                assert!(
                    cells.iter().all(|c| island.contains(c.centre)),
                    "{name} {kind}"
                );
                if island.area() > 3000.0 {
                    let cover =
                        CellMetrics::new(island, studio.pavement().fields.unwrap(), &cells).cover;
                    assert!(cover.coverage > 0.65, "{name} {kind}: {cover:?}");
                }
            }
        }
    }
}

#[test]
fn each_island_is_packed_as_if_it_were_alone() {
    let rings = beside();
    for kind in KINDS {
        let link = format!("size=256&cs=12&kind={kind}");
        let both = with_cells(&link, &rings);
        let own = by_island(both.pavement().domain.unwrap(), both.pavement().cells);
        for (ring, own) in rings.iter().zip(own) {
            let alone = with_cells(&link, std::slice::from_ref(ring))
                .pavement()
                .cells
                .len() as f64;
            let count = own.len() as f64;
            assert!(
                (count / alone - 1.0).abs() < 0.1,
                "{kind}: {count} for {alone}"
            );
        }
    }
}

#[test]
fn islands_smaller_than_a_cell_are_one() {
    for kind in KINDS {
        for (edge, cells) in [("wall", "fitted"), ("wall", "packed"), ("on", "fitted")] {
            let link = format!("size=256&cs=40&kind={kind}&edge={edge}&cells={cells}");
            let studio = with_cells(&link, &target());
            let domain = studio.pavement().domain.unwrap();
            let own = by_island(domain, studio.pavement().cells);
            let specks = domain.islands().iter().zip(&own);
            let speck: Vec<_> = specks.filter(|(island, _)| island.area() < 40.0).collect();
            assert_eq!(speck.len(), 1);
            assert_eq!(speck[0].1.len(), 1, "{link}");
        }
    }
}

#[test]
fn scattered_points_reach_every_island() {
    for cells in ["voronoi", "lloyd"] {
        let link = format!("size=256&cs=20&cells={cells}");
        assert_fills(&with_cells(&link, &target()), &link);
    }
}

#[test]
fn nothing_joins_two_islands() {
    for link in [
        "size=256&cs=13",
        "size=256&cs=13&edge=on",
        "size=256&cs=13&kind=circle",
    ] {
        let studio = with_cells(link, &beside());
        let domain = studio.pavement().domain.unwrap();
        let cells = studio.pavement().cells;
        for (cell, beside) in cells.iter().zip(graph(domain, cells)) {
            let island = domain.island(cell.centre);
            let other = |k: u32| domain.island(cells[k as usize].centre);
            assert!(beside.into_iter().all(|k| other(k) == island), "{link}");
        }
        let mesh = studio.pavement().mesh.unwrap();
        assert!(!mesh.faces.is_empty());
        for face in &mesh.faces {
            let at = face.nodes().iter().map(|&k| mesh.vertices[k as usize]);
            let mut islands: Vec<usize> = at.map(|p| domain.island(p)).collect();
            islands.dedup();
            assert_eq!(islands.len(), 1, "{link}");
        }
    }
}

/// Lines that cross several islands, and a kind for each part.
#[test]
fn islands_with_lines_and_kinds() {
    let link = "size=256&cs=13&lines=0,0.45,1,0.5&parts=0.2,0.2,2;0.7,0.7,3";
    let studio = with_cells(link, &beside());
    let domain = studio.pavement().domain.unwrap();
    assert_eq!(domain.parts(), 4);
    assert_fills(&studio, link);
    let kind = |part: usize| {
        let own = studio
            .pavement()
            .cells
            .iter()
            .filter(|c| domain.part(c.centre) == part);
        own.map(|c| c.kind).next().unwrap()
    };
    let parts = [(60., 60.), (60., 200.), (200., 60.), (200., 180.)];
    let kinds = parts.map(|(x, y)| kind(domain.part(DVec2::new(x, y))));
    use bubblestone::field::CellKind::{Circle, Ellipse, Square};
    assert_eq!(kinds, [Circle, Square, Square, Ellipse]);
    // Without lines every island is a part.
    let studio = with_cells("size=256&cs=13&parts=0.7,0.5,1", &beside());
    let domain = studio.pavement().domain.unwrap();
    assert_eq!(domain.parts(), 2);
    assert_fills(&studio, "parts");
    for cell in studio.pavement().cells {
        let right = cell.centre.x > 120.0;
        assert_eq!(cell.kind.is_stretched(), right);
    }
}
