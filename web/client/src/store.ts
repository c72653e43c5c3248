// The open document. Each change is stored in the browser at once and in its file soon after, so that it survives a
// crash of either side.
import { knownVersion, knowVersion } from "./history";
import { ask, Refusal } from "./server";

interface Draft { text: string; base: string | null }

const DELAY = 400; // ms from a change to its request
const AGAIN = 1000; // ms between attempts to reach the server

const GATEWAY = new Set([502, 503, 504]); // a balancer without a server

const draftKey = (name: string): string => `fabserver draft ${name}`;

export class Store {
  name = "";
  text = "";
  changedElsewhere = false; // whether the opened text is one that this browser neither wrote nor read before
  private version: string | null = null; // of the file; null: no file yet
  private timer = 0;
  private saving = false;
  private unanswered = new Set<string>(); // texts that were sent without an answer: the file may have them
  onState: (state: "saved" | "saving" | "away" | "conflict" | "refused" | "none", message: string) => void = () => {};

  /** Reads a document, or its draft if that was not written to the file. Throws Refusal and TypeError. */
  async open(name: string): Promise<string> {
    await this.flush();
    const answer = await ask(`/api/documents/${encodeURIComponent(name)}`);
    const text = await answer.text();
    this.name = name;
    this.unanswered.clear();
    this.version = answer.headers.get("ETag")?.replaceAll('"', "") ?? null;
    this.text = text;
    this.changedElsewhere = this.version !== (knownVersion(name) ?? this.version);
    if (this.version) knowVersion(name, this.version);
    const draft = this.draft(name);
    if (draft && draft.text !== text && (draft.base === this.version ||
        confirm(`This browser has changes of “${name}” that are not in its file, ` +
          "which changed meanwhile. Take the browser's?"))) {
      this.changedElsewhere = false;
      this.change(draft.text);
    } else {
      localStorage.removeItem(draftKey(name));
      this.onState("saved", "");
    }
    return this.text;
  }

  /** Opens a document without a file: its draft in this browser, or "". The first change writes it. */
  async begin(name: string): Promise<string> {
    await this.flush();
    this.name = name;
    this.unanswered.clear();
    this.version = null;
    this.text = "";
    const draft = this.draft(name);
    if (draft) this.change(draft.text);
    return this.text;
  }

  /** Creates a document and writes it at once. */
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
    } catch { /* the browser's storage is full; the file follows soon */ }
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
        knowVersion(name, version);
        this.unanswered.clear();
        if (text === this.text) {
          localStorage.removeItem(draftKey(name));
          this.onState("saved", "");
        } else {
          localStorage.setItem(draftKey(name), JSON.stringify({ text: this.text, base: version } satisfies Draft));
        }
      }
    } catch (error) {
      if (error instanceof Refusal && error.kind === "changed") {
        if (await this.isOurs(name)) this.timer = window.setTimeout(() => void this.save(force), 0);
        else this.onState("conflict", error.message);
      } else if (error instanceof Refusal && !GATEWAY.has(error.status)) {
        this.onState("refused", error.message);
      } else {
        this.unanswered.add(text);
        this.onState("away", "The server is away: your changes are kept in this browser.");
        this.timer = window.setTimeout(() => void this.save(force), AGAIN);
      }
    } finally {
      this.saving = false;
    }
  }

  /** Whether the file has a text of ours whose answer was lost with its server; takes its version then. */
  private async isOurs(name: string): Promise<boolean> {
    try {
      const answer = await ask(`/api/documents/${encodeURIComponent(name)}`);
      if (name !== this.name || !this.unanswered.delete(await answer.text())) return false;
      this.version = answer.headers.get("ETag")?.replaceAll('"', "") ?? null;
      return true;
    } catch {
      return false;
    }
  }

  /** After a conflict: overwrites the file. */
  overwrite(): void { void this.save(true); }

  /** After a conflict: discards the draft. */
  forget(): void { localStorage.removeItem(draftKey(this.name)); }
}
