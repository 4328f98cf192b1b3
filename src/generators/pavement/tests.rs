//! Tests: exactly the stages with changed inputs run, and bigger pictures show no joints between bands.

use super::params::{self, Params};
use super::schema::keys;
use super::{Pavement, SCHEMA, Stage};
use crate::export::{Map, MapKind};
use crate::field::FieldParams;
use crate::generators::bigger::Bigger;
use crate::generators::height_field::{Bodies, solids};
use crate::generators::rows::{shared, stones};
use crate::generators::{ALL, Engine};
use crate::heightfield::TextureParams;
use crate::light::ShadeParams;
use crate::packing::PackingParams;
use crate::random::{Purpose, Random};
use crate::recipe::{Key, Kind, Recipe};
use crate::solid::{SkinParams, StoneParams};
use crate::studio::Studio;

/// Three test values for each parameter that is a list.
fn drawn(key: Key) -> [&'static str; 3] {
    match key {
        keys::POLY => [
            "0.1,0.1,0.9,0.2,0.7,0.9,0.2,0.8",
            "0.1,0.1,0.9,0.1,0.9,0.9,0.1,0.9;0.3,0.3,0.3,0.6,0.6,0.6",
            "0.05,0.3,0.95,0.3,0.95,0.8,0.05,0.8",
        ],
        keys::LINES => ["", "0,0.4,1,0.6", "0.1,0.1,0.9,0.9;0.1,0.9,0.9,0.1"],
        keys::STROKES => ["", "0.2,0.3,0.8,0.6,0.9,0.1", "0.5,0.1,0.5,0.9"],
        keys::SPOTS => ["", "0.5,0.5,0.3,1.5", "0.5,0.5,0.3,1.5;0.2,0.2,0.2,2"],
        keys::STRETCH => ["", "0.5,0.5,0.3,4", "0.3,0.5,0.2,1"],
        keys::PARTS => ["", "0.5,0.5,1;0.2,0.7,3", "0.3,0.3,2"],
        keys::GIVEN => ["", "0.4,0.5,1;0.6,0.5,0", "0.5,0.5,0"],
        _ => panic!("nothing to draw for {}", key.0),
    }
}

/// A recipe with some changed values, for small pictures with few cells.
fn changed(recipe: &Recipe, random: &mut Random) -> Recipe {
    let mut changed = recipe.clone();
    for _ in 0..=random.below(3) {
        let lists = || SCHEMA.rows.iter().filter(|row| row.kind == Kind::Text);
        let row = match random.below(5) {
            0 => lists().nth(random.below(lists().count())),
            _ => SCHEMA.rows.get(random.below(SCHEMA.rows.len())),
        };
        let row = row.expect("a row");
        let text = match row.kind {
            Kind::Text => drawn(row.key)[random.below(3)].to_owned(),
            Kind::Choice => row.choices[random.below(row.choices.len())].word.to_owned(),
            Kind::Number | Kind::Int => {
                let value = row.min + (row.max - row.min) * random.unit();
                format!("{value:.2}")
            }
        };
        let _ = changed.set(row.key.0, &text);
    }
    let sides = [recipe.side(), recipe.side(), recipe.side(), 128.0, 160.0];
    let side = sides[random.below(sides.len())].to_string();
    let _ = changed.set("size", &side);
    if changed.number(keys::CS) < 12.0 {
        let _ = changed.set("cs", "12");
    }
    changed
}

#[test]
fn the_libraries_defaults_are_those_of_a_recipe() {
    let mut recipe = Recipe::new(&SCHEMA);
    let stone = |recipe: &Recipe| stones::stone(recipe, 1.0);
    assert_eq!(params::fields(&recipe), FieldParams::default());
    assert_eq!(params::packing(&recipe), PackingParams::default());
    assert_eq!(shared::shading(&recipe), ShadeParams::default());
    // The skin parameters of a recipe have other defaults while its stones are not skin.
    let skin = SkinParams::default();
    let texture = TextureParams {
        stone: StoneParams {
            skin,
            ..stone(&recipe)
        },
        ..params::texture(&recipe)
    };
    assert_eq!(texture, TextureParams::default());
    assert_eq!(recipe.set("stone", "skin"), Ok(vec![]));
    assert_eq!(stone(&recipe).skin, skin);
}

/// The stages that must run to go from one recipe to another: those whose parameters differ, and those that read
/// their results.
fn due(from: &Params, to: &Params) -> [bool; 8] {
    let finishes = [&from.finish, &to.finish];
    let [painted, weathered, lit] = [
        finishes[0].planes != finishes[1].planes,
        finishes[0].weather != finishes[1].weather,
        finishes[0].light != finishes[1].light,
    ];
    let dressed = (&from.flow, from.coats) != (&to.flow, to.coats);
    let domain = from.domain != to.domain;
    let fields = domain || from.fields != to.fields;
    let packing = fields || from.packing != to.packing;
    let cells = packing || from.cells != to.cells;
    let planes = cells || dressed || painted;
    let weather = planes || weathered;
    [
        domain,
        fields,
        packing,
        packing,
        cells,
        planes,
        weather,
        weather || lit,
    ]
}

fn asked(recipe: &Recipe) -> Params {
    Pavement::new(recipe).made.latest()
}

/// From any state, a studio reaches the recipe's result without unnecessary work.
#[test]
fn exactly_what_differs_runs() {
    let mut random = Random::new(11, Purpose::Placement, 0);
    let mut recipe = super::recipe("size=128&cs=16").0;
    let mut studio = Studio::new(ALL, recipe.clone());
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    let mut late = 0;
    for _ in 0..60 {
        let next = changed(&recipe, &mut random);
        let (from, runs) = (asked(&recipe), studio.runs());
        studio.set_recipe(next.clone());
        if studio.finish(&mut || 0.0).is_err() {
            studio.set_recipe(recipe.clone());
            assert_eq!(studio.finish(&mut || 0.0), Ok(()));
            continue;
        }
        let due = due(&from, &asked(&next));
        for (((word, new), (_, old)), due) in studio.runs().into_iter().zip(runs).zip(due) {
            assert_eq!(
                new - old,
                u64::from(due),
                "{word}: {} to {}",
                recipe.link(),
                next.link()
            );
        }
        late += usize::from(!due[Stage::Cells as usize]);
        let mut plain = Studio::new(ALL, next.clone());
        assert_eq!(plain.finish(&mut || 0.0), Ok(()));
        assert_eq!(
            studio.digest(),
            plain.digest(),
            "{} to {}",
            recipe.link(),
            next.link()
        );
        assert!(studio.picture() == plain.picture(), "{}", next.link());
        recipe = next;
    }
    assert!(late > 10, "{late}");
}

/// Pictures of stones and skin, weathered, tiled, lit by a lamp, and by a low sun from every quarter.
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

/// A picture or its maps, made in bands of `band` rows.
fn made(pavement: &Pavement, scale: usize, kinds: &[MapKind], band: usize) -> Vec<Map> {
    let bodies = Bodies {
        domain: pavement.made.domain.made().expect("a domain"),
        cells: pavement.made.scales(),
        coats: pavement.made.coats(),
    };
    let params = pavement.made.finish.params(scale);
    let side = scale * pavement.made.planes().expect("planes").side;
    let work = (bodies.coats, solids(&params.planes), band);
    let mut bigger = Bigger::begin((scale, kinds), side, 0, params, work);
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
        let mut pavement = Pavement::new(&recipe);
        while pavement.at().is_some() && pavement.failure().is_none() {
            pavement.advance();
        }
        assert_eq!(pavement.failure(), None, "{link}");
        let scale = [2, 3, 4][at % 3];
        // Maps do not depend on the light, so they are made only for the first links, whose stones differ.
        let wanted: &[&[MapKind]] = if at < 4 { &[&kinds, &[]] } else { &[&[]] };
        // Bands that divide the picture and bands that do not.
        let bands = [16, 50];
        for (turn, &kinds) in wanted.iter().enumerate() {
            let band = bands[(at + turn) % 2];
            let whole = made(&pavement, scale, kinds, usize::MAX);
            let banded = made(&pavement, scale, kinds, band);
            assert!(banded == whole, "{link} {band}");
        }
    }
}

/// The mean difference between a view and its larger drawing, whose pixels are averaged, in 255ths.
fn off(plain: &[u8], fine: &[u8], scale: usize) -> f64 {
    let side = (plain.len() / 4).isqrt();
    let mean = |k: usize| {
        let (x, y) = (scale * (k / 4 % side), scale * (k / 4 / side));
        let at = |n: usize| 4 * ((y + n / scale) * scale * side + x + n % scale) + k % 4;
        let sum: f64 = (0..scale * scale).map(|n| f64::from(fine[at(n)])).sum();
        sum / (scale * scale) as f64
    };
    let apart = plain.iter().enumerate();
    let apart: f64 = apart.map(|(k, &v)| (mean(k) - f64::from(v)).abs()).sum();
    apart / plain.len() as f64
}

/// Maps always have the recipe's pixels. All other views have the pixels that are asked for.
#[test]
fn drawings_have_more_pixels_and_the_same_content() {
    let (recipe, _) = ALL.recipe("size=128&cs=24&kind=ellipse&ca=2&spots=0.5,0.5,0.3,1.5");
    let mut studio = Studio::new(ALL, recipe);
    studio.finish(&mut || 0.0).unwrap();
    let drawn = "paper packed cells mesh direction potential picture+mesh height+cells paper+energy+forces \
                 picture+anisotropy+singularities+packed";
    for view in drawn.split(' ').filter(|view| !view.is_empty()) {
        for scale in [2, 3] {
            let engine = studio.engine_mut();
            let plain = engine.view(view).to_vec();
            let words = format!("{view}+x{scale}");
            let scale = scale.min(if view == "potential" { 2 } else { 3 });
            while !engine.prepare(&words, &mut || 0.0, 1.0) {}
            let fine = engine.view(&words).to_vec();
            assert_eq!(fine.len(), plain.len() * scale * scale, "{words}");
            let off = off(&plain, &fine, scale);
            // A picture's grain is softer when it is enlarged.
            let most = match view.starts_with("picture") {
                true => 7.0,
                false => 2.0,
            };
            assert!(off < most, "{words}: {off}");
            assert_eq!(engine.view(view), plain, "{words} changed {view}");
        }
    }
    for view in "auto picture height normals ids albedo roughness ao paper+size".split(' ') {
        let plain = studio.engine_mut().view(view).to_vec();
        assert_eq!(studio.engine_mut().view(&format!("{view}+x3")), plain);
    }
}

#[test]
fn a_drawing_is_never_too_large_for_memory() {
    let (recipe, _) = ALL.recipe("size=1024");
    let mut studio = Studio::new(ALL, recipe);
    for (words, side) in [("paper+x3", 2048), ("paper+x2", 2048), ("paper+x4", 1024)] {
        assert_eq!(studio.engine_mut().view(words).len(), 4 * side * side);
    }
}
