//! A picture with more pixels is the same picture.

use crate::common::finished;
use bubblestone::export::{Map, MapKind};
use bubblestone::generators::PictureSlice;
use bubblestone::notice::{Code, Notice};
use bubblestone::studio::Studio;

/// A whole enlarged picture, or its maps, in as few slices as possible.
fn made(studio: &mut Studio, scale: usize, kinds: &[MapKind]) -> PictureSlice {
    let mut slice = || {
        let maps = studio.maps().unwrap();
        let made = maps.picture_file((scale, kinds), &mut || 0.0, f64::INFINITY);
        made.expect("a picture that can be saved")
    };
    let mut whole = slice();
    while !whole.done {
        let next = slice();
        for (map, more) in whole.rows.iter_mut().zip(next.rows) {
            map.bytes.extend(more.bytes);
        }
        (whole.progress, whole.heights, whole.done) = (next.progress, next.heights, next.done);
    }
    whole
}

/// A whole enlarged picture.
fn bigger(studio: &mut Studio, scale: usize) -> Map {
    made(studio, scale, &[]).rows.remove(0)
}

/// The smallest slice of one: a slice with no time.
fn slice(studio: &mut Studio, scale: usize) -> Result<PictureSlice, Notice> {
    let maps = studio.maps().unwrap();
    maps.picture_file((scale, &[]), &mut || 0.0, 0.0)
}

/// The mean colour difference between a picture and an enlarged one, whose pixels are averaged over blocks. A
/// block covers `block` by `block` pixels of the first picture.
fn difference(picture: &[u8], made: &Map, scale: usize, block: usize) -> f64 {
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
    for (at, rgb) in made.bytes.chunks_exact(3).enumerate() {
        add(at % wide / block, at / wide / block, rgb, 1.0 / pixels);
    }
    sums.iter().map(|d| d.abs()).sum::<f64>() / sums.len() as f64
}

#[test]
fn averaged_it_is_the_picture() {
    let links = [
        "size=128",
        "size=128&stone=flag&palette=slate",
        "size=128&stone=skin&kind=ellipse&palette=lizard&outline=square",
        "size=128&stone=skin&tile=1&rings=4&keel=0.3&pattern=spots",
        // On a smaller tile, its few stones differ more from the mean.
        "size=256&tile=1",
        "size=128&wear=0.6&moss=0.5&dirt=0.4&wet=0.4",
        "size=128&light=point&lx=0.3&ly=0.2&lz=0.2",
        "size=128&az=100&el=15",
    ];
    for link in links {
        let mut studio = finished(link);
        // The largest pictures take most of the time, and two of them stand for all.
        let scales = match link {
            "size=128" | "size=128&az=100&el=15" => 4,
            _ => 3,
        };
        let bounds = [(2, 5.0, 2.0), (3, 6.0, 4.0), (4, 7.0, 4.0), (8, 8.5, 6.5)];
        for (scale, most, most_smooth) in bounds.into_iter().take(scales) {
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

/// The mean difference in green between pixels this far apart, in a corner that is ground.
fn roughness(made: &Map, apart: usize) -> f64 {
    const CORNER: usize = 80;
    let green = |x: usize, y: usize| f64::from(made.bytes[3 * (y * made.side + x) + 1]);
    let at = |k: usize| (k % CORNER, k / CORNER);
    let rough = |(x, y)| {
        let here = green(x, y);
        (here - green(x + apart, y)).abs() + (here - green(x, y + apart)).abs()
    };
    (0..CORNER * CORNER).map(at).map(rough).sum::<f64>() / (2 * CORNER * CORNER) as f64
}

/// Without grains of a pixel, the sand of large pictures is smooth waves, and light makes ripples of them.
#[test]
fn sand_of_large_pictures_has_grains() {
    let mut studio = finished("size=256");
    for (scale, least) in [(4, 0.6), (8, 0.5)] {
        let made = bigger(&mut studio, scale);
        let share = roughness(&made, scale / 4) / roughness(&made, scale);
        assert!(share > least, "{scale}: {share}");
    }
}

#[test]
fn at_its_own_side_it_is_the_picture() {
    // Stones in two bands, and on a tile whose stones reach over its edges.
    for link in [
        "size=1536&cs=80&outline=square",
        "size=256&tile=1&stone=skin",
    ] {
        let mut studio = finished(link);
        let made = bigger(&mut studio, 1);
        let rgb = studio.picture().unwrap().chunks_exact(4);
        let rgb: Vec<u8> = rgb.flat_map(|p| [p[0], p[1], p[2]]).collect();
        assert!(made.bytes == rgb, "{link}");
    }
}

#[test]
fn slices_give_the_same_picture() {
    let mut studio = finished("size=160&outline=annulus&cs=14&moss=0.5");
    let whole = made(&mut studio, 2, &[]);
    assert!(whole.begun && whole.done && whole.progress == 1.0);
    let whole = &whole.rows[0];
    assert_eq!((whole.side, whole.bytes.len()), (320, 3 * 320 * 320));
    let (mut rows, mut progress, mut slices) = (Vec::new(), 0.0, 0);
    loop {
        let slice = slice(&mut studio, 2).unwrap();
        assert_eq!(slice.begun, slices == 0);
        assert!(
            slice.progress >= progress,
            "{progress} then {}",
            slice.progress
        );
        (progress, slices) = (slice.progress, slices + 1);
        rows.extend(slice.rows.into_iter().flat_map(|map| map.bytes));
        if slice.done {
            break;
        }
    }
    assert!(slices > 100 && progress == 1.0);
    assert!(rows == whole.bytes);
}

#[test]
fn another_picture_begins_anew() {
    let mut studio = finished("size=160&outline=annulus&cs=14");
    assert!(slice(&mut studio, 2).unwrap().begun);
    assert!(!slice(&mut studio, 2).unwrap().begun);
    assert!(slice(&mut studio, 3).unwrap().begun);
    assert!(made(&mut studio, 3, &[MapKind::Id]).begun);
    assert!(slice(&mut studio, 3).unwrap().begun);
    studio.maps().unwrap().stop_picture();
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
    for (link, most) in [("size=1088&cs=60", 7), ("size=128&cs=20", 8)] {
        let mut studio = finished(link);
        let picture = studio.picture().map(<[u8]>::to_vec);
        for scale in [0, most + 1, 12, usize::MAX / 4096] {
            let said = slice(&mut studio, scale).unwrap_err().to_string();
            let most = format!("1 to {most} times its side");
            assert!(said.contains(&most), "{said}");
        }
        assert_eq!(studio.picture().map(<[u8]>::to_vec), picture);
    }
}

#[test]
fn its_maps_are_those_of_the_picture() {
    let kinds = MapKind::ALL.map(|(kind, _)| kind);
    for link in ["size=160&tile=1&cs=14", "size=160&cs=14&moss=0.5&wear=0.5"] {
        let mut studio = finished(link);
        let own = kinds.map(|kind| studio.maps().unwrap().map(kind).unwrap());
        assert!(made(&mut studio, 1, &kinds).rows == own, "{link}");
        let bigger = made(&mut studio, 2, &kinds);
        assert!(bigger.heights.1 > bigger.heights.0);
        for ((map, own), (_, word)) in bigger.rows.iter().zip(&own).zip(MapKind::ALL) {
            assert_eq!(
                (map.side, map.bytes.len()),
                (320, 4 * own.bytes.len()),
                "{word}"
            );
            // The high byte of 16 bit values.
            let step = usize::from(map.bits / 8);
            let mean = |bytes: &[u8]| {
                let values = bytes.iter().step_by(step).map(|&v| f64::from(v));
                values.sum::<f64>() / (bytes.len() / step) as f64
            };
            let (big, small) = (mean(&map.bytes), mean(&own.bytes));
            assert!((big - small).abs() < 4.0, "{word}: {big}, {small}");
        }
    }
}
