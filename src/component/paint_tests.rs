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
fn a_shared_mesh_under_a_tint_has_the_colour_of_the_body() {
    for finish in FINISHES {
        for id in 1..40 {
            let base = finish.base(1, id);
            let tint = finish.tint(1, id);
            let mesh = finish.shared_colour(&Mark::BODY);
            let wanted = finish.colour(&Mark::BODY, base);
            for k in 0..3 {
                let found = f32::from(mesh[k]) * f32::from(tint[k]) / 255.0;
                let off = (found - f32::from(wanted[k])).abs();
                assert!(off < 1.6, "{} {id}: {off}", finish.word);
            }
        }
    }
}

#[test]
fn parts_keep_their_colours_on_variants() {
    let leaf = ComponentKind::Leaf.finish();
    for id in 1..40 {
        let vein = leaf.variant_colour(&Mark::of(Part::Vein), id);
        assert_eq!(vein, leaf.variant_colour(&Mark::of(Part::Vein), 0));
        let tint = leaf.mild_tint(1, id).map(f32::from);
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
    let base = bean.base(1, 1);
    let scar = Mark::of(Part::Vein);
    assert_eq!(Some(bean.colour(&scar, base)), bean.part(Part::Vein));
    let half = bean.colour(&scar.shared(0.5), base);
    let body = bean.colour(&Mark::BODY, base);
    assert!(body[1] < half[1] && half[1] < bean.colour(&scar, base)[1]);
    let [dark, light] = [-1.0, 1.0].map(|v| bean.colour(&Mark::BODY.shaded(v), base));
    assert!(dark[0] < body[0] && body[0] < light[0]);
    assert_ne!(bean.base(1, 1), bean.base(1, 2));
    assert_ne!(bean.base(1, 1), bean.base(2, 1));
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
