/** Dialogs that open an outline from a file and save it to one. */
import type { Ring } from '../module/types';
import { t } from '../words/editor';
import { make } from '../base/dom';
import { dialogOf } from '../late/dialog';
import { offer } from '../late/download';
import { jsonFile, svgFile } from './export';
import '../styles/late/outline-dialog.css';

interface DialogNeeds {
  side(): number;
  outline(): Ring[];
  /** The name of a file of the outline. */
  fileName(ending: string): string;
  takeFile(file: File): void;
  takeText(text: string, name: string): Promise<boolean>;
}

function button(id: string, text: string, act: () => void): HTMLButtonElement {
  const made = make('button', { type: 'button', id, class: 'key' }, text);
  made.addEventListener('click', act);
  return made;
}

/** The last text that was refused. It stands in the dialog when this is opened again, to be mended. */
let refused = '';

export function importDialog(needs: DialogNeeds): void {
  const file = make('input', { type: 'file', id: 'outline-file', accept: '.svg,.json,image/svg+xml,application/json', 'aria-label': t('import_file') });
  const text = make('textarea', { id: 'outline-text', rows: '5', spellcheck: 'false', placeholder: 'M 10 10 H 90 V 90 Z' });
  file.hidden = true;
  file.addEventListener('change', () => {
    const chosen = file.files?.[0];
    dialog.close();
    if (chosen) needs.takeFile(chosen);
  });
  const use = button('take-text', t('import_use'), () => {
    const given = text.value;
    dialog.close();
    void needs.takeText(given, t('pasted')).then((taken) => (refused = taken ? '' : given));
  });
  text.value = refused;
  use.disabled = refused === '';
  text.addEventListener('input', () => (use.disabled = text.value.trim() === ''));
  const open = button('choose-file', t('import_open'), () => file.click());
  const close = button('leave-import', t('cancel'), () => dialog.close());
  const dialog = dialogOf(
    'import-dialog',
    'outline-dialog',
    t('import_title'),
    make('p', {}, t('import_what')),
    make('div', { class: 'row' }, open, file),
    make('label', { for: 'outline-text' }, t('import_paste')),
    text,
    make('div', { class: 'row' }, use, close),
  );
}

export function exportDialog(needs: DialogNeeds): void {
  const save = (make: (rings: Ring[], side: number) => string, ending: string, type: string): void => {
    offer(new Blob([make(needs.outline(), needs.side())], { type }), needs.fileName(ending));
    dialog.close();
  };
  const svg = button('export-svg', t('export_svg'), () => save(svgFile, 'svg', 'image/svg+xml'));
  const json = button('export-json', t('export_json'), () => save(jsonFile, 'json', 'application/json'));
  const close = button('leave-export', t('cancel'), () => dialog.close());
  const dialog = dialogOf('export-dialog', 'outline-dialog', t('export_title'), make('p', {}, t('export_what')), make('div', { class: 'row' }, svg, json, close));
}
