//! Inspection of cells and packings: the probe, the plots, and the cells as SVG.

use crate::paving::OfPavement;
use bubblestone::generators::ALL;
use bubblestone::generators::Histogram;
use bubblestone::generators::pavement;
use bubblestone::studio::Studio;
use glam::DVec2;

fn studio(link: &str) -> Studio {
    Studio::new(ALL, crate::common::recipe(link))
}

fn finished(link: &str) -> Studio {
    crate::common::finished(&format!("size=192&cs=16&{link}"))
}

/// A packing after some steps.
fn packing(link: &str, steps: usize) -> Studio {
    let mut studio = studio(&format!("size=192&cs=16&{link}"));
    for _ in 0..steps {
        studio.step(&mut || 0.0);
    }
    assert_eq!(studio.stage(), "packing");
    studio
}

fn contains(ring: &[DVec2], p: DVec2) -> bool {
    let edges = (0..ring.len()).map(|k| (ring[k], ring[(k + 1) % ring.len()]));
    let crossed = edges.filter(|(a, b)| {
        (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)
    });
    crossed.count() % 2 == 1
}

fn area(ring: &[DVec2]) -> f64 {
    let edges = (0..ring.len()).map(|k| ring[k].perp_dot(ring[(k + 1) % ring.len()]));
    0.5 * edges.sum::<f64>()
}

#[test]
fn the_cell_at_its_centre_is_found() {
    for link in [
        "outline=star",
        "kind=circle",
        "kind=ellipse&stone=skin",
        "kind=rectangle&lines=0.1,0.5,0.9,0.45",
        "tile=1&kind=ellipse",
        "tile=1",
    ] {
        let mut studio = finished(link);
        let cells = studio.pavement().cells.to_vec();
        let (mut found, side) = (0, 192.0);
        for (index, cell) in cells.iter().enumerate() {
            if !contains(&cell.ring, cell.centre) {
                continue;
            }
            found += 1;
            let wrapped = cell.centre.rem_euclid(DVec2::splat(side));
            let p = if link.contains("tile") {
                wrapped
            } else {
                cell.centre
            };
            let probe = studio
                .inspect()
                .probe(DVec2::new(p.x, p.y))
                .expect("a cell is there");
            assert_eq!(probe.cell, index, "{link}");
            assert!((probe.centre - p).length() < 1e-9, "{link}");
            assert!(contains(&probe.outline, p), "{link}");
            let polygon = probe.polygon.expect("cells are polygons");
            assert!((polygon.area - area(&cell.ring)).abs() < 1e-6);
            assert!((3..=12).contains(&polygon.sides), "{link}: {polygon:?}");
            assert!(
                (1..=12).contains(&polygon.neighbours),
                "{link}: {polygon:?}"
            );
            assert!(probe.aspect >= 1.0 && probe.size > 0.0 && probe.wanted > 0.0);
            assert_eq!(probe.angle.is_none(), link == "kind=circle");
            assert_eq!(probe.off.is_none(), link == "kind=circle");
        }
        assert!(found > 9 * cells.len() / 10, "{link}: {found}");
    }
}

#[test]
fn there_is_no_cell_outside() {
    let mut studio = finished("outline=annulus");
    for (x, y) in [(96.0, 96.0), (1.0, 1.0), (-50.0, 1e9), (f64::NAN, 0.0)] {
        assert_eq!(studio.inspect().probe(DVec2::new(x, y)), None);
    }
    assert_eq!(
        Studio::new(ALL, pavement::recipe("").0)
            .inspect()
            .probe(DVec2::new(96.0, 96.0)),
        None
    );
}

#[test]
fn rows_of_squares_are_as_wanted() {
    for (angle, turn) in [("0", 0.0), ("30", 30.0)] {
        let mut studio = finished(&format!("tile=1&dir=constant&angle={angle}"));
        let wanted = studio.pavement().fields.unwrap().params().clone();
        let probe = studio.inspect().probe(DVec2::new(96.0, 96.0)).unwrap();
        let polygon = probe.polygon.unwrap();
        assert_eq!((polygon.sides, polygon.neighbours), (4, 4));
        assert!((probe.size / wanted.size - 1.0).abs() < 0.02, "{probe:?}");
        assert_eq!(probe.wanted, wanted.size);
        assert!(probe.off.unwrap() < 0.5 && probe.aspect < 1.05, "{probe:?}");
        // Among the equivalent rotations, the nearest one is that which repeats with the tile.
        let off = (probe.angle.unwrap() - turn).rem_euclid(90.0);
        assert!(off.min(90.0 - off) < 8.0, "{probe:?}");
    }
}

#[test]
fn honeycombs_have_six_neighbours() {
    let mut studio = finished("tile=1&kind=circle&dir=constant");
    let mut neighbours = [0; 13];
    for k in 0..100 {
        let p = (
            10.0 + 18.0 * f64::from(k % 10),
            10.0 + 18.0 * f64::from(k / 10),
        );
        let polygon = studio
            .inspect()
            .probe(DVec2::new(p.0, p.1))
            .unwrap()
            .polygon
            .unwrap();
        neighbours[polygon.neighbours] += 1;
    }
    assert!(neighbours[6] > 75, "{neighbours:?}");
}

#[test]
fn cells_on_their_way_can_be_asked_too() {
    for link in ["outline=star", "kind=circle", "tile=1&kind=rectangle"] {
        let mut studio = packing(link, 4);
        let particles = studio.pavement().packing.unwrap().particles();
        let mut own = 0;
        for (index, particle) in particles.iter().enumerate() {
            let probe = studio
                .inspect()
                .probe(DVec2::new(particle.centre.x, particle.centre.y))
                .unwrap();
            own += usize::from(probe.cell == index);
            assert_eq!(probe.polygon, None);
            assert!(probe.outline.len() >= 4);
        }
        assert_eq!(own, particles.len(), "{link}");
    }
}

fn count(histogram: &Histogram) -> usize {
    histogram.counts.iter().map(|&n| n as usize).sum()
}

#[test]
fn histograms_count_all_cells() {
    for (link, widest) in [
        ("outline=star", 45.0),
        ("kind=circle", 0.0),
        ("kind=rectangle", 90.0),
        ("kind=ellipse&stone=skin", 90.0),
        ("tile=1", 45.0),
    ] {
        let mut done = finished(link);
        let cells = done.pavement().cells.len();
        let mut early = packing(link, 3);
        let placed = early.progress().cells;
        for (studio, cells) in [(&mut done, cells), (&mut early, placed)] {
            let [size, angle] = studio.inspect().histograms();
            assert_eq!(count(&size), cells, "{link}");
            assert!(size.from < 1.0 && size.to > 1.0);
            if widest == 0.0 {
                assert!(angle.counts.is_empty(), "{link}");
            } else {
                assert!(count(&angle) > 9 * cells / 10, "{link}");
            }
        }
        let [size, angle] = done.inspect().histograms();
        assert_eq!(angle.to, widest, "{link}");
        // Most cells have about the wanted size, and stand as the field does.
        let within = |h: &Histogram, classes: std::ops::Range<usize>| -> usize {
            let some = h.counts.get(classes).unwrap_or_default();
            some.iter().map(|&n| n as usize).sum()
        };
        assert!(within(&size, 9..21) > 7 * cells / 10, "{link}: {size:?}");
        assert!(
            within(&angle, 0..10) >= 8 * count(&angle) / 10,
            "{link}: {angle:?}"
        );
    }
    let mut none = Studio::new(ALL, pavement::recipe("").0);
    assert_eq!(
        none.inspect().histograms(),
        [Histogram::default(), Histogram::default()]
    );
}

#[test]
fn packings_are_recorded_step_by_step() {
    let mut whole = finished("outline=star&kind=circle");
    let rows = whole.inspect().samples().to_vec();
    assert!(rows.windows(2).all(|w| w[0].step < w[1].step));
    let last = whole.progress();
    let end = rows.last().unwrap();
    assert_eq!((rows.len(), end.step), (last.steps as usize, last.steps));
    assert_eq!(end.largest_move, last.largest_move);
    assert_eq!(whole.engine_mut().energy(), end.energy.pairs);
    assert_eq!(
        whole.engine_mut().steps().unwrap().energy_parts(),
        end.energy
    );
    assert!(end.energy.pairs < rows[0].energy.pairs && end.energy.motion < rows[0].energy.motion);
    // Inspection and the size of slices do not change the result.
    let mut watched = studio("size=192&cs=16&outline=star&kind=circle");
    while !watched.done() {
        watched.tick(&mut || 0.0, 0.0, 1);
        watched.engine_mut().view("auto+forces+energy");
        watched.inspect().histograms();
        watched.inspect().probe(DVec2::new(96.0, 60.0));
    }
    assert_eq!(watched.inspect().samples(), rows);
    assert_eq!(watched.digest(), whole.digest());
}

#[test]
fn records_of_large_packings_are_thinned() {
    let mut studio = studio("size=256&cs=5&outline=square&dir=spiral");
    while studio.stage() != "mesh" {
        studio.step(&mut || 0.0);
    }
    let last = studio.progress();
    assert!(last.cells > 2000);
    let rows = studio.inspect().samples();
    assert!(
        rows.iter()
            .all(|row| row.step % 4 == 0 || row.step == last.steps)
    );
    assert_eq!(rows.len(), last.steps.div_ceil(4) as usize);
}

#[test]
fn the_net_force_is_what_the_energy_asks_for() {
    // Forces are much smaller at rest than at the start, and the energies of the particles add up to the total.
    let greatest = |studio: &Studio| {
        let mut packing = studio.pavement().packing.unwrap().clone();
        let loads = packing.net_forces(studio.pavement().domain.unwrap());
        let forces = loads.iter().filter(|(p, _)| !p.fixed);
        forces
            .map(|(_, load)| load.force.length())
            .fold(0.0, f64::max)
    };
    let (early, done) = (packing("outline=star", 2), finished("outline=star"));
    assert!(greatest(&done) < 0.5 * greatest(&early));
    let mut packing = done.pavement().packing.unwrap().clone();
    let loads = packing.net_forces(done.pavement().domain.unwrap());
    let sum: f64 = loads.iter().map(|(p, l)| l.energy * p.size * p.size).sum();
    let mean = loads.iter().map(|(p, _)| p.size * p.size).sum::<f64>() / loads.len() as f64;
    let energy = packing.energy(done.pavement().domain.unwrap());
    assert!(
        (sum / mean - energy).abs() < 1e-6 * energy.abs(),
        "{sum} {energy}"
    );
}

/// The points of a path of straight lines.
fn points(path: &str) -> Vec<DVec2> {
    let plain = path.trim_start_matches('M').trim_end_matches('Z');
    let point = |pair: &str| {
        let (x, y) = pair.split_once(' ').unwrap();
        for number in [x, y] {
            let decimals = number.split_once('.').map_or(0, |(_, d)| d.len());
            assert!(decimals <= 2, "{number}");
        }
        DVec2::new(x.parse().unwrap(), y.parse().unwrap())
    };
    plain.split('L').map(point).collect()
}

#[test]
fn the_svg_has_every_cell() {
    for link in [
        "outline=plaza",
        "kind=ellipse&stone=skin&lines=0.1,0.5,0.9,0.45",
        "tile=1&kind=circle",
        "tile=1&lines=0.2,0.2,0.8,0.7",
        "cells=packed",
    ] {
        let mut studio = finished(link);
        let text = studio.inspect().svg();
        let svg = roxmltree::Document::parse(&text).expect("an SVG file is XML");
        let root = svg.root_element();
        assert!(root.has_tag_name(("http://www.w3.org/2000/svg", "svg")));
        assert_eq!(root.attribute("viewBox"), Some("0 0 192 192"));
        assert_eq!(root.attribute("width"), Some("192"));
        let named = |id: &str| root.descendants().find(|n| n.attribute("id") == Some(id));
        let (mut sum, mut whole) = (0.0, 0.0);
        for (index, cell) in studio.pavement().cells.iter().enumerate() {
            let node = named(&format!("cell-{index}")).expect("each cell has its path");
            let ring = points(node.attribute("d").unwrap());
            assert_eq!(ring.len(), cell.ring.len());
            let fill = node.attribute("fill").unwrap();
            assert!(fill.len() == 7 && fill.starts_with('#'), "{fill}");
            sum += area(&ring);
            whole += area(&cell.ring);
        }
        assert!((sum / whole - 1.0).abs() < 1e-3, "{sum} {whole}");
        let paths = named("cells").unwrap().children();
        let paths = paths.filter(|n| n.has_tag_name("path")).count();
        assert_eq!(paths, studio.pavement().cells.len());
        assert_eq!(named("outline").is_some(), !link.contains("tile"));
        let lines = named("lines").map_or(0, |group| {
            group.children().filter(|n| n.is_element()).count()
        });
        assert_eq!(lines > 0, link.contains("lines"));
        assert_eq!(named("line-0").is_some(), link.contains("lines"));
        let copies = root.descendants().filter(|n| n.has_tag_name("use"));
        assert_eq!(copies.count() > 0, link.contains("tile"));
    }
    assert_eq!(Studio::new(ALL, pavement::recipe("").0).inspect().svg(), "");
}
