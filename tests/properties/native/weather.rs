//! Wear, dirt, moss and wet: their places and their effects.

use crate::paving::OfPavement;
use bubblestone::heightfield::{GROUND, Planes};
use bubblestone::material::{Gloss, material_table};
use bubblestone::studio::Studio;
use glam::DVec2;

const SIDE: usize = 256;
const BASE: &str = "size=256&outline=road_straight&ow=1.6&cs=20";

fn finished(more: &str) -> Studio {
    crate::common::finished(&format!("{BASE}{more}"))
}

fn planes(more: &str) -> Planes {
    finished(more).pavement().planes.expect("planes").clone()
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(s, n), v| (s + v, n + 1.0));
    sum / f64::max(count, 1.0)
}

fn height(planes: &Planes, is: impl Fn(usize) -> bool) -> f64 {
    let those = (0..SIDE * SIDE).filter(|&i| is(i));
    mean(those.map(|i| f64::from(planes.bump[i])))
}

fn light(planes: &Planes, is: impl Fn(usize) -> bool) -> f64 {
    let those = (0..SIDE * SIDE).filter(|&i| is(i));
    mean(those.map(|i| planes.colour[i].iter().map(|&v| f64::from(v)).sum::<f64>()))
}

#[test]
fn fair_weather_changes_nothing_and_any_other_something() {
    let plain = finished("").digest();
    assert_eq!(finished("&wear=0&moss=0&dirt=0&wet=0").digest(), plain);
    for key in ["wear", "moss", "dirt", "wet"] {
        assert_ne!(finished(&format!("&{key}=0.5")).digest(), plain, "{key}");
    }
}

#[test]
fn moss_and_dirt_lie_low() {
    let plain = planes("");
    let paved = |i: usize| plain.occlusion[i] < 250 || plain.id[i] != GROUND;
    for more in ["&moss=0.4", "&dirt=0.6"] {
        let grown = planes(more);
        let covered = |i: usize| paved(i) && grown.material[i] != plain.material[i];
        let many = (0..SIDE * SIDE).filter(|&i| covered(i)).count();
        assert!(many > SIDE * SIDE / 50, "{more}: {many}");
        let low = height(&plain, covered);
        let all = height(&plain, paved);
        assert!(low < all - 1.0, "{more}: {low}, {all} on average");
        // The cover has a thickness of its own.
        assert!(height(&grown, covered) > low, "{more}");
    }
}

#[test]
fn more_moss_covers_more() {
    let covered = |more: &str| {
        let [plain, grown] = ["", more].map(planes);
        (0..SIDE * SIDE)
            .filter(|&i| plain.material[i] != grown.material[i])
            .count()
    };
    let (few, some, most) = (
        covered("&moss=0.2"),
        covered("&moss=0.5"),
        covered("&moss=1"),
    );
    assert!(
        0 < few && 2 * few < some && some < most,
        "{few} {some} {most}"
    );
    assert!(most > SIDE * SIDE * 2 / 3, "{most}");
}

#[test]
fn wear_lowers_and_smooths_the_middle_of_the_way_and_spares_its_rim() {
    let studio = finished("&wear=1");
    let (worn, plain) = (studio.pavement().planes.expect("planes"), planes(""));
    let domain = studio.pavement().domain.expect("a domain");
    let farthest = studio
        .pavement()
        .cells
        .iter()
        .map(|c| domain.nearest(c.centre).distance)
        .fold(0.0, f64::max);
    let away = |i: usize| {
        let p = DVec2::new((i % SIDE) as f64, (i / SIDE) as f64);
        domain.nearest(p).distance
    };
    let top = plain.bump.iter().copied().fold(0.0, f32::max);
    let high = |i: usize| plain.id[i] != GROUND && plain.bump[i] > 0.7 * top;
    let middle = |i: usize| high(i) && away(i) > 0.7 * farthest;
    let rim = |i: usize| high(i) && away(i) < 0.15 * farthest;
    let loss = |is: &dyn Fn(usize) -> bool| height(&plain, is) - height(worn, is);
    assert!(loss(&middle) > 1.0, "{}", loss(&middle));
    assert!(loss(&rim) < 0.2 * loss(&middle), "{}", loss(&rim));
    let rough = |planes: &Planes| {
        let those = (1..SIDE * SIDE - 1).filter(|&i| (i - 1..=i + 1).all(middle));
        let bump = &planes.bump;
        mean(those.map(|i| f64::from((bump[i + 1] - 2.0 * bump[i] + bump[i - 1]).abs())))
    };
    assert!(
        rough(worn) < 0.6 * rough(&plain),
        "{} {}",
        rough(worn),
        rough(&plain)
    );
}

#[test]
fn wet_darkens_shines_and_stands_level() {
    let [plain, damp, wet] = ["", "&wet=0.4", "&wet=1"].map(planes);
    let stone = |i: usize| plain.id[i] != GROUND && wet.bump[i] == plain.bump[i];
    let (dry, some, most) = (
        light(&plain, stone),
        light(&damp, stone),
        light(&wet, stone),
    );
    assert!(
        most < some && some < 0.95 * dry && most < 0.8 * dry,
        "{dry} {some} {most}"
    );
    // Water among the stones has one level.
    let water = (material_table("granite", "sand", Gloss::Own).len() - 1) as u8;
    let pools: Vec<usize> = (0..SIDE * SIDE)
        .filter(|&i| wet.material[i] == water && wet.bump[i] > plain.bump[i])
        .collect();
    assert!(pools.len() > 500, "{}", pools.len());
    let inner = pools.iter().map(|&i| wet.bump[i]).fold(f32::MIN, f32::max);
    let level = pools.iter().filter(|&&i| wet.bump[i] == inner).count();
    assert!(level * 2 > pools.len(), "{level} of {}", pools.len());
}

#[test]
fn gloss_changes_the_light_and_not_the_planes() {
    let own = finished("");
    let mut shine = Vec::new();
    for word in ["matt", "glossy", "wet"] {
        let other = finished(&format!("&gloss={word}"));
        assert_eq!(own.digest(), other.digest());
        assert_ne!(own.picture(), other.picture(), "{word}");
        let table = material_table("granite", "sand", Gloss::of_word(word));
        assert_eq!(table[0], material_table("granite", "sand", Gloss::Own)[0]);
        shine.push(table[1].specular);
    }
    assert!(shine.is_sorted() && shine[0] < shine[2]);
}

/// Pixels on both sides of a tile's edges differ as little as those inside it.
#[test]
fn weather_on_tiles_has_no_seam() {
    let studio = finished("&tile=1&wear=0.8&moss=0.5&dirt=0.5&wet=0.6");
    let planes = studio.pavement().planes.expect("planes");
    let step = |x: usize| {
        let next = (x + 1) % SIDE;
        mean((0..SIDE).map(|y| {
            let light = |x: usize| {
                let colour = planes.colour[y * SIDE + x];
                colour.iter().map(|&v| f64::from(v)).sum::<f64>()
            };
            (light(x) - light(next)).abs()
        }))
    };
    let inside = (0..SIDE - 1).map(step).fold(0.0, f64::max);
    assert!(step(SIDE - 1) <= inside);
}
