//! Pictures and views are compared with those in `golden/pictures`. The digests fix the planes to the bit;
//! these tests fix the visible result.
//!
//! After an intended change of pictures, `BUBBLESTONE_UPDATE=1 cargo test --test pictures` writes them again.
//! Look at them before you commit them.

// Files are available natively only.
#![cfg(not(target_arch = "wasm32"))]

use bubblestone::generators::ALL;
use bubblestone::generators::pavement;
use bubblestone::generators::pavement::Base;
use bubblestone::studio::Studio;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// The most by which a channel of a pixel may differ before the pixel counts as changed.
const SAME: u8 = 10;
/// The most changed pixels, in thousandths. A stone that moves by a pixel changes more.
const OTHERS_PER_MILLE: usize = 4;

fn studio(link: &str) -> Studio {
    let (recipe, notices) = pavement::recipe(link);
    assert!(notices.is_empty(), "{notices:?}");
    let mut studio = Studio::new(ALL, recipe);
    assert_eq!(studio.finish(&mut || 0.0), Ok(()));
    studio
}

fn golden(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/pictures");
    folder.join(format!("{name}.png"))
}

fn write(path: &Path, side: usize, rgb: &[u8]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let mut encoder = png::Encoder::new(File::create(path).unwrap(), side as u32, side as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(rgb).unwrap();
}

fn read(path: &Path) -> Option<Vec<u8>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?))
        .read_info()
        .ok()?;
    let mut bytes = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut bytes).ok()?;
    bytes.truncate(info.buffer_size());
    Some(bytes)
}

/// Compares an RGBA picture with the golden one of this name. If they differ, the picture and the difference
/// (black where equal) are written side by side for inspection.
fn check(name: &str, rgba: &[u8]) {
    let found: Vec<u8> = rgba.chunks(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    let side = (rgba.len() / 4).isqrt();
    if std::env::var_os("BUBBLESTONE_UPDATE").is_some() {
        return write(&golden(name), side, &found);
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pictures");
    let actual = folder.join(format!("{name}.actual.png"));
    let wanted = read(&golden(name)).filter(|wanted| wanted.len() == found.len());
    let Some(wanted) = wanted else {
        write(&actual, side, &found);
        panic!(
            "{name}: no golden picture of this size; see {}",
            actual.display()
        );
    };
    let apart: Vec<u8> = found
        .iter()
        .zip(&wanted)
        .map(|(a, b)| a.abs_diff(*b))
        .collect();
    let others = apart
        .chunks(3)
        .filter(|p| p.iter().any(|&d| d > SAME))
        .count();
    if others * 1000 > OTHERS_PER_MILLE * side * side {
        let diff = folder.join(format!("{name}.diff.png"));
        write(&actual, side, &found);
        write(
            &diff,
            side,
            &apart
                .iter()
                .map(|d| d.saturating_mul(4))
                .collect::<Vec<u8>>(),
        );
        panic!(
            "{name}: {others} pixels differ; see {} and {}",
            actual.display(),
            diff.display()
        );
    }
}

#[test]
fn pavements_look_as_they_did() {
    for (name, link) in [
        ("ring", "size=128&cs=14&hs=11"),
        (
            "star",
            "size=128&outline=star&ow=1.5&on=6&cs=13&stone=flag&sv=0.96&hs=7&palette=terracotta&ground=mortar&el=50",
        ),
        (
            "lantern",
            "size=128&outline=y_fork&ow=1.4&cs=13&hs=12&palette=basalt&ground=dark&light=point&lx=0.5&ly=0.42&lz=0.2&diff=1.3",
        ),
        (
            "moss",
            "size=128&outline=road_s&ow=1.4&on=1&cs=12&vs=0.2&hs=9&cells=packed&palette=mossy&ground=moss",
        ),
    ] {
        check(name, studio(link).picture().unwrap());
    }
}

#[test]
fn views_look_as_they_did() {
    let mut studio = studio("size=128&outline=plaza&on=1&cs=14&gx=0.4&hs=10&palette=marble");
    for (base, word) in Base::ALL {
        if base != Base::Auto {
            check(&format!("view-{word}"), studio.engine_mut().view(word));
        }
    }
}
