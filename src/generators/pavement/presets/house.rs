//! Pavements that are not from the papers.

use super::Preset;

const PAVEMENTS: &str = "Pavements";

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    Preset::plain([PAVEMENTS, "piazza", "Sandstone piazza"],
        "Flagstones part around flower beds in the evening sun.",
        "v=1&outline=plaza&cs=27&vs=0.06&stone=flag&sv=0.98&hs=16&dr=0.14&fd=1.35&af=1.3&palette=sandstone&vary=1.2&ground=mortar&az=210&el=38&amb=1.1&diff=1.25"),
    Preset::plain([PAVEMENTS, "serpentine", "Basalt serpentine"],
        "Small dark setts follow five bends.",
        "v=1&outline=road_s&ow=1.45&on=5&cs=11&hs=12&dr=0.35&fd=1.4&af=1.1&palette=basalt&az=215&el=38&amb=1.1&diff=1.25"),
    Preset::plain([PAVEMENTS, "spiral", "Marble spiral"],
        "White, rose and green pebbles wind inwards through grass.",
        "v=1&outline=road_spiral&ow=1.5&cs=15&vs=0.18&sv=0.96&dr=0.22&fd=1.2&af=0.4&palette=marble&vary=1.4&ground=moss&soft=0.85&el=38&amb=1.1&diff=1.2"),
    Preset::plain([PAVEMENTS, "ripples", "Porphyry ripples"],
        "Stones grow from the middle of the crossing outwards.",
        "v=1&outline=crossing&ow=1.3&cs=20&gr=0.45&hs=16&dr=0.25&palette=porphyry&vary=1.1&ground=gravel&soft=0.4&el=38&amb=1.2&diff=1.35"),
    Preset::plain([PAVEMENTS, "fountain", "Garden court"],
        "Marble setts in rings around a lawn.",
        "v=1&outline=plaza&ow=0.8&on=1&cs=16&vs=0.05&hs=16&dr=0.25&af=1&palette=marble&vary=1.4&ground=moss&soft=0.8&el=38"),
    Preset::plain([PAVEMENTS, "lantern", "Lantern at the fork"],
        "Sandstone at night: one lamp, long shadows.",
        "v=1&outline=y_fork&ow=1.4&cs=22&hs=22&dr=0.35&palette=sandstone&ground=dark&wet=0.35&light=point&lx=0.5&ly=0.4&lz=0.28&amb=0.8&diff=1.6&spec=1.6"),
    Preset::plain([PAVEMENTS, "cloister", "Old cloister"],
        "Moss has crept over the limestone, dust lies in the joints.",
        "v=1&outline=plaza&on=1&cs=30&vs=0.1&stone=flag&dr=0.15&palette=limestone&ground=soil&moss=0.8&dirt=0.3&el=38"),
    Preset::plain([PAVEMENTS, "rain", "Fork in the rain"],
        "Granite setts, wet to the joints, under one lamp.",
        "v=1&outline=y_fork&ow=1.6&cs=24&vs=0.1&hs=15&dr=0.35&ground=gravel&wet=0.75&light=point&lx=0.75&ly=0.25&amb=1.8&diff=2&spec=1.4"),
];
