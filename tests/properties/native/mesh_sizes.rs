//! The announced numbers of triangles and bytes of mesh files are those of the files.

use super::export::{LINK, file_of, nodes, order};
use crate::common::finished;
use bubblestone::export::{DETAILS, MeshFormat, MeshOrder};
use bubblestone::generators::pavement::PAVEMENT;
use std::collections::HashSet;

/// For presets of every group, stones have as many triangles as ordered, and files have the announced size.
#[test]
fn details_are_kept_over_presets() {
    let mut seen = HashSet::new();
    let links = PAVEMENT.presets.iter().filter(|p| seen.insert(p.group));
    let links: Vec<&str> = links.map(|preset| preset.link).collect();
    let more = [
        "stone=flag&size=256",
        "stone=skin&sc=0.5&tc=0.8&size=256&outline=star",
    ];
    for (k, link) in links.into_iter().chain(more).enumerate() {
        let (word, detail) = DETAILS[k % 3];
        let mut studio = finished(link);
        let order = order(MeshFormat::Glb, detail);
        let told = studio.meshes().unwrap().mesh_size(&order).unwrap();
        let file = file_of(&mut studio, &order);
        let nodes = nodes(&file);
        let (ground, stones) = nodes.split_last().unwrap();
        let own: usize = stones.iter().map(|node| node.triangles.len()).sum();
        let mean = own as f64 / stones.len() as f64 / detail as f64;
        assert!((0.7..1.3).contains(&mean), "{link}, {word}: {mean}");
        let all = (own + ground.triangles.len()) as f64;
        let off = [all / told.triangles as f64, file.len() as f64 / told.bytes];
        assert!(
            off.iter().all(|v| (0.9..1.1).contains(v)),
            "{link}: {off:?}"
        );
    }
}

#[test]
fn the_text_file_is_as_long_as_told() {
    let mut studio = finished(LINK);
    for (_, detail) in DETAILS {
        let order = order(MeshFormat::Obj, detail);
        let told = studio.meshes().unwrap().mesh_size(&order).unwrap().bytes;
        let off = file_of(&mut studio, &order).len() as f64 / told;
        assert!((0.85..1.15).contains(&off), "{off}");
    }
}

/// The words for the parts of a building that are no blocks.
const MATERIAL_WORDS: [&str; 9] = [
    "mortar", "brick", "stone", "glass", "wood", "iron", "moss", "grass", "ground",
];

/// The names of the bodies in a GLB file.
fn names_of(glb: &[u8]) -> Vec<String> {
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    let nodes = json["nodes"].as_array().unwrap().iter().skip(1);
    nodes
        .map(|node| node["name"].as_str().unwrap().to_owned())
        .collect()
}

/// Shapes, vessels and grounds of piles and buildings have words for names, and bodies have numbers of their own.
#[test]
fn vessels_and_grounds_are_saved_beside_the_bodies() {
    let links = [
        (&["shape"][..], "make=pile&c1=pebble&ps=6&form=openbox"),
        (&["shape"], "make=pile&c1=pebble&ps=6&form=bowl"),
        (&MATERIAL_WORDS, "make=masonry&module=own&w=240&h=200"),
        (&MATERIAL_WORDS, "make=masonry&pattern=coped&building=steps"),
    ];
    for (others, link) in links {
        let mut studio = finished(&format!("{link}&size=128"));
        let order = order(MeshFormat::Glb, 100);
        let names = names_of(&file_of(&mut studio, &order));
        let (plain, numbered): (Vec<_>, Vec<_>) =
            names.iter().partition(|name| others.contains(&&name[..]));
        assert!(numbered.len() > 9, "{link}: {names:?}");
        let number = |name: &str| name.split('_').nth(1).and_then(|n| n.parse::<usize>().ok());
        let numbers: HashSet<_> = numbered.iter().map(|name| number(name)).collect();
        assert!(!numbers.contains(&None), "{link}: {names:?}");
        assert_eq!(numbers.len(), numbered.len(), "{link}: {plain:?}");
        let joined = MeshOrder {
            joined: true,
            ..order
        };
        assert_eq!(names_of(&file_of(&mut studio, &joined)), ["all"], "{link}");
    }
}
