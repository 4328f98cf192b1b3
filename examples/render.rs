//! Renders one link to files.
//!
//!     cargo run --release --example render -- '<link or fragment>' [--outline FILE.json] [--model [ROLE=]FILE]
//!         [--shape FILE] --out DIR [--views] [--maps] [--maps-for PROGRAM] [--mesh] [--detail WORD] [--one-mesh]
//!         [--stl SIDE,BASE,RELIEF,SQUARES] [--svg] [--scale N] [--view CAMERA] [--samples N] [--aperture A]
//!
//! Writes picture.png, height.png (16 bit grey), albedo.png, id.png, cells.json, mesh.json and report.json into DIR.
//! If the link has words of a view (`view`, `step`, `camera`, `cut`, `body`; docs/parameters.md), seen.png is that view. Options
//! write more:
//!
//! - `--views`: each view of the page, and some mixtures, as view-NAME.png.
//! - `--maps`: normal-opengl.png, normal-directx.png, roughness.png, ao.png, orm.png and height-float.exr.
//! - `--maps-for`: the files that blender, godot, unity or unreal expect.
//! - `--mesh`: the meshes of all cells and the ground as surface.obj, surface.glb and, with images,
//!   surface-textured.glb. `--detail` is low, middle (the default) or high. With `--one-mesh`, the GLB
//!   files have one mesh of all bodies instead of one for each stone.
//! - `--stl`: the height field as a closed slab with these millimetres, as slab.stl.
//! - `--svg`: the cells' outlines as cells.svg.
//! - `--scale`: the picture at 1 to 8 times its side as picture-Nx.png; with `--maps` also its maps as NAME-Nx.png.
//! - `--view`: the bodies by this camera as slant.png, slant-depth.png, slant-normal.png and slant-id.png; report.json
//!   gets the hash of the still, `frame`. slant.png is the mean of `--samples` samples (1 to 64, 12 by default), each with
//!   camera and lamp moved a little. `--aperture` is the diameter of the lens as a share of the distance in focus (0 to
//!   0.5): what is nearer or farther is blurred. 0.03 looks like a model that is photographed.
//!
//! Ends with code 2 and one sentence if an argument or a file is wrong.
//!
//! The model file (OBJ, GLB, PLY or STL) is added to the link; if the link names a file already, it must be that one.
//! ROLE is the key of the parameter that names the file. Without it, the first parameter that waits for a file is used.
//!
//! For piles, `--model` gives the component, and `--shape` the shape that bodies are heaped on; bodies.json has all
//! components, bodies and walls, and bodies.csv a line for each body, for the scatter tools of other programs. For
//! masonry, `--model` gives the building, as OBJ or JSON.
//!
//! An outline file with a `size` is drawn in a picture of that size, or scaled to that of the link if the link names
//! one, as on the page.

#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(not(target_arch = "wasm32"))]
use bubblestone::{
    generators::ALL,
    generators::pavement::{self, Pavement},
    notice::{Arg, Code, Notice},
    studio::Studio,
};
#[cfg(not(target_arch = "wasm32"))]
use std::{ffi::OsString, path::PathBuf};

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    native::end(run())
}

#[cfg(not(target_arch = "wasm32"))]
fn run() -> Result<(), String> {
    use bubblestone::generators::Viewing;
    use bubblestone::scene::SAMPLES;

    let options = Options::read(std::env::args_os().skip(1))?;
    let (mut studio, mut notices) = open(&options)?;
    let mut clock = native::clock();
    studio.finish(&mut clock)?;
    let out = &options.out;
    native::make(out)?;
    let mut frame = None;
    if let Some(words) = &options.view {
        let (camera, said) = studio.generator().camera().read(words);
        notices.extend(said);
        frame = Some(native::slant::write_slant(
            &mut studio,
            camera,
            (options.samples.unwrap_or(SAMPLES), options.aperture),
            &mut clock,
            out,
        )?);
    }
    native::write_all(&mut studio, notices, frame, out)?;
    write_more(&mut studio, &options)?;
    // This comes last, because a view that stops at a step leaves the work unfinished.
    let (viewing, faults) = Viewing::read(&options.link, studio.generator());
    faults.iter().for_each(|fault| eprintln!("{fault}"));
    if let Some(viewing) = viewing {
        native::seen::write_seen(&mut studio, &viewing, &mut clock, out)?;
    }
    Ok(())
}

/// A studio with the link's recipe and the named files, and notices of all changes.
#[cfg(not(target_arch = "wasm32"))]
fn open(options: &Options) -> Result<(Studio, Vec<Notice>), String> {
    let (mut recipe, mut notices) = ALL.recipe(&options.link);
    let mut studio = match &options.outline {
        None => Studio::new(ALL, recipe),
        Some(_) if !recipe.is_of(&pavement::SCHEMA) => {
            return Err("--outline is for pavements only.".into());
        }
        Some(path) => {
            let mut file = native::read_outline(path)?;
            if let Some(size) = file.size {
                if !options.link_has_size() {
                    notices.extend(recipe.set("size", &size.to_string())?);
                }
                file.scale(recipe.side() / size);
            }
            let made = Pavement::with_outline(&recipe, &file.outline);
            let (engine, mended) = made.map_err(|e| format!("{path}: {e}"))?;
            notices.extend(mended);
            Studio::with_engine(ALL, recipe, Box::new(engine))
        }
    };
    for path in &options.models {
        notices.extend(native::model::open_model(&mut studio, path)?);
    }
    notices.retain(|notice| !has_given(&studio, notice));
    // Refused before the work, not after it.
    let wants_maps = [
        ("--maps", options.maps),
        ("--maps-for", options.maps_for.is_some()),
        ("--scale", options.scale.is_some()),
    ];
    let wanted = wants_maps.into_iter().find(|(_, is_wanted)| *is_wanted);
    if let Some((option, _)) = wanted.filter(|_| studio.maps().is_err()) {
        return Err(format!("{option} is for pavements only."));
    }
    Ok((studio, notices))
}

/// Whether a notice says that a choice lacks its file, and the recipe has got that file since.
#[cfg(not(target_arch = "wasm32"))]
fn has_given(studio: &Studio, notice: &Notice) -> bool {
    let arg = |name: &str| notice.args.iter().find(|arg| arg.0 == name);
    let chosen = arg("is").map(|arg| &arg.1);
    let is_set = |chosen: &Arg| match chosen {
        Arg::Choice { key, word, .. } => studio.recipe().get(key) == *word,
        _ => false,
    };
    notice.code == Code::PointsMissing && chosen.is_some_and(is_set)
}

/// Writes the files that options ask for beside those that are always written.
#[cfg(not(target_arch = "wasm32"))]
fn write_more(studio: &mut Studio, options: &Options) -> Result<(), String> {
    let out = &options.out;
    if options.views {
        native::write_views(studio, out)?;
    }
    if options.maps {
        native::write_maps(studio, out)?;
    }
    if let Some(program) = &options.maps_for {
        native::write_maps_for(studio, program, out)?;
    }
    if options.mesh {
        let detail = native::detail_of(options.detail.as_deref().unwrap_or("middle"))?;
        native::write_meshes(studio, detail, options.one_mesh, out)?;
    }
    if let Some([side, base, relief, squares]) = options.stl {
        let slab = bubblestone::export::Slab {
            side,
            base,
            relief,
            squares: squares as usize,
        };
        native::write_slab(studio, slab, out)?;
    }
    if let Some(scale) = options.scale {
        native::write_bigger(studio, scale, options.maps, out)?;
    }
    if options.svg {
        native::write_svg(studio, out)?;
    }
    Ok(())
}

/// The options of the command line.
#[cfg(not(target_arch = "wasm32"))]
#[derive(Default)]
struct Options {
    link: String,
    outline: Option<String>,
    models: Vec<OsString>,
    out: PathBuf,
    views: bool,
    maps: bool,
    maps_for: Option<String>,
    mesh: bool,
    detail: Option<String>,
    one_mesh: bool,
    stl: Option<[f32; 4]>,
    scale: Option<usize>,
    view: Option<String>,
    samples: Option<usize>,
    aperture: f64,
    svg: bool,
}

#[cfg(not(target_arch = "wasm32"))]
impl Options {
    fn read(mut words: impl Iterator<Item = OsString>) -> Result<Self, String> {
        use bubblestone::scene::{MOST_SAMPLES, WIDEST};
        const USAGE: &str = "Usage: render '<link or fragment>' [--outline FILE.json] [--model [ROLE=]FILE] \
            [--shape FILE] --out DIR [--views] [--maps] [--maps-for PROGRAM] [--mesh] [--detail WORD] [--one-mesh] \
            [--stl SIDE,BASE,RELIEF,SQUARES] [--svg] [--scale N] \
            [--view ANGLE,HEIGHT,DISTANCE,LENS,X,Y,Z] [--samples N] [--aperture A].";
        let mut options = Options::default();
        let mut link = None;
        while let Some(word) = words.next() {
            let word = native::text(word)?;
            // Names of files need not be text.
            let mut path = |name: &str| {
                let value = words.next();
                value.ok_or_else(|| format!("{name} needs a value. {USAGE}"))
            };
            let mut value = |name: &str| native::text(path(name)?);
            match word.as_str() {
                "--outline" => options.outline = Some(value("--outline")?),
                "--model" => options.models.push(path("--model")?),
                "--shape" => {
                    let mut named = OsString::from("model=");
                    named.push(path("--shape")?);
                    options.models.push(named);
                }
                "--out" => options.out = path("--out")?.into(),
                "--views" => options.views = true,
                "--maps" => options.maps = true,
                "--maps-for" => options.maps_for = Some(value("--maps-for")?),
                "--mesh" => options.mesh = true,
                "--detail" => options.detail = Some(value("--detail")?),
                "--one-mesh" => options.one_mesh = true,
                "--stl" => {
                    let numbers = value("--stl")?;
                    let numbers: Vec<f32> = numbers.split(',').flat_map(str::parse).collect();
                    let said = |_| format!("--stl needs four numbers, as 100,3,4,256. {USAGE}");
                    options.stl = Some(numbers.try_into().map_err(said)?);
                }
                "--scale" => {
                    let scale = value("--scale")?.parse();
                    let said = |_| format!("--scale needs a whole number, 1 to 8. {USAGE}");
                    options.scale = Some(scale.map_err(said)?);
                }
                "--view" => options.view = Some(value("--view")?),
                "--samples" => {
                    let samples = value("--samples")?.parse().ok();
                    let samples = samples.filter(|n| (1..=MOST_SAMPLES).contains(n));
                    let said =
                        format!("--samples needs a whole number, 1 to {MOST_SAMPLES}. {USAGE}");
                    options.samples = Some(samples.ok_or(said)?);
                }
                "--aperture" => {
                    let aperture = value("--aperture")?.parse().ok();
                    let aperture = aperture.filter(|wide| (0.0..=WIDEST).contains(wide));
                    let said = format!("--aperture needs a number, 0 to {WIDEST}. {USAGE}");
                    options.aperture = aperture.ok_or(said)?;
                }
                "--svg" => options.svg = true,
                _ if word.starts_with("--") => {
                    return Err(format!("There is no option {word}. {USAGE}"));
                }
                _ if link.is_some() => return Err(format!("Give one link only. {USAGE}")),
                _ => link = Some(word),
            }
        }
        options.link = link.unwrap_or_default();
        if options.out.as_os_str().is_empty() {
            return Err(format!("Say where the files go. {USAGE}"));
        }
        Ok(options)
    }

    /// Whether the link itself names the picture's size.
    fn link_has_size(&self) -> bool {
        let fragment = self.link.rsplit('#').next().unwrap_or_default();
        fragment.split('&').any(|word| word.starts_with("size="))
    }
}
