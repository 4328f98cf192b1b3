/** The words of what is loaded later; other languages come whole. */
import { words } from '../strings/en-look.json';
import { learn } from '../words';

learn(words);

export { t, type Word } from '../words';
