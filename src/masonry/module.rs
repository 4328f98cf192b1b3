//! Modules of patterns: the spacings of their grid lines, half a brick along a course and a course in height.

use crate::building::Module;

/// Modular bricks of the United States: 8 x 4 x 2 2/3 inches with joints.
pub const US_BRICK: Module = new(0.1016, 0.0677, 0.010);
/// British bricks: 225 x 112.5 x 75 mm with joints.
pub const UK_BRICK: Module = new(0.1125, 0.075, 0.010);
/// Random ashlar: a grid of 125 mm.
pub const ASHLAR: Module = new(0.125, 0.125, 0.014);
/// Cubes of 250 mm.
pub const BLOCK: Module = new(0.25, 0.25, 0.012);

const fn new(half: f64, course: f64, joint: f64) -> Module {
    Module {
        half,
        course,
        joint,
    }
}

/// Why a module cannot be laid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModuleFault {
    /// A length is not finite, W or H is not above 0, or the joint is below 0.
    NotPositive,
    /// The joint is as wide as a block, or wider.
    WideJoint,
    /// W and H differ by more than [`MOST_RATIO`]: the maps of occupancy would need too many pixels for a block.
    Uneven,
}

/// The greatest ratio of W and H, either way.
pub const MOST_RATIO: f64 = 4.0;

/// Checks a module.
///
/// # Errors
/// If it cannot be laid.
pub fn check(module: &Module) -> Result<(), ModuleFault> {
    let Module {
        half,
        course,
        joint,
    } = *module;
    let are_finite = [half, course, joint].iter().all(|v| v.is_finite());
    if !are_finite || half <= 0.0 || course <= 0.0 || joint < 0.0 {
        return Err(ModuleFault::NotPositive);
    }
    if joint >= half.min(course) {
        return Err(ModuleFault::WideJoint);
    }
    // Numbers read from a link (URL) are rounded, so the limit has a little slack.
    let is_uneven = half.max(course) > MOST_RATIO * half.min(course) * (1.0 + 1e-9);
    if is_uneven {
        Err(ModuleFault::Uneven)
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_that_cannot_be_laid_are_refused() {
        for good in [Module::NORMAL, US_BRICK, UK_BRICK, ASHLAR, BLOCK] {
            assert_eq!(check(&good), Ok(()));
        }
        assert_eq!(check(&new(0.1, 0.1, 0.1)), Err(ModuleFault::WideJoint));
        assert_eq!(check(&new(0.1, 0.4, 0.01)), Ok(()));
        for uneven in [new(0.1, 0.41, 0.01), new(1.0, 0.02, 0.0)] {
            assert_eq!(check(&uneven), Err(ModuleFault::Uneven));
        }
        for bad in [
            new(0.0, 0.1, 0.01),
            new(0.1, f64::NAN, 0.01),
            new(0.1, 0.1, -0.01),
        ] {
            assert_eq!(check(&bad), Err(ModuleFault::NotPositive));
        }
    }
}
