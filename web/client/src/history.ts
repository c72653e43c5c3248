// Undo histories in the browser's database, so that they survive a reload. Each has a limit; the oldest documents'
// are removed.

export interface History { now: string; past: unknown }

const DELAY = 150; // ms; shorter than that of writing the file
const DOCUMENTS = 40;
export const MOST = 2_000_000; // characters of one history

function database(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open("fabserver", 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore("histories", { keyPath: "name" })
      .createIndex("time", "time");
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = () => reject(opening.error!);
  });
}

let opened: Promise<IDBDatabase> | null = null;

async function store(mode: IDBTransactionMode): Promise<IDBObjectStore> {
  return (await (opened ??= database())).transaction("histories", mode).objectStore("histories");
}

function answer<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error!);
  });
}

let waiting: { name: string; take: () => History } | null = null;
let timer = 0;

/** Writes a history soon. `take`: returns it as it is then. */
export function keepHistory(name: string, take: () => History): void {
  if (!name) return;
  waiting = { name, take };
  clearTimeout(timer);
  timer = window.setTimeout(flushHistory, DELAY);
}

/** Writes the history that waits, if any. */
export function flushHistory(): void {
  clearTimeout(timer);
  if (!waiting) return;
  const { name, take } = waiting, now = take();
  waiting = null;
  void (async () => {
    try {
      const histories = await store("readwrite");
      histories.put({ name, time: Date.now(), ...now });
      const names = await answer(histories.index("time").getAllKeys()) as string[];
      for (const old of names.slice(0, -DOCUMENTS)) {
        histories.delete(old);
        localStorage.removeItem(knownKey(old));
      }
    } catch { /* without a database there is no undo after a reload */ }
  })();
}
addEventListener("pagehide", flushHistory);

export async function historyOf(name: string): Promise<History | null> {
  try {
    return await answer((await store("readonly")).get(name)) ?? null;
  } catch {
    return null;
  }
}

export async function forgetHistory(name: string): Promise<void> {
  try {
    (await store("readwrite")).delete(name);
  } catch { /* there is none */ }
}

/** Gives a document's history to another name. */
export async function moveHistory(from: string, to: string): Promise<void> {
  const version = knownVersion(from);
  if (version) knowVersion(to, version);
  localStorage.removeItem(knownKey(from));
  try {
    const kept = await answer((await store("readonly")).get(from)), histories = await store("readwrite");
    histories.delete(from);
    if (kept) histories.put({ ...kept, name: to });
    else histories.delete(to);
  } catch { /* without a database there is none */ }
}

// The last version of a file that this browser read or wrote.

const knownKey = (name: string): string => `fabserver version ${name}`;

export function knownVersion(name: string): string | null { return localStorage.getItem(knownKey(name)); }

export function knowVersion(name: string, version: string): void {
  try {
    localStorage.setItem(knownKey(name), version);
  } catch { /* the browser's storage is full */ }
}
