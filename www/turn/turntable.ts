/**
 * The turntable: the bodies of the picture from an oblique camera, over the sheet. A worker makes the frames; the
 * page shows them.
 *
 * For scripts, the sheet has an attribute `data-turn`: the state of the latest request (`coming`, `moving`, `still`,
 * `fine` or `refused`). The frame has `data-body`: the number of the body last pointed at, or `none`.
 */
import { t } from '../words/turn';
import { byId, make, say } from '../base/dom';
import { RETOLD } from '../base/language';
import { keep, kept } from '../base/storage';
import type { Generator, Parameter } from '../module/types';
import { cameraLimits, cameraWords, firstCamera, homeOf, wholeBodies } from '../state/asked-view';
import type { Camera, Cut } from '../state/viewing';
import type { Bodies, FrameSource, Heard, Plane, Quality, BodyInfo } from '../picture/frames/source';
import { ALL_AROUND, nearer, type Heights } from './camera';
import { Card, hasSteps, sentence } from './card';
import { componentIn } from './components';
import { CutTool } from './cut';
import { Frames } from './frames';
import { CLOSER, Gestures } from './gestures';
import { Labels } from './labels';
import { Making } from './making';
import { Outline } from './outline';
import { planes } from './planes';
import { Sway } from './sway';
import { seen } from './told';
import '../styles/late/look.css';
import '../styles/late/turn.css';

/** The surroundings of a turntable. */
export interface Surroundings {
  /** The generator, which decides the first camera and its limits. */
  generator(): Pick<Generator, 'home' | 'lowest' | 'offers'>;
  /** The source of frames; without it, a worker makes them. */
  frames?: (heard: Heard) => FrameSource;
  /** The recipe's link, whether a control is being dragged, and the recipe's values. */
  link(): string;
  held(): boolean;
  /** Whether frames at rest are refined; they are if this is missing. */
  refines?(): boolean;
  get(key: string): string;
  /** The camera; undefined for the usual one. */
  camera(): Camera | undefined;
  take(camera: Camera): void;
  /** The plane that cuts bodies away; `slice` takes another one. */
  cut?(): Cut | undefined;
  slice?(cut: Cut | undefined): void;
  /** The step of a body that a link asks for, as `ID:STEP`. Later calls return ''. */
  asked?(): string;
  /** The act that turns the bricks of a corner (0) or an edge (1) of a building by hand; undefined if there is none. */
  flip?(feature: readonly [kind: number, number: number]): (() => void) | undefined;
  /** The parameters of the generator, which name the components of a pile. */
  schema(): readonly Parameter[];
  /** Called with the subject that is shown: a step in the making of one body (`ID:STEP`), or '' for all. */
  only?(subject: string, camera: Camera): void;
  /** Leaves the turntable. Missing in an embedded picture, and if there is nothing but bodies to see. */
  leave?: () => void;
  /** Whether it is embedded in another page. */
  alone?: boolean;
  /** Called after each new frame; `whole` tells whether it has all pixels. */
  framed?: (whole: boolean) => void;
  /** Called when there are no more frames. */
  ended(how: 'lost' | 'broken', why: string): void;
}

/**
 * The first camera for one body. The usual light then comes from the front; the body's corners are at distance 1 from
 * its middle.
 */
const BODY: Camera = [80, 30, 4.2, 35, 0, 0, 0];

/** Milliseconds for which the worker is kept after the turntable is left. */
const KEPT = 60_000;

/** The key of the note that the visitor has turned bodies. */
const DRAGGED = 'dragged';

/** The most pixels along a side. */
const MOST = 1600;

export class Turntable {
  private readonly place: Surroundings;
  private readonly sheet = byId('sheet');
  private readonly canvas = make('canvas', { 'aria-hidden': 'true' });
  private readonly stand = make('div', { class: 'turn-stand', id: 'turn', role: 'application', tabindex: '0', 'aria-describedby': 'turn-seen' }, this.canvas);
  private readonly told = make('p', { class: 'said', id: 'turn-seen', role: 'status' });
  private readonly bar = make('progress', { max: '1', 'aria-label': t('working') });
  private readonly working = make('div', { class: 'turn-working' }, make('span', { role: 'status' }, t('working')), this.bar);
  private readonly making: Making;
  private readonly card: Card;
  private readonly labels = new Labels(() => this.frames.labels());
  private readonly outline = new Outline((id) => this.frames.outlineOf(id, this.canvas.width / Math.max(1, this.stand.clientWidth)));
  private readonly root: HTMLElement;
  private readonly frames: FrameSource;
  private readonly gestures: Gestures;
  /** Shown until the visitor has dragged once. */
  private readonly hint = make('p', { class: 'turn-hint', 'aria-hidden': 'true' }, t('drag'));
  /** Tools at the top of the frame; a card keeps clear of them. */
  private readonly tools: HTMLElement[] = [];
  private readonly cutTool = new CutTool({ camera: () => this.camera, take: (cut, moving) => this.slice(cut, moving) });
  private bodies: Bodies = { count: 0, sort: 'stone' };
  private readonly sway = new Sway(() => this.follow());
  private plane: Plane = 'light';
  private on = false;
  private moving = false;
  /** The state of the latest request, and the recipe of the frame that is shown. */
  private reached: Quality | 'coming' | 'refused' = 'coming';
  private shown = '';
  /** The recipe of the latest request. */
  private wanted = '';
  /** The timer that ends the worker once the turntable is off for long. */
  private ending = 0;
  /** The camera for one body. */
  private beside: Camera = BODY;
  /** Counts the places pointed at; a late answer is ignored. */
  private pointed = 0;
  /** The place of the picked body, in fractions of the frame's sides. */
  private at: readonly [number, number] = [0.5, 0.5];

  constructor(place: Surroundings) {
    this.place = place;
    this.making = new Making({ get: (key) => place.get(key), show: () => this.follow(), end: () => this.all() });
    this.card = new Card({ how: (body) => this.how(body), flip: (body) => this.flipOf(body), outline: (id) => this.outline.of(id), tools: () => Math.max(0, ...this.tools.map(({ offsetTop, offsetHeight }) => offsetTop + offsetHeight)), home: () => this.home() });
    const heard: Heard = {
      frame: (frame, quality, bodies, latest) => this.show(frame, quality, bodies, latest),
      kept: (quality) => this.state(quality),
      working: (done) => (this.bar.value = done),
      refused: () => (this.making.subject === '' ? this.state('refused') : this.all()),
      ended: (how, why) => {
        this.shown = '';
        place.ended(how, why);
      },
    };
    this.frames = place.frames?.(heard) ?? new Frames(heard);
    this.gestures = new Gestures(
      this.stand,
      {
        camera: () => this.camera,
        heights: () => (this.making.subject === '' ? (cameraLimits(place.generator())[1] as Heights) : ALL_AROUND),
        take: (camera, moving) => this.take(camera, moving),
        home: () => this.home(),
        leave: () => this.leave(),
        tap: (x, y) => void this.point(x, y, true),
        over: (x, y) => (x === undefined || y === undefined ? this.unpoint() : void this.point(x, y, false)),
        enter: () => void this.enter(),
      },
      place.alone === true,
    );
    this.root = make('div', { class: 'turn' }, make('div', { class: 'turn-frame' }, this.stand, this.outline.element, this.labels.element, this.card.element), this.making.strip, this.working, this.told);
    if (!place.alone && !kept(DRAGGED)) this.root.append(this.hint);
    if (place.slice) this.tools.push(this.cutTool.element);
    if (place.leave) this.tools.push(planes((plane) => this.choose(plane)), this.wayOut());
    this.root.append(...this.tools);
    this.stand.ariaLabel = this.isFramed ? `${t('name_space')}. ${t('keys_space')}` : `${t('name')}. ${t('keys')}`;
    // The keys of the steps and of the way back also work while the frame has the focus.
    this.stand.addEventListener('keydown', (event) => !event.defaultPrevented && this.making.step(event.key) && event.preventDefault());
    new ResizeObserver(() => {
      this.card.put();
      this.follow();
    }).observe(this.stand);
    // Words of the card, such as "Course", look like others of the page.
    addEventListener(RETOLD, () => this.card.picked && void this.point(...this.at, true));
  }

  toggle(on: boolean): void {
    if (on === this.on) return;
    this.on = on;
    // Screen readers and the Tab key skip the covered picture.
    byId('pane').inert = on;
    clearTimeout(this.ending);
    if (on) {
      this.sheet.append(this.root);
      this.root.toggleAttribute('data-shown', this.shown === this.place.link());
      if (!this.place.alone) this.sway.arm();
      this.follow();
      return;
    }
    this.sway.end();
    this.gestures.end();
    this.making.end();
    this.card.hide();
    this.moving = false;
    this.root.remove();
    delete this.sheet.dataset['turn'];
    this.ending = window.setTimeout(() => this.frames.end(), KEPT);
  }

  focus(): void {
    this.stand.focus({ preventScroll: true });
  }

  /** The element that contains the frame. */
  get host(): HTMLElement {
    return this.stand.parentElement ?? this.root;
  }

  /** Whether it has the focus. */
  get focused(): boolean {
    return this.root.contains(document.activeElement);
  }

  /** Zooms in (1), out (-1), or back to the first camera (0). */
  step(by: number): void {
    if (by) this.gestures.soon(nearer(this.camera, by > 0 ? CLOSER : 1 / CLOSER));
    else this.home();
  }

  /** Sways once, if that can help the visitor: the picture is finished, and nothing was touched. */
  greet(): void {
    if (this.on && this.making.subject === '' && this.plane === 'light') this.sway.begin();
  }

  /** Requests a new frame. To be called after each change of the view. */
  follow(): void {
    const { clientWidth, clientHeight } = this.stand;
    if (!this.on || !clientWidth || !clientHeight) return;
    const fine = Math.min(devicePixelRatio, MOST / Math.max(clientWidth, clientHeight));
    const [width, height] = [clientWidth, clientHeight].map((side) => Math.round(side * fine)) as [number, number];
    const { making, place } = this;
    const cut = making.subject === '' ? place.cut?.() : undefined;
    this.cutTool.show(cut, making.subject !== '' || !place.generator().offers.includes('cut'));
    const wish = { link: place.link(), subject: making.subject, camera: cameraWords(this.sway.of(this.camera), homeOf(place.generator())), width, height, plane: this.plane, cut: wholeBodies(cut), moving: this.moving || this.sway.goes || place.held(), refined: place.refines?.() ?? true };
    // The number of a body means another one in another recipe.
    if (wish.link !== this.wanted) this.unpick();
    this.wanted = wish.link;
    place.only?.(making.subject, this.camera);
    this.state(this.frames.want(wish) ? 'coming' : this.reached);
  }

  private get isFramed(): boolean {
    return this.place.generator().offers.includes('frames');
  }

  private choose(plane: Plane): void {
    this.plane = plane;
    this.follow();
  }

  private get camera(): Camera {
    return this.making.subject === '' ? (this.place.camera() ?? this.first) : this.beside;
  }

  /** The first camera for all bodies. */
  private get first(): Camera {
    const { place } = this;
    return firstCamera(place.generator(), (key) => place.get(key));
  }

  private take(camera: Camera, moving: boolean): void {
    this.moving = moving;
    if (moving) this.sway.learnt();
    if (moving && this.hint.isConnected) {
      this.hint.remove();
      keep(DRAGGED, 'yes');
    }
    this.unpick();
    if (this.making.subject !== '') this.beside = camera;
    else this.place.take(camera);
    this.follow();
  }

  private slice(cut: Cut | undefined, moving: boolean): void {
    this.moving = moving;
    this.unpick();
    this.place.slice?.(cut);
    this.follow();
  }

  private home(): void {
    this.gestures.stop();
    this.take(this.making.subject === '' ? this.first : BODY, false);
  }

  private leave(): void {
    if (this.making.subject !== '') this.all();
    else if (this.card.picked) this.card.hide();
    else this.place.leave?.();
  }

  private wayOut(): HTMLElement {
    const end = make('button', { type: 'button', class: 'key', id: 'turn-end', 'aria-label': t('end'), title: t('end') }, '×');
    end.addEventListener('click', (event) => {
      event.stopPropagation();
      this.place.leave?.();
    });
    return end;
  }

  private show(frame: ImageBitmap, quality: Quality, bodies: Bodies, latest: boolean): void {
    const { canvas } = this;
    this.bodies = bodies;
    [canvas.width, canvas.height] = [frame.width, frame.height];
    canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(frame);
    this.root.toggleAttribute('data-shown', true);
    this.outline.framed(quality !== 'moving');
    this.labels.framed(quality !== 'moving');
    this.place.framed?.(quality !== 'moving');
    if (!latest) return;
    this.shown = this.place.link();
    this.state(quality);
    // Bodies that are still being made get moving frames only, and have no steps yet.
    const isMade = quality !== 'moving' || !this.isFramed;
    const asked = isMade && this.making.subject === '' ? this.place.asked?.() : '';
    if (asked) void this.ask(asked);
    if (quality !== 'moving' && !this.moving) say(this.told, this.making.subject === '' ? seen(bodies, this.camera, this.isFramed) : this.making.seen);
  }

  private state(word: Quality | 'coming' | 'refused'): void {
    this.reached = word;
    if (this.on) this.sheet.dataset['turn'] = word;
  }

  /** Shows the card of the body at a place of the frame. The card of a `picked` body has a button for more. */
  private async point(x: number, y: number, picked: boolean): Promise<BodyInfo | undefined> {
    if (this.making.subject !== '' || this.moving || (this.card.picked && !picked)) return undefined;
    const turn = (this.pointed += 1);
    const body = this.named(await this.frames.bodyAt(x, y));
    if (turn !== this.pointed || !this.on) return undefined;
    this.stand.dataset['body'] = String(body?.id ?? 'none');
    if (picked) this.at = [x, y];
    if (body) this.card.show(body, this.bodies.sort, x, y, picked);
    else this.card.hide();
    return body;
  }

  /** A body of a pile with the name of its component. */
  private named(body: BodyInfo | undefined): BodyInfo | undefined {
    const word = body?.words['type'];
    return body && word !== undefined ? { ...body, words: { ...body.words, type: componentIn(this.place.schema(), word) } } : body;
  }

  /** Closes the card of a body, and keeps a late answer from opening one. */
  private unpick(): void {
    this.pointed += 1;
    if (this.card.element.contains(document.activeElement)) this.focus();
    this.card.hide();
  }

  private unpoint(): void {
    this.pointed += 1;
    delete this.stand.dataset['body'];
    if (!this.card.picked) this.card.hide();
  }

  /** Picks the body in the middle; a second call shows how it is made. */
  private async enter(): Promise<void> {
    if (this.making.subject !== '') return;
    const { picked } = this.card;
    if (picked && hasSteps(picked, this.bodies.sort)) {
      this.how(picked);
      return;
    }
    const body = await this.point(0.5, 0.5, true);
    say(byId('cell-said'), body ? sentence(body, this.bodies.sort) : t('nothing'));
  }

  /** Shows the step that a link asks for. A body or a step that does not exist is left out. */
  private async ask(asked: string): Promise<void> {
    const [id = 0, step = 0] = asked.split(':').map(Number);
    const body = await this.frames.bodyOf(id);
    if (body?.steps.length && this.on) this.how(body, Math.min(step, body.steps.length - 1));
  }

  private flipOf({ figures: { feature, number } }: BodyInfo): (() => void) | undefined {
    const act = feature === undefined || number === undefined ? undefined : this.place.flip?.([feature, number]);
    return act && (() => {
      this.card.hide();
      this.focus();
      act();
    });
  }

  private how(body: BodyInfo, step = 0): void {
    this.gestures.stop();
    this.card.hide();
    this.beside = BODY;
    this.moving = false;
    this.making.begin(body, step);
  }

  private all(): void {
    const focused = this.focused;
    this.making.end();
    if (focused) this.focus();
    this.follow();
  }
}
