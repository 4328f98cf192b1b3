/**
 * Changes the language of all words where they stand, so that the picture, the work and open dialogs stay. A text of
 * the page's markup is found by its key. A text that a script set is found in the memory of words/words.ts. Later
 * changes of the page are observed, because a part that is added later may hold words of the other language.
 */
import { again } from '../words/words';

/** The page's own words by language and key. */
type PageWords = Record<'en' | 'ja', Record<string, string>>;

/** The attributes that hold words, or the address of a page in a language. */
const ATTRIBUTES = ['href', 'title', 'aria-label', 'aria-valuetext', 'placeholder', 'label', 'alt'];

/** Signs with which scripts join separate texts. */
const JOINTS = /( [·–+/] |, |: |、|[.?] |[。？])/;

/** The text of a place in both languages, kept so that the way back is exact even if two words look alike. */
const pairs = new WeakMap<Node, Map<string, Partial<Record<'en' | 'ja', string>>>>();

let observer: MutationObserver | undefined;
let tell: (root: Node) => void = () => undefined;

/** Changes the words of the page now and those that come later. `partsOf` gives an element's texts with their keys. */
export function retell(page: PageWords, to: 'en' | 'ja', partsOf: (element: HTMLElement) => [name: string, key: string][]): void {
  const from = to === 'en' ? 'ja' : 'en';
  const own = (element: Element | null, name: string, text: string): string | undefined => {
    if (!(element instanceof HTMLElement) || element.dataset['t'] === undefined) return undefined;
    const key = partsOf(element).find((part) => part[0] === name)?.[1] ?? '';
    return page[from][key] === text ? page[to][key] : undefined;
  };
  const put = (node: Text | Element, name: string, text: string): void => {
    const bare = text.trim();
    if (!bare) return;
    const known = pairs.get(node) ?? new Map<string, Partial<Record<'en' | 'ja', string>>>();
    const pair = known.get(name);
    const now = (pair?.[from] === bare ? pair[to] : undefined) ?? own(node instanceof Text ? node.parentElement : node, name, bare) ?? inParts(bare);
    if (now === bare) return;
    pairs.set(node, known.set(name, { [from]: bare, [to]: now }));
    const whole = text.replace(bare, () => now);
    if (node instanceof Text) node.data = whole;
    else node.setAttribute(name, whole);
  };
  tell = (root) => {
    for (const node of nodesOf(root)) {
      if (node instanceof Text) put(node, '', node.data);
      else for (const name of ATTRIBUTES) put(node, name, node.getAttribute(name) ?? '');
    }
  };
  observer ??= watch();
  tell(document.documentElement);
}

/** The texts and elements of a part of the page, apart from the choice of languages. */
function* nodesOf(root: Node): Iterable<Text | Element> {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT, (node) => (node instanceof Element && node.matches('#language, script, style') ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT));
  for (let node: Node | null = root; node; node = walker.nextNode()) {
    if (node instanceof Text || node instanceof Element) yield node;
  }
}

/** A text in the present language. If it is unknown, its longest known parts are translated, from left to right. */
function inParts(text: string): string {
  const whole = again(text);
  if (whole !== undefined) return whole;
  const pieces = text.split(JOINTS);
  let told = '';
  for (let at = 0; at < pieces.length; ) {
    let end = pieces.length;
    let known: string | undefined;
    while (end > at && known === undefined) known = bareIn(pieces.slice(at, end--).join(''));
    told += known ?? pieces[at] ?? '';
    at = end + 1;
  }
  return told;
}

/** A text in the present language, with the space that follows it; undefined if it is unknown. */
function bareIn(text: string): string | undefined {
  const bare = text.trimEnd();
  const now = again(bare);
  return now === undefined ? undefined : now + text.slice(bare.length);
}

/** Changes the words that are added or set later. A text of the present language stays the same. */
function watch(): MutationObserver {
  const seen = new MutationObserver((changes) => {
    for (const { type, target, addedNodes } of changes) for (const node of type === 'childList' ? addedNodes : [target]) tell(node);
  });
  seen.observe(document.documentElement, { subtree: true, childList: true, characterData: true, attributeFilter: ATTRIBUTES });
  return seen;
}
