//! Skins of animals, and of what grows or is told of like them.

use super::{Preset, free};

const GALLERY: &str = "Gallery";

#[rustfmt::skip]
pub(super) const PRESETS: &[Preset] = &[
    free(GALLERY, "crocodile-back", "Crocodile, back",
        "Keeled plates in rows down the spine, rounder ones towards the flanks.",
        "v=1&outline=polygon&poly=5sG31H05sCAAwrvCz5sCA&lines=64L3-IqrEsvUtSsvUvzEsvUr7BsvU.6ipBv9xCorEsvUtSsvUtzEsvUr7BsvU&kind=circle&parts=smjBgggBC&ca=1.2&cs=28&spots=gggBgggBsmzB05C&dir=strokes&strokes=o_e3-IorEsvUtSsvUtzEsvUt7BsvU&reach=1&seed=5&stone=skin&sv=1.35&sr=0.4&tc=0.3&flat=0.3&keel=1&dr=0.15&fd=1.5&palette=crocodile&ground=hide&pattern=blotches&pn=0.35&pm=0.5&dirt=0.4&el=33&amb=1.5&diff=1.7&occl=0.7"),
    free(GALLERY, "crocodile-belly", "Crocodile, belly",
        "Beads of the flank pass into smooth square plates, as tanners like them.",
        "v=1&outline=polygon&poly=5sG31H05sCAAwrvCz5sCA&lines=k7O31Ho-C86TgtB86T_sB86Tn-C86T&kind=rectangle&parts=smDgggBE&ca=1.3&cs=34&gx=0.1&dir=strokes&angle=90&strokes=k7e31Ho-C86TgtB86T_sB86Tn-C86T&reach=1&seed=2&stone=skin&sv=1.18&sr=0.35&sa=90&tc=0.15&flat=0.35&af=0.02&palette=crocodile&vary=0.6&ground=hide&belly=1&ba=0&amb=1.1&occl=0.6"),
    free(GALLERY, "lizard", "Green lizard",
        "Small beads, marked by a reaction and diffusion from scale to scale.",
        "v=1&tile=1&kind=circle&cs=13&gy=0.3&vs=0.12&stone=skin&sv=1.25&sr=0.8&tc=0.3&af=0.05&palette=lizard&ground=hide&pattern=turing&pn=0.13&ps=0.9&pc=0.4"),
    free(GALLERY, "snake", "Snake",
        "Narrow keeled scales lean over each other under a coat of rosettes.",
        "v=1&tile=1&kind=ellipse&cs=18&dir=constant&angle=90&stone=skin&sv=1.5&sr=0.7&sc=1&tc=0.4&keel=0.3&af=0.03&palette=snake&ground=hide&pattern=rosettes&pn=0.2"),
    free(GALLERY, "fish", "Fish",
        "Round silvery scales, each under two others, from the dark back to the pale belly.",
        "v=1&tile=1&kind=ellipse&ca=1.25&cs=36&dir=constant&angle=90&stone=skin&sv=1.8&sr=0.8&sc=2.2&sa=-90&tc=0.5&af=0.02&palette=fish&vary=0.5&ground=hide&gloss=glossy&belly=0.7&el=35"),
    free(GALLERY, "koi", "Koi",
        "The same scales in white and orange.",
        "v=1&tile=1&kind=ellipse&ca=1.2&cs=30&dir=constant&angle=90&stone=skin&sv=1.8&sr=0.8&sc=2.2&sa=-90&tc=0.5&af=0.02&palette=koi&vary=0.5&ground=hide&gloss=wet&pattern=blotches&pn=0.5&ps=0.75&pc=0.4&rim=0.2&el=35"),
    free(GALLERY, "tortoise", "Tortoise",
        "Vertebral, costal and marginal shields with their growth rings: lines make the three rows.",
        "v=1&outline=polygon&poly=m86BgggBhrBkvJ54DuyIt-Fi5GzvHqtEnqIkvBnqIjvBzvHptEt-Fh5G54DtyIhrBjvJirBjvJ64DtyIu-Fh5G0vHptEoqIjvBoqIkvB0vHqtEu-Fi5G64DuyI&lines=050BgggB5gB-9Hl-CqjHtzEq2Fr6F2yD5sG-oB5sG9oBr6F1yDtzEp2Fl-CpjH5gB99H6gB99Hm-CpjHuzEp2Fs6F1yD6sG9oB6sG-oBs6F2yDuzEq2Fm-CqjH6gB-9H.1wbpsYA04wB.kuNz4wBA04wB&kind=ellipse&parts=q4FgggBC&ca=1.25&cs=98&gb=0.8&gd=0.1&dir=strokes&strokes=873BgggBr7Bi4K7lF8kJ31H0kG7kJyjC7kJxjC31HzkG7lF7kJr5Bh4Ks5Bh4K8lF7kJ41HzkG8kJxjC8kJyjC41H0kG8lF8kJs7Bi4K&reach=0.06&seed=5&stone=skin&sv=1.25&sr=0.35&tc=0.35&flat=0.5&rings=6&af=0.03&palette=tortoise&rim=0.6&light=point&lx=0.3&lz=0.5"),
    free(GALLERY, "armadillo", "Armadillo",
        "Rosettes before and behind, and between them bands of bone that move on bare skin.",
        "v=1&outline=polygon&poly=31H31HwrvCAAwrvCvrvCA.-xC9n1B8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ak5G8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ai5G8xS_1C-xS7kB-xS8kB8xSg2CA5kB7xSh2C9xS7kB9xS8kB7xSi2C.Ai5G8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ak5G8xSh2C-xS7kB-xS8kB8xSi2CA7kB7xSh2C9xS5kB9xS6kB7xSi2C.Ai5G8xS_1C-xS7kB-xS8kB8xSg2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C.Ak5G8xSh2C-xS5kB-xS6kB8xSi2CA7kB7xS_1C9xS7kB9xS8kB7xSg2C&lines=31H29M86T_1C86T7kB86T8kB86Tg2C.vrvC64rB86T_1C86T7kB86T8kB86Tg2C&kind=rectangle&parts=gggBAE.AsmjCE&ca=2.2&cs=22&dir=constant&angle=90&stone=skin&sv=1.2&sr=0.6&sc=0.4&tc=0.3&flat=0.2&fd=1.4&af=0.08&palette=armadillo&vary=0.5&ground=hide&dirt=0.3"),
    free(GALLERY, "thorny-devil", "Thorny devil",
        "Each thorn stands alone in its ring of beads: a line around it keeps it so.",
        "v=1&lines=ijMg1O3rCzlCyYrkDogD1e4rC0lCxYqkDngD4e.4pa_qJitB2pC_oB6rC_1CiChtB3pCgpB3rCg2ChC.4gR4hVpiD_qBnMvqDg2Ct_BqiDgrBoMwqD_1Cu_B.z5c1pC2wDrQ0lCi6C_qBwqD1wDsQzlCh6CgrBvqD.9oR0xP9zClK5iB7vCo1B1lC-zCoK6iB8vCn1B0lC.o2lBwqD7mBwqD1yDuS1nCh4C-mBvqD2yDtS0nCi4C.l0d6rK0apiDqiDza2nC2nCzaqiDpiD0a1nC1nC.0vnBq4Fv_Bv_BwUh4Ci4CxYu_Bw_BtUi4Ch4CyY&tile=1&kind=circle&cs=17&spots=05M0wL6jFggG.mqY76DmpEggG.u9RwrPgqFggG.zna-6Dq4FggG.rvU0nKmpEggG.smjB6sGq4FggG.nhX4-I6jFggG.6jlB86DsvEggG&vs=0.12&stone=skin&sr=2&tc=0.8&dr=0.1&af=0.02&palette=desert&ground=hide&pattern=blotches&pn=0.5&ps=0.85&rim=0.4&el=40&amb=1.2"),
    free(GALLERY, "pinecone", "Pine cone",
        "Scales grow outwards and lie over each other away from the middle.",
        "v=1&outline=polygon&poly=5sG5sG05sCAA05sCz5sCA&kind=ellipse&ca=1.3&cs=34&gr=0.8&dir=circular&stone=skin&sv=1.6&sr=0.9&sc=1.6&sa=-90&tc=0.5&keel=0.4&fd=1.4&af=0.07&palette=cone&ground=hide&el=34&amb=1.1&diff=1.3"),
    free(GALLERY, "dragon", "Dragon",
        "Keeled scales as broad as hands follow the bend of a neck, crimson to gold.",
        "v=1&outline=polygon&poly=5sG31H05sCAAwrvCz5sCA&kind=ellipse&ca=1.3&cs=46&gx=0.4&dir=strokes&strokes=5sGggwBumTt9BsmTl8KggQ__PmzJlzZ&reach=1&stone=skin&sv=1.7&sr=0.9&sc=1.6&sa=90&tc=0.5&keel=0.5&fd=1.3&af=0.05&palette=dragon&ground=hide&gloss=glossy&rim=-0.5&belly=0.7&ba=45&az=230&el=25&amb=1.3&diff=1.4"),
    free(GALLERY, "gila", "Gila monster",
        "Beads of bone in a labyrinth of coral and black.",
        "v=1&tile=1&kind=circle&cs=13&vs=0.12&stone=skin&sv=1.25&sr=0.8&tc=0.3&af=0.05&palette=coral&ground=hide&pattern=turing&pn=0.17&ps=0.9&pc=0.55"),
];
