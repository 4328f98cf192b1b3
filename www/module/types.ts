/** Types that the page shares with the module. The module declares the objects that it returns. */
export type { Answer, Generator, Histogram, Histograms, Notice, NoticeArg, Parameter, PictureSlice, PixelMap, Preset, Probe, Series, Status } from '../../pkg/bubblestone.js';

/** Reasons why a part of a view shows nothing. */
export type Absence = 'not_yet' | 'at_rest' | 'no_point' | 'no_mesh' | 'one_size' | 'all_even';

/** Rings of an outline in picture units, y down: an outer ring first, then islands and holes; not closed. */
export type Point = [number, number];
export type Ring = Point[];
