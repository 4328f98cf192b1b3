/** Makes an element of SVG with attributes and children. */
export function shape<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Record<string, string> = {}, ...children: SVGElement[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
