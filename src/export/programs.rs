//! Sets of maps for other programs: which maps, how packed, and the files' names. The page has the same sets in
//! `www/take/files/programs.ts`, which keeps the module small.

use super::MapKind;

/// The sets of each program: each line has a map's word and the name of its file.
///
/// Unreal has green down, and occlusion, roughness and metal in one map (Epic Games' names of assets). Unity has the
/// mask map of its pipelines (URP reads it as metal and occlusion, too). Godot takes one map with its ORMMaterial3D.
/// Blender's Node Wrangler finds single maps by the words in their names.
const SETS: [(&str, &str); 4] = [
    (
        "blender",
        "albedo Bubblestone_BaseColor.png
normal-opengl Bubblestone_Normal.png
roughness Bubblestone_Roughness.png
ao Bubblestone_AO.png
height-float Bubblestone_Displacement.exr
id Bubblestone_ID.png",
    ),
    (
        "godot",
        "albedo bubblestone_albedo.png
normal-opengl bubblestone_normal.png
orm bubblestone_orm.png
height-float bubblestone_height.exr
id bubblestone_id.png",
    ),
    (
        "unity",
        "albedo Bubblestone_BaseMap.png
normal-opengl Bubblestone_Normal.png
orm Bubblestone_MaskMap.png
height-float Bubblestone_Height.exr
id Bubblestone_ID.png",
    ),
    (
        "unreal",
        "albedo T_Bubblestone_BC.png
normal-directx T_Bubblestone_N.png
orm T_Bubblestone_ORM.png
height-float T_Bubblestone_H.exr
id T_Bubblestone_ID.png",
    ),
];

/// The maps of a program's set with the names of their files; an unknown word has no maps. A mask map is made of the
/// map of occlusion, roughness and metal: [`super::Map::mask`].
pub fn maps_for(program: &str) -> impl Iterator<Item = (MapKind, &'static str)> {
    let set = SETS.iter().find(|(word, _)| *word == program);
    let lines = set.map_or("", |(_, lines)| lines).lines();
    lines.filter_map(|line| {
        let (word, file) = line.split_once(' ')?;
        Some((MapKind::of_word(word)?, file))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_of_a_set_is_a_map() {
        for (program, lines) in SETS {
            assert_eq!(
                maps_for(program).count(),
                lines.lines().count(),
                "{program}"
            );
            for (kind, file) in maps_for(program) {
                let float = kind == MapKind::HeightFloat;
                assert_eq!(file.ends_with(".exr"), float, "{program}");
            }
        }
        assert_eq!(maps_for("paint").count(), 0);
    }
}
