// The gallery: documents, scans and examples. A picture is rendered when its entry becomes visible.
import { by, element } from "./elements";
import { moveHistory } from "./history";
import { menu } from "./menu";
import { message, question, questionOfText } from "./messages";
import { asOne, lookAt, textOfScan, upload } from "./scan";
import { ask, Refusal } from "./server";
import { forgetDraft, moveDraft } from "./store";

export function languageOf(name: string): string { return name.split(".").pop()!.toLowerCase(); }

export function said(error: unknown): string {
  return error instanceof Refusal ? error.message : error instanceof TypeError ? "The server is away"
    : (error as Error).message;
}

/** What the gallery does to the page. */
export interface Host {
  readonly name: string; // of the open document; "": none
  open(name: string): Promise<void>;
  create(wanted: string, content: string): Promise<void>;
  flush(): Promise<void>; // writes the changes that wait
  close(): Promise<void>; // ends the work on the open document
}

interface Listed { documents: { name: string }[]; scans: string[] }

const documentAt = (name: string): string => `/api/documents/${encodeURIComponent(name)}`;
const listed = async (): Promise<Listed> => (await ask("/api/documents")).json();

async function read(name: string): Promise<{ text: string; version: string }> {
  const answer = await ask(documentAt(name));
  return { text: await answer.text(), version: answer.headers.get("ETag") ?? "" };
}

/** Writes a new document; one that is there is not replaced. */
async function writeNew(name: string, text: string): Promise<void> {
  await ask(documentAt(name), { method: "PUT", body: text });
}

async function remove(name: string, version: string): Promise<void> {
  await ask(documentAt(name), { method: "DELETE", headers: { "If-Match": version } });
}

const stemOf = (name: string): string => name.replace(/\.\w+$/, "");

/** Returns the name with a number, where documents with that name exist. */
export function freeName(wanted: string, taken: Set<string>): string {
  const [, stem, end] = /^(.*?)(\.\w+)$/.exec(wanted)!;
  let name = wanted;
  for (let i = 2; taken.has(name); ++i) name = `${stem} ${i}${end}`;
  return name;
}

async function modelOf(address: string, name: string): Promise<string> {
  const content = await (await ask(address)).text();
  return languageOf(name) === "json" ? JSON.parse(content).text ?? "" : content;
}

export class Gallery {
  private dialog = by<HTMLDialogElement>("gallery");
  private drawing: Promise<unknown> = Promise.resolve();
  private seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      this.seen.unobserve(target);
      this.drawing = this.drawing.then(() => this.draw(target as HTMLElement)); // one at a time: the model goes first
    }
  });

  constructor(private host: Host) {
    by("close-gallery").onclick = () => this.close();
    by("new-scan").onclick = () => by("scan-file").click();
    by("scan-file").onchange = () => void this.uploadScan();
  }

  close(): void { this.dialog.close(); }

  async open(): Promise<void> {
    this.tell("");
    if (!this.dialog.open) this.dialog.showModal();
    await this.list();
  }

  private tell(words: string, label = "", act = (): void => {}): void {
    const line = by("gallery-told");
    line.hidden = !words;
    line.replaceChildren(words);
    if (!label) return;
    const button = element("button", {}, label);
    button.onclick = () => { this.tell(""); act(); };
    line.append(" ", button);
  }

  private async draw(card: HTMLElement): Promise<void> {
    const { address, name } = card.dataset, holder = card.querySelector(".thumb")!;
    try {
      if (!this.dialog.open || !card.isConnected) return;
      const model = await modelOf(address!, name!);
      if (!model.trim()) return;
      const language = languageOf(name!) === "json" ? "frep" : languageOf(name!);
      const answer = await ask("/api/picture",
        { method: "POST", body: JSON.stringify({ text: model, language, width: 240, height: 160, smooth: true }) });
      const flat = JSON.parse(answer.headers.get("Fieldfab-Picture")!).flat;
      const image = element("img", { src: URL.createObjectURL(await answer.blob()), alt: "" });
      if (flat) {  // white inside, black outside: a mask
        const shape = element("span", { className: "mask" });
        shape.style.maskImage = `url("${image.src}")`;
        holder.replaceChildren(shape);
      } else holder.replaceChildren(image);
    } catch { holder.replaceChildren(); }
  }

  private card(name: string, address: string, chosen: () => void): HTMLElement {
    const made = element("button", { className: "card" }, element("span", { className: "thumb" }),
      element("span", { className: "caption" }, name.replace(/\.(frep|json)$/, ""),
        element("small", {}, languageOf(name) === "json" ? "sheet" : languageOf(name))));
    Object.assign(made.dataset, { address, name });
    made.onclick = chosen;
    this.seen.observe(made);
    return made;
  }

  /** Adds a button with the actions on an entry. */
  private withActions(entry: HTMLElement, name: string, actions: Record<string, () => Promise<void>>): HTMLElement {
    const more = element("button", { className: "more", ariaLabel: `Actions on ${name}`,
      title: Object.keys(actions).join(", ") }, "⋯");
    menu(more, () => Object.entries(actions).map(([words, act]) => ({ words, act: () => void this.run(act) })));
    const made = element("div", { className: "entry" }, entry, more);
    made.dataset.name = name;
    return made;
  }

  private async run(act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      this.tell(said(error));
    }
  }

  private async list(): Promise<void> {
    try {
      const [{ documents, scans }, { examples }] = await Promise.all([listed(), (await ask("/api/examples")).json()]);
      by("documents").replaceChildren(...documents.filter(({ name }) => !name.endsWith(".job")).map(({ name }) =>
        this.withActions(this.card(name, documentAt(name), () => void this.host.open(name)), name, {
          "Rename …": () => this.rename(name), Duplicate: () => this.duplicate(name),
          Delete: () => this.remove(name),
        })));
      if (!by("documents").childElementCount) by("documents").append(element("p", { className: "quiet" }, "None yet."));
      by("scans-head").hidden = !scans.length;
      by("scans").replaceChildren(...scans.map((name) => {
        const entry = element("button", { className: "card", title: "Make a text that shows it" },
          element("span", { className: "caption" }, name, element("small", {}, "scan")));
        entry.onclick = () => void this.run(() => this.useScan(name, ""));
        return this.withActions(entry, name, { Delete: () => this.removeScan(name) });
      }));
      const sheetsFirst = (examples as string[])
        .sort((a, b) => Number(b.endsWith(".json")) - Number(a.endsWith(".json")) || a.localeCompare(b));
      by("examples").replaceChildren(...sheetsFirst.map((name) => {
        const address = `/api/examples/${encodeURIComponent(name)}`;
        return this.card(name, address, () => void this.run(async () =>
          this.host.create(name, await (await ask(address)).text())));
      }));
    } catch (error) {
      by("documents").replaceChildren(element("p", { className: "quiet" }, said(error)));
    }
  }

  // Documents

  /** Returns the job that belongs to a document, if no other document has the same one. */
  private jobOf(name: string, names: Set<string>): string | null {
    const job = `${stemOf(name)}.job`;
    const shared = [...names].some((each) => each !== name && each !== job && stemOf(each) === stemOf(name));
    return names.has(job) && !shared ? job : null;
  }

  private async rename(name: string): Promise<void> {
    const wanted = (await questionOfText(`The new name of “${name}”`, stemOf(name), "Rename"))?.trim();
    if (!wanted || wanted === stemOf(name)) return;
    const end = name.slice(stemOf(name).length);
    const to = wanted.toLowerCase().endsWith(end.toLowerCase()) ? wanted : wanted + end;
    await this.host.flush();
    const names = new Set((await listed()).documents.map((each) => each.name)), job = this.jobOf(name, names);
    const pairs = [[name, to], ...(job ? [[job, `${stemOf(to)}.job`]] : [])];
    for (const [, each] of pairs)
      if (names.has(each)) throw new Error(`There is a document “${each}” already`);
    await this.takingAway(name, async () => {
      const wasOpen = this.host.name === name;
      for (const [from, each] of pairs) {
        const { text, version } = await read(from);
        await writeNew(each, text);
        await remove(from, version);
        moveDraft(from, each);
        await moveHistory(from, each);
      }
      if (!wasOpen) return;
      await this.host.close();
      await this.host.open(to);
    });
  }

  /** Does what takes a document away, and lists again. Its card goes first: its picture may still wait to be drawn,
   *  which would ask for a document that is no more. */
  private async takingAway(name: string, act: () => Promise<void>): Promise<void> {
    by("documents").querySelector(`.entry[data-name="${CSS.escape(name)}"]`)?.remove();
    try {
      await act();
    } finally {
      await this.list();
    }
  }

  private async duplicate(name: string): Promise<void> {
    await this.host.flush();
    const names = new Set((await listed()).documents.map((each) => each.name)), to = freeName(name, names);
    await writeNew(to, (await read(name)).text);
    const job = `${stemOf(name)}.job`, copy = `${stemOf(to)}.job`;
    if (names.has(job) && !names.has(copy)) await writeNew(copy, (await read(job)).text);
    await this.list();
    this.tell(`“${to}” is a copy of “${name}”.`);
  }

  private async remove(name: string): Promise<void> {
    await this.host.flush();
    const names = new Set((await listed()).documents.map((each) => each.name)), job = this.jobOf(name, names);
    const gone: { name: string; text: string }[] = [];
    await this.takingAway(name, async () => {
      for (const each of job ? [name, job] : [name]) {
        const { text, version } = await read(each);
        await remove(each, version);
        forgetDraft(each);
        gone.push({ name: each, text });
      }
      if (this.host.name === name) await this.host.close();
    });
    this.tell(`“${name}” is deleted${job ? ", and its job" : ""}.`, "Undo", () => void this.run(async () => {
      for (const each of gone) await writeNew(each.name, each.text);
      await this.list();
    }));
  }

  // Scans

  private async useScan(name: string, note: string): Promise<void> {
    this.tell(`Reading “${name}” …`);
    const scan = await lookAt(name);
    this.tell("");
    await this.host.create(name.replace(/(\.nii)?\.\w+$/, "") + ".frep", textOfScan(name, scan, note));
  }

  private async removeScan(name: string): Promise<void> {
    if (await question(`Delete the scan “${name}”? It cannot be brought back, and texts that open it show nothing.`,
      "Delete", "Keep it") !== 0) return;
    await ask(`/api/scans/${encodeURIComponent(name)}`, { method: "DELETE" });
    await this.list();
  }

  private async uploadScan(): Promise<void> {
    const input = by<HTMLInputElement>("scan-file"), button = by<HTMLButtonElement>("new-scan");
    const files = [...input.files ?? []];
    input.value = ""; // so that the same files can be chosen again
    if (!files.length) return;
    const ended = new AbortController();
    const told = (words: string): void => {
      if (!ended.signal.aborted) this.tell(words, "Cancel", () => ended.abort());
    };
    button.disabled = true;
    try {
      const { name: given, data } = await asOne(files, (share) => told(`Packing ${Math.round(100 * share)} %`));
      ended.signal.throwIfAborted();
      const { name, note } = await upload(given, data, (share) =>
        told(share < 1 ? `Uploading ${Math.round(100 * share)} %` : "Reading …"), ended.signal).catch(async (error) => {
        const there = /^there is a scan '(.+)' already$/.exec(error.message)?.[1];
        if (!there || await question(`There is a scan “${there}” already. Use that one?`, "Use it", "Cancel") !== 0)
          throw error;
        return { name: there, note: "" };
      });
      ended.signal.throwIfAborted();
      await this.useScan(name, note);
    } catch (error) {
      this.tell("");
      if (!ended.signal.aborted) void message(said(error));
      else await this.list();
    } finally {
      button.disabled = false;
    }
  }
}

