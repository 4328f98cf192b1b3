//! The picture with more pixels is the same picture.

use crate::common::finished;
use bubblestone::export::MapKind;
use bubblestone::generators::PictureSlice;
use bubblestone::notice::Code;
use bubblestone::studio::Studio;

/// All of a bigger picture, in one call.
fn bigger(studio: &mut Studio, scale: usize) -> PictureSlice {
    let made = studio
        .engine_mut()
        .picture_file(scale, &mut || 0.0, f64::INFINITY);
    made.expect("a picture that can be saved")
}

/// The mean difference of colours between a picture and a bigger one whose pixels are averaged over
/// squares of `block` pixels of the first.
fn difference(picture: &[u8], made: &PictureSlice, scale: usize, block: usize) -> f64 {
    let side = made.side / scale;
    let across = side / block;
    let mut sums = vec![0.0; 3 * across * across];
    let mut add = |x: usize, y: usize, colour: &[u8], share: f64| {
        for (k, &v) in colour.iter().take(3).enumerate() {
            sums[3 * (y * across + x) + k] += f64::from(v) * share;
        }
    };
    let pixels = (block * block) as f64;
    for (at, rgba) in picture.chunks_exact(4).enumerate() {
        add(at % side / block, at / side / block, rgba, -1.0 / pixels);
    }
    let (wide, block) = (made.side, block * scale);
    let pixels = (block * block) as f64;
    for (at, rgb) in made.rows.chunks_exact(3).enumerate() {
        add(at % wide / block, at / wide / block, rgb, 1.0 / pixels);
    }
    sums.iter().map(|d| d.abs()).sum::<f64>() / sums.len() as f64
}

#[test]
fn averaged_it_is_the_picture() {
    let links = [
        "",
        "stone=flag&palette=slate",
        "stone=skin&kind=ellipse&palette=lizard&outline=square",
        "stone=skin&tile=1&rings=4&keel=0.3&pattern=spots",
        "tile=1",
        "wear=0.6&moss=0.5&dirt=0.4&wet=0.4",
        "light=point&lx=0.3&ly=0.2&lz=0.2",
        "az=100&el=15",
    ];
    for link in links {
        let mut studio = finished(&format!("size=256&{link}"));
        for (scale, most, most_smooth) in [(2, 5.0, 2.0), (3, 6.0, 4.0), (4, 7.0, 4.0)] {
            let made = bigger(&mut studio, scale);
            let picture = studio.picture().unwrap();
            let [off, smooth] = [1, 8].map(|block| difference(picture, &made, scale, block));
            assert!(
                off < most && smooth < most_smooth,
                "{link} {scale}: {off} {smooth}"
            );
        }
    }
}

#[test]
fn at_its_own_side_it_is_the_picture() {
    // Stones of two bands, and of two pictures of a tile.
    for link in [
        "size=1536&cs=80&outline=square",
        "size=256&tile=1&stone=skin",
    ] {
        let mut studio = finished(link);
        let made = bigger(&mut studio, 1);
        let off = difference(studio.picture().unwrap(), &made, 1, 1);
        assert!(off < 1e-5, "{link}: {off}");
    }
}

#[test]
fn slices_give_the_same_picture() {
    let mut studio = finished("size=160&outline=annulus&cs=14&moss=0.5");
    let whole = bigger(&mut studio, 2);
    assert!(whole.begun && whole.done && whole.progress == 1.0);
    assert_eq!((whole.side, whole.rows.len()), (320, 3 * 320 * 320));
    let (mut rows, mut progress, mut slices) = (Vec::new(), 0.0, 0);
    loop {
        // No time at all: the least there can be.
        let slice = studio
            .engine_mut()
            .picture_file(2, &mut || 0.0, 0.0)
            .unwrap();
        assert_eq!(slice.begun, slices == 0);
        assert!(
            slice.progress >= progress,
            "{progress} then {}",
            slice.progress
        );
        (progress, slices) = (slice.progress, slices + 1);
        rows.extend(slice.rows);
        if slice.done {
            break;
        }
    }
    assert!(slices > 100 && progress == 1.0);
    assert!(rows == whole.rows);
}

#[test]
fn another_picture_begins_anew() {
    let mut studio = finished("size=160&outline=annulus&cs=14");
    let slice =
        |studio: &mut Studio, scale| studio.engine_mut().picture_file(scale, &mut || 0.0, 0.0);
    assert!(slice(&mut studio, 2).unwrap().begun);
    assert!(!slice(&mut studio, 2).unwrap().begun);
    assert!(slice(&mut studio, 3).unwrap().begun);
    studio.engine_mut().stop_file();
    assert!(slice(&mut studio, 3).unwrap().begun);
    let mut recipe = studio.recipe().clone();
    assert_eq!(recipe.set("az", "10"), Ok(vec![]));
    studio.set_recipe(recipe);
    assert!(slice(&mut studio, 3).unwrap_err().code == Code::NotYet);
    studio.finish(&mut || 0.0).unwrap();
    assert!(slice(&mut studio, 3).unwrap().begun);
}

#[test]
fn what_is_too_large_gets_a_sentence() {
    let mut studio = finished("size=1088&cs=60");
    for scale in [0, 4, 5, usize::MAX / 4096] {
        let said = studio
            .engine_mut()
            .picture_file(scale, &mut || 0.0, 0.0)
            .unwrap_err();
        let said = said.to_string();
        assert!(said.contains("1 to 3 times its side"), "{said}");
    }
}

#[test]
fn its_maps_are_those_of_the_picture() {
    let mut studio = finished("size=160&tile=1&cs=14");
    assert!(studio.engine().bigger_map(MapKind::Height).is_err());
    bigger(&mut studio, 2);
    for (kind, word) in MapKind::ALL {
        let (map, own) = (
            studio.engine().bigger_map(kind).unwrap(),
            studio.engine().map(kind).unwrap(),
        );
        assert_eq!(
            (map.side, map.bytes.len()),
            (320, 4 * own.bytes.len()),
            "{word}"
        );
        // The high byte of what has two.
        let step = usize::from(map.bits / 8);
        let mean = |bytes: &[u8]| {
            let values = bytes.iter().step_by(step).map(|&v| f64::from(v));
            values.sum::<f64>() / (bytes.len() / step) as f64
        };
        let (big, small) = (mean(&map.bytes), mean(&own.bytes));
        assert!((big - small).abs() < 4.0, "{word}: {big}, {small}");
    }
    studio.engine_mut().stop_file();
    assert!(studio.engine().bigger_map(MapKind::Height).is_err());
}
