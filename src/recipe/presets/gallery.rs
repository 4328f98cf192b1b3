//! Skins of animals.

use super::Preset;

pub(super) const PRESETS: &[Preset] = &[];
