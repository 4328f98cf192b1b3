//! Properties of the generator's table, and of the blocks of buildings by rule.

use super::MasonryEngine;
use super::schema::{FILE, ROWS, keys};
use crate::building::Rule;
use crate::generators::Engine;
use crate::notice::Notice;
use crate::recipe::Recipe;

fn recipe(link: &str) -> Recipe {
    let (recipe, notices) = Recipe::from_link(&[&super::SCHEMA], link);
    assert!(notices.is_empty(), "{link}: {notices:?}");
    recipe
}

/// The engine of a recipe, up to its blocks; or the sentence with which it stopped.
fn laid(link: &str) -> Result<MasonryEngine, Notice> {
    let mut engine = MasonryEngine::new(&recipe(link));
    while engine
        .at()
        .is_some_and(|at| at < super::stages::WORDS.len() - 1)
    {
        if let Some(notice) = engine.failure() {
            return Err(notice.clone());
        }
        engine.advance();
    }
    Ok(engine)
}

#[test]
fn there_is_a_word_for_each_building_and_a_row_for_each_of_its_numbers() {
    let row = super::SCHEMA.row("building").expect("a row");
    let words = row.choices.iter().map(|choice| choice.word);
    let words: Vec<&str> = words.filter(|&word| word != FILE).collect();
    assert_eq!(words, Rule::ALL.map(Rule::word));
    for rule in Rule::ALL {
        let own = |row: &&crate::recipe::Parameter| {
            let of = row.shown_for;
            of.is_some_and(|(key, of)| key == keys::BUILDING && of == [rule.word()])
        };
        let rows: Vec<_> = ROWS.iter().filter(own).collect();
        assert_eq!(rows.len(), rule.numbers().len(), "{}", rule.word());
        for (row, number) in rows.iter().zip(rule.numbers()) {
            assert_eq!(row.key.0, format!("{}_{}", rule.word(), number.word));
            assert_eq!((row.min, row.max), (number.least, number.most));
        }
    }
}

#[test]
fn every_building_has_a_block_for_each_cell() {
    for rule in Rule::ALL {
        let link = format!("make=masonry&building={}", rule.word());
        let engine = laid(&link).expect("a building");
        let cells = engine.made.cells.made().expect("cells").cells();
        let scene = &engine.made.blocks.made().expect("blocks").scene;
        let drawn = scene
            .instances
            .iter()
            .filter(|instance| instance.id > 0)
            .count();
        assert_eq!(scene.fault(), None);
        assert!(
            drawn * 100 >= cells.len() * 98,
            "{}: {drawn} of {}",
            rule.word(),
            cells.len()
        );
        assert!(!cells.is_empty());
    }
}
