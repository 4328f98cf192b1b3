//! Skins of animals, of plants, and of creatures in tales.

use super::Preset;

const GALLERY: &str = "Gallery";

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    Preset::plain([GALLERY, "crocodile-back", "Crocodile, back"],
        "Keeled plates in rows down the spine, rounder ones towards the flanks.",
        "v=1&outline=polygon&poly=5sG31H05sCAAwrvCz5sCA&lines=64L3-IqrEsvUtSsvUvzEsvUr7BsvU.6ipBv9xCorEsvUtSsvUtzEsvUr7BsvU&kind=circle&parts=smjBgggBC&ca=1.2&cs=28&spots=gggBgggBsmzB05C&dir=strokes&strokes=o_e3-IorEsvUtSsvUtzEsvUt7BsvU&reach=1&seed=5&stone=skin&sv=1.25&sr=0.4&sc=0.1&tc=0.5&flat=0.1&keel=0.6&dr=0.1&fd=1.3&af=0.04&palette=crocodile&vary=1.2&ground=hide&rim=0.35&belly=0.5&dirt=0.15&az=245&el=55&amb=1.4&diff=1.7&spec=2&occl=0.5"),
    Preset::plain([GALLERY, "crocodile-belly", "Crocodile, belly"],
        "Beads of the flank pass into smooth square plates, as tanners like them.",
        "v=1&outline=polygon&poly=5sG31H05sCAAwrvCz5sCA&lines=k7O31Ho-C86TgtB86T_sB86Tn-C86T&kind=rectangle&parts=smDgggBE&ca=1.3&cs=34&gx=0.1&dir=strokes&angle=90&strokes=k7e31Ho-C86TgtB86T_sB86Tn-C86T&reach=1&seed=2&stone=skin&sv=1.18&sr=0.35&sa=90&tc=0.15&flat=0.35&af=0.02&palette=crocodile&vary=0.6&ground=hide&belly=1&ba=0&amb=1.1&occl=0.6"),
    Preset::plain([GALLERY, "lizard", "Green lizard"],
        "Small beads, marked by a reaction and diffusion from scale to scale.",
        "v=1&tile=1&kind=circle&cs=13&gy=0.3&vs=0.12&seed=2&stone=skin&sv=1.25&sr=0.8&tc=0.3&af=0.04&palette=lizard&ground=hide&pattern=turing&pn=0.15&ps=0.9&pc=0.36"),
    Preset::plain([GALLERY, "fish", "Fish"],
        "Round silvery scales lie like tiles on a roof, darker on the back, pale on the belly.",
        "v=1&tile=1&kind=ellipse&ca=1.25&cs=36&dir=constant&angle=90&stone=skin&sv=1.9&sr=0.8&sc=2.2&tilt=0.08&sa=-90&tc=0.5&af=0.02&palette=fish&vary=0.3&ground=hide&gloss=wet&rim=-0.2&belly=0.7&el=50&spec=1.8&shin=1.5"),
    Preset::plain([GALLERY, "armadillo", "Armadillo"],
        "Bands of bony plates move on bare skin, between two shields of rosettes.",
        "v=1&outline=polygon&poly=31H31HwrvCAAwrvCvrvCA.-xC9n1B8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ak5G8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ai5G8xS_1C-xS7kB-xS8kB8xSg2CA5kB7xSh2C9xS7kB9xS8kB7xSi2C.Ai5G8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ak5G8xSh2C-xS7kB-xS8kB8xSi2CA7kB7xSh2C9xS5kB9xS6kB7xSi2C.Ai5G8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ak5G8xSh2C-xS5kB-xS6kB8xSi2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C&lines=31H29M86T_1C86T7kB86T8kB86Tg2C.vrvC64rB86T_1C86T7kB86T8kB86Tg2C&kind=rectangle&parts=gggBAE.AsmjCE&ca=1.3&cs=30&dir=constant&angle=90&seed=3&stone=skin&sv=1.25&sr=0.4&sc=0.15&tilt=0.05&flat=0.35&fd=1.4&af=0.08&palette=armadillo&vary=0.8&ground=hide&rim=0.45&belly=0.4&ba=0&amb=1.2&diff=1.4"),
    Preset::plain([GALLERY, "thorny-devil", "Thorny devil"],
        "Each thorn stands in a ring of beads: a line around it leaves room for one cell.",
        "v=1&lines=k7OmzJ_Qw_BvuBwuBt_BgRv_B_QvuBvuB_Qv_BgRv_BwuBtuBw_B_Qu_BgRwuBuuBgRw_B.05crmD_Qw_BvuBuuBv_BgRv_B_QtuBtuB_Qv_BgRv_BuuBvuBw_B_Qw_BgRwuBwuBgRw_B.v0Q6sW_Qu_BvuBwuBv_BgRt_B_QvuBvuB_Qt_BgRv_BwuBvuBu_B_Qw_BgRwuBwuBgRw_B.yiet9B_Qu_BvuBwuBv_BgRt_B_QvuBvuB_Qt_BgRv_BwuBvuBu_B_Qw_BgRwuBwuBgRw_B.h3uBqvU_Qw_BtuBwuBv_BgRv_B_QvuBvuB_Qv_BgRt_BwuBvuBw_B_Qw_BgRuuBwuBgRu_B.i3egpB_Qu_BvuBwuBv_BgRt_B_QvuBvuB_Qt_BgRv_BwuBvuBu_B_Qw_BgRwuBwuBgRw_B.svUqvE_Qw_BvuBwuBv_BgRv_B_QtuBvuB_Qv_BgRt_BuuBvuBw_B_Qw_BgRwuBwuBgRu_B&tile=1&kind=circle&cs=16&spots=m8KmzJ0wL68C.AA05E6sE.y5crmD0wL68C.AA05E6sE.v0Q6sW0wL68C.AA05E6sE.yiet9B0wL68C.AA05E6sE._2uBqvU0wL68C.AA05E6sE.g3egpB0wL68C.AA05E6sE.svUqvE0wL68C.AA05E6sE&vs=0.06&stone=skin&sr=1.3&tc=0.9&dr=0.1&fd=1.3&af=0.03&palette=desert&vary=0.7&ground=hide&pattern=lines&pn=0.06&ps=0.8&rim=0.25&el=40&amb=1.1&diff=1.4"),
    Preset::plain([GALLERY, "gila", "Gila monster"],
        "Beads of bone in a labyrinth of coral and black.",
        "v=1&tile=1&kind=circle&cs=13&vs=0.12&stone=skin&sv=1.25&sr=0.8&tc=0.3&af=0.05&palette=coral&ground=hide&pattern=turing&pn=0.17&ps=0.9&pc=0.55&amb=1.3&diff=1.5"),
];
