//! Maps of the finished picture.

use crate::common::finished;
use crate::paving::OfPavement;
use bubblestone::export::{MapKind, maps};
use bubblestone::heightfield::Planes;
use bubblestone::material::{Gloss, material_table};
use std::collections::HashSet;

/// The planes of a tile, moved by an offset.
fn shifted(planes: &Planes, [dx, dy]: [usize; 2]) -> Planes {
    fn moved<T: Clone>(list: &[T], side: usize, [dx, dy]: [usize; 2]) -> Vec<T> {
        let at = |k: usize| (k / side + dy) % side * side + (k % side + dx) % side;
        (0..list.len()).map(|k| list[at(k)].clone()).collect()
    }
    let by = [dx, dy];
    Planes {
        bump: moved(&planes.bump, planes.side, by),
        colour: moved(&planes.colour, planes.side, by),
        material: moved(&planes.material, planes.side, by),
        id: moved(&planes.id, planes.side, by),
        occlusion: moved(&planes.occlusion, planes.side, by),
        ..*planes
    }
}

#[test]
fn maps_of_a_tile_repeat_to_the_pixel() {
    let mut studio = finished("size=192&tile=1&cs=17&kind=square");
    let planes = studio.pavement().planes.unwrap().clone();
    let materials = material_table("granite", "sand", Gloss::default());
    for (kind, word) in MapKind::ALL {
        let map = studio.maps().unwrap().map(kind).unwrap();
        let pixel = usize::from(map.channels) * usize::from(map.bits) / 8;
        assert_eq!(map.bytes.len(), map.side * map.side * pixel, "{word}");
        let values: HashSet<&[u8]> = map.bytes.chunks_exact(pixel).collect();
        assert!(values.len() > 2, "{word} is flat");
        let [dx, dy] = [77, 130];
        let other = maps::map(kind, &shifted(&planes, [dx, dy]), &materials, 1.0);
        for (k, there) in other.bytes.chunks_exact(pixel).enumerate() {
            let (x, y) = ((k % 192 + dx) % 192, (k / 192 + dy) % 192);
            let here = &map.bytes[(y * 192 + x) * pixel..][..pixel];
            assert_eq!(here, there, "{word} at {x}, {y}");
        }
    }
}
