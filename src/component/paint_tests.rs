use super::*;

#[test]
fn words_lead_to_finishes() {
    for (k, finish) in FINISHES.iter().enumerate() {
        assert_eq!(Finish::of_word(finish.word), Some(finish));
        assert!(!finish.label.is_empty() && !finish.bases.is_empty());
        assert!(FINISHES[..k].iter().all(|f| f.label != finish.label));
    }
    assert_eq!(Finish::of_word("brick"), None);
    let words = ComponentKind::ALL.map(|kind| kind.finish().word);
    assert!(words.contains(&"bean") && words.contains(&"leaf"));
}

#[test]
fn parts_keep_their_colours_on_variants() {
    let leaf = ComponentKind::Leaf.finish();
    for id in 1..40 {
        let vein = leaf.variant_colour(&Mark::of(Part::Vein), id);
        assert_eq!(vein, leaf.variant_colour(&Mark::of(Part::Vein), 0));
        let tint = leaf.tint(1, id, 1.0).map(f32::from);
        let wanted = leaf.part(Part::Vein).unwrap().map(f32::from);
        for k in 0..3 {
            let found = f32::from(vein[k]) * tint[k] / 255.0;
            assert!((found / wanted[k] - 1.0).abs() < 0.2, "{id}: {found}");
        }
    }
    let [first, last] = [0, 7].map(|number| leaf.variant_colour(&Mark::BODY, number));
    assert_ne!(first, last);
    assert_eq!(first, leaf.variant_colour(&Mark::BODY, 8));
}

#[test]
fn marks_mix_the_colours_of_parts_and_shade_them() {
    let bean = ComponentKind::Bean.finish();
    let of = |mark: Mark| bean.variant_colour(&mark, 0);
    let scar = Mark::of(Part::Vein);
    let [body, half, whole] = [Mark::BODY, scar.shared(0.5), scar].map(of);
    assert!(body[1] < half[1] && half[1] < whole[1]);
    let [dark, light] = [-1.0, 1.0].map(|v| of(Mark::BODY.shaded(v)));
    assert!(dark[0] < body[0] && body[0] < light[0]);
}

#[test]
fn tints_differ_as_much_as_is_asked_for() {
    let pebble = ComponentKind::Pebble.finish();
    let spread = |vary: f64| {
        let reds = (1..80).map(|id| pebble.tint(1, id, vary)[0]);
        let (low, high) = reds.fold((255, 0), |(low, high), red| (red.min(low), red.max(high)));
        high - low
    };
    assert_eq!(spread(0.0), 0);
    assert!(spread(0.5) > 5 && spread(1.0) > spread(0.5));
    assert_ne!(pebble.tint(1, 1, 1.0), pebble.tint(2, 1, 1.0));
}

#[test]
fn each_kind_is_painted_with_the_parts_that_it_has() {
    let material = ComponentKind::Chestnut.finish();
    assert_ne!(material.material(Part::Body), material.material(Part::Cap));
    for (kind, part) in [
        (ComponentKind::Ball, Part::Cap),
        (ComponentKind::Leaf, Part::Stalk),
        (ComponentKind::Apple, Part::Stalk),
        (ComponentKind::Pebble, Part::Vein),
        (ComponentKind::Rice, Part::Tip),
    ] {
        assert!(kind.finish().part(part).is_some(), "{kind:?}");
    }
}
