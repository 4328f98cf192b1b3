/** Stands in until the page no longer asks for it: the small pictures are files of the site. */
export class Thumbs {
  constructor(readonly thumbs: never[], readonly resting: () => boolean) {}
  wake(): void {}
}
