// The document that is open. Each change is kept in the browser at once and in its file soon after, so that it outlives
// the end of either.
import { ask, Refusal } from "./server";

interface Draft { text: string; base: string | null }

const DELAY = 400; // ms between a change and its way into the file
const AGAIN = 1000; // ms until a server that was away is tried again

const draftKey = (name: string): string => `fabserver draft ${name}`;

export class Store {
  name = "";
  text = "";
  private version: string | null = null; // of the file; null: there is none yet
  private timer = 0;
  private saving = false;
  onState: (state: "saved" | "saving" | "away" | "conflict" | "refused" | "none", message: string) => void = () => {};

  /** Reads a document; with a draft of it that did not get into its file, the draft. Throws Refusal and TypeError. */
  async open(name: string): Promise<string> {
    await this.flush();
    const answer = await ask(`/api/documents/${encodeURIComponent(name)}`);
    const text = await answer.text();
    this.name = name;
    this.version = answer.headers.get("ETag")?.replaceAll('"', "") ?? null;
    this.text = text;
    const draft = this.draft(name);
    if (draft && draft.text !== text && (draft.base === this.version ||
        confirm(`This browser has changes of “${name}” that are not in its file, ` +
          "which changed meanwhile. Take the browser's?"))) {
      this.change(draft.text);
    } else {
      localStorage.removeItem(draftKey(name));
      this.onState("saved", "");
    }
    return this.text;
  }

  /** A document that has no file yet: what this browser has of it, or nothing. It is written when it changes. */
  async begin(name: string): Promise<string> {
    await this.flush();
    this.name = name;
    this.version = null;
    this.text = "";
    const draft = this.draft(name);
    if (draft) this.change(draft.text);
    return this.text;
  }

  /** A new document, written at once. */
  async create(name: string, text: string): Promise<void> {
    await this.begin(name);
    this.change(text);
    await this.flush();
  }

  private draft(name: string): Draft | null {
    try {
      return JSON.parse(localStorage.getItem(draftKey(name)) ?? "null");
    } catch {
      return null;
    }
  }

  change(text: string): void {
    if (!this.name || text === this.text) return;
    this.text = text;
    try {
      localStorage.setItem(draftKey(this.name), JSON.stringify({ text, base: this.version } satisfies Draft));
    } catch { /* the browser's room is full: the file has it in a moment */ }
    this.onState("saving", "");
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.save(), DELAY);
  }

  private async flush(): Promise<void> {
    if (!this.name || !this.draft(this.name)) return;
    clearTimeout(this.timer);
    await this.save();
  }

  private async save(force = false): Promise<void> {
    if (this.saving) {
      this.timer = window.setTimeout(() => void this.save(force), DELAY);
      return;
    }
    this.saving = true;
    const { name, text } = this;
    try {
      const expected = force ? "*" : this.version;
      const headers: Record<string, string> = expected ? { "If-Match": expected === "*" ? "*" : `"${expected}"` } : {};
      const answer = await ask(`/api/documents/${encodeURIComponent(name)}`, { method: "PUT", body: text, headers });
      const { version } = await answer.json();
      if (name === this.name) {
        this.version = version;
        if (text === this.text) {
          localStorage.removeItem(draftKey(name));
          this.onState("saved", "");
        } else {
          localStorage.setItem(draftKey(name), JSON.stringify({ text: this.text, base: version } satisfies Draft));
        }
      }
    } catch (error) {
      if (error instanceof Refusal && error.kind === "changed") {
        this.onState("conflict", error.message);
      } else if (error instanceof Refusal) {
        this.onState("refused", error.message);
      } else {
        this.onState("away", "The server is away: your changes are kept in this browser.");
        this.timer = window.setTimeout(() => void this.save(force), AGAIN);
      }
    } finally {
      this.saving = false;
    }
  }

  /** After a conflict: writes what is here over the other. */
  overwrite(): void { void this.save(true); }

  /** After a conflict: forgets what is here. */
  forget(): void { localStorage.removeItem(draftKey(this.name)); }
}
