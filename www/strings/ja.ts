/** Japanese. */
import { foreign } from './ja-module';
import { page, words } from './ja.json';

export { foreign, page, words };
