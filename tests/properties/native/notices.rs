//! Notices that only a native program can get. The WebAssembly module takes no lines beside rings and no camera
//! to correct, and its tests have no time for too many triangles or cells. `node/shipped.test.mjs` makes the
//! module give all other notices, and reads from this file which ones it can leave out.

use super::lines::outline;
use bubblestone::generators::pavement::{self, PavementRecipe};
use bubblestone::modelfiles::Reading;
use bubblestone::notice::{Arg, Code, Notice};
use bubblestone::scene::Camera;
use bubblestone::surface_field::fit::check_count;
use bubblestone::trimesh::TriMesh;
use bubblestone::trimesh::refine::Refining;
use glam::{DVec2, DVec3};

fn codes(notices: &[Notice]) -> Vec<Code> {
    notices.iter().map(|notice| notice.code).collect()
}

#[test]
fn a_camera_is_mended() {
    let read = |text| codes(&Camera::default().read(text).1);
    assert_eq!(read("20,none"), [Code::CameraNumber]);
    assert_eq!(read("0,0,1,30,0,0,0,0"), [Code::CameraNumbers]);
}

#[test]
fn lines_beside_rings_are_refused() {
    let refused = |lines| {
        let mut recipe = pavement::recipe("").0;
        recipe.set_polygon(&outline(lines)).unwrap_err()
    };
    let short = refused(vec![vec![DVec2::splat(150.0); 2]]);
    assert_eq!(short.code, Code::LineShort);
    let [(_, Arg::Part(line))] = &short.args[..] else {
        panic!("{short}");
    };
    assert_eq!(line.code, Code::Line);
    let line = |count: usize, y: f64| -> Vec<DVec2> {
        let x = |k: usize| 110.0 + 0.1 * k as f64;
        (0..count).map(|k| DVec2::new(x(k), y)).collect()
    };
    assert_eq!(refused(vec![line(513, 130.0)]).code, Code::LinePoints);
    let many = (0..65).map(|k| line(2, 110.0 + f64::from(k)));
    assert_eq!(refused(many.collect()).code, Code::LinesRefused);
}

#[test]
fn too_much_for_a_machine_is_refused() {
    assert_eq!(check_count(1e6).unwrap_err().code, Code::SurfaceCells);
    let corners = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let triangle = TriMesh::new(corners, vec![[0, 1, 2]]).expect("a mesh");
    let refined = Refining::evenly(triangle, 1e-6).finish_all();
    assert_eq!(
        refined.err().map(|why| why.code),
        Some(Code::RefinedTooMany)
    );
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    text += &"f 1 2 3\n".repeat(2_000_001);
    let read = Reading::read("a.obj", text.into_bytes());
    assert_eq!(read.err().map(|why| why.code), Some(Code::ModelTooLarge));
}
