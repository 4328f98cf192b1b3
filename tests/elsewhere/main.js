import { load, paint, presets } from 'bubblestone';
import 'bubblestone/element';

globalThis.told = {};
for (const stone of document.querySelectorAll('bubble-stone')) {
  for (const kind of ['done', 'error']) stone.addEventListener(kind, ({ detail }) => (globalThis.told[stone.id] = { kind, ...detail }));
}

await load();
globalThis.presets = presets('pavement').length;
globalThis.painted = await paint(document.querySelector('#canvas'), '#size=128&cs=24');
