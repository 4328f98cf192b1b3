//! Tests of the files of scenes, and of the files that recipes name.

use super::given_files::GivenFiles;
use super::loading::Loading;
use super::tests::{GREEN, RED, scene};
use super::*;
use crate::export::{MeshFormat, MeshOrder, SceneFile, SceneTerms};
use crate::generators::MeshSlice;
use crate::material::{Gloss, material_table};
use crate::notice::Code;
use crate::recipe::NamedFile;
use crate::scene::{Instance, Paint, Scene};
use std::collections::BTreeSet;

fn file(format: MeshFormat, joined: bool, scene: &Scene) -> Vec<u8> {
    let order = MeshOrder {
        format,
        detail: 100,
        images: None,
        joined,
    };
    let materials = material_table("granite", "sand", Gloss::default());
    let mut saving = None;
    let mut bytes = Vec::new();
    loop {
        let terms = || SceneTerms {
            materials: ["sand", "clay", "chalk"].map(str::to_owned).to_vec(),
            ..SceneTerms::default()
        };
        let new = || SceneFile::new(&order, (&materials, terms()), scene);
        let name = |instance: &Instance| format!("box \"{}\"", instance.id);
        let advance = |file: &mut SceneFile| file.advance(scene, name);
        let MeshSlice { parts, done, .. } =
            Saving::slice(&mut saving, (&order, 1), new, (&mut || 0.0, 0.0), advance);
        bytes.extend(parts.concat());
        if done {
            return bytes;
        }
    }
}

fn json_of(glb: &[u8]) -> serde_json::Value {
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    serde_json::from_slice(&glb[20..20 + length]).unwrap()
}

#[test]
fn bodies_share_meshes_in_a_file() {
    let mut many = scene([Some(RED), Some(GREEN)]);
    for k in 0..8 {
        let mut more = many.instances[k % 2];
        more.id = k as u32 + 3;
        more.place.origin.y += 1.0 + k as f32;
        many.instances.push(more);
    }
    let glb = file(MeshFormat::Glb, false, &many);
    let json = json_of(&glb);
    let count = |key: &str| json[key].as_array().unwrap().len();
    // One white surface as a mesh with each paint; the bodies are in the first node.
    assert_eq!(
        (count("meshes"), count("accessors"), count("nodes")),
        (2, 3, 11)
    );
    assert_eq!(count("materials"), 3);
    assert_eq!(json["nodes"][1]["name"], "box \"1\"");
    let joined = json_of(&file(MeshFormat::Glb, true, &many));
    let parts = joined["meshes"][0]["primitives"].as_array().unwrap();
    assert_eq!(
        (joined["meshes"].as_array().unwrap().len(), parts.len()),
        (1, 2)
    );
    assert!(parts[0]["material"] != parts[1]["material"]);
    let text = String::from_utf8(file(MeshFormat::Obj, false, &many)).unwrap();
    assert_eq!(
        text.lines().filter(|line| line.starts_with("o ")).count(),
        10
    );
    assert!(text.contains("\no box_\"1\"\nv -0.5 0 -0.2 ") || text.contains("o box_\"1\""));
}

#[test]
fn many_tints_become_a_few_shades() {
    let mut many = scene([Some(RED), Some(GREEN)]);
    let body = many.instances[0];
    many.instances = (0..600)
        .map(|k| {
            let tint = [100 + (k % 90) as u8, 60, 60 + (k % 7) as u8];
            let material = (k % 2) as u8;
            let paint = Some(Paint { tint, material });
            Instance { paint, ..body }
        })
        .collect();
    let json = json_of(&file(MeshFormat::Glb, false, &many));
    let list = |key: &str| json[key].as_array().unwrap();
    // The first material is that of bodies without a paint.
    assert_eq!((list("materials").len(), list("meshes").len()), (49, 48));
    assert_eq!(list("nodes").len(), 601);
    let names: BTreeSet<_> = list("materials")
        .iter()
        .map(|one| one["name"].as_str())
        .collect();
    assert!(names.len() == 49 && names.contains(&Some("clay")) && names.contains(&Some("clay_24")));
}

/// A tetrahedron as text.
fn tetrahedron() -> Vec<u8> {
    b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n".to_vec()
}

#[test]
fn files_of_two_roles_are_waited_for_and_read() {
    let named = |digest| Some(NamedFile::new(digest, "a.obj"));
    let asked = [("part", 7), ("form", 8)].map(|(role, digest)| AskedFile {
        role,
        file: named(digest),
        is_z_up: false,
    });
    let mut files = GivenFiles::default();
    files.give(8, tetrahedron(), &asked);
    let missing: Vec<_> = files.missing(&asked).collect();
    assert_eq!(missing.len(), 1);
    assert_eq!((missing[0].role, &missing[0].name[..]), ("part", "a.obj"));
    let refused = Loading::advance(&asked, &mut None, &files);
    assert_eq!(refused.err().unwrap().code, Code::ModelMissing);
    files.give(7, tetrahedron(), &asked);
    assert_eq!(files.missing(&asked).count(), 0);
    let mut work = None;
    let read = std::iter::from_fn(|| Some(Loading::advance(&asked, &mut work, &files).unwrap()));
    let loaded = read.into_iter().find_map(|done| done).unwrap();
    assert_eq!(loaded.meshes.len(), 2);
    assert!(loaded.meshes.iter().all(|mesh| mesh.triangles().len() == 4));
}
