/**
 * Files that recipes ask for, by the digest of their bytes: kept on this device, and where that fails, by the pages that
 * got them while those are open. Pages and workers of one site find the same ones.
 */

/** A file as it is kept. */
interface Kept {
  digest: string;
  name: string;
  /** When it was last asked for. */
  used: number;
  file: Blob;
}

const NAME = 'bubblestone files';
const STORE = 'files';

/** Bytes that are kept in all; what was not asked for longest goes first. */
const MOST = 256_000_000;

/** Milliseconds that other pages may take to say that they have a file. */
const PATIENCE = 400;

/** Those that this page got. */
const here = new Map<string, Kept>();
let channel: BroadcastChannel | undefined;
let base: Promise<IDBDatabase> | undefined;

/** Keeps a file; false where it is gone with this page, as there is no storage, or no room. */
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

/** A file of this digest, wherever it is; undefined where it is not to be had. */
export async function findFile(digest: string): Promise<Blob | undefined> {
  const { file } = here.get(digest) ?? (await stored(digest)) ?? {};
  return file ?? (await fromOthers(digest));
}

/** Lets go of a file that is not what it should be. */
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

/** The newest stays, however large it is. */
async function makeRoom(newest: string): Promise<void> {
  const all = (await within('readonly', (store) => store.getAll())) as Kept[];
  const size = (kept: Kept[]): number => kept.reduce((sum, { file }) => sum + file.size, 0);
  const others = all.filter(({ digest }) => digest !== newest).sort((a, b) => a.used - b.used);
  for (let left = size(all); left > MOST; ) {
    const oldest = others.shift();
    if (!oldest) return;
    await within('readwrite', (store) => store.delete(oldest.digest));
    left -= oldest.file.size;
  }
}

/** Has one thing done in the storage. */
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

/** The storage, which stays open: some browsers can read a file only as long as what it came from is. */
function opened(): Promise<IDBDatabase> {
  const forget = (): void => {
    base = undefined;
  };
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open(NAME, 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(STORE, { keyPath: 'digest' });
    opening.onsuccess = () => {
      const { result } = opening;
      result.onclose = forget;
      // Another page, of a later build, has something to change.
      result.onversionchange = () => {
        result.close();
        forget();
      };
      resolve(result);
    };
    opening.onerror = opening.onblocked = () => {
      forget();
      reject(opening.error ?? new Error());
    };
  });
}

/** This page tells others what it has. */
function answer(): void {
  if (channel || typeof BroadcastChannel !== 'function') return;
  channel = new BroadcastChannel(NAME);
  channel.addEventListener('message', ({ data }: MessageEvent<{ want?: string }>) => {
    const kept = data.want === undefined ? undefined : here.get(data.want);
    if (kept) channel?.postMessage({ have: kept.digest, file: kept.file });
  });
}

/** A file that a page has which is open now. */
async function fromOthers(digest: string): Promise<Blob | undefined> {
  if (typeof BroadcastChannel !== 'function') return undefined;
  const asking = new BroadcastChannel(NAME);
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
