use super::fixture::{self, PARAMS, count, deepest_overlap, pierced};
use super::{Body, CostScope, Fate, Kind, Method, RefineParams, Refining, Turn, Wall};
use crate::trimesh::TriMesh;
use glam::DVec3;

#[test]
fn spheres_overlap_by_no_more_than_was_asked_for() {
    let mesh = fixture::heap(12.0);
    for (offset, removal) in [(0.0, 0.0), (0.1, 0.05), (0.3, 0.2)] {
        for kinds in [
            vec![fixture::ball()],
            vec![fixture::rod()],
            vec![fixture::ball(), fixture::rod()],
        ] {
            let params = RefineParams {
                offset,
                removal,
                ..PARAMS
            };
            let pile = fixture::pile(&mesh, kinds.clone(), &[], params, 50);
            let deepest = deepest_overlap(pile.bodies(), &kinds);
            assert!(deepest <= offset + removal + 1e-9, "{deepest}");
            assert!(deepest > offset - 1e-6, "bodies touch: {deepest}");
        }
    }
}

#[test]
fn each_dart_has_a_fate_and_each_body_is_in_its_range() {
    let mesh = fixture::globe(6.0);
    let large = Kind {
        scale: 2.0,
        density: 1.5,
        range: 0.3,
        ..fixture::ball()
    };
    let kinds = vec![large, fixture::rod()];
    let ground = Wall::Plane {
        normal: -DVec3::Y,
        offset: 5.0,
    };
    let pile = fixture::pile(&mesh, kinds.clone(), &[ground], PARAMS, 7);
    let fates =
        [Fate::Merged, Fate::Walls, Fate::Removed, Fate::Kept].map(|fate| count(&pile, fate));
    assert_eq!(fates.iter().sum::<usize>(), pile.bodies().len());
    assert!(fates.iter().all(|&n| n > 0), "{fates:?}");
    for body in pile.bodies().iter().filter(|b| b.fate == Fate::Kept) {
        let (lo, hi) = body.range;
        assert!(lo <= body.t && body.t <= hi);
        let shape = body.shape(&kinds);
        let lowest = shape
            .points
            .iter()
            .map(|&p| (body.place() + body.turn * (body.scale * p)).y)
            .fold(f64::INFINITY, f64::min);
        assert!(lowest >= -5.0 - 0.05 * body.radius(&kinds), "{lowest}");
    }
}

#[test]
fn any_slices_give_the_same_bits() {
    let mesh = fixture::heap(9.0);
    let kinds = || {
        vec![
            Kind {
                jitter: 0.2,
                ..fixture::rod()
            },
            fixture::ball(),
        ]
    };
    for method in [
        Method::Exact,
        Method::Golden {
            iterations: 15,
            scope: CostScope::Nearest,
        },
    ] {
        let params = RefineParams {
            method,
            retries: 2,
            ..PARAMS
        };
        let whole = fixture::pile(&mesh, kinds(), &[], params, usize::MAX);
        assert_eq!(
            whole.bodies(),
            fixture::pile(&mesh, kinds(), &[], params, 1).bodies()
        );
    }
}

/// The mean number of kept bodies over five seeds.
fn mean_kept(mesh: &TriMesh, kind: &Kind, params: RefineParams) -> f64 {
    let kept = |seed| {
        count(
            &fixture::pile(
                mesh,
                vec![kind.clone()],
                &[],
                RefineParams { seed, ..params },
                1000,
            ),
            Fate::Kept,
        )
    };
    (1..=5).map(kept).sum::<usize>() as f64 / 5.0
}

#[test]
fn more_is_kept_with_more_overlap_and_more_range() {
    let mesh = fixture::heap(10.0);
    let rod = fixture::rod();
    let base = mean_kept(&mesh, &rod, PARAMS);
    assert!(
        mean_kept(
            &mesh,
            &rod,
            RefineParams {
                offset: 0.2,
                ..PARAMS
            }
        ) > base
    );
    assert!(
        mean_kept(
            &mesh,
            &rod,
            RefineParams {
                removal: 0.2,
                ..PARAMS
            }
        ) > base
    );
    assert!(
        mean_kept(
            &mesh,
            &Kind {
                range: 3.0,
                ..rod.clone()
            },
            PARAMS
        ) > base
    );
    assert!(
        mean_kept(
            &mesh,
            &rod,
            RefineParams {
                retries: 3,
                ..PARAMS
            }
        ) > base
    );
}

#[test]
fn the_exact_solver_keeps_no_fewer_than_golden_section() {
    let mesh = fixture::heap(8.0);
    for kind in [fixture::ball(), fixture::rod()] {
        let kept = |method| {
            let params = RefineParams { method, ..PARAMS };
            count(
                &fixture::pile(&mesh, vec![kind.clone()], &[], params, 1000),
                Fate::Kept,
            )
        };
        let exact = kept(Method::Exact);
        for scope in [CostScope::Nearest, CostScope::All] {
            let iterations = 15;
            let golden = kept(Method::Golden { iterations, scope });
            println!("{scope:?}: {golden} of {exact}");
            assert!(
                5 * golden > exact && golden <= exact,
                "{scope:?}: {golden} of {exact}"
            );
        }
    }
}

#[test]
fn golden_section_keeps_what_eq_3_allows() {
    let mesh = fixture::heap(9.0);
    let kinds = vec![fixture::rod()];
    let method = Method::Golden {
        iterations: 15,
        scope: CostScope::Nearest,
    };
    let pile = fixture::pile(
        &mesh,
        kinds.clone(),
        &[],
        RefineParams { method, ..PARAMS },
        1000,
    );
    let mut settled: Vec<&Body> = Vec::new();
    for &k in pile.history() {
        let body = &pile.bodies()[k as usize];
        if body.fate != Fate::Kept {
            continue;
        }
        let points = body
            .shape(&kinds)
            .points
            .iter()
            .map(|&p| body.place() + body.turn * (body.scale * p));
        for p in points {
            for other in &settled {
                let depth = other
                    .spheres(&kinds)
                    .map(|s| s.radius - s.centre.distance(p))
                    .fold(f64::NEG_INFINITY, f64::max);
                assert!(depth / other.radius(&kinds) <= PARAMS.offset + PARAMS.removal + 1e-9);
            }
        }
        settled.push(body);
    }
    assert!(settled.len() > 50);
}

#[test]
fn a_range_of_nothing_leaves_bodies_at_their_darts() {
    let mesh = fixture::heap(9.0);
    let kind = Kind {
        range: 0.0,
        ..fixture::ball()
    };
    let pile = fixture::pile(&mesh, vec![kind], &[], PARAMS, 1000);
    assert!(count(&pile, Fate::Kept) > 20);
    assert!(pile.bodies().iter().all(|b| b.t == 0.0));
}

#[test]
fn bodies_of_a_global_frame_lie_level() {
    let mesh = fixture::globe(6.0);
    let turn = Turn {
        ranges: DVec3::ZERO,
        is_global: true,
    };
    let pile = fixture::pile(
        &mesh,
        vec![Kind {
            turn,
            ..fixture::rod()
        }],
        &[],
        PARAMS,
        1000,
    );
    let kept = pile.bodies().iter().filter(|b| b.fate == Fate::Kept);
    assert!(kept.clone().count() > 100 && kept.clone().all(|b| b.turn == glam::DMat3::IDENTITY));
}

#[test]
fn a_layer_lies_at_its_depth() {
    let mesh = fixture::globe(6.0);
    let search = crate::trimesh::Search::new(&mesh);
    let mut layer = super::LayerDarting::new(&mesh, (0, 1), 2.0, 1.0, 1);
    while !layer.advance(&mesh, &search, 100) {}
    // The mesh is a polyhedron inside of its ball.
    let radii = layer.darts().iter().map(|d| d.at.length());
    assert!(radii.clone().all(|r| (3.7..4.1).contains(&r)));
    let full = super::expected_darts(4.0 * std::f64::consts::PI * 16.0, 1.0);
    assert!(
        layer.darts().len() as f64 > 0.85 * full,
        "{} of {full}",
        layer.darts().len()
    );
}

fn pierced_by_normals(pile: &Refining, kinds: &[Kind]) -> usize {
    let mut counts: Vec<usize> = pile
        .bodies()
        .iter()
        .map(|b| pierced(pile.bodies(), kinds, (b.at, b.normal), 20.0))
        .collect();
    counts.sort_unstable();
    counts[counts.len() / 2]
}

#[test]
fn the_natural_range_pierces_three_to_five_bodies() {
    let mesh = fixture::heap(16.0);
    let volume = 4.0 / 3.0 * std::f64::consts::PI;
    let ball = fixture::ball();
    let range = super::natural_range(volume, 3.0 * volume, ball.diagonal());
    let kinds = vec![Kind {
        range,
        density: 0.75,
        ..ball
    }];
    let pile = fixture::pile(&mesh, kinds.clone(), &[], PARAMS, 1000);
    let median = pierced_by_normals(&pile, &kinds);
    assert!((3..=5).contains(&median), "{median} with the range {range}");
}
