// The page: one document, its views, and the actions of the buttons.
import { by, element, pressed } from "./elements";
import { flushHistory, forgetHistory, type History, historyOf, keepHistory } from "./history";
import { Handles } from "./handles";
import { MachineView } from "./machine";
import { Picture } from "./picture";
import { asOne, lookAt, textOfScan, upload } from "./scan";
import { ask, Connection, type LibraryFunction, post, Refusal } from "./server";
import { emptySheet, writeSheet } from "./sheet";
import { SheetView } from "./sheet_view";
import { Store } from "./store";
import { knowWords, TextView } from "./text_view";

const MOST_TEXT = 1_000_000;
const connection = new Connection(), store = new Store();
const picture = new Picture(by("picture"), connection, "main"), above = new Picture(by("sheet"), connection, "sheet");
const handles = new Handles(picture), machine = new MachineView(), text = new TextView(), sheet = new SheetView(above);
let kind: "" | "text" | "sheet" = "", made = "";

// Themes

const dark = matchMedia("(prefers-color-scheme: dark)");
function theme(): void {
  document.documentElement.dataset.theme = localStorage.getItem("fabserver theme") ?? (dark.matches ? "dark" : "light");
}
dark.addEventListener("change", theme);
theme();
by("theme").onclick = () => {
  localStorage.setItem("fabserver theme", document.documentElement.dataset.theme === "dark" ? "light" : "dark");
  theme();
};

// The model

function languageOf(name: string): string { return name.split(".").pop()!.toLowerCase(); }

function show(model: string): void {
  made = model;
  const language = kind === "sheet" ? "frep" : languageOf(store.name);
  if (new Blob([model]).size > MOST_TEXT) {
    tell([], `The text has more than ${MOST_TEXT / 1e6} MB: it is saved, and not shown`);
    return;
  }
  const wanted = model.trim() ? { text: model, language } : null;
  picture.show(wanted);
  machine.follow(wanted);
  if (kind === "sheet") above.show(wanted);
}

function tell(mistakes: Parameters<TextView["mark"]>[0], message: string | null): void {
  if (kind === "text") text.mark(mistakes, message);
  else if (kind === "sheet") sheet.mark(mistakes, message);
  by("picture").classList.toggle("stale", message !== null);
}

picture.onParameters = (answer) => {
  if (kind !== "text") return;
  text.follow(answer.parameters!);
  handles.follow(text.known);
};
handles.onMove = (values) => text.set(values);
picture.onError = (answer) => tell(answer?.mistakes ?? [], answer?.message ?? null);
picture.onPicture = (answer) => {
  if (answer.flat === undefined) return;
  by("right").classList.toggle("flat", answer.flat);
  machine.flat = answer.flat;
};
text.onChange = (now) => {
  store.change(now);
  keepHistory(store.name, () => text.history());
  show(now);
};
sheet.onText = show;
sheet.onChange = (document) => {
  store.change(document);
  keepHistory(store.name, () => sheet.history());
};

/** Shows the machine's panels in place of the document, or hides them. */
function showMachine(on: boolean): void {
  pressed(by("machine"), on);
  by("left").classList.toggle("machining", on);
  by("machine-view").hidden = !on;
  if (!on) machine.hide();
  else
    void machine.open(store.name,
      made.trim() ? { text: made, language: kind === "sheet" ? "frep" : languageOf(store.name) } : null);
}
by("machine").onclick = () => showMachine(!isOn("machine"));

// Documents

store.onState = (state, message) => {
  const chip = by("saved");
  const said = { saved: "Saved", saving: "Saving …", away: "Kept in this browser", conflict: "Changed elsewhere",
    refused: "Not saved", none: "" }[state];
  chip.dataset.state = state;
  chip.title = message;
  chip.replaceChildren(said);
  if (state === "conflict") {
    const mine = element("button", {}, "Keep mine"), theirs = element("button", {}, "Take theirs");
    mine.onclick = () => store.overwrite();
    theirs.onclick = () => { store.forget(); void open(store.name); };
    chip.append(" ", mine, " ", theirs);
  } else if (state === "refused") chip.append(`: ${message}`);
};

connection.onState = (isOpen) => {
  by("away").hidden = isOpen;
  by("away").textContent = isOpen ? ""
    : "The server is away. Your changes are kept in this browser; the picture follows when it is back.";
};

function notice(words: string): void {
  by("notice").hidden = !words;
  by("notice-words").textContent = words;
}
by("close-notice").onclick = () => notice("");

function display(name: string, content: string, kept: History | null = null): void {
  const isSheet = languageOf(name) === "json";
  kind = isSheet ? "sheet" : "text";
  by("text-view").hidden = isSheet;
  by("sheet-view").hidden = !isSheet;
  by("name").textContent = name;
  document.title = `${name} – fabserver`;
  history.replaceState(null, "", `#${encodeURIComponent(name)}`);
  picture.measure(false);
  pressed(by("measure"), false);
  picture.show(null);
  handles.follow([]);
  above.show(null);
  picture.fit();
  document.body.classList.add("has-document");
  showMachine(false);
  if (isSheet) {
    showText(false);
    try {
      sheet.open(content, kept);
    } catch (error) {
      kind = "text";  // shown unchanged, never written
      by("text-view").hidden = false;
      by("sheet-view").hidden = true;
      store.name = "";
      text.open(content, "json");
      text.mark([], (error as Error).message);
    }
  } else {
    text.open(content, languageOf(name), kept);
    show(content);
  }
}

async function open(name: string): Promise<void> {
  try {
    flushHistory();
    const content = await store.open(name), kept = await historyOf(name);
    display(name, content, kept);
    notice(kept && store.changedElsewhere
      ? `“${name}” was changed elsewhere: this is the newer version. Undo leads back to this browser's.` : "");
    by<HTMLDialogElement>("gallery").close();
  } catch (error) {
    alert(error instanceof Refusal ? error.message : "The server is away");
  }
}

async function create(wanted: string, content: string): Promise<void> {
  const { documents } = await (await ask("/api/documents")).json();
  const taken = new Set<string>(documents.map((each: { name: string }) => each.name));
  const [, stem, end] = /^(.*?)(\.\w+)$/.exec(wanted)!;
  let name = wanted;
  for (let i = 2; taken.has(name); ++i) name = `${stem} ${i}${end}`;
  flushHistory();
  await Promise.all([store.create(name, content), forgetHistory(name)]);
  display(name, content);
  notice("");
  by<HTMLDialogElement>("gallery").close();
}

// The gallery: documents and examples. A picture is rendered when its entry becomes visible.

async function modelOf(address: string, name: string): Promise<string> {
  const content = await (await ask(address)).text();
  return languageOf(name) === "json" ? JSON.parse(content).text ?? "" : content;
}

let drawing: Promise<unknown> = Promise.resolve();
const seen = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    seen.unobserve(target);
    const { address, name } = (target as HTMLElement).dataset, holder = target.querySelector(".thumb")!;
    drawing = drawing.then(async () => {  // one at a time: the open model has priority
      if (!by<HTMLDialogElement>("gallery").open) return;
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
    }).catch(() => holder.replaceChildren());
  }
});

function card(name: string, address: string, chosen: () => void): HTMLElement {
  const isSheet = languageOf(name) === "json";
  const made = element("button", { className: "card" }, element("span", { className: "thumb" }),
    element("span", { className: "caption" }, name.replace(/\.(frep|json)$/, ""),
      element("small", {}, isSheet ? "sheet" : languageOf(name))));
  Object.assign(made.dataset, { address, name });
  made.onclick = chosen;
  seen.observe(made);
  return made;
}

async function gallery(): Promise<void> {
  const dialog = by<HTMLDialogElement>("gallery");
  if (!dialog.open) dialog.showModal();
  try {
    const [{ documents }, { examples }] =
      await Promise.all([(await ask("/api/documents")).json(), (await ask("/api/examples")).json()]);
    by("documents").replaceChildren(...documents.filter((each: { name: string }) => !each.name.endsWith(".job")).map(
      ({ name }: { name: string }) => card(name, `/api/documents/${encodeURIComponent(name)}`, () => void open(name))));
    if (!documents.length) by("documents").append(element("p", { className: "quiet" }, "None yet."));
    const sheetsFirst = (examples as string[])
      .sort((a, b) => Number(b.endsWith(".json")) - Number(a.endsWith(".json")) || a.localeCompare(b));
    by("examples").replaceChildren(...sheetsFirst.map((name) => {
      const address = `/api/examples/${encodeURIComponent(name)}`;
      return card(name, address, async () => void create(name, await (await ask(address)).text()));
    }));
  } catch (error) {
    by("documents").replaceChildren(element("p", { className: "quiet" },
      error instanceof Refusal ? error.message : "The server is away."));
  }
}

by("open").onclick = () => void gallery();
by("close-gallery").onclick = () => by<HTMLDialogElement>("gallery").close();
by("new-text").onclick = () => void create("model.frep",
  "size = 20  # 5 to 60, the side\nr = 6      # 1 to 20, the hole\n" +
  "rounded_box(size, size, size / 2, 2) - cylinder(r, size)\n");
by("new-sheet").onclick = () => void create("sheet.json", writeSheet(emptySheet()));

by("new-scan").onclick = () => by("scan-file").click();
by<HTMLInputElement>("scan-file").onchange = async () => {
  const input = by<HTMLInputElement>("scan-file"), button = by<HTMLButtonElement>("new-scan");
  const files = [...input.files ?? []];
  if (!files.length) return;
  button.disabled = true;
  try {
    const { name: given, data } = await asOne(files, (share) => {
      button.textContent = `Packing ${Math.round(100 * share)} %`;
    });
    const { name, note } = await upload(given, data, (share) => {
      button.textContent = share < 1 ? `${Math.round(100 * share)} %` : "Reading …";
    }).catch((error) => {
      const there = /^there is a scan '(.+)' already$/.exec(error.message)?.[1];
      if (!there || !confirm(`${error.message}. Take that one?`)) throw error;
      return { name: there, note: "" };
    });
    button.textContent = "Reading …";
    await create(name.replace(/(\.nii)?\.\w+$/, "") + ".frep", textOfScan(name, await lookAt(name), note));
  } catch (error) {
    alert(error instanceof Refusal ? error.message : "The server is away");
  } finally {
    input.value = "";
    button.disabled = false;
    button.textContent = "Scan …";
  }
};

// Links that contain a model

async function packed(content: string): Promise<string> {
  const stream = new Blob([content]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return btoa(Array.from(bytes, (each) => String.fromCharCode(each)).join("")).replaceAll("+", "-").replaceAll("/", "_")
    .replaceAll("=", "");
}

async function unpacked(given: string): Promise<string> {
  const bytes = Uint8Array.from(atob(given.replaceAll("-", "+").replaceAll("_", "/")), (each) => each.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
}

by("share").onclick = async () => {
  const link = `${location.origin}/#share=${await packed(JSON.stringify({ name: store.name, text: store.text }))}`;
  try {
    await navigator.clipboard.writeText(link);
    by("share").textContent = "Copied";
  } catch {
    prompt("A link that holds this model:", link);
  }
  setTimeout(() => { by("share").textContent = "Share"; }, 1500);
};

async function begin(): Promise<void> {
  const known: Promise<[{ functions: LibraryFunction[]; words: { name: string }[] }, { formats: string[] }]> =
    Promise.all(["/api/library", "/api/documents"].map(async (each) => (await ask(each)).json())) as never;
  const [{ functions, words }, { formats }] = await known;
  knowWords(words.map((each) => each.name));
  sheet.know(functions);
  by("download").append(...formats.map((each) => element("option", { value: each }, each.slice(1))));
  const hash = location.hash.slice(1);
  if (hash.startsWith("share=")) {
    try {
      const { name, text: content } = JSON.parse(await unpacked(hash.slice(6)));
      await create(/^[A-Za-z0-9][\w .+-]{0,80}\.(frep|json)$/.test(name) ? name : "shared.frep", String(content));
    } catch {
      alert("This link holds no model");
      await gallery();
    }
  } else if (hash) await open(decodeURIComponent(hash));
  else await gallery();
}

// Files

by<HTMLSelectElement>("download").onchange = async () => {
  const menu = by<HTMLSelectElement>("download"), extension = menu.value, first = menu.options[0];
  menu.value = "";
  if (!extension || !made.trim()) return;
  try {
    let job = await post<{ job: string; state: string; progress: number; error: { message: string } | null;
      result: { certain?: boolean } }>(
        "/api/files", { text: made, language: kind === "sheet" ? "frep" : languageOf(store.name), extension });
    while (job.state === "waiting" || job.state === "working") {
      first.textContent = `${extension.slice(1)}: ${Math.round(100 * job.progress)} %`;
      job = await (await ask(`/api/jobs/${job.job}?state=${job.state}&progress=${job.progress}`)).json();
    }
    if (job.state !== "done") throw new Refusal(422, job.state, job.error?.message ?? "It was cancelled");
    const download = store.name.replace(/\.\w+$/, "") + extension;
    const link = element("a", { href: `/api/jobs/${job.job}/file?name=${encodeURIComponent(download)}`, download });
    link.click();
    if (job.result?.certain === false) alert("The file is written. It may lack parts that are thinner than its cells.");
  } catch (error) {
    alert(error instanceof Refusal ? error.message : "The server is away");
  } finally {
    first.textContent = "Download";
  }
};

// Views and keys

const views: Record<string, [number, number]> = { iso: [0.5, -0.95], top: [0, 0], front: [0, -Math.PI / 2],
  right: [-Math.PI / 2, -Math.PI / 2] };
by("views").onclick = (event) => {
  const view = (event.target as HTMLElement).dataset.view;
  if (view) picture.look(...views[view]);
};
by("fit").onclick = () => picture.fit();
by("fit-sheet").onclick = () => sheet.fit();
by<HTMLSelectElement>("mode").onchange = () => {
  const was = picture.twoD;
  picture.camera.mode = by<HTMLSelectElement>("mode").value;
  section();
  if (was !== picture.twoD) picture.fit();
  else picture.ask();
};
function toggle(id: string, now: boolean, act: (on: boolean) => void): void {
  pressed(by(id), now);
  act(now);
}
function isOn(id: string): boolean { return by(id).getAttribute("aria-pressed") === "true"; }
by("perspective").onclick = () => toggle("perspective", !isOn("perspective"), (on) => {
  picture.camera.perspective = on ? 0.6 : 0;
  handles.place();
  picture.ask();
});
by("measure").onclick = () => toggle("measure", !isOn("measure"), (on) => picture.measure(on));
function section(): void {
  const axis = by<HTMLSelectElement>("section").value;
  const bar = by<HTMLInputElement>("section-at");
  const i = "xyz".indexOf(axis);
  const { bounds } = picture, share = Number(bar.value) / 1000;
  const slice = picture.camera.mode === "bitmap" && !picture.flat;
  bar.hidden = !axis && !slice;
  picture.camera.z = slice && bounds ? bounds[2] + (bounds[5] - bounds[2]) * share : 0;
  picture.camera.section = axis && bounds
    ? { axis, at: bounds[i] + (bounds[i + 3] - bounds[i]) * share,
      keep: axis === "y" ? "above" : "below" }
    : null;
  picture.ask();
}
by("section").onchange = by("section-at").oninput = section;

/** Shows a sheet's generated text, read-only, in place of the inspector. */
function showText(on: boolean): void {
  pressed(by("show-text"), on);
  by("sheet-view").classList.toggle("with-text", on);
  by("made")?.remove();
  if (on) by("sheet-view").append(element("pre", { id: "made" }, made));
}
by("show-text").onclick = () => showText(!isOn("show-text"));

by("undo").onclick = () => (kind === "sheet" ? sheet.undo() : text.undo());
by("redo").onclick = () => (kind === "sheet" ? sheet.redo() : text.redo());
by("help").onclick = () => by<HTMLDialogElement>("keys").showModal();
by("close-keys").onclick = () => by<HTMLDialogElement>("keys").close();
addEventListener("keydown", (event) => {
  const target = event.target as HTMLElement, control = event.ctrlKey || event.metaKey;
  if (control && event.key === "o") { event.preventDefault(); void gallery(); return; }
  if (target.closest(".cm-editor, input, select, textarea, dialog")) return;
  if (control && event.key.toLowerCase() === "z") {
    event.preventDefault();
    by(event.shiftKey ? "redo" : "undo").click();
  } else if (control && event.key === "y") { event.preventDefault(); by("redo").click(); }
  if (control || event.altKey) return;
  const keys: Record<string, () => void> = {
    f: () => (target.closest("#sheet") ? sheet.fit() : picture.fit()), p: () => by("perspective").click(),
    m: () => by("measure").click(), "?": () => by("help").click(),
    1: () => picture.look(...views.iso), 2: () => picture.look(...views.top), 3: () => picture.look(...views.front),
    4: () => picture.look(...views.right),
  };
  keys[event.key]?.();
});

// Widths of the panes

const divider = by("divider");
function width(wanted: number): void {
  const share = Math.min(80, Math.max(15, wanted));
  document.documentElement.style.setProperty("--left", `${share}%`);
  divider.setAttribute("aria-valuenow", String(Math.round(share)));
}
divider.onpointerdown = (event) => {
  divider.setPointerCapture(event.pointerId);
  divider.onpointermove = (next) => width(100 * next.clientX / innerWidth);
  divider.onpointerup = () => { divider.onpointermove = null; };
};
divider.onkeydown = (event) => {
  const now = 100 * by("left").clientWidth / innerWidth;
  if (event.key === "ArrowLeft") width(now - 2);
  if (event.key === "ArrowRight") width(now + 2);
};

// A hint on the first visit

if (!localStorage.getItem("fabserver hint")) {
  const hint = element("div", { id: "hint" },
    matchMedia("(pointer: coarse)").matches ? "One finger turns, two move and zoom. Fit shows all."
      : "Drag turns, the wheel zooms to the pointer, right drag moves. F shows all.");
  const close = element("button", { ariaLabel: "Close the hint" }, "✕");
  close.onclick = () => { localStorage.setItem("fabserver hint", "seen"); hint.remove(); };
  hint.append(close);
  by("picture").append(hint);
}

void begin().catch((error) => {
  by("away").hidden = false;
  by("away").textContent = error instanceof Refusal ? error.message
    : "The server is away. Reload the page when it is back.";
});
