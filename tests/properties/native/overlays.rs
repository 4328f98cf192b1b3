//! The overlays of a picture, checked by its pixels.

use super::views::{SIDE, differing, finished};
use bubblestone::generators::ALL;
use bubblestone::generators::pavement::{self, Overlay};
use bubblestone::studio::Studio;

/// A pavement in which every overlay has something to show.
const FULL: &str = "outline=square&kind=ellipse&dir=circular&gx=0.4&stretch=0.5,0.5,0.3,4";

#[test]
fn overlays_lie_over_the_picture_and_over_each_other() {
    let mut studio = finished(FULL);
    let mut seen = |words: String| studio.engine_mut().view(&words).to_vec();
    let picture = seen("picture".into());
    for (k, (_, a)) in Overlay::ALL.iter().enumerate() {
        let over = seen(format!("picture+{a}"));
        assert!(differing(&picture, &over) > 60, "{a}");
        assert!(over.chunks(4).all(|p| p[3] == 255), "{a}");
        assert!(
            differing(&over, &seen((*a).into())) > SIDE * SIDE / 8,
            "{a}"
        );
        for (_, b) in &Overlay::ALL[..k] {
            let both = seen(format!("picture+{a}+{b}"));
            assert!(differing(&both, &over) > 40, "{b} under {a}");
            let other = seen(format!("picture+{b}"));
            assert!(differing(&both, &other) > 40, "{a} over {b}");
            assert!(both == seen(format!("{b}+picture+{a}")), "{a} {b}");
        }
    }
    assert!(picture == seen("picture".into()));
}

#[test]
fn heat_waits_for_the_fields_of_a_new_outline() {
    let mut studio = finished(FULL);
    let before = studio.engine_mut().view("picture+size").to_vec();
    let star = FULL.replace("square", "star");
    let (star, _) = pavement::recipe(&format!("size={SIDE}&cs=14&{star}"));
    studio.set_recipe(star);
    while studio.stage() != "fields" {
        studio.tick(&mut || 0.0, 0.0, 1);
    }
    assert!(studio.engine_mut().view("picture+size") == before);
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    assert!(studio.engine_mut().view("picture+size") != before);
}

#[test]
fn overlays_let_the_picture_through() {
    let mut studio = finished(FULL);
    let picture = studio.engine_mut().view("picture").to_vec();
    // A fill keeps light pixels light and dark pixels dark.
    for word in ["size", "energy"] {
        let over = studio.engine_mut().view(&format!("picture+{word}"));
        let grey = |rgba: &[u8]| -> Vec<f64> {
            let pixels = rgba.chunks(4);
            pixels
                .map(|p| p[..3].iter().map(|&c| f64::from(c)).sum())
                .collect()
        };
        let (below, above) = (grey(&picture), grey(over));
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let (m, n) = (mean(&below), mean(&above));
        let of = |a: &[f64], p: f64, b: &[f64], q: f64| {
            a.iter().zip(b).map(|(a, b)| (a - p) * (b - q)).sum::<f64>()
        };
        let alike =
            of(&below, m, &above, n) / (of(&below, m, &below, m) * of(&above, n, &above, n)).sqrt();
        assert!(alike > 0.4, "{word}: {alike}");
    }
}

/// The contrast of two pixels, 1 to 21, from their luminances (as for text in WCAG).
fn contrast(a: &[u8], b: &[u8]) -> f64 {
    let linear = |c: u8| libm::pow((f64::from(c) / 255.0 + 0.055) / 1.055, 2.4);
    let light =
        |p: &[u8]| 0.05 + 0.2126 * linear(p[0]) + 0.7152 * linear(p[1]) + 0.0722 * linear(p[2]);
    let (a, b) = (light(a), light(b));
    a.max(b) / a.min(b)
}

#[test]
fn fields_stand_out_from_pale_stones_and_from_dark_ones() {
    for palette in ["limestone", "marble", "granite", "basalt"] {
        for word in ["direction", "anisotropy"] {
            let link = format!("kind=ellipse&outline=square&palette={palette}");
            let mut studio = finished(&link);
            let picture = studio.engine_mut().view("picture").to_vec();
            let over = studio.engine_mut().view(&format!("picture+{word}"));
            let pairs = picture.chunks(4).zip(over.chunks(4));
            let drawn: Vec<f64> = pairs
                .filter(|(a, b)| a != b)
                .map(|(a, b)| contrast(a, b))
                .collect();
            let clear = drawn.iter().filter(|&&ratio| ratio > 2.0).count();
            let share = clear as f64 / drawn.len() as f64;
            assert!(share > 0.36, "{word} on {palette}: {share}");
        }
    }
}

#[test]
fn overlays_show_only_what_is_there() {
    let (recipe, _) = pavement::recipe(&format!("size={SIDE}&cs=14&outline=star"));
    let mut studio = Studio::new(ALL, recipe);
    for _ in 0..3 {
        studio.step(&mut || 0.0);
    }
    let mut seen = |words: &str| studio.engine_mut().view(words).to_vec();
    let plain = seen("auto");
    assert!(plain == seen("auto+mesh+cells"));
    for word in ["forces", "energy", "direction", "size", "packed"] {
        assert!(plain != seen(&format!("auto+{word}")), "{word}");
    }
}
