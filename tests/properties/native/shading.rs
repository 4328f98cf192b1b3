//! Shading: shadows, slices, changes of light.

use super::samples::{SIDE, painted, pavement, small};
use bubblestone::heightfield::{Planes, Shader};
use bubblestone::light::{Light, ShadeParams};
use bubblestone::material::{Gloss, material_table};
use std::f64::consts::TAU;

fn shaded(planes: &Planes, params: &ShadeParams, rows: usize) -> Vec<u8> {
    let table = material_table("granite", "sand", Gloss::Own);
    let mut shader = Shader::new(params, planes.side, 1);
    let mut calls = 0;
    while !shader.advance(planes, &table, rows) {
        calls += 1;
        assert!(calls < 10_000, "shading ends");
    }
    shader.rgba().to_vec()
}

fn lit_by(light: Light) -> ShadeParams {
    ShadeParams {
        light,
        ..ShadeParams::default()
    }
}

/// Flat ground with one wall of height 10 along a column.
fn wall(column: usize) -> Planes {
    let mut planes = Planes::new(SIDE);
    for y in 0..SIDE {
        planes.bump[y * SIDE + column] = 10.0;
    }
    planes.colour.fill([128; 3]);
    planes
}

fn red(image: &[u8], x: usize, y: usize) -> u32 {
    u32::from(image[(SIDE * y + x) * 4])
}

#[test]
fn a_wall_throws_a_shadow_of_the_right_length_away_from_the_light() {
    let planes = wall(48);
    let elevation = TAU / 8.0;
    for (azimuth, sign) in [(TAU / 2.0, 1i32), (0.0, -1)] {
        let light = Light::Parallel { azimuth, elevation };
        let image = shaded(&planes, &lit_by(light), 1000);
        let at = |d: i32| red(&image, (48 + sign * d) as usize, 48);
        assert!(at(5) < at(20) * 2 / 3, "dark behind the wall");
        assert!(at(14).abs_diff(at(20)) < 10, "10 px at 45 degrees");
        assert!(at(-5).abs_diff(at(20)) < 10, "light before it");
    }
}

#[test]
fn a_lamp_throws_shadows_outwards_wherever_it_stands() {
    let planes = wall(60);
    for x in [0.2, -0.3] {
        let params = ShadeParams {
            ambient: 0.0,
            ..lit_by(Light::Point { x, y: 0.5, z: 0.3 })
        };
        let image = shaded(&planes, &params, 1000);
        let without = ShadeParams {
            shadow: 0.0,
            ..params
        };
        let open = shaded(&planes, &without, 1000);
        let (behind, light) = (red(&image, 64, 48), red(&open, 64, 48));
        assert!(
            behind < light / 2,
            "{behind} behind the wall, {light} without"
        );
        assert_eq!(red(&image, 50, 48), red(&open, 50, 48));
    }
}

#[test]
fn slices_do_not_change_the_picture() {
    let planes = painted(small(), &pavement(16.0));
    let lamp = Light::Point {
        x: 0.3,
        y: 0.4,
        z: 0.3,
    };
    for light in [ShadeParams::default().light, lamp] {
        let params = lit_by(light);
        let sliced = shaded(&planes, &params, 1);
        assert_eq!(sliced, shaded(&planes, &params, usize::MAX));
    }
}

#[test]
fn a_restarted_shader_forgets_the_light_before() {
    let planes = painted(small(), &pavement(16.0));
    let table = material_table("granite", "sand", Gloss::Own);
    let low = Light::Parallel {
        azimuth: 1.0,
        elevation: 0.2,
    };
    let mut shader = Shader::new(&lit_by(low), SIDE, 1);
    while !shader.advance(&planes, &table, 50) {}
    shader.restart(&ShadeParams::default());
    while !shader.advance(&planes, &table, 50) {}
    assert_eq!(shader.rgba(), shaded(&planes, &ShadeParams::default(), 50));
}
