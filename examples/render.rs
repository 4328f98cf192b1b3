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
//! components, bodies and walls, and bodies.csv a line for each body, for the scatter tools of other programs.
//!
//! An outline file with a `size` is drawn in a picture of that size, or scaled to that of the link if the link names
//! one, as on the page.

#[cfg(not(target_arch = "wasm32"))]
mod native;

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    native::end(run())
}

#[cfg(not(target_arch = "wasm32"))]
fn run() -> Result<(), String> {
    use bubblestone::generators::pavement::{self, Pavement};
    use bubblestone::generators::{ALL, Viewing};
    use bubblestone::scene::SAMPLES;
    use bubblestone::studio::Studio;

    let wish = Wish::read(std::env::args_os().skip(1))?;
    let (mut recipe, mut notices) = ALL.recipe(&wish.link);
    let mut studio = match &wish.outline {
        None => Studio::new(ALL, recipe),
        Some(_) if !recipe.is_of(&pavement::SCHEMA) => {
            return Err("--outline is for pavements only.".into());
        }
        Some(path) => {
            let mut file = native::read_outline(path)?;
            if let Some(size) = file.size {
                if !wish.link_has_size() {
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
    for path in &wish.models {
        notices.extend(native::model::open_model(&mut studio, path)?);
    }
    let mut clock = native::clock();
    studio.finish(&mut clock)?;
    let out = &wish.out;
    native::make(out)?;
    let mut frame = None;
    if let Some(words) = &wish.view {
        let (camera, said) = studio.generator().camera().read(words);
        notices.extend(said);
        frame = Some(native::slant::write_slant(
            &mut studio,
            camera,
            (wish.samples.unwrap_or(SAMPLES), wish.aperture),
            &mut clock,
            out,
        )?);
    }
    native::write_all(&mut studio, notices, frame, out)?;
    if wish.views {
        native::write_views(&mut studio, out)?;
    }
    if wish.maps {
        native::write_maps(&mut studio, out)?;
    }
    if let Some(program) = &wish.maps_for {
        native::write_maps_for(&mut studio, program, out)?;
    }
    if wish.mesh {
        let detail = native::detail_of(wish.detail.as_deref().unwrap_or("middle"))?;
        native::write_meshes(&mut studio, detail, wish.one_mesh, out)?;
    }
    if let Some([side, base, relief, squares]) = wish.stl {
        let slab = bubblestone::export::Slab {
            side,
            base,
            relief,
            squares: squares as usize,
        };
        native::write_slab(&studio, slab, out)?;
    }
    if let Some(scale) = wish.scale {
        native::write_bigger(&mut studio, scale, wish.maps, out)?;
    }
    if wish.svg {
        native::write_svg(&mut studio, out)?;
    }
    // This comes last, because a view that stops at a step leaves the work unfinished.
    let (viewing, faults) = Viewing::read(&wish.link, studio.generator());
    faults.iter().for_each(|fault| eprintln!("{fault}"));
    if let Some(viewing) = viewing {
        native::seen::write_seen(&mut studio, &viewing, &mut clock, out)?;
    }
    Ok(())
}

#[cfg(not(target_arch = "wasm32"))]
use std::{ffi::OsString, path::PathBuf};

/// The options of the command line.
#[cfg(not(target_arch = "wasm32"))]
#[derive(Default)]
struct Wish {
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
impl Wish {
    fn read(mut words: impl Iterator<Item = OsString>) -> Result<Self, String> {
        use bubblestone::scene::{MOST_SAMPLES, WIDEST};
        const USAGE: &str = "Usage: render '<link or fragment>' [--outline FILE.json] [--model [ROLE=]FILE] \
            [--shape FILE] --out DIR [--views] [--maps] [--maps-for PROGRAM] [--mesh] [--detail WORD] [--one-mesh] \
            [--stl SIDE,BASE,RELIEF,SQUARES] [--svg] [--scale N] \
            [--view ANGLE,HEIGHT,DISTANCE,LENS,X,Y,Z] [--samples N] [--aperture A].";
        let mut wish = Wish::default();
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
                "--outline" => wish.outline = Some(value("--outline")?),
                "--model" => wish.models.push(path("--model")?),
                "--shape" => {
                    let mut named = OsString::from("model=");
                    named.push(path("--shape")?);
                    wish.models.push(named);
                }
                "--out" => wish.out = path("--out")?.into(),
                "--views" => wish.views = true,
                "--maps" => wish.maps = true,
                "--maps-for" => wish.maps_for = Some(value("--maps-for")?),
                "--mesh" => wish.mesh = true,
                "--detail" => wish.detail = Some(value("--detail")?),
                "--one-mesh" => wish.one_mesh = true,
                "--stl" => {
                    let numbers = value("--stl")?;
                    let numbers: Vec<f32> = numbers.split(',').flat_map(str::parse).collect();
                    let said = |_| format!("--stl needs four numbers, as 100,3,4,256. {USAGE}");
                    wish.stl = Some(numbers.try_into().map_err(said)?);
                }
                "--scale" => {
                    let scale = value("--scale")?.parse();
                    let said = |_| format!("--scale needs a whole number, 1 to 8. {USAGE}");
                    wish.scale = Some(scale.map_err(said)?);
                }
                "--view" => wish.view = Some(value("--view")?),
                "--samples" => {
                    let samples = value("--samples")?.parse().ok();
                    let samples = samples.filter(|n| (1..=MOST_SAMPLES).contains(n));
                    let said =
                        format!("--samples needs a whole number, 1 to {MOST_SAMPLES}. {USAGE}");
                    wish.samples = Some(samples.ok_or(said)?);
                }
                "--aperture" => {
                    let aperture = value("--aperture")?.parse().ok();
                    let aperture = aperture.filter(|wide| (0.0..=WIDEST).contains(wide));
                    let said = format!("--aperture needs a number, 0 to {WIDEST}. {USAGE}");
                    wish.aperture = aperture.ok_or(said)?;
                }
                "--svg" => wish.svg = true,
                _ if word.starts_with("--") => {
                    return Err(format!("There is no option {word}. {USAGE}"));
                }
                _ if link.is_some() => return Err(format!("Give one link only. {USAGE}")),
                _ => link = Some(word),
            }
        }
        wish.link = link.unwrap_or_default();
        if wish.out.as_os_str().is_empty() {
            return Err(format!("Say where the files go. {USAGE}"));
        }
        Ok(wish)
    }

    /// Whether the link itself names the picture's size.
    fn link_has_size(&self) -> bool {
        let fragment = self.link.rsplit('#').next().unwrap_or_default();
        fragment.split('&').any(|word| word.starts_with("size="))
    }
}
