//! A few of the finest presets, with which the page opens.

use super::Preset;

const SHOWPIECES: &str = "Showpieces";

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    Preset::plain([SHOWPIECES, "pinecone", "Pine cone"],
        "Scales grow outwards and lie over each other, away from the middle.",
        "v=1&outline=polygon&poly=5sG5sG05sCAA05sCz5sCA&kind=ellipse&ca=1.3&cs=32&gr=0.7&dir=circular&stone=skin&sv=1.55&sr=0.9&sc=1.5&tilt=0.1&sa=-90&tc=0.5&keel=0.4&fd=1.4&af=0.06&palette=cone&ground=hide&el=34&amb=1.1&diff=1.3"),
    Preset::plain([SHOWPIECES, "dragon", "Dragon"],
        "Keeled scales follow the bend of a neck, from crimson to gold.",
        "v=1&outline=polygon&poly=76D31Hi3uCAA0wrCh3uCA&kind=ellipse&ca=1.3&cs=36&gx=0.3&dir=strokes&strokes=5sGggwBumTt9BsmTl8KggQ__PmzJlzZ&reach=1&seed=2&stone=skin&sv=1.6&sr=0.85&sc=1.6&tilt=0.18&sa=90&tc=0.5&keel=0.5&fd=1.3&af=0.03&palette=dragon&ground=hide&gloss=glossy&rim=-0.6&belly=0.7&ba=45&az=230&el=25&amb=1.3&diff=1.4&spec=1.2"),
    Preset::plain([SHOWPIECES, "pebbles", "Beach pebbles"],
        "Marble that the sea has rolled, all lying one way.",
        "v=1&tile=1&kind=ellipse&ca=1.35&cs=32&dir=constant&angle=25&vs=0.35&seed=2&hs=32&dr=0.15&af=0.3&palette=marble&vary=1.3&wear=0.4&az=215&el=36&amb=1.1&diff=1.25"),
    Preset::plain([SHOWPIECES, "snake", "Snake"],
        "Narrow keeled scales lie over each other under a coat of rosettes.",
        "v=1&tile=1&kind=ellipse&cs=18&dir=constant&angle=90&stone=skin&sv=1.45&sr=0.7&sc=0.9&tilt=0.12&tc=0.4&keel=0.35&af=0.03&palette=snake&ground=hide&pattern=rosettes&pn=0.25&ps=0.8&el=38"),
    Preset::plain([SHOWPIECES, "star", "Terracotta star"],
        "Terracotta in a star with eight tips, laid on dark ground.",
        "v=1&outline=star&ow=1.5&on=8&cs=22&stone=flag&sv=0.96&hs=11&dr=0.08&bh=0.14&fd=1.3&af=0.8&palette=terracotta&vary=1.3&ground=dark&az=215&el=40&amb=1.1&diff=1.25"),
    Preset::plain([SHOWPIECES, "lane", "Mossy lane"],
        "Where every visit begins: old stones through a garden, late in the day.",
        "v=1&outline=road_s&ow=1.25&cs=26&vs=0.15&hs=28&dr=0.4&palette=mossy&ground=moss&az=240&el=36&amb=1.1&diff=1.25"),
    Preset::plain([SHOWPIECES, "ring", "Granite ring"],
        "The recipe without a word: cobbles run round and round.",
        ""),
    Preset::plain([SHOWPIECES, "wet-arches", "Arches in the rain"],
        "Porphyry setts in segmental arches, wet to the joints, under one lamp.",
        "v=1&tile=1&cs=26&spots=A6sGmzJ6sB.Ay5MmzJ6sB.A05MmzJ6sB.A05MmzJ6sB.Ay5MmzJ6sB.gggBrmzBmzJ6sB.Ay5MmzJ6sB.A05MmzJ6sB.A05MmzJ6sB.Ay5MmzJ6sB&dir=strokes&strokes=Am0O-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.A__vB-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD.__fggQ-1EjzD2uFvoCs7FxYs7FyY2uFwoC-1EkzD&reach=1&hs=19&dr=0.25&palette=porphyry&vary=1.2&ground=gravel&wet=0.75&light=point&lx=0.6&lz=0.7&amb=1.7&diff=2&spec=1.1"),
    Preset::plain([SHOWPIECES, "tortoise", "Tortoise"],
        "Vertebral, costal and marginal shields with their growth rings: lines make the three rows.",
        "v=1&outline=polygon&poly=m86BgggBhrBkvJ54DuyIt-Fi5GzvHqtEnqIkvBnqIjvBzvHptEt-Fh5G54DtyIhrBjvJirBjvJ64DtyIu-Fh5G0vHptEoqIjvBoqIkvB0vHqtEu-Fi5G64DuyI&lines=050BgggB5gB-9Hl-CqjHtzEq2Fr6F2yD5sG-oB5sG9oBr6F1yDtzEp2Fl-CpjH5gB99H6gB99Hm-CpjHuzEp2Fs6F1yD6sG9oB6sG-oBs6F2yDuzEq2Fm-CqjH6gB-9H.1wbpsYA04wB.kuNz4wBA04wB&kind=ellipse&parts=q4FgggBC&ca=1.25&cs=98&gb=0.8&gd=0.1&dir=strokes&strokes=873BgggBr7Bi4K7lF8kJ31H0kG7kJyjC7kJxjC31HzkG7lF7kJr5Bh4Ks5Bh4K8lF7kJ41HzkG8kJxjC8kJyjC41H0kG8lF8kJs7Bi4K&reach=0.06&seed=5&stone=skin&sv=1.25&sr=0.35&tc=0.35&flat=0.5&rings=6&af=0.03&palette=tortoise&rim=0.6&light=point&lx=0.3&lz=0.5"),
    Preset::plain([SHOWPIECES, "via", "Via"],
        "Basalt that two thousand years of feet have rounded and polished.",
        "v=1&tile=1&kind=circle&cs=62&vs=0.26&seed=16&hs=32&palette=basalt&ground=soil&wear=0.8&dirt=0.7&el=32&amb=1.3&diff=1.4"),
    Preset::plain([SHOWPIECES, "koi", "Koi"],
        "Scales like tiles on a roof, in white and orange.",
        "v=1&tile=1&kind=ellipse&ca=1.25&cs=30&dir=constant&angle=90&stone=skin&sv=1.9&sr=0.8&sc=2.2&tilt=0.08&sa=-90&tc=0.5&af=0.02&palette=koi&vary=0.5&ground=hide&gloss=wet&pattern=blotches&pn=0.5&ps=0.85&pc=0.4&rim=-0.2&el=38&amb=1.1&diff=1.1&spec=1.4&shin=1.5"),
];
