// The open document. Each change is stored in the browser at once and in its file soon after, so that it survives a
// crash of either side.
import { knownVersion, knowVersion } from "./history";
import { question } from "./messages";
import { ask, Refusal } from "./server";

interface Draft { text: string; base: string | null }

/** `lost`: neither the server nor the browser's storage takes the document. `shown`: it is only shown. */
export type State = "saved" | "saving" | "away" | "conflict" | "refused" | "lost" | "shown" | "none";

const DELAY = 400; // ms from a change to its request
const AGAIN = 1000; // ms between attempts to reach the server

const GATEWAY = new Set([502, 503, 504]); // a balancer without a server

const draftKey = (name: string): string => `fabserver draft ${name}`;

/** Gives the draft of a document to another name. */
export function moveDraft(from: string, to: string): void {
  const draft = localStorage.getItem(draftKey(from));
  localStorage.removeItem(draftKey(from));
  if (draft !== null) localStorage.setItem(draftKey(to), draft);
}

export function forgetDraft(name: string): void { localStorage.removeItem(draftKey(name)); }

export class Store {
  name = "";
  text = "";
  changedElsewhere = false; // whether the opened text is one that this browser neither wrote nor read before
  private version: string | null = null; // of the file; null: no file yet
  private timer = 0;
  private saving: Promise<void> | null = null;
  private unsaved = false; // whether the text is not in the file
  private kept = true; // whether the browser's storage has the text while it is not in the file
  private unanswered = new Set<string>(); // texts that were sent without an answer: the file may have them
  onState: (state: State, message: string) => void = () => {};

  constructor() {
    addEventListener("beforeunload", (event) => { if (this.atRisk) event.preventDefault(); });
  }

  /** Whether closing the document would lose changes: they are neither in its file nor in the browser's storage. */
  get atRisk(): boolean { return this.name !== "" && this.unsaved && !this.kept; }

  /** Reads a document, or its draft if that was not written to the file. Throws Refusal and TypeError. */
  async open(name: string): Promise<string> {
    await this.flush();
    const answer = await ask(`/api/documents/${encodeURIComponent(name)}`);
    const text = await answer.text(), version = answer.headers.get("ETag")?.replaceAll('"', "") ?? null;
    const draft = this.draft(name);
    const takesDraft = draft !== null && draft.text !== text && (draft.base === version || await question(
      `This browser has changes of “${name}” that are not in its file, which changed meanwhile. Whose are to be kept?`,
      "This browser's", "The file's") === 0);
    this.begun(name, text, version);
    // A draft that is in the file was written from here, though its answer did not come before the page was left.
    this.changedElsewhere = draft?.text !== text && version !== (knownVersion(name) ?? version);
    if (version) knowVersion(name, version);
    if (takesDraft) {
      this.changedElsewhere = false;
      this.change(draft.text);
    } else {
      forgetDraft(name);
      this.onState("saved", "");
    }
    return this.text;
  }

  /** Opens a document without a file: its draft in this browser, or "". The first change writes it. */
  async begin(name: string): Promise<string> {
    await this.flush();
    this.begun(name, "", null);
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

  /** Ends the work on the document without writing it. */
  close(state: State = "none", message = ""): void {
    this.begun("", "", null);
    this.onState(state, message);
  }

  private begun(name: string, text: string, version: string | null): void {
    clearTimeout(this.timer); // of the document before
    Object.assign(this, { name, text, version, unsaved: false, kept: true, changedElsewhere: false });
    this.unanswered.clear();
  }

  private draft(name: string): Draft | null {
    try {
      return JSON.parse(localStorage.getItem(draftKey(name)) ?? "null");
    } catch {
      return null;
    }
  }

  /** Stores the text in the browser, if that has space for it. */
  private keep(): void {
    try {
      const draft: Draft = { text: this.text, base: this.version };
      localStorage.setItem(draftKey(this.name), JSON.stringify(draft));
      this.kept = true;
    } catch {
      this.kept = false; // said where the server does not take it, either
    }
  }

  change(text: string): void {
    if (!this.name || text === this.text) return;
    this.text = text;
    this.unsaved = true;
    this.keep();
    this.onState("saving", "");
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.save(), DELAY);
  }

  /** Writes the changes that wait. */
  async flush(): Promise<void> {
    clearTimeout(this.timer);
    await this.saving;
    clearTimeout(this.timer);
    if (this.name && this.unsaved) await this.save();
  }

  private save(force = false): Promise<void> {
    if (this.saving) {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => void this.save(force), DELAY);
      return this.saving;
    }
    return this.saving = this.write(force).finally(() => { this.saving = null; });
  }

  private async write(force: boolean): Promise<void> {
    const { name, text } = this;
    if (!name || !this.unsaved) return;
    const again = (delay: number): void => {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => void this.save(force), delay);
    };
    try {
      const expected = force ? "*" : this.version;
      const headers: Record<string, string> = expected ? { "If-Match": expected === "*" ? "*" : `"${expected}"` } : {};
      const answer = await ask(`/api/documents/${encodeURIComponent(name)}`, { method: "PUT", body: text, headers });
      const { version } = await answer.json();
      if (name !== this.name) return;
      this.version = version;
      knowVersion(name, version);
      this.unanswered.clear();
      this.unsaved = text !== this.text;
      if (this.unsaved) return this.keep();
      forgetDraft(name);
      this.onState("saved", "");
    } catch (error) {
      if (name !== this.name) return;
      if (error instanceof Refusal && error.kind === "changed") {
        if (await this.isOurs(name)) again(0);
        else if (name === this.name) this.onState("conflict", error.message);
      } else if (error instanceof Refusal && !GATEWAY.has(error.status)) {
        this.onState("refused", error.message + (this.kept ? "" : "; closing this page loses the changes"));
      } else {
        this.unanswered.add(text);
        if (this.kept) this.onState("away", "The server is away: your changes are kept in this browser.");
        else this.onState("lost", "The server is away, and this browser's storage has no space: keep this page open.");
        again(AGAIN);
      }
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
  forget(): void {
    forgetDraft(this.name);
    this.unsaved = false;
  }
}
