/**
 * The layers of plates, each an SVG. A layer that has not changed stays, so a ground is drawn once for all steps on it.
 */
export class Layers {
  private readonly shown = new Map<Element, readonly string[]>();

  put(place: Element, plate: string): void {
    const layers = plate.split(END).slice(0, -1);
    const before = this.shown.get(place) ?? [];
    this.shown.set(place, layers);
    if (before.length !== layers.length) place.innerHTML = plate;
    else for (const [k, layer] of layers.entries()) if (layer !== before[k]) replace(place.children[k], `${layer}${END}`);
  }
}

const END = '</svg>';

function replace(element: Element | undefined, markup: string): void {
  if (element) element.outerHTML = markup;
}
