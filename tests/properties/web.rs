//! The interface to JavaScript, under Node.

use bubblestone::web::{Bubblestone, digest_of_link, generators, presets, random_seed, schema};
use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const LINK: &str = "size=160&outline=star&cs=14";

fn property(object: &JsValue, key: &str) -> JsValue {
    Reflect::get(object, &key.into()).unwrap()
}

fn number(object: &JsValue, key: &str) -> f64 {
    property(object, key).as_f64().unwrap()
}

/// The code of a notice, whose sentence ends with a full stop.
fn code(notice: &JsValue) -> String {
    let text = property(notice, "text").as_string().unwrap();
    assert!(text.ends_with('.'), "{text}");
    property(notice, "code").as_string().unwrap()
}

/// Whether a value was refused, and the codes of the notices.
fn answer(answer: &JsValue) -> (bool, String) {
    let notices: Array = property(answer, "notices").unchecked_into();
    let codes: Vec<String> = notices.iter().map(|notice| code(&notice)).collect();
    (property(answer, "refused").is_truthy(), codes.join(" "))
}

fn run(page: &mut Bubblestone) {
    while !["done", "error"].contains(&page.stage().as_str()) {
        page.tick(8.0, 4);
    }
}

#[wasm_bindgen_test]
fn a_link_becomes_planes() {
    let mut page = Bubblestone::new(LINK);
    assert_eq!(page.notices().length(), 0);
    assert_eq!(
        (page.stage().as_str(), page.digest().as_str()),
        ("domain", "")
    );
    run(&mut page);
    assert_eq!(page.stage(), "done");
    assert_eq!(page.problem(), JsValue::UNDEFINED);
    assert_eq!(page.digest(), digest_of_link(LINK));
    assert_eq!(page.side(), 160);
    let again = digest_of_link(&format!("https://example.org/#{}", page.link()));
    assert_eq!(page.digest(), again);
}

#[wasm_bindgen_test]
fn the_status_has_its_figures() {
    let mut page = Bubblestone::new(LINK);
    run(&mut page);
    let status = page.status();
    for key in ["cells", "steps", "largestMove", "stones"] {
        assert!(number(&status, key) > 0.0, "{key}");
    }
    for key in ["energy", "added", "removed"] {
        assert!(number(&status, key).is_finite(), "{key}");
    }
    assert_eq!(property(&status, "converged"), JsValue::TRUE);
    let ms = property(&status, "ms");
    let stages = Object::keys(ms.unchecked_ref::<Object>());
    assert_eq!(stages.length(), 8);
    assert!(
        stages
            .iter()
            .all(|s| number(&ms, &s.as_string().unwrap()) >= 0.0)
    );
}

#[wasm_bindgen_test]
fn parameters_are_set_by_text() {
    let mut page = Bubblestone::new(LINK);
    let set = |page: &mut Bubblestone, key, text| {
        let (refused, codes) = answer(&page.set(key, text));
        (refused, codes, page.get("cs"))
    };
    let is = |refused, code: &str, cs: &str| (refused, code.to_owned(), cs.to_owned());
    assert_eq!(set(&mut page, "cs", "20"), is(false, "", "20"));
    assert_eq!(set(&mut page, "cs", "1e9"), is(false, "must_be", "80"));
    assert_eq!(set(&mut page, "cs", "many"), is(true, "must_be", "80"));
    assert_eq!(
        set(&mut page, "nonsense", "1"),
        is(true, "not_a_parameter", "80")
    );
    assert_eq!(page.open("cs=12&nonsense=1").length(), 1);
    assert_eq!(
        (page.get("cs").as_str(), page.notices().length()),
        ("12", 1)
    );
    // Arguments are separate from the words.
    let notice = page.open("stone=brick").get(0);
    let args = property(&notice, "args");
    assert_eq!(
        property(&property(&args, "what"), "key"),
        JsValue::from("stone")
    );
    assert_eq!(property(&args, "given"), JsValue::from("\"brick\""));
    let allowed: Array = property(&args, "allowed").unchecked_into();
    assert_eq!(property(&allowed.get(1), "word"), JsValue::from("flag"));
}

#[wasm_bindgen_test]
fn pausing_stepping_and_starting_again() {
    let mut page = Bubblestone::new(LINK);
    let steps = |page: &mut Bubblestone| number(&page.status(), "steps");
    page.step();
    page.step();
    assert_eq!(steps(&mut page), 2.0);
    assert!(!page.tick(50.0, 0));
    assert_eq!(steps(&mut page), 2.0);
    run(&mut page);
    let digest = page.digest();
    page.restart();
    assert_eq!(page.stage(), "packing");
    run(&mut page);
    assert_eq!(page.digest(), digest);
}

#[wasm_bindgen_test]
fn outlines_go_in_and_out() {
    let mut page = Bubblestone::new(LINK);
    let points = [20., 20., 140., 24., 136., 130., 18., 140.];
    assert_eq!(
        answer(&page.set_outline(&points, &[4])),
        (false, String::new())
    );
    assert_eq!(page.get("outline"), "polygon");
    let outline = page.outline();
    let back: Float64Array = property(&outline, "points").unchecked_into();
    let near = |(a, b): (f64, &f64)| (a - b).abs() < 0.01;
    assert!(back.to_vec().into_iter().zip(&points).all(near));
    let rings: Uint32Array = property(&outline, "rings").unchecked_into();
    assert_eq!(rings.to_vec(), [4]);
    let link = page.link();
    for (points, rings) in [
        (vec![1., 2., 3.], vec![2]),
        (vec![1., 2., f64::NAN, 4., 9., 9.], vec![3]),
        (vec![10., 10., 100., 100., 100., 10., 10., 100.], vec![4]),
        (vec![], vec![]),
        (vec![1., 2.], vec![u32::MAX, 2]),
        // Copying the remaining points for each of these rings would not fit into memory.
        (vec![10.; 400_000], vec![2; 100_000]),
    ] {
        assert!(answer(&page.set_outline(&points, &rings)).0);
        assert_eq!(page.link(), link);
    }
}

#[wasm_bindgen_test]
fn lists_and_parts_are_asked_for() {
    let mut page = Bubblestone::new("size=160&cs=14&outline=square&lines=0,0.5,1,0.5");
    run(&mut page);
    let lines = page.list("lines");
    let numbers: Float64Array = property(&lines, "numbers").unchecked_into();
    assert_eq!(numbers.to_vec(), [0.0, 0.5, 1.0, 0.5]);
    let rows: Uint32Array = property(&lines, "rows").unchecked_into();
    assert_eq!(rows.to_vec(), [4]);
    let none: Uint32Array = property(&page.list("nothing"), "rows").unchecked_into();
    assert_eq!(none.length(), 0);
    let (above, below) = (page.part(80.0, 50.0), page.part(80.0, 110.0));
    assert!(above >= 0 && below >= 0 && above != below);
    assert_eq!((page.part(1.0, 1.0), page.part(f64::NAN, 0.0)), (-1, -1));
}

#[wasm_bindgen_test]
fn maps_come_as_bytes() {
    let mut page = Bubblestone::new(LINK);
    assert_eq!(code(&page.map("height")), "not_yet");
    run(&mut page);
    let map = page.map("height");
    assert_eq!((number(&map, "side"), number(&map, "bits")), (160.0, 16.0));
    let bytes: Uint8Array = property(&map, "bytes").unchecked_into();
    assert_eq!(bytes.length(), 2 * 160 * 160);
    for none in [
        page.map("nothing"),
        page.mesh_file("", "low", &[], 1.0),
        page.mesh_file("glb", "lowest", &[], 1.0),
    ] {
        assert_eq!(code(&none), "no_such_file");
    }
    assert_eq!(page.mesh_size("obj", "low", &[]).len(), 2);
    assert_eq!(page.mesh_size("stl", "low", &[]).len(), 0);
    assert!(page.report().contains("\"height_range\""));
}

/// The module of a first visit tells the sizes of meshes, but writes none.
#[cfg(not(feature = "house"))]
#[wasm_bindgen_test]
fn a_first_visit_has_no_mesh_files() {
    let mut page = Bubblestone::new(LINK);
    run(&mut page);
    assert_eq!(
        code(&page.mesh_file("glb", "low", &[], 1.0)),
        "no_such_file"
    );
    assert_eq!(page.svg(), "");
}

#[cfg(feature = "house")]
#[wasm_bindgen_test]
fn meshes_come_as_bytes() {
    let mut page = Bubblestone::new(LINK);
    assert_eq!(code(&page.mesh_file("glb", "low", &[], 1e9)), "not_yet");
    run(&mut page);
    for ending in ["glb", "obj"] {
        let mut parts = Vec::new();
        let mut done = false;
        while !done {
            let slice = page.mesh_file(ending, "middle", &[], 1.0);
            assert_eq!(property(&slice, "begun").is_truthy(), parts.is_empty());
            parts.push(JsValue::NULL);
            parts.extend(property(&slice, "parts").unchecked_into::<Array>().iter());
            done = property(&slice, "done").is_truthy();
        }
        parts.retain(|part| !part.is_null());
        let length = |part: &JsValue| part.unchecked_ref::<Uint8Array>().length();
        assert!(parts.iter().map(length).sum::<u32>() > 100_000, "{ending}");
    }
}

#[wasm_bindgen_test]
fn tables_are_plain_objects() {
    let first = generators().get(0);
    assert_eq!(
        property(&first, "word").as_string().as_deref(),
        Some("pavement")
    );
    assert_eq!(schema("castle").length() + presets("castle").length(), 0);
    let schema: Array = schema("pavement");
    assert!(schema.length() > 30);
    for row in schema.iter() {
        for key in ["key", "name", "kind", "help", "group"] {
            assert!(property(&row, key).as_string().is_some(), "{key}");
        }
        assert!(number(&row, "min") <= number(&row, "max"));
    }
    for row in presets("pavement").iter() {
        let link = property(&row, "link").as_string().unwrap();
        assert_eq!(Bubblestone::new(&link).notices().length(), 0, "{link}");
    }
}

#[wasm_bindgen_test]
fn dice_fall_otherwise_each_time() {
    let throws: Vec<u32> = (0..4).map(|_| random_seed()).collect();
    assert!(throws.iter().any(|&t| t != throws[0]));
}

#[wasm_bindgen_test]
fn a_bigger_picture_comes_in_rows() {
    let mut page = Bubblestone::new(LINK);
    assert_eq!(code(&page.picture_file(2, "", 1e9)), "not_yet");
    run(&mut page);
    assert_eq!(code(&page.picture_file(9, "", 1e9)), "bad_scale");
    assert_eq!(
        code(&page.picture_file(2, "ao nothing", 1e9)),
        "no_such_file"
    );
    for (words, bytes) in [("", vec![3]), ("ao height id", vec![1, 2, 3])] {
        let (mut sums, mut slices) = (vec![0; bytes.len()], 0);
        loop {
            let slice = page.picture_file(2, words, 4.0);
            assert_eq!(property(&slice, "begun"), JsValue::from(slices == 0));
            for (map, sum) in Array::from(&property(&slice, "maps")).iter().zip(&mut sums) {
                assert_eq!(number(&map, "side"), 320.0);
                *sum += number(&property(&map, "bytes"), "length") as usize;
            }
            slices += 1;
            if property(&slice, "done") == JsValue::TRUE {
                break;
            }
        }
        let pixels = bytes.iter().map(|n| n * 320 * 320);
        assert_eq!(sums, pixels.collect::<Vec<usize>>(), "{words}");
    }
    page.stop_file();
}
