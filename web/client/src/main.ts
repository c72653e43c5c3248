// The page: one document, its views, and the actions of the buttons.
import { offerFiles } from "./download";
import { by, element, pressed, short } from "./elements";
import { freeName, Gallery, languageOf, said } from "./gallery";
import { flushHistory, forgetHistory, type History, historyOf, keepHistory } from "./history";
import { Handles } from "./handles";
import { MachineView } from "./machine";
import { message, notice, question, questionOfText, versions } from "./messages";
import { Picture } from "./picture";
import { ask, Connection, type LibraryFunction, Refusal } from "./server";
import { documentIn, linkOf, reach } from "./share";
import { emptySheet, writeSheet } from "./sheet";
import { SheetView } from "./sheet_view";
import { Store } from "./store";
import { knowWords, TextView } from "./text_view";

const MOST_TEXT = 1_000_000, MOST_DOCUMENT = 4_000_000;
const connection = new Connection(), store = new Store();
const picture = new Picture(by("picture"), connection, "main"), above = new Picture(by("sheet"), connection, "sheet");
const handles = new Handles(picture), machine = new MachineView(), text = new TextView(), sheet = new SheetView(above);
const gallery = new Gallery({
  get name() { return store.name; }, open, create, close,
  flush: async () => { flushHistory(); await Promise.all([store.flush(), machine.flush()]); },
});
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

function language(): string { return kind === "sheet" ? "frep" : languageOf(store.name); }

/** Returns the model as it is now; null if it is empty. */
function model(): { text: string; language: string } | null {
  return made.trim() ? { text: made, language: language() } : null;
}

function show(content: string): void {
  const size = new Blob([content]).size;
  made = size > MOST_TEXT ? "" : content;
  const wanted = model();
  machine.follow(wanted);
  if (size > MOST_TEXT) {
    picture.hold();
    above.hold();
    tell([], size > MOST_DOCUMENT && kind === "text"
      ? `The text has ${short(size / 1e6)} MB: documents with more than ${MOST_DOCUMENT / 1e6} MB are not saved`
      : `The text has ${short(size / 1e6)} MB: texts with more than ${MOST_TEXT / 1e6} MB are not shown`);
    return;
  }
  picture.show(wanted);
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
  if (kind !== "text") return;
  store.change(now);
  keepHistory(store.name, () => text.history());
  show(now);
};
// Results of a sheet's nodes may come when another document is open already.
sheet.onText = (now) => { if (kind === "sheet") show(now); };
sheet.onChange = (document) => {
  if (kind !== "sheet") return;
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
    void machine.open(store.name, model());
}
by("machine").onclick = () => showMachine(!isOn("machine"));

// Documents

store.onState = (state, why) => {
  const chip = by("saved");
  const words = { saved: "Saved", saving: "Saving …", away: "Kept in this browser", conflict: "Changed elsewhere",
    refused: "Not saved", lost: "Only in this page", shown: "Not saved", none: "" }[state];
  chip.dataset.state = state;
  chip.title = why;
  chip.replaceChildren(words);
  if (state === "conflict") {
    const theirs = (): void => { store.forget(); void open(store.name); };
    chip.append(" ", ...versions(() => store.overwrite(), theirs));
  } else if (state === "refused" || state === "lost") chip.append(`: ${why}`);
};

connection.onState = (isOpen) => {
  by("away").hidden = isOpen;
  by("away").textContent = isOpen ? ""
    : "The server is away. Your changes are kept in this browser; the picture follows when it is back.";
};

by("close-notice").onclick = () => notice("");

/** Enables what acts on a document. */
function enable(on: boolean): void {
  for (const each of ["undo", "redo", "machine", "share", "download"]) by<HTMLButtonElement>(each).disabled = !on;
}

function display(name: string, content: string, kept: History | null = null): void {
  const isSheet = languageOf(name) === "json";
  kind = isSheet ? "sheet" : "text";
  made = "";
  by("empty").hidden = true;
  by("text-view").hidden = isSheet;
  by("sheet-view").hidden = !isSheet;
  by("name").textContent = name;
  document.title = `${name} – fabserver`;
  history.replaceState(null, "", `#${encodeURIComponent(name)}`);
  picture.measure(false);
  picture.aim(false);
  pressed(by("measure"), false);
  picture.show(null);
  Object.assign(picture.camera, { mode: "shaded", section: null, z: 0 });
  by<HTMLSelectElement>("mode").value = "shaded";
  by<HTMLSelectElement>("section").value = "";
  by("section-place").hidden = true;
  handles.follow([]);
  above.show(null);
  picture.fit();
  document.body.classList.add("has-document");
  showMachine(false);
  sheet.showText(false);
  enable(true);
  if (isSheet) {
    try {
      sheet.open(content, kept);
    } catch (error) {
      kind = "";  // shown unchanged, never written
      by("text-view").hidden = false;
      by("sheet-view").hidden = true;
      enable(false);
      store.close("shown", (error as Error).message);
      text.open(content, "json");
      text.allow(false);
      text.mark([], (error as Error).message);
      by("picture").classList.remove("stale");
    }
  } else {
    text.open(content, languageOf(name), kept);
    show(content);
  }
}

/** Asks before changes are lost that neither the file nor the browser's storage takes. */
async function mayLeave(): Promise<boolean> {
  await store.flush();
  return !store.atRisk || await question(
    `The changes of “${store.name}” are not saved, and would be lost. Leave it?`, "Leave", "Stay") === 0;
}

async function open(name: string): Promise<void> {
  try {
    flushHistory();
    if (!await mayLeave()) return;
    const content = await store.open(name), kept = await historyOf(name);
    display(name, content, kept);
    notice(kept && store.changedElsewhere
      ? `“${name}” was changed elsewhere: this is the newer version. Undo leads back to this browser's.` : "");
    gallery.close();
  } catch (error) {
    await message(said(error));
    if (!kind && !by<HTMLDialogElement>("gallery").open) void gallery.open();
  }
}

async function create(wanted: string, content: string): Promise<void> {
  const { documents } = await (await ask("/api/documents")).json();
  const name = freeName(wanted, new Set<string>(documents.map((each: { name: string }) => each.name)));
  flushHistory();
  if (!await mayLeave()) return;
  await Promise.all([store.create(name, content), forgetHistory(name)]);
  display(name, content);
  notice("");
  gallery.close();
}

/** Ends the work on the open document, which is removed or gets another name. */
async function close(): Promise<void> {
  showMachine(false);
  await machine.close();
  store.close();
  kind = made = "";
  picture.show(null);
  above.show(null);
  document.body.classList.remove("has-document");
  by("name").textContent = "Documents";
  by("empty").hidden = false;
  document.title = "fabserver";
  history.replaceState(null, "", location.pathname);
  notice("");
  enable(false);
}

const start = (wanted: string, content: string): void =>
  void create(wanted, content).catch((error) => message(said(error)));
by("open").onclick = by("open-empty").onclick = () => void gallery.open();
by("new-text").onclick = () => start("model.frep",
  "size = 20  # 5 to 60, the side\nr = 6      # 1 to 20, the hole\n" +
  "rounded_box(size, size, size / 2, 2) - cylinder(r, size)\n");
by("new-sheet").onclick = () => start("sheet.json", writeSheet(emptySheet()));

by("share").onclick = async () => {
  const link = await linkOf(store.name, store.text);
  try {
    await navigator.clipboard.writeText(link);
    notice(`A link that holds this model is copied. ${reach()}`);
  } catch {
    await questionOfText(`A link that holds this model. ${reach()}`, link, "Close");
  }
};

async function begin(): Promise<void> {
  enable(false);
  by("empty").hidden = false;
  const known: Promise<[{ functions: LibraryFunction[]; words: { name: string }[] }, { formats: string[] }]> =
    Promise.all(["/api/library", "/api/documents"].map(async (each) => (await ask(each)).json())) as never;
  const [{ functions, words }, { formats }] = await known;
  knowWords(words.map((each) => each.name));
  sheet.know(functions);
  offerFiles(formats, () => ({ text: made, language: language(), name: store.name }));
  const hash = location.hash.slice(1);
  if (hash.startsWith("share=")) {
    const given = await documentIn(hash);
    history.replaceState(null, "", location.pathname);
    if (!given) await message("This link holds no model");
    else if (await question(`This link holds a model, “${given.name}”. Add it to the documents of this folder?`,
      "Add it", "Leave it") === 0)
      return create(given.name, given.text);
    await gallery.open();
  } else if (hash) await open(decodeURIComponent(hash));
  else await gallery.open();
}

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
  section(null);
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
let keep: "below" | "above" = "below"; // the side of the section plane that is shown

/** Shows the section or the slice. `at`: its place, mm; null: where the slider is. */
function section(at: number | null): void {
  const axis = by<HTMLSelectElement>("section").value, { bounds, camera } = picture;
  const bar = by<HTMLInputElement>("section-at"), number = by<HTMLInputElement>("section-number");
  const slice = camera.mode === "bitmap" && !picture.flat, i = slice ? 2 : "xyz".indexOf(axis);
  by("section-place").hidden = !axis && !slice;
  by("section-flip").hidden = slice;
  camera.z = 0;
  camera.section = null;
  if ((axis || slice) && bounds) {
    const low = bounds[i], size = bounds[i + 3] - low;
    if (at === null) {
      at = low + size * Number(bar.value) / 1000;
      number.value = short(at);
    } else bar.value = String(1000 * (at - low) / size);
    if (slice) camera.z = at;
    else camera.section = { axis, at, keep };
  }
  picture.ask();
}
by("section").onchange = () => {
  keep = by<HTMLSelectElement>("section").value === "y" ? "above" : "below"; // the side away from the eye at first
  section(null);
};
by("section-at").oninput = () => section(null);
by<HTMLInputElement>("section-number").onchange = () => {
  const given = by<HTMLInputElement>("section-number");
  section(given.value === "" ? null : given.valueAsNumber);
};
by("section-flip").onclick = () => {
  keep = keep === "below" ? "above" : "below";
  section(by<HTMLInputElement>("section-number").valueAsNumber);
};

by("undo").onclick = () => (kind === "sheet" ? sheet.undo() : text.undo());
by("redo").onclick = () => (kind === "sheet" ? sheet.redo() : text.redo());
by("help").onclick = () => by<HTMLDialogElement>("keys").showModal();
by("close-keys").onclick = () => by<HTMLDialogElement>("keys").close();
addEventListener("keydown", (event) => {
  const target = event.target as HTMLElement, control = event.ctrlKey || event.metaKey;
  if (control && event.key === "o") { event.preventDefault(); void gallery.open(); return; }
  if (event.key === "F8" && kind) {
    event.preventDefault();
    if (kind === "sheet") sheet.nextMistake();
    else text.nextMistake();
    return;
  }
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
  hint.onpointerdown = (event) => event.stopPropagation(); // the picture would take the click
  by("picture").append(hint);
}

void begin().catch((error) => {
  by("away").hidden = false;
  by("away").textContent = error instanceof Refusal ? error.message
    : "The server is away. Reload the page when it is back.";
});
