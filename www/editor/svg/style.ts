/** The properties that style sheets, style attributes and attributes give to a drawing's elements. */
import { compile } from 'css-select';
import { AttributeAction, parse, SelectorType, type Selector } from 'css-what';
import type { Element } from 'domhandler';

/** An element's properties by name. */
export type Properties = ReadonlyMap<string, string>;

interface Rule {
  fits: (element: Element) => boolean;
  weight: number;
  tells: Declaration[];
}

interface Declaration {
  key: string;
  value: string;
  important: boolean;
}

/** Properties that children inherit. */
export const INHERITED = [
  'clip-rule', 'color', 'fill', 'fill-opacity', 'fill-rule', 'marker-end', 'marker-mid', 'marker-start', 'stroke', 'stroke-dasharray', 'stroke-dashoffset',
  'stroke-linecap', 'stroke-linejoin', 'stroke-miterlimit', 'stroke-opacity', 'stroke-width', 'visibility',
];

/** Rules for media other than a light screen, and at-rules that style no elements. */
const ELSEWHERE = /@(?:media\b(?=[^{]*\b(?:print|speech|dark|not|reduce)\b)|font-face|(?:-\w+-)?keyframes|page|property|counter-style)/i;

export class StyleRules {
  private readonly rules: Rule[] = [];

  constructor(texts: string[]) {
    for (const text of texts) this.read(text.replace(/\/\*[^]*?(?:\*\/|$)|<!--|-->/g, ''));
    this.rules.sort((a, b) => a.weight - b.weight);
  }

  /** Reads rules. Nested rules, such as those for media, are read like all others. */
  private read(text: string): void {
    for (const { head, body } of blocks(text)) {
      if (ELSEWHERE.test(head)) continue;
      if (head.startsWith('@')) this.read(body);
      else this.add(head, declarations(body));
    }
  }

  private add(selectors: string, tells: Declaration[]): void {
    try {
      for (const selector of parse(selectors)) this.rules.push({ fits: compile<Element, Element>([selector], { xmlMode: true }), weight: weight(selector), tells });
    } catch {
      // The selector has a mistake, or needs a live page, such as :hover.
    }
  }

  /** Important declarations win, then the more specific ones, then the later ones. */
  of(element: Element): Properties {
    const own = declarations(element.attribs['style'] ?? '');
    const told = [...this.rules.filter(({ fits }) => fits(element)).flatMap(({ tells }) => tells), ...own];
    const last = [...told.filter(({ important }) => !important), ...told.filter(({ important }) => important)];
    return new Map([...Object.entries(element.attribs), ...last.map(({ key, value }): [string, string] => [key, value])].map(([key, value]) => [key, value.trim()]));
  }
}

/** The text before braces and the text in them. */
function* blocks(text: string): Generator<{ head: string; body: string }> {
  let [from, open, deep] = [0, 0, 0];
  for (const { index, 0: sign } of text.matchAll(/[{};]|"[^"]*"|'[^']*'/g)) {
    if (sign === '{' && deep++ === 0) open = index;
    // A rule without braces, such as @import.
    if (sign === ';' && deep === 0) from = index + 1;
    if (sign === '}' && deep > 0 && --deep === 0) {
      yield { head: text.slice(from, open).trim(), body: text.slice(open + 1, index) };
      from = index + 1;
    }
  }
}

function declarations(text: string): Declaration[] {
  return [...text.matchAll(/(?<![-\w])([-\w]+)\s*:\s*((?:[^;"'(]|"[^"]*"|'[^']*'|\([^)]*\))*)/g)].map(([, key = '', said = '']) => {
    const value = said.replace(/!\s*important\s*$/i, '');
    return { key: key.startsWith('--') ? key : key.toLowerCase(), value: value.trim(), important: value !== said };
  });
}

/** The specificity of a selector: ids, then classes and the like, then elements. */
function weight(selector: Selector[]): number {
  return selector.reduce((sum, part) => {
    if (part.type === SelectorType.Attribute) return sum + (part.name === 'id' && part.action === AttributeAction.Equals ? 1e6 : 1e3);
    if (part.type === SelectorType.Tag || part.type === SelectorType.PseudoElement) return sum + 1;
    if (part.type !== SelectorType.Pseudo || part.name === 'where') return sum;
    return sum + (Array.isArray(part.data) ? Math.max(...part.data.map(weight)) : 1e3);
  }, 0);
}
