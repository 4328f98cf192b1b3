//! Colours by rule: each rule does what its name says.

use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::cells::Cell;
use bubblestone::domain::Domain;
use bubblestone::field::CellKind;
use bubblestone::material::{Coat, Coats, ColourParams, Pattern};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

const SIDE: f64 = 240.0;

/// Square cells in rows over the picture.
fn rows(count: usize) -> Vec<Cell> {
    let pitch = SIDE / count as f64;
    let cell = |k: usize| {
        let centre = DVec2::new((k % count) as f64 + 0.5, (k / count) as f64 + 0.5) * pitch;
        let corner = |x: f64, y: f64| centre + DVec2::new(x, y) * (0.5 * pitch);
        Cell {
            id: k as u32,
            centre,
            kind: CellKind::Square,
            size: pitch,
            aspect: 1.0,
            axis: DVec2::X,
            ring: vec![
                corner(-1.0, -1.0),
                corner(1.0, -1.0),
                corner(1.0, 1.0),
                corner(-1.0, 1.0),
            ],
        }
    };
    (0..count * count).map(cell).collect()
}

fn coats(domain: &Domain, cells: &[Cell], colour: ColourParams, slice: usize) -> Vec<Coat> {
    let mut coats = Coats::new(colour, 1, SIDE);
    while !coats.advance(domain, cells, slice) {}
    coats.finish(domain, cells)
}

fn by(pattern: Pattern) -> ColourParams {
    ColourParams {
        pattern,
        scale: 60.0,
        sharpness: 0.6,
        ..ColourParams::default()
    }
}

fn mean(values: impl Iterator<Item = f32>) -> f64 {
    let values: Vec<f32> = values.collect();
    values.iter().map(|&v| f64::from(v)).sum::<f64>() / values.len().max(1) as f64
}

#[test]
fn weights_are_shares_whatever_the_rule_and_however_it_is_sliced() {
    let ring = finished("size=240&cs=14&lines=0.1,0.5,0.9,0.5");
    let domain = ring.pavement().domain.expect("a domain");
    let cells = ring.pavement().cells;
    for (pattern, word) in Pattern::ALL {
        assert_eq!(Pattern::of_word(word), pattern);
        for sharpness in [0.0, 1.0] {
            let colour = ColourParams {
                sharpness,
                belly: 1.0,
                scale: 12.0,
                ..by(pattern)
            };
            let found = coats(domain, cells, colour, usize::MAX);
            assert_eq!(found.len(), cells.len());
            assert_eq!(found, coats(domain, cells, colour, 37), "{word}");
            let fits = |v: f32| (0.0..=1.0).contains(&v);
            assert!(
                found.iter().all(|c| fits(c.mark) && fits(c.belly)),
                "{word}"
            );
            let marked = mean(found.iter().map(|c| c.mark));
            let plain = pattern == Pattern::Plain;
            assert_eq!(marked == 0.0, plain, "{word}: {marked}");
            assert!(marked < 0.98, "{word}: {marked}");
        }
    }
}

#[test]
fn nothing_is_marked_by_an_amount_of_none() {
    let domain = Domain::torus(SIDE, &[]);
    for (pattern, word) in Pattern::ALL {
        let colour = ColourParams {
            amount: 0.0,
            ..by(pattern)
        };
        let found = coats(&domain, &rows(12), colour, 100);
        assert!(found.iter().all(|&c| c == Coat::default()), "{word}");
    }
}

#[test]
fn the_share_is_kept_by_every_scattered_rule() {
    let domain = Domain::torus(SIDE, &[]);
    let cells = rows(40);
    for pattern in [
        Pattern::Bands,
        Pattern::Spots,
        Pattern::Blotches,
        Pattern::Turing,
        Pattern::Size,
    ] {
        for share in [0.25, 0.5] {
            let colour = ColourParams {
                share,
                sharpness: 0.9,
                scale: 40.0,
                ..by(pattern)
            };
            let found = mean(coats(&domain, &cells, colour, 999).iter().map(|c| c.mark));
            assert!(
                (found - share).abs() < 0.1,
                "{pattern:?}: {found}, not {share}"
            );
        }
    }
}

/// Bands repeat after the scale across their angle; along it they change less.
#[test]
fn bands_are_periodic_across_their_angle() {
    let domain = Domain::torus(SIDE, &[]);
    let cells = rows(48);
    let found = coats(&domain, &cells, by(Pattern::Bands), 999);
    let away = |dx: usize, dy: usize| {
        let other = |k: usize| (k / 48 + dy) % 48 * 48 + (k % 48 + dx) % 48;
        mean((0..cells.len()).map(|k| (found[k].mark - found[other(k)].mark).abs()))
    };
    // A band's period is 12 cells.
    assert!(
        away(12, 0) < 0.6 * away(6, 0),
        "{} {}",
        away(12, 0),
        away(6, 0)
    );
    assert!(away(0, 6) < 0.6 * away(6, 0));
}

#[test]
fn patterns_of_tiles_repeat() {
    let domain = Domain::torus(SIDE, &[]);
    let cells = rows(24);
    let mut moved = cells.clone();
    for cell in &mut moved {
        let by = DVec2::new(-SIDE, SIDE);
        cell.centre += by;
        cell.ring.iter_mut().for_each(|p| *p += by);
    }
    for (pattern, word) in Pattern::ALL {
        let colour = ColourParams {
            belly: 1.0,
            angle: 0.3,
            belly_angle: 1.0,
            ..by(pattern)
        };
        let (here, there) = (
            coats(&domain, &cells, colour, 99),
            coats(&domain, &moved, colour, 99),
        );
        for (a, b) in here.iter().zip(&there) {
            let apart = (a.mark - b.mark).abs().max((a.belly - b.belly).abs());
            assert!(apart < 1e-3, "{word}: {a:?} {b:?}");
        }
    }
}

/// The reaction shows both states, in marks of about the scale, at any number of cells.
#[test]
fn reactions_make_marks_of_the_scale() {
    let domain = Domain::torus(SIDE, &[]);
    for count in [24usize, 60, 120] {
        let cells = rows(count);
        let colour = ColourParams {
            sharpness: 0.8,
            ..by(Pattern::Turing)
        };
        let found = coats(&domain, &cells, colour, 999);
        let middle = mean(found.iter().map(|c| c.mark));
        let off = |c: &Coat| c.mark - middle as f32;
        let variance = mean(found.iter().map(|c| off(c) * off(c)));
        assert!(variance > 0.12, "{count}: {variance}");
        // A wave has two borders along a row. A labyrinth's stripes cross the row at all angles.
        let differs = |k: usize| {
            let right = k / count * count + (k + 1) % count;
            (found[k].mark > 0.5) != (found[right].mark > 0.5)
        };
        let borders = (0..cells.len()).filter(|&k| differs(k)).count() as f64 / count as f64;
        let waves = borders / 2.0;
        let wanted = SIDE / colour.scale;
        assert!(
            (0.4 * wanted..1.3 * wanted).contains(&waves),
            "{count}: {waves} waves, not {wanted}"
        );
    }
}

#[test]
fn boundary_lines_size_and_direction_are_told_apart() {
    let studio = finished("size=240&outline=square&cs=12&lines=0.1,0.5,0.9,0.5&gx=0.5");
    let domain = studio.pavement().domain.expect("a domain");
    let cells = studio.pavement().cells;
    let of = |colour: ColourParams, is: &dyn Fn(&Cell) -> bool| {
        let found = coats(domain, cells, colour, 999);
        let of = |wanted: bool| {
            let those = cells
                .iter()
                .zip(&found)
                .filter(move |(c, _)| is(c) == wanted);
            mean(those.map(|(_, coat)| coat.mark))
        };
        (of(true), of(false))
    };
    let near = |c: &Cell| domain.nearest(c.centre).distance < 25.0;
    let (rim, rest) = of(
        ColourParams {
            scale: 30.0,
            ..by(Pattern::Boundary)
        },
        &near,
    );
    assert!(rim > rest + 0.5, "{rim} {rest}");
    let near = |c: &Cell| (c.centre.y - 0.5 * SIDE).abs() < 20.0;
    let (rim, rest) = of(
        ColourParams {
            scale: 20.0,
            ..by(Pattern::Lines)
        },
        &near,
    );
    assert!(rim > rest + 0.5, "{rim} {rest}");
    let (right, left) = of(by(Pattern::Size), &|c| c.centre.x > 0.5 * SIDE);
    assert!(right > left + 0.3, "{right} {left}");
    // A square looks the same after a quarter turn, but not after an eighth.
    let pointing = |angle| {
        of(
            ColourParams {
                angle,
                ..by(Pattern::Direction)
            },
            &|_| true,
        )
        .0
    };
    assert!(pointing(0.0) > pointing(FRAC_PI_4) + 0.5);
    assert!((pointing(0.0) - pointing(FRAC_PI_2)).abs() < 1e-6);
}

#[test]
fn the_belly_lies_where_it_is_said() {
    let studio = finished("size=240&outline=square&cs=16");
    let domain = studio.pavement().domain.expect("a domain");
    let colour = ColourParams {
        belly: 0.8,
        belly_angle: 0.0,
        ..ColourParams::default()
    };
    let found = coats(domain, studio.pavement().cells, colour, 999);
    for (cell, coat) in studio.pavement().cells.iter().zip(found) {
        if cell.centre.x < 0.25 * SIDE {
            assert_eq!(coat.belly, 0.0);
        }
        if cell.centre.x > 0.85 * SIDE {
            assert_eq!(coat.belly, 0.8);
        }
    }
}

#[test]
fn every_word_and_number_reaches_the_planes() {
    let base = "size=160&tile=1&kind=ellipse&cs=14&palette=lizard";
    let digest = |more: &str| finished(&format!("{base}{more}")).digest();
    let mut seen = vec![digest("")];
    for (_, word) in &Pattern::ALL[1..7] {
        seen.push(digest(&format!("&pattern={word}")));
    }
    for more in [
        "&pattern=direction",
        "&pattern=direction&pa=40",
        "&pattern=bands&pn=0.3",
        "&pattern=bands&pa=90",
        "&pattern=bands&ps=0.1",
        "&pattern=bands&pc=0.3",
        "&pattern=bands&pm=0.5",
        "&rim=0.5",
        "&rim=-0.5",
        "&belly=0.7",
        "&belly=0.7&ba=0",
    ] {
        seen.push(digest(more));
    }
    let count = seen.len();
    seen.sort();
    seen.dedup();
    assert_eq!(seen.len(), count, "two of them look alike");
}

#[test]
fn rims_are_darker_than_middles_and_the_other_way_round() {
    let light = |rim: &str| {
        let studio = finished(&format!(
            "size=200&outline=square&cs=40&stone=flag&dr=0&rim={rim}"
        ));
        let planes = studio.pavement().planes.expect("planes");
        let sum = |place: &dyn Fn(&Cell) -> Vec<DVec2>| {
            let places = studio.pavement().cells.iter().flat_map(place);
            let at = places.map(|p| planes.colour[p.y as usize * 200 + p.x as usize]);
            mean(at.map(|c| c.iter().map(|&v| f32::from(v)).sum()))
        };
        let edge = sum(&|c| {
            c.ring
                .iter()
                .map(|&p| c.centre + 0.7 * (p - c.centre))
                .collect()
        });
        edge / sum(&|c| vec![c.centre])
    };
    let (dark, plain, pale) = (light("1"), light("0"), light("-1"));
    assert!(
        dark < 0.8 * plain && plain < 0.8 * pale,
        "{dark} {plain} {pale}"
    );
}
