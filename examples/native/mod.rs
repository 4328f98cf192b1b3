//! Functions that the native programs share: clock, files, messages.
#![allow(dead_code)] // Each program uses a part of it.

pub mod model;
pub mod seen;
pub mod sheet;
pub mod slant;

use bubblestone::domain::Outline;
use bubblestone::export::{
    DETAILS, Map, MapKind, MeshFormat, MeshOrder, Slab, SlabFile, exr, maps_for, metrics_json,
};
use bubblestone::generators::Viewing;
use bubblestone::notice::Notice;
use bubblestone::studio::Studio;
use serde_json::Value;
use std::path::Path;
use std::process::ExitCode;

/// A clock: milliseconds since this call.
#[allow(clippy::disallowed_methods)] // The library has no clock of its own; it gets this one.
pub fn clock() -> impl FnMut() -> f64 {
    let start = std::time::Instant::now();
    move || start.elapsed().as_secs_f64() * 1e3
}

/// A word of the command line as text.
pub fn text(word: std::ffi::OsString) -> Result<String, String> {
    word.into_string().map_err(|word| {
        let word = word.to_string_lossy();
        format!("{word} is not text in UTF-8: give the file another name.")
    })
}

/// Prints the sentence of an error and returns exit code 2.
pub fn end(result: Result<(), String>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(sentence) => {
            eprintln!("{sentence}");
            ExitCode::from(2)
        }
    }
}

/// An outline from a file.
pub struct OutlineFile {
    /// The rings as they are in the file.
    pub outline: Outline,
    /// The side of the picture that it is drawn for.
    pub size: Option<f64>,
}

impl OutlineFile {
    /// Scales the rings to a picture of another side.
    pub fn scale(&mut self, factor: f64) {
        let Outline { rings, lines } = &mut self.outline;
        for point in rings.iter_mut().chain(lines).flatten() {
            *point *= factor;
        }
    }
}

/// Reads `{"size": [512, 512], "outer": [[x, y], ...], "holes": [[[x, y], ...], ...], "rings": [...], "lines":
/// [...]}`. Only `outer` or `rings` is required, and unknown words are ignored. Whether a ring is a hole or an
/// island follows from the rings themselves.
pub fn read_outline(path: &str) -> Result<OutlineFile, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("Cannot read {path}: {e}."))?;
    let value: Value =
        serde_json::from_str(&text).map_err(|e| format!("{path} is not JSON: {e}."))?;
    outline_of(&value).map_err(|what| format!("{path}: {what}"))
}

fn outline_of(value: &Value) -> Result<OutlineFile, String> {
    let runs = |name: &str| match value.get(name) {
        None | Some(Value::Null) => Ok(Vec::new()),
        Some(Value::Array(runs)) => runs
            .iter()
            .enumerate()
            .map(|(k, run)| ring_of(run, &format!("{name}[{k}]")))
            .collect::<Result<Vec<_>, _>>(),
        Some(_) => Err(format!("\"{name}\" is not a list of lists of points.")),
    };
    let mut rings = match value.get("outer") {
        None | Some(Value::Null) => Vec::new(),
        Some(outer) => vec![ring_of(outer, "outer")?],
    };
    rings.extend(runs("holes")?);
    rings.extend(runs("rings")?);
    if rings.is_empty() {
        return Err(
            "there is no \"outer\" ring and no list of \"rings\"; an outline is \
             {\"outer\": [[x, y], ...], \"holes\": [...]} or {\"rings\": [[[x, y], ...], ...]}."
                .into(),
        );
    }
    let lines = runs("lines")?;
    let size = match value.get("size") {
        None | Some(Value::Null) => None,
        Some(size) => Some(side_of(size)?),
    };
    Ok(OutlineFile {
        outline: Outline { rings, lines },
        size,
    })
}

fn side_of(size: &Value) -> Result<f64, String> {
    let sides: Vec<Option<f64>> = match size {
        Value::Array(sides) => sides.iter().map(Value::as_f64).collect(),
        side => vec![side.as_f64()],
    };
    let side = match sides[..] {
        [Some(side)] => side,
        [Some(width), Some(height)] => width.max(height),
        _ => 0.0,
    };
    if side > 0.0 {
        Ok(side)
    } else {
        Err("\"size\" is not [width, height] in pixels.".into())
    }
}

fn ring_of(ring: &Value, name: &str) -> Result<Vec<glam::DVec2>, String> {
    let points = ring
        .as_array()
        .ok_or(format!("\"{name}\" is not a list of points [x, y]."))?;
    let read = |(k, point): (usize, &Value)| {
        let pair = point.as_array().map(|p| p.iter().map(Value::as_f64));
        match pair.map(Iterator::collect::<Vec<_>>).as_deref() {
            Some(&[Some(x), Some(y)]) => Ok(glam::DVec2::new(x, y)),
            _ => Err(format!(
                "point {k} of \"{name}\" is not two numbers [x, y] but {point}."
            )),
        }
    };
    points.iter().enumerate().map(read).collect()
}

/// Writes the files of any link: the report of a finished studio, the pictures, and the stages' data as text.
/// `frame` is the hash of a still, for the report.
pub fn write_all(
    studio: &mut Studio,
    notices: Vec<Notice>,
    frame: Option<String>,
    dir: &Path,
) -> Result<(), String> {
    make(dir)?;
    write_report(studio, notices, frame, dir)?;
    write_made(studio, dir)
}

/// Makes the folder if it does not exist.
pub fn make(dir: &Path) -> Result<(), String> {
    std::fs::create_dir_all(dir).map_err(|e| format!("Cannot make {}: {e}.", dir.display()))
}

fn write_report(
    studio: &mut Studio,
    notices: Vec<Notice>,
    frame: Option<String>,
    dir: &Path,
) -> Result<(), String> {
    let mut report = studio.report();
    (report.notices, report.frame) = (notices, frame);
    report.notices.extend(studio.engine().remarks());
    let metrics = studio.engine().products().and_then(|made| made.metrics());
    let measures = || {
        let data = studio.engine().data().into_iter();
        let mut named = data.filter(|(name, _)| *name == "measures.json");
        named.next().map(|(_, text)| text)
    };
    report.metrics = metrics.map(|made| metrics_json(&made)).or_else(measures);
    write(dir, "report.json", report.json().as_bytes())
}

/// Writes the picture, three of its maps, and the stages' data as text.
fn write_made(studio: &mut Studio, dir: &Path) -> Result<(), String> {
    for (name, text) in studio.engine().data() {
        write(dir, name, text.as_bytes())?;
    }
    let side = studio.side();
    if let Some(picture) = studio.picture() {
        write_rgb(dir, "picture.png", side, opaque(picture))?;
    }
    for kind in [MapKind::Height, MapKind::Albedo, MapKind::Id] {
        if has_planes(studio) {
            write_map(studio, kind, dir)?;
        }
    }
    Ok(())
}

/// Whether there are planes: only height fields have them.
fn has_planes(studio: &Studio) -> bool {
    studio.generator().stages.contains(&"planes")
}

/// Writes all maps.
pub fn write_maps(studio: &mut Studio, dir: &Path) -> Result<(), String> {
    for (kind, _) in MapKind::ALL {
        write_map(studio, kind, dir)?;
    }
    Ok(())
}

/// Writes the enlarged picture, and with `maps` all its maps.
pub fn write_bigger(
    studio: &mut Studio,
    scale: usize,
    maps: bool,
    dir: &Path,
) -> Result<(), String> {
    let bigger = studio.maps()?;
    let mut made = |kinds: &[MapKind]| -> Result<Vec<Map>, Notice> {
        let mut maps: Vec<Map> = Vec::new();
        loop {
            let slice = bigger.picture_file((scale, kinds), &mut || 0.0, f64::INFINITY)?;
            if slice.begun {
                maps = slice.rows;
            } else {
                let rows = maps.iter_mut().zip(slice.rows);
                rows.for_each(|(map, more)| map.bytes.extend(more.bytes));
            }
            if slice.done {
                return Ok(maps);
            }
        }
    };
    for picture in made(&[])? {
        write_png(dir, &format!("picture-{scale}x.png"), &picture)?;
    }
    if maps {
        let all = made(&MapKind::ALL.map(|(kind, _)| kind))?;
        for (map, (_, word)) in all.iter().zip(MapKind::ALL) {
            write_png(dir, &format!("{word}-{scale}x.png"), map)?;
        }
    }
    bigger.stop_picture();
    Ok(())
}

fn write_map(studio: &mut Studio, kind: MapKind, dir: &Path) -> Result<(), String> {
    write_png(
        dir,
        &format!("{}.png", kind.word()),
        &studio.maps()?.map(kind)?,
    )
}

/// Writes the maps that a program expects, under the names that it expects.
pub fn write_maps_for(studio: &mut Studio, program: &str, dir: &Path) -> Result<(), String> {
    let maps: Vec<_> = maps_for(program).collect();
    if maps.is_empty() {
        return Err("--maps-for takes blender, godot, unity or unreal.".into());
    }
    for (kind, name) in maps {
        let map = studio.maps()?.map(kind)?;
        let mask = name.contains("Mask").then(|| map.mask());
        write_png(dir, name, &mask.unwrap_or(map))?;
    }
    Ok(())
}

/// Writes a map as PNG, or as EXR if it has floats.
fn write_png(dir: &Path, name: &str, map: &Map) -> Result<(), String> {
    match map.bits {
        32 => write(dir, &name.replace(".png", ".exr"), &exr(map)),
        _ => write(dir, name, &png_of(map)?),
    }
}

fn png_of(map: &Map) -> Result<Vec<u8>, String> {
    let colour = match map.channels {
        1 => png::ColorType::Grayscale,
        4 => png::ColorType::Rgba,
        _ => png::ColorType::Rgb,
    };
    let depth = match map.bits {
        16 => png::BitDepth::Sixteen,
        _ => png::BitDepth::Eight,
    };
    encode((map.side, map.side), &map.bytes, colour, depth)
}

/// The triangles of a stone at this level of detail, one of [`DETAILS`].
pub fn detail_of(word: &str) -> Result<usize, String> {
    let found = DETAILS.iter().find(|(known, _)| *known == word);
    let found = found.ok_or("--detail takes low, middle or high.")?;
    Ok(found.1)
}

/// Writes the meshes of all cells and the ground as surface.obj and surface.glb, and also as
/// surface-textured.glb if there are images. With `joined`, a GLB file has one mesh of all bodies.
pub fn write_meshes(
    studio: &mut Studio,
    detail: usize,
    joined: bool,
    dir: &Path,
) -> Result<(), String> {
    for (format, word) in MeshFormat::ALL {
        let order = MeshOrder {
            format,
            detail,
            images: None,
            joined,
        };
        let file = mesh(studio, order)?;
        write(dir, &format!("surface.{word}"), &file)?;
    }
    if !has_planes(studio) {
        return Ok(());
    }
    let kinds = [MapKind::Albedo, MapKind::NormalOpengl, MapKind::Orm];
    let mut images = Vec::new();
    for kind in kinds {
        images.push(png_of(&studio.maps()?.map(kind)?)?);
    }
    let order = MeshOrder {
        format: MeshFormat::Glb,
        detail,
        images: Some([0, 1, 2].map(|k| images[k].len() as u32)),
        joined,
    };
    let mut file = mesh(studio, order)?;
    for image in images {
        file.extend(image);
        file.resize(file.len().next_multiple_of(4), 0);
    }
    write(dir, "surface-textured.glb", &file)
}

/// Writes the height field as slab.stl.
pub fn write_slab(studio: &Studio, slab: Slab, dir: &Path) -> Result<(), String> {
    let planes = studio.engine().products().and_then(|made| made.planes);
    let planes = planes.ok_or("--stl is for pavements only.")?;
    let mut file = SlabFile::new(slab, planes);
    let parts: Vec<_> = std::iter::from_fn(|| file.next(planes)).collect();
    write(dir, "slab.stl", &parts.concat())
}

fn mesh(studio: &mut Studio, order: MeshOrder) -> Result<Vec<u8>, String> {
    let meshes = studio.meshes()?;
    let file = meshes.mesh_file(&order, &mut || 0.0, f64::INFINITY)?;
    Ok(file.parts.concat())
}

/// Mixed views of pavements that are written in addition to the single ones, and drawings on paper, as in
/// docs/making.webp.
const MIXED: [&str; 7] = [
    "paper+packed",
    "paper+mesh",
    "paper+cells",
    "picture+cells+mesh",
    "picture+size+direction+singularities",
    "picture+energy+forces",
    "cells+anisotropy+singularities",
];

/// Writes every base, every overlay alone and over the picture, and some mixed views.
pub fn write_views(studio: &mut Studio, dir: &Path) -> Result<(), String> {
    let views = studio.generator().views;
    let mut words: Vec<String> = views.bases.iter().map(|&word| word.into()).collect();
    for &word in views.overlays {
        words.extend([word.into(), format!("picture+{word}")]);
    }
    if studio.generator().views.bases.contains(&"paper") {
        words.extend(MIXED.map(String::from));
    }
    for word in words {
        write_view(studio, &word, dir)?;
    }
    Ok(())
}

/// Writes one view.
pub fn write_view(studio: &mut Studio, words: &str, dir: &Path) -> Result<(), String> {
    let (side, mut none) = (studio.side(), || 0.0);
    let viewing = Viewing::of(words);
    let frame = seen::seen(studio, &viewing, &mut none)?;
    write_rgb(dir, &format!("view-{words}.png"), side, opaque(&frame))
}

/// Writes the cells as cells.svg.
pub fn write_svg(studio: &mut Studio, dir: &Path) -> Result<(), String> {
    let cells = studio.engine_mut().inspect();
    let cells = cells.ok_or("--svg is for pavements only.")?;
    write(dir, "cells.svg", cells.svg().as_bytes())
}

fn write(dir: &Path, name: &str, bytes: &[u8]) -> Result<(), String> {
    let path = dir.join(name);
    std::fs::write(&path, bytes).map_err(|e| format!("Cannot write {}: {e}.", path.display()))
}

/// The colours of an opaque RGBA picture.
pub fn opaque(rgba: &[u8]) -> impl Iterator<Item = [u8; 3]> + '_ {
    rgba.chunks_exact(4).map(|p| [p[0], p[1], p[2]])
}

/// Writes 8 bit red, green, blue.
pub fn write_rgb(
    dir: &Path,
    name: &str,
    width: usize,
    colours: impl Iterator<Item = [u8; 3]>,
) -> Result<(), String> {
    let bytes: Vec<u8> = colours.flatten().collect();
    let height = bytes.len() / (3 * width.max(1));
    let png = encode(
        (width, height),
        &bytes,
        png::ColorType::Rgb,
        png::BitDepth::Eight,
    )?;
    write(dir, name, &png)
}

fn encode(
    (width, height): (usize, usize),
    bytes: &[u8],
    colour: png::ColorType,
    depth: png::BitDepth,
) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width as u32, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    let written = encoder
        .write_header()
        .and_then(|mut writer| writer.write_image_data(bytes));
    written.map_err(|e| format!("A picture could not be written: {e}."))?;
    Ok(out)
}
