//! Tests: bigger pictures do not show that they were painted in bands.

use super::{Pavement, params};
use crate::export::{Map, MapKind};
use crate::generators::ALL;
use crate::generators::bigger::Bigger;
use crate::generators::height_field::Bodies;
use crate::studio::Studio;

const LINKS: [&str; 9] = [
    "size=128&cs=16&wear=0.6&moss=0.5&dirt=0.4&wet=0.4",
    "size=128&cs=20&stone=skin&kind=ellipse&palette=lizard&outline=square",
    "size=128&cs=20&stone=skin&tile=1&rings=4&keel=0.3&pattern=spots&moss=0.5",
    "size=192&cs=18&tile=1&ground=gravel&wet=0.7",
    "size=128&cs=18&light=point&lx=0.3&ly=0.2&lz=0.2",
    "size=128&cs=18&az=20&el=8",
    "size=128&cs=18&az=100&el=8&ground=gravel",
    "size=128&cs=18&az=190&el=8&tile=1",
    "size=128&cs=18&az=280&el=8&outline=square&stone=flag",
];

/// A picture or its maps, made in bands of so many rows.
fn made(pavement: &Pavement, scale: usize, kinds: &[MapKind], band: usize) -> Vec<Map> {
    let bodies = Bodies {
        domain: pavement.made.terrain.domain.made().expect("a domain"),
        cells: pavement.made.scales(),
        coats: pavement.made.coats(),
    };
    let params = params::finish(&pavement.working.recipe, scale, 0);
    let side = scale * pavement.made.planes().expect("planes").side;
    let mut bigger = Bigger::begin((scale, kinds), side, 0, params, (bodies, band));
    while !bigger.is_done() {
        bigger.add(bodies);
    }
    bigger.take()
}

#[test]
fn bands_make_the_whole() {
    let kinds = MapKind::ALL.map(|(kind, _)| kind);
    for (at, link) in LINKS.into_iter().enumerate() {
        let (recipe, notices) = ALL.recipe(link);
        assert!(notices.is_empty(), "{link}");
        let mut studio = Studio::new(ALL, recipe);
        assert_eq!(studio.finish(&mut || 0.0), Ok(()), "{link}");
        let pavement: &Pavement = studio.engine_as().expect("a pavement");
        let scale = [2, 3, 4][at % 3];
        for kinds in [&kinds[..], &[]] {
            let whole = made(pavement, scale, kinds, usize::MAX);
            for band in [16, 50] {
                let banded = made(pavement, scale, kinds, band);
                assert!(banded == whole, "{link} {band}");
            }
        }
    }
}
