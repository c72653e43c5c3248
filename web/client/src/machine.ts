// The Machine view: the workflow as stacked panels (Keeter 6), made from fieldfab.cam's tables. Plans and simulations
// are shown in 3D.
import { by, element, short } from "./elements";
import { versions } from "./messages";
import { ask, post, Refusal } from "./server";
import type { Playback } from "./playback";
import { Store } from "./store";

type Value = number | string | boolean;
type Values = Record<string, Value>;
interface Setting {
  name: string; help: string; unit: string; kind: "flag" | "number" | "text" | "list"; default: Value | null;
  lower: number | null; upper: number | null; whole: boolean;
  choices: string[]; needs: string; needs_values: string[];
  follows?: string; // instead of a default: what the value follows from
}
interface Machine {
  id: string; name: string; description: string; takes: string; settings: Setting[]; materials: Record<string, Values>
}
interface Operation { name: string; help: string; settings: Setting[] }
interface Tables { machines: Machine[]; operations: Operation[]; joining: Setting[] }
interface JobText {
  format: "fieldfab job"; version: 1; machine: string; material: string; setting: Values; zero: string; stock: Values;
  tools: Values[]; operations: Values[]; adjust_feeds?: boolean
}
interface Told {
  program: string; notes: string[]; seconds: number; planned_seconds: number; stock: number[];
  reports: { name: string; cut: number; rapid: number; seconds: number }[];
  good?: boolean; events?: { kind: string; line: number; amount: number }[]; removed?: number; simulated?: number;
}
interface Job {
  job: string; state: string; progress: number; message: string; error: { message: string } | null; result: Told | null
}

const number = (name: string, help: string, unit = "mm", standard: number | null = null): Setting =>
  ({ name, help, unit, kind: "number", default: standard, lower: 0, upper: null, whole: false, choices: [], needs: "",
    needs_values: [] });
const choice = (name: string, help: string, choices: string[]): Setting =>
  ({ ...number(name, help, ""), kind: "text", default: choices[0], choices });
const TOOL: Setting[] = [
  choice("shape", "of the cutting part", ["flat", "ball", "bull", "v", "tapered", "drill"]),
  number("diameter", "of the cutting part"),
  { ...number("corner_radius", "of a bull nose"), needs: "shape", needs_values: ["bull"] },
  { ...number("angle", "of the tip", "degrees"), needs: "shape", needs_values: ["v", "tapered", "drill"] },
  { ...number("tip_diameter", "of a blunt tip"), needs: "shape", needs_values: ["v", "tapered"] },
  number("flute", "length that cuts"), number("length", "from the tip to the holder"),
  number("shank", "diameter of the shank"), number("holder_diameter", "of the holder"),
  number("holder_length", "of the holder"), { ...number("flutes", "number of cutting edges", "", 2), whole: true },
  number("feed", "of cuts", "mm/min"), number("plunge", "feed of plunges", "mm/min"),
  number("spindle", "speed of the spindle", "rpm"),
];
const STOCK: Setting[] = [number("margin", "about the part", "mm", 0), number("top", "above the part", "mm", 0),
  number("thickness", "of a flat part")];
const ZERO = choice("zero",
  "where the program's zero is: as the model has it, or at the corner or the centre of its top",
  ["model", "corner", "centre"]);

const FEEDS: Setting = {
  ...number("adjust_feeds", "to the material that each move removes: slower in corners, faster in air", ""),
  kind: "flag",
};

/** Returns a default job. `sampled`: the model is a scan or a mesh; a lattice as fine as its samples suffices. */
function fresh(flat: boolean, sampled: boolean): JobText {
  const lattice: Values = sampled ? { cell: 0.5, surface_tolerance: 0.1, tolerance: 0.1 } : {};
  return {
    format: "fieldfab job", version: 1, machine: "linuxcnc", material: "", setting: {}, zero: "corner",
    stock: flat ? { margin: 5, thickness: 3 } : { margin: 2, top: 1 },
    tools: [{ number: 1, shape: "flat", diameter: flat ? 3 : 6, flute: 20, length: 40 }],
    operations: flat ? [{ type: "profile", tool: 1 }]
      : [{ type: "rough", tool: 1, ...lattice }, { type: "finish", tool: 1, stepover: 0.3, ...lattice }],
  };
}

type Model = { text: string; language: string };

const isTable = (value: unknown): boolean => typeof value === "object" && value !== null && !Array.isArray(value);

/** Reads a job's file. Throws Error with a description of the fault. */
function readJob(name: string, text: string): Partial<JobText> {
  let given: Partial<JobText>;
  try {
    given = JSON.parse(text);
  } catch (error) {
    throw new Error(`${name} is not a job: ${(error as Error).message}. It is left as it is`, { cause: error });
  }
  if (given?.format !== "fieldfab job") throw new Error(`${name} is not a job of fabserver. It is left as it is`);
  if (given.version !== 1)
    throw new Error(`${name} is of version ${given.version}; this page knows version 1. ` +
      "It is left as it is: open it with a newer Fieldfab");
  const { tools = [], operations = [], setting = {}, stock = {} } = given;
  const lists = [tools, operations].every((each) => Array.isArray(each) && each.every(isTable));
  if (!lists || !isTable(setting) || !isTable(stock))
    throw new Error(`${name} is not a job: its tools, operations, stock or settings are not tables. ` +
      "It is left as it is");
  return given;
}

function time(seconds: number): string {
  const minutes = Math.floor(seconds / 60);
  return minutes ? `${minutes} min ${Math.round(seconds % 60)} s` : `${short(seconds, 3)} s`;
}

export class MachineView {
  private tables: Tables | null = null;
  private job: JobText = fresh(false, false);
  private store = new Store();
  private name = "";
  private running: Job | null = null;
  private playback: Playback | null = null;
  private model: Model | null = null;
  private usable = false; // whether there is a job that can be planned
  private stopped = false; // whether the user ended the job that runs
  private shown: { model: Model | null; job: string } | null = null; // of which the results are
  flat = false;

  constructor() {
    by("plan").onclick = () => void this.run(false);
    by("simulate").onclick = () => void this.run(true);
    by("stop-job").onclick = () => {
      this.stopped = true;
      if (this.running?.job) void ask(`/api/jobs/${this.running.job}`, { method: "DELETE" }).catch(() => {});
    };
    this.store.onState = (state, message) => {
      const said = { saved: "", saving: "", away: "The job is kept in this browser",
        conflict: "The job was changed elsewhere", refused: `The job is not saved: ${message}`,
        lost: "The job is not saved: keep this page open", shown: "The job is not saved", none: "" }[state];
      by("job-state").replaceChildren(said);
      if (state !== "conflict") return;
      const theirs = (): void => { this.store.forget(); void this.load(this.name); };
      by("job-state").append(" ", ...versions(() => this.store.overwrite(), theirs));
    };
  }

  /** Shows the job of a document, or a default one. */
  async open(document: string, model: Model | null): Promise<void> {
    this.follow(model);
    const name = document.replace(/\.\w+$/, "") + ".job";
    if (this.name !== name) await this.load(name);
  }

  private async load(name: string): Promise<void> {
    this.name = name;
    this.hide();
    by("panels").replaceChildren();
    this.forgetResults();
    this.tell("");
    this.use(false);
    try {
      this.tables ??= await (await ask("/api/machining")).json();
      const { documents } = await (await ask("/api/documents")).json();
      const text = documents.some((each: { name: string }) => each.name === name) ? await this.store.open(name)
        : await this.store.begin(name);
      if (this.name !== name) return;
      const given = text ? readJob(name, text) : {};
      this.job = { ...fresh(this.flat, /\bopen\s*\(/.test(this.model?.text ?? "")), ...given };
      this.draw();
      this.use(true);
    } catch (error) {
      if (this.name !== name) return;
      this.name = "";
      this.store.close(error instanceof TypeError ? "none" : "shown");
      this.tell(error instanceof TypeError ? "The server is away" : (error as Error).message);
    }
  }

  /** Ends the work on the job, whose document is removed or gets another name. */
  async close(): Promise<void> {
    await this.store.flush();
    this.name = "";
    this.store.close();
  }

  /** Writes the changes that wait. */
  flush(): Promise<void> { return this.store.flush(); }

  follow(model: Model | null): void {
    this.model = model;
    this.compare();
  }

  private use(on: boolean): void {
    this.usable = on;
    this.enable();
  }

  private enable(): void {
    for (const each of ["plan", "simulate"])
      by<HTMLButtonElement>(each).disabled = !this.usable || this.running !== null;
  }

  private forgetResults(): void {
    this.shown = null;
    by("job-result").replaceChildren();
    this.compare();
  }

  /** Marks results of an earlier model or job, and takes away what could be milled or believed. */
  private compare(): void {
    const { shown, model } = this;
    const isOld = shown !== null && (shown.model?.text !== model?.text || shown.model?.language !== model?.language ||
      shown.job !== JSON.stringify(this.job));
    by("job-result").classList.toggle("old", isOld);
    by("stage").classList.toggle("old", isOld);
    for (const each of by("job-result").querySelectorAll<HTMLElement>("[data-when]"))
      each.hidden = (each.dataset.when === "old") !== isOld;
  }

  private changed(): void {
    this.store.change(JSON.stringify(this.job, null, 1) + "\n");
    this.compare();
  }

  // Panels

  private row(setting: Setting, values: Values, again: () => void): HTMLElement {
    const label = setting.name[0].toUpperCase() + setting.name.slice(1).replaceAll("_", " ");
    const now = values[setting.name];
    const set = (value: Value | null): void => {
      if (value === null) delete values[setting.name];
      else values[setting.name] = value;
      this.changed();
      again();
    };
    let input: HTMLInputElement | HTMLSelectElement;
    if (setting.choices.length) {
      input = element("select", {}, ...setting.choices.map((each) => element("option", { value: each }, each)));
      input.value = String(now ?? setting.default);
      input.onchange = () => set(input.value);
    } else if (setting.kind === "flag") {
      const box = input = element("input", { type: "checkbox", checked: Boolean(now ?? setting.default) });
      box.onchange = () => set(box.checked);
    } else {
      const box = input = element("input", {
        type: setting.kind === "number" ? "number" : "text", step: "any",
        placeholder: setting.follows ?? (setting.default === null ? "auto" : String(setting.default)),
        value: now === undefined ? "" : String(now),
      });
      if (setting.lower !== null) box.min = String(setting.lower);
      if (setting.upper !== null) box.max = String(setting.upper);
      box.onchange = () => set(box.value === "" ? null : setting.kind === "number" ? Number(box.value) : box.value);
    }
    input.dataset.setting = setting.name;
    return element("label", { className: "setting", title: setting.help }, element("span", {}, label), input,
      element("small", {}, setting.unit));
  }

  /** `changed`: called after each change. */
  private rows(settings: Setting[], values: Values, changed = (): void => {}): HTMLElement {
    const host = element("div", { className: "settings" });
    const fill = (): void => {
      const isFirst = (each: Setting, i: number): boolean =>
        settings.findIndex((other) => other.name === each.name) === i;
      const matters = settings.filter((each, i) => isFirst(each, i) && each.kind !== "list").filter((each) => {
        const needed = settings.find((other) => other.name === each.needs);
        if (!needed) return true;
        const value = values[needed.name] ?? needed.default;
        return each.needs_values.length ? each.needs_values.includes(String(value)) : Boolean(value);
      });
      host.replaceChildren(...matters.map((each) => this.row(each, values, () => {
        if (settings.some((other) => other.needs === each.name)) fill();
        changed();
      })));
    };
    fill();
    return host;
  }

  private panel(title: string, open: boolean, ...content: (Node | string)[]): HTMLDetailsElement {
    return element("details", { className: "panel", open }, element("summary", {}, title), ...content);
  }

  private choose(label: string, options: [string, string][], now: string, set: (value: string) => void): HTMLElement {
    const select = element("select", {}, ...options.map(([value, words]) => element("option", { value }, words)));
    select.value = now;
    select.dataset.setting = label.toLowerCase();
    select.onchange = () => { set(select.value); this.changed(); this.draw(); };
    return element("label", { className: "setting" }, element("span", {}, label), select, element("small"));
  }

  /** Returns a list of tables, each a panel. Panels can be added, moved and removed. */
  private list(title: string, items: Values[], made: () => Values,
      panel: (item: Values, i: number) => HTMLElement): HTMLElement {
    const add = element("button", { ariaLabel: `Add to ${title.toLowerCase()}` }, "+");
    add.onclick = () => { items.push(made()); this.changed(); this.draw(); };
    const host = this.panel(title, true, ...items.map((item, i) => {
      const shown = panel(item, i);
      const buttons = ([["↑", "Earlier", -1], ["✕", "Remove", 0]] as const).map(([sign, words, way]) => {
        const button = element("button", { ariaLabel: words, disabled: way < 0 && i === 0 }, sign);
        button.onclick = () => {
          items.splice(i, 1);
          if (way) items.splice(i + way, 0, item);
          this.changed();
          this.draw();
        };
        return button;
      });
      return element("div", { className: "titled" }, shown, element("div", { className: "panel-tools" }, ...buttons));
    }));
    return element("div", { className: "titled" }, host, element("div", { className: "panel-tools" }, add));
  }

  /** Returns the settings of an operation with the defaults that its tool and the job's material make. */
  private defaultsOf(settings: Setting[], operation: Values, machine: Machine): Setting[] {
    const tool = this.job.tools.find((each) => Number(each.number) === Number(operation.tool));
    const material = machine.materials[this.job.material];
    return settings.map((setting) => {
      const speed = ["feed", "plunge", "spindle"].includes(setting.name);
      if (speed && Number(tool?.[setting.name]) > 0) return { ...setting, default: tool![setting.name] };
      if (!material) return setting;
      if (setting.name in material) return { ...setting, default: material[setting.name] };
      return speed && !Object.keys(material).length ? { ...setting, follows: "by material" } : setting;
    });
  }

  private draw(): void {
    const { job } = this;
    const { machines, operations, joining } = this.tables!;
    const machine = machines.find((each) => each.id === job.machine) ?? machines[0];
    const materials = Object.keys(machine.materials).map((each): [string, string] => [each, each]);
    const chooseMaterial = (value: string): void => { job.material = value; };
    const toolName = (tool: Values): string => `${tool.number}: ${tool.diameter ?? ""} mm ${tool.shape ?? "flat"}`;
    const main = this.panel("Machine", true,
      this.choose("Machine", machines.map((each) => [each.id, each.name]), machine.id, (value) => {
        job.machine = value;
        job.material = "";
        job.setting = {};
      }),
      element("p", { className: "quiet" }, machine.description),
      ...(materials.length
        ? [this.choose("Material", [["", "any"], ...materials], job.material, chooseMaterial)] : []),
      this.rows(machine.settings, job.setting));
    const stock = this.panel("Stock", true, this.rows([ZERO], job as unknown as Values), this.rows(STOCK, job.stock));
    const free = (): number => 1 + Math.max(0, ...job.tools.map((each) => Number(each.number)));
    const tools = this.list("Tools", job.tools,
      () => ({ number: free(), shape: "flat", diameter: 6, flute: 20, length: 40 }),
      (tool, i) => {
        const shown: HTMLDetailsElement = this.panel(toolName(tool), i === 0,
          this.rows(TOOL, tool, () => { shown.firstElementChild!.firstChild!.textContent = toolName(tool); }));
        return shown;
      });
    const cuts = this.list("Operations", job.operations,
      () => ({ type: "finish", tool: Number(job.tools[0]?.number ?? 1) }), (operation, i) => {
        const of = operations.find((each) => each.name === operation.type) ?? operations[0];
        return this.panel(`${i + 1}. ${of.name.replaceAll("_", " ")}`, i === 0,
          this.choose("Type", operations.map((each) => [each.name, each.name.replaceAll("_", " ")]), of.name,
            (value) => {
              for (const key of Object.keys(operation)) if (key !== "tool") delete operation[key];
              operation.type = value;
            }),
          this.choose("Tool", job.tools.map((each) => [String(each.number), toolName(each)]), String(operation.tool),
            (value) => { operation.tool = Number(value); }),
          element("p", { className: "quiet" }, of.help),
          this.rows(this.defaultsOf([...of.settings, ...joining], operation, machine), operation));
      });
    cuts.querySelector(".panel")!.append(this.rows([FEEDS], job as unknown as Values));
    const opened = [...by("panels").querySelectorAll<HTMLDetailsElement>("details")].map(
      (each) => [each.firstElementChild!.firstChild!.textContent, each.open] as const);
    by("panels").replaceChildren(main, stock, tools,
      ...(["paths", "flat paths"].includes(machine.takes) ? [cuts] : []));
    for (const each of by("panels").querySelectorAll<HTMLDetailsElement>("details"))
      each.open = opened.find(([title]) => title === each.firstElementChild!.firstChild!.textContent)?.[1] ?? each.open;
  }

  // Planning and simulation

  private tell(message: string): void {
    by("job-message").hidden = !message;
    by("job-message").textContent = message;
  }

  private async run(simulate: boolean): Promise<void> {
    if (this.running || !this.usable) return;
    if (!this.model) return this.tell("There is nothing to plan: the model is empty");
    this.tell("");
    this.forgetResults();
    this.stopped = false;
    const of = { model: this.model, job: JSON.stringify(this.job) };
    const bar = by<HTMLProgressElement>("job-progress");
    by("job-running").hidden = false;
    let begun = false;
    try {
      const { format: _, version: __, ...job } = this.job;
      const takesPaths = ["paths", "flat paths"].includes(
        this.tables!.machines.find((each) => each.id === job.machine)!.takes);
      const asked = post<Job>("/api/machine",
        { ...this.model, job: takesPaths ? job : { ...job, operations: [] }, simulate });
      this.running = { job: "", state: "waiting", progress: 0, message: "", error: null, result: null };
      this.enable();
      this.running = await asked;
      begun = true;
      if (this.stopped) await ask(`/api/jobs/${this.running.job}`, { method: "DELETE" });
      while (this.running.state === "waiting" || this.running.state === "working") {
        bar.value = this.running.progress;
        by("job-doing").textContent = this.running.message || "waiting";
        this.running = await (await ask(
          `/api/jobs/${this.running.job}?state=${this.running.state}&progress=${this.running.progress}`)).json() as Job;
      }
      if (this.running.state === "done") await this.show(this.running, simulate, of);
      else if (this.stopped)
        by("job-result").replaceChildren(element("p", { className: "quiet" }, "You stopped the plan."));
      else this.tell(this.running.error?.message ?? "The server stopped the plan");
    } catch (error) {
      this.tell(error instanceof Refusal ? error.message : !(error instanceof TypeError) ? String(error)
        : begun ? "The server went away during the plan. Plan again when it is back." : "The server is away");
    } finally {
      this.running = null;
      this.enable();
      by("job-running").hidden = true;
    }
  }

  private async show(done: Job, simulated: boolean, of: { model: Model; job: string }): Promise<void> {
    const told = done.result!;
    const address = (name: string): string => `/api/jobs/${done.job}/files/${encodeURIComponent(name)}`;
    const link = (name: string, words: string, saved = ""): HTMLElement => element("a", saved
      ? { href: `${address(name)}?name=${encodeURIComponent(saved)}`, download: saved }
      : { href: address(name), target: "_blank", rel: "noopener" }, words);
    const stem = this.store.name.replace(/\.job$/, "");
    const rows = told.reports.map((each) => element("tr", {}, element("td", {}, each.name),
      element("td", {}, `${Math.round(each.cut)} mm`), element("td", {}, time(each.seconds))));
    const faults = (told.events ?? []).map((each) => element("li", {},
      `${each.kind}, line ${each.line}: ${short(each.amount, 3)} mm`));
    // Shown for as long as the results are those of the model and the job as they are now.
    const now = <T extends HTMLElement>(made: T): T => { made.dataset.when = "now"; return made; };
    const old = element("p", { className: "bad", hidden: true },
      "These results are of an earlier state: the model or the job changed since. Plan again.");
    old.dataset.when = "old";
    old.setAttribute("role", "status");
    by("job-result").replaceChildren(old,
      element("p", {}, element("strong", { id: "job-time" }, time(told.seconds)), " ",
        ...(told.planned_seconds !== told.seconds ? [`(${time(told.planned_seconds)} with the planned feeds) `] : []),
        ...(simulated ? [now(element("span", { className: told.good ? "good" : "bad" },
          told.good ? "The simulation found no fault." : "The simulation found faults."))] : [])),
      ...(faults.length ? [element("ul", {}, ...faults)] : []), element("table", {}, ...rows),
      ...told.notes.map((each) => element("p", { className: "quiet" }, each)),
      now(element("p", { className: "links-of-job" },
        link(told.program, "Program", stem + told.program.replace(/^program/, "")), link("sheet.html", "Set-up sheet"),
        ...(simulated ? [link("report.html", "Report")] : []), link("job.toml", "Job file", `${stem}.toml`))));
    this.shown = of;
    this.compare();
    try {
      const { Playback } = await import("./playback");  // loads three.js on first use
      by("stage").hidden = false;
      this.playback ??= new Playback(by("stage"));
      await this.playback.show(address, told.stock, simulated);
    } catch (error) {
      this.hide();
      this.tell(`This browser shows no 3D: ${(error as Error).message}`);
    }
  }

  hide(): void { by("stage").hidden = true; }
}
