/** Japanese. */
import { page, words } from './ja.json';
import { foreign } from './ja-module';

export { foreign, page, words };
