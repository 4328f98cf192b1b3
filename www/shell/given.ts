/**
 * Files that the visitor drops, pastes or chooses. A model is known by its name. The content of any other file tells
 * whether it holds a recipe, a building or an outline, whatever the page shows.
 */
import { t } from '../words/take';
import { isModel } from '../base/files';
import { alertOf } from '../base/messages';
import type { Later } from '../base/later';
import type { Work } from '../state/work';
import type { Editor } from '../editor/editor';
import type { Space } from '../space/space';
import { openRecipe } from '../take/recipe-file';

/** The bytes at the start of a file in which a building's keys are looked for. */
const HEAD = 4_000_000;

/** Matches the text of a building (docs/building.md), also of one that is no valid JSON. */
const BUILDING = /^\s*\{[^]*?"(faces|unit)"\s*:/;

export class GivenFiles {
  private readonly work: Work;
  private readonly editor: Later<Editor>;
  private readonly space: Later<Space>;

  constructor(work: Work, editor: Later<Editor>, space: Later<Space>) {
    this.work = work;
    this.editor = editor;
    this.space = space;
  }

  /** Opens a file. A model gets the `role`, if there is one. A folder, and a file that has gone, cannot be read. */
  async take(file: File, role?: string): Promise<void> {
    try {
      await this.open(file, role);
    } catch {
      alertOf('outline', t('unreadable', { name: file.name }));
    }
  }

  private async open(file: File, role?: string): Promise<void> {
    const model = isModel(file.name);
    if (!model && (await openRecipe(this.work, file))) return;
    const isBuilding = !model && BUILDING.test(await file.slice(0, HEAD).text());
    if (model || isBuilding) this.space.ask((it) => void it.take({ file, role, isBuilding }));
    else this.editor.ask((it) => void it.takeFile(file));
  }
}
