//! Facts of each step in the making of a stone on a surface.

use super::super::fixture::{ball, rows};
use super::super::{Stones, links};
use super::*;
use crate::heightfield::TextureParams;
use crate::material::WeatherParams;
use crate::solid::{SkinParams, StoneParams};

fn params(stone: StoneParams, cells: &[SurfaceCell]) -> StonesParams {
    let texture = TextureParams {
        stone,
        ..TextureParams::default()
    };
    let dry = WeatherParams {
        wear: 0.0,
        moss: 0.0,
        dirt: 0.0,
        wet: 0.0,
    };
    StonesParams::new(texture, dry, cells)
}

fn stones() -> [StoneParams; 2] {
    let skin = SkinParams {
        skew: 0.6,
        tilt: 0.2,
        ..SkinParams::DEFAULT
    };
    let scale = StoneParams {
        kind: StoneKind::Skin,
        skin,
        ..StoneParams::default()
    };
    [StoneParams::default(), scale]
}

/// Index of a cell that is not on the border.
const INSIDE: usize = 5 * 30 + 7;

#[test]
fn loop_steps_have_the_edges_triangles_and_vertices_of_their_rule() {
    let cells = rows([30, 12], [true, false]).cells(&ball);
    let links = links(&cells);
    let paving = Paving {
        cells: &cells,
        links: &links,
        ..Paving::default()
    };
    assert_eq!(super::super::neighbours(&cells, &links, INSIDE).len(), 4);
    for (stone, [each, sides]) in stones().into_iter().zip([[27, 3], [3, 1]]) {
        let params = params(stone, &cells);
        let list = steps(&params, paving, INSIDE);
        let words: Vec<&str> = list.iter().map(|step| step.word()).collect();
        assert_eq!(words[..4], ["cell", "plane", "base", "sweep"], "{words:?}");
        assert_eq!(
            words[words.len() - 4..],
            ["noise", "kept", "bent", "finish"]
        );
        let shape = |wanted| step(&params, paving, INSIDE, wanted).expect("a step");
        let of = |making| shape(StoneStep::Solid(making));
        let last = list.iter().filter_map(|step| match step {
            StoneStep::Solid(making) => making.level(),
            _ => None,
        });
        let last = last.max().expect("a Loop step");
        assert!(last >= 2, "{last}");
        let corners = shape(StoneStep::Plane).flat.cell.ring.len();
        let mut edges = of(Making::Control).edges.len();
        let mut triangles = each * corners;
        let mut vertices = 1 + edges - triangles;
        let mut border = sides * corners;
        for level in 1..=last {
            (vertices, edges) = (vertices + edges, 2 * edges + 3 * triangles);
            (triangles, border) = (4 * triangles, 2 * border);
            let made = of(Making::Loop(level));
            // The base is closed by a fan.
            assert_eq!(made.surface.triangles.len(), triangles + border, "{level}");
            if level <= 2 {
                assert_eq!(made.edges.len(), edges, "{level}");
            }
            if level == last {
                assert_eq!(made.surface.positions.len(), vertices + 1);
            }
        }
        let kept = shape(StoneStep::Kept);
        let most = most_triangles(cells.len());
        assert!(kept.surface.triangles.len() <= most, "{most}");
        assert_eq!(2 * kept.edges.len(), 3 * kept.surface.triangles.len());
        for &wanted in &list {
            assert_eq!(shape(wanted).surface.fault(), None, "{wanted:?}");
        }
    }
    let none = steps(&params(stones()[0], &cells), paving, cells.len());
    assert_eq!(none, []);
}

#[test]
fn the_last_step_before_colour_is_the_body_of_the_scene() {
    let rows = rows([30, 12], [true, false]);
    let (mesh, cells) = (rows.mesh(&ball), rows.cells(&ball));
    let links = links(&cells);
    let paving = Paving {
        cells: &cells,
        links: &links,
        ..Paving::default()
    };
    for stone in stones() {
        let params = params(stone, &cells);
        let mut making = Stones::new(params, &mesh, &cells);
        while !making.advance(&mesh, paving) {}
        let scene = making.finish();
        let body = &scene.bodies[INSIDE].levels[0];
        let scale = super::super::Fit::new(&mesh).scale;
        let made = step(&params, paving, INSIDE, StoneStep::Bent).expect("a step");
        let own = made.surface.positions.len() - body.positions.len();
        let raised = DVec3::Z * made.flat.bend.anchor;
        for (p, q) in made.surface.positions[own..].iter().zip(&body.positions) {
            let p = made.flat.out(p.as_dvec3() - raised) * scale;
            assert!((p.as_vec3() - q).length() < 1e-6, "{p} {q}");
        }
    }
}
