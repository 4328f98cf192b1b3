//! Voronoi cells of scattered points, plain and relaxed: they fill the outline, and are what their name says.

use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::cells::{Cell, Scatter, ScatterParams};
use bubblestone::domain::{Domain, signed_area};
use bubblestone::field::{FieldBuilder, FieldParams};
use bubblestone::studio::Studio;
use glam::DVec2;

fn centroid(ring: &[DVec2]) -> DVec2 {
    let mut sum = DVec2::ZERO;
    for k in 0..ring.len() {
        let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
        sum += (a - ring[0]).perp_dot(b - ring[0]) * (a + b - 2.0 * ring[0]);
    }
    ring[0] + sum / (6.0 * signed_area(ring))
}

#[test]
fn they_fill_every_outline() {
    for outline in ["plaza", "road_spiral", "road_notch", "star", "l_shape"] {
        for size in [12, 60, 128] {
            for cells in ["voronoi", "lloyd"] {
                let link = format!("size=256&outline={outline}&cs={size}&cells={cells}");
                let studio = finished(&link);
                let figures = studio.pavement().metrics().unwrap().cells;
                let cover = figures.cover;
                assert!((cover.coverage - 1.0).abs() < 1e-5, "{link}: {cover:?}");
                assert!(
                    cover.overlap < 1e-5 && cover.outside < 1e-5,
                    "{link}: {cover:?}"
                );
                // Large pieces that the outline cuts off become separate cells.
                let packed = studio.pavement().packing.unwrap().report().cells;
                let of_points = studio
                    .pavement()
                    .cells
                    .iter()
                    .filter(|c| (c.id as usize) < packed);
                assert_eq!(of_points.count(), packed, "{link}");
            }
        }
    }
}

#[test]
fn every_place_belongs_to_the_nearest_point() {
    for cells in ["voronoi", "lloyd"] {
        let studio = finished(&format!("size=256&outline=square&cs=11&cells={cells}"));
        let cells: &[Cell] = studio.pavement().cells;
        for cell in cells {
            let nearest = |p: DVec2| {
                let distances = cells.iter().map(|c| c.centre.distance(p));
                distances.fold(f64::INFINITY, f64::min)
            };
            // The test points lie a little inside each corner, because up to three points are equally near at
            // the corner.
            for &corner in &cell.ring {
                let p = corner.lerp(cell.centre, 0.01);
                assert!(cell.centre.distance(p) <= nearest(p), "{cell:?}");
            }
        }
    }
}

#[test]
fn lloyds_relaxation_evens_them_out() {
    for outline in ["annulus", "plaza", "star"] {
        let with = |cells| finished(&format!("size=256&outline={outline}&cs=9&cells={cells}"));
        let (plain, even) = (with("voronoi"), with("lloyd"));
        let variation = |s: &Studio| s.pavement().metrics().unwrap().cells.area_cv;
        assert!(variation(&plain) > 0.4, "{outline}: {}", variation(&plain));
        assert!(variation(&even) < 0.15, "{outline}: {}", variation(&even));
        // Cells cut by the outline are included.
        let mut farthest = 0.0_f64;
        for cell in even.pavement().cells {
            farthest = farthest.max(cell.centre.distance(centroid(&cell.ring)));
        }
        assert!(farthest < 0.2 * 9.0, "{outline}: {farthest}");
    }
}

#[test]
fn they_are_drawn_by_the_seed() {
    let with = |seed| finished(&format!("size=128&cs=12&cells=voronoi&seed={seed}"));
    assert_eq!(with(1).pavement().cells, with(1).pavement().cells);
    assert_ne!(with(1).pavement().cells, with(2).pavement().cells);
}

#[test]
fn a_torus_has_no_seam() {
    let torus = Domain::torus(100.0, &[]);
    let fields = FieldBuilder::build(&torus, FieldParams::default());
    for count in [2, 5, 100] {
        let params = ScatterParams {
            count,
            rounds: 60,
            seed: 4,
        };
        let mut scatter = Scatter::new(&torus, params);
        while !scatter.advance(&torus) {}
        let points: Vec<DVec2> = scatter
            .particles(&fields)
            .iter()
            .map(|p| p.centre)
            .collect();
        let mut least = f64::INFINITY;
        for (k, &a) in points.iter().enumerate() {
            assert_eq!(a, torus.space().wrap(a));
            for &b in &points[..k] {
                least = least.min(torus.space().shortest(a - b).length());
            }
        }
        let apart = 100.0 / (count as f64).sqrt();
        assert!(least > 0.7 * apart, "{count}: {least} of {apart}");
    }
}
