/**
 * Files that recipes name, by the digest of their bytes. They are stored on this device; if that fails, the pages
 * that received them keep them while they are open. All pages and workers of the site share them.
 */

/** A stored file. */
interface Kept {
  digest: string;
  name: string;
  /** The time when it was last requested. */
  used: number;
  file: Blob;
}

const NAME = 'bubblestone files';
const STORE = 'files';

/** The most bytes that are stored. The files that were not requested for the longest time are deleted first. */
const MOST = 256_000_000;

/** Milliseconds to wait for the answers of other pages. */
const PATIENCE = 400;

/** Milliseconds to wait for the storage. Some browsers never answer; it then counts as refused until it answers. */
const OPENING = 3000;

/** The files that this page received. */
const here = new Map<string, Kept>();
let channel: BroadcastChannel | undefined;
let base: Promise<IDBDatabase> | undefined;

/** Stores a file; false if it is lost with this page because there is no storage or no space. */
export async function keepFile(digest: string, name: string, file: Blob): Promise<boolean> {
  const kept = { digest, name, used: Date.now(), file };
  here.set(digest, kept);
  answer();
  try {
    await within('readwrite', (store) => store.put(kept));
    await makeRoom(digest);
    return true;
  } catch {
    return false;
  }
}

/**
 * Stores a file that came with someone's recipe. It replaces no file, and none is deleted for it. False if it is lost
 * with this page.
 */
export async function addFile(digest: string, name: string, file: Blob): Promise<boolean> {
  const kept = { digest, name, used: Date.now(), file };
  if (!here.has(digest)) here.set(digest, kept);
  answer();
  try {
    if (sizeOf(await everyFile()) + file.size > MOST) return false;
    await within('readwrite', (store) => store.add(kept));
    return true;
  } catch {
    return false;
  }
}

/** A file with this digest from any source; undefined if it is not available. */
export async function findFile(digest: string): Promise<Blob | undefined> {
  const { file } = here.get(digest) ?? (await stored(digest)) ?? {};
  return file ?? (await fromOthers(digest));
}

/** Deletes a file whose content is wrong. */
export async function dropFile(digest: string): Promise<void> {
  here.delete(digest);
  await within('readwrite', (store) => store.delete(digest)).catch(() => undefined);
}

async function stored(digest: string): Promise<Kept | undefined> {
  try {
    return await within<Kept | undefined>('readwrite', (store) => {
      const asked = store.get(digest) as IDBRequest<Kept | undefined>;
      asked.onsuccess = () => asked.result && store.put({ ...asked.result, used: Date.now() });
      return asked;
    });
  } catch {
    return undefined;
  }
}

async function everyFile(): Promise<Kept[]> {
  return within<Kept[]>('readonly', (store) => store.getAll() as IDBRequest<Kept[]>);
}

function sizeOf(kept: Kept[]): number {
  return kept.reduce((sum, { file }) => sum + file.size, 0);
}

/** Deletes old files; the newest stays, however large it is. */
async function makeRoom(newest: string): Promise<void> {
  const all = await everyFile();
  const others = all.filter(({ digest }) => digest !== newest).sort((a, b) => a.used - b.used);
  for (let left = sizeOf(all); left > MOST; ) {
    const oldest = others.shift();
    if (!oldest) return;
    await within('readwrite', (store) => store.delete(oldest.digest));
    left -= oldest.file.size;
  }
}

/** Runs one request in the storage. */
async function within<T>(mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const transaction = (await (base ??= opened())).transaction(STORE, mode);
  const done = new Promise<void>((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = transaction.onerror = () => reject(transaction.error ?? new Error());
  });
  const request = act(transaction.objectStore(STORE));
  await done;
  return request.result;
}

/** Opens the storage, which stays open: some browsers can read a file only while its source is open. */
function opened(): Promise<IDBDatabase> {
  const forget = (): void => {
    base = undefined;
  };
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open(NAME, 1);
    setTimeout(() => reject(new Error()), OPENING);
    opening.onupgradeneeded = () => opening.result.createObjectStore(STORE, { keyPath: 'digest' });
    opening.onsuccess = () => {
      const { result } = opening;
      result.onclose = forget;
      // A page of a later build wants to change the storage.
      result.onversionchange = () => {
        result.close();
        forget();
      };
      base = Promise.resolve(result);
      resolve(result);
    };
    opening.onerror = opening.onblocked = () => {
      forget();
      reject(opening.error ?? new Error());
    };
  });
}

/** A channel to the other open pages; undefined in old browsers, and in those that forbid it together with storing. */
function openChannel(): BroadcastChannel | undefined {
  try {
    return new BroadcastChannel(NAME);
  } catch {
    return undefined;
  }
}

/** Answers the requests of other pages with this page's files. */
function answer(): void {
  if (channel) return;
  channel = openChannel();
  channel?.addEventListener('message', ({ data }: MessageEvent<{ want?: string }>) => {
    const kept = data.want === undefined ? undefined : here.get(data.want);
    if (kept) channel?.postMessage({ have: kept.digest, file: kept.file });
  });
}

/** Requests a file from the other open pages. */
async function fromOthers(digest: string): Promise<Blob | undefined> {
  const asking = openChannel();
  if (!asking) return undefined;
  try {
    return await new Promise((resolve) => {
      asking.addEventListener('message', ({ data }: MessageEvent<{ have?: string; file?: Blob }>) => {
        if (data.have === digest) resolve(data.file);
      });
      setTimeout(() => resolve(undefined), PATIENCE);
      asking.postMessage({ want: digest });
    });
  } finally {
    asking.close();
  }
}
