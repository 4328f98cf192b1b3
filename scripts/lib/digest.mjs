// A short digest of the contents of files.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';

/** @param {string[]} files */
export function digest(files) {
  const hash = createHash('sha256');
  for (const file of files) hash.update(readFileSync(file));
  return hash.digest('hex');
}
