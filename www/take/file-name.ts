/** The name of a file from its parts; name.ts has the rule. */

/** The parts of a name by which files of one recipe differ. */
export interface Kind {
  /** The pixels along a side, for pictures and maps. */
  readonly size?: number | undefined;
  /** Words that tell files of one ending apart. */
  readonly variant?: readonly (string | false)[];
  readonly ending: string;
}

export function fileName(name: string, seed: string, { size, variant = [], ending }: Kind): string {
  const words = [plain(name), seed, size ? String(size) : '', ...variant];
  return `${['bubblestone', ...words.filter(Boolean)].join('-')}.${ending}`;
}

/** The text in small letters, digits and hyphens. */
function plain(text: string): string {
  const bare = text.normalize('NFKD').replace(/[\u0300-\u036f'’]/g, '');
  return bare
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');
}
