// The sheet on the page: nodes at their positions, in millimetres, over the live picture of the model.
import type { EditorView } from "@codemirror/view";
import { by, element, pressed, short, slider, svg } from "./elements";
import { kindsOf, type NodeKind, ownKinds, saveKind } from "./library";
import type { Picture } from "./picture";
import { Sandbox } from "./sandbox";
import type { LibraryFunction, Mistake } from "./server";
import { emptySheet, makesCircle, Past, readSheet, type Result, type Sheet, type SheetNode, textOf,
  writeSheet } from "./sheet";
import { codeEditor, markLine } from "./text_view";

export class SheetView {
  sheet: Sheet = emptySheet();
  private past = new Past("");
  private results = new Map<number, Result>();
  private lines: number[] = [];
  private chosen = new Set<number>();
  private sandbox = new Sandbox();
  private layer = element("div", { className: "nodes" });
  private links = svg("svg", { class: "links", "aria-hidden": "true" });
  private code: { node: number; editor: EditorView } | null = null;
  private inspected = "";
  private kinds: NodeKind[] = [];
  private mistakes = new Map<number, string>();
  onText: (text: string) => void = () => {};
  onChange: (document: string) => void = () => {};

  constructor(private picture: Picture) {
    picture.host.append(this.links, this.layer);
    picture.fixed = true;
    picture.camera.alpha = picture.camera.beta = 0;
    picture.onView = () => this.place();
    this.sandbox.onResults = (sheet, results) => this.took(sheet, results);
    this.sandbox.onLate = (id) => this.tell(
      `${this.sheet.nodes.find((each) => each.id === id)?.name ?? "A node"} was stopped: it ran longer than a second`,
      id);
    by("add-node").onclick = () => this.openPalette();
    by("remove-node").onclick = () => this.remove();
    by<HTMLSelectElement>("snap").onchange = () => {
      this.sheet.snap = Number(by<HTMLSelectElement>("snap").value);
      this.settle();
    };
    by("find-node").oninput = () => this.listKinds();
    picture.host.addEventListener("keydown", (event) => this.key(event), true);
    picture.host.addEventListener("pointerdown", (event) => { if (event.target === picture.canvas) this.choose([]); });
    new ResizeObserver(() => this.place()).observe(picture.host);
  }

  know(functions: LibraryFunction[]): void { this.kinds = kindsOf(functions); }

  /** Shows a document. Throws Error for an invalid one. */
  open(text: string): void {
    this.sheet = readSheet(text);
    this.past = new Past(this.state());
    this.chosen.clear();
    this.results.clear();
    this.closeCode();
    by("inspector").replaceChildren();
    this.inspected = "";
    this.picture.bounds = null;
    this.picture.frame(-40, -30, 40, 30);
    this.fit();
    this.picture.onPicture = (answer) => {  // the first answer brings the model's bounds
      if (!answer.bounds) return;
      this.picture.onPicture = () => {};
      this.fit();
    };
    by<HTMLSelectElement>("snap").value = String(this.sheet.snap);
    this.draw();
    this.evaluate();
  }

  /** Returns the state for undo: the sheet without its text, which is derived. */
  private state(): string { return writeSheet({ ...this.sheet, text: "" }); }

  /** Fits all nodes and the model to the view. */
  fit(): void {
    const { bounds } = this.picture;
    const xs = this.sheet.nodes.map((node) => node.x);
    const ys = this.sheet.nodes.map((node) => node.y);
    if (bounds && this.sheet.text) xs.push(bounds[0], bounds[3]), ys.push(bounds[1], bounds[4]);
    if (xs.length) this.picture.frame(Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys));
  }

  undo(): void { this.restore(this.past.undo()); }
  redo(): void { this.restore(this.past.redo()); }

  private restore(state: string | null): void {
    if (state === null) return;
    this.sheet = readSheet(state);
    this.chosen = new Set([...this.chosen].filter((id) => this.sheet.nodes.some((node) => node.id === id)));
    by<HTMLSelectElement>("snap").value = String(this.sheet.snap);
    this.closeCode();
    this.inspected = "";
    this.draw();
    this.inspect();
    this.evaluate();
    this.onChange(writeSheet(this.sheet));
  }

  private evaluate(): void { this.sandbox.evaluate(structuredClone(this.sheet)); }

  private took(sheet: Sheet, results: Map<number, Result>): void {
    this.results = results;
    this.mistakes.clear();
    for (const result of results.values()) if (result.error) this.mistakes.set(result.id, result.error);
    const { text, nodes } = textOf(sheet, results);
    this.lines = nodes;
    this.sheet.text = text;
    const first = [...this.mistakes][0];
    this.tell(first ? `${this.nameOf(first[0])}: ${first[1]}`
      : text || !sheet.nodes.length ? null : "No node makes a shape yet: add one that does (+ Node)",
      first?.[0] ?? null);
    this.inspect();
    this.onText(text);
    this.keepText();
  }

  private nameOf(id: number): string { return this.sheet.nodes.find((each) => each.id === id)?.name ?? "A node"; }

  /** Stores the text in the document, for programs that read it without JavaScript. */
  private keepText(): void {
    if (!this.moving) this.onChange(writeSheet(this.sheet));
  }

  /** Marks the nodes that caused errors of the generated text. */
  mark(mistakes: Mistake[], message: string | null): void {
    for (const [id, said] of [...this.mistakes]) if (said.startsWith("its text: ")) this.mistakes.delete(id);
    for (const each of mistakes) {
      const id = this.lines[each.line - 1];
      if (id !== undefined) this.mistakes.set(id, `its text: ${each.message}`);
    }
    const first = [...this.mistakes][0];
    if (first) this.tell(`${this.nameOf(first[0])}: ${first[1]}`, first[0]);
    else this.tell(message, null);
  }

  private tell(message: string | null, node: number | null): void {
    const box = by("sheet-message");
    box.hidden = message === null;
    box.textContent = message ?? "";
    box.onclick = () => { if (node !== null) this.choose([node]); };
    if (message !== null && node !== null) this.mistakes.set(node, message.replace(/^[^:]*: /, ""));
    for (const each of this.layer.querySelectorAll<HTMLElement>(".node"))
      each.classList.toggle("wrong", this.mistakes.has(Number(each.dataset.id)));
    if (this.code) {
      const said = this.mistakes.get(this.code.node) ?? null;
      markLine(this.code.editor, this.results.get(this.code.node)?.line ?? null, said);
    }
  }

  // A change is shown at once; it becomes an undo step when it is complete.

  private moving = false;

  private changed(): void {
    this.place();
    this.evaluate();
  }

  private settle(merging = ""): void {
    this.past.keep(this.state(), merging);
    this.onChange(writeSheet(this.sheet));
    this.changed();
  }

  // Nodes

  private draw(): void {
    this.layer.replaceChildren(...this.sheet.nodes.map((node) => this.elementOf(node)));
    this.place();
  }

  private elementOf(node: SheetNode): HTMLElement {
    const port = element("span", { className: "port", title: "Drag to a node that is to take this one" });
    const made = element("div", { className: "node", tabIndex: -1, title: node.name },
      element("span", { className: "dot" }), element("span", { className: "label" }, node.name), port);
    made.dataset.id = String(node.id);
    made.classList.toggle("chosen", this.chosen.has(node.id));
    made.onpointerdown = (event) => (event.target === port ? this.pull(event, node.id) : this.grab(event, node.id));
    made.ondblclick = () => this.code?.editor.focus();
    return made;
  }

  private at(id: number): HTMLElement | null { return this.layer.querySelector(`[data-id="${id}"]`); }

  private place(): void {
    if (!this.picture.scale) return;
    for (const node of this.sheet.nodes) {
      const [x, y] = this.picture.pixel(node.x, node.y), made = this.at(node.id);
      if (made) made.style.transform = `translate(${x}px, ${y}px)`;
    }
    this.links.replaceChildren(...this.sheet.nodes.flatMap((node) => node.parents.map((id) => this.linkOf(id, node))));
  }

  private linkOf(from: number, node: SheetNode): SVGElement {
    const parent = this.sheet.nodes.find((each) => each.id === from)!;
    const [x0, y0] = this.picture.pixel(parent.x, parent.y), [x1, y1] = this.picture.pixel(node.x, node.y);
    const far = Math.hypot(x1 - x0, y1 - y0) || 1, bow = Math.min(24, far / 6);
    const mx = (x0 + x1) / 2 + (y1 - y0) / far * bow, my = (y0 + y1) / 2 - (x1 - x0) / far * bow;
    const path = `M${x0} ${y0}Q${mx} ${my} ${x1} ${y1}`;
    const group = svg("g", { class: "link" });
    const wide = svg("path", { d: path, class: "wide" });
    const tip = svg("circle", { cx: (x0 + 2 * mx + x1) / 4, cy: (y0 + 2 * my + y1) / 4, r: 3 });
    const title = svg("title");
    title.textContent = `${parent.name} → ${node.name}: click to cut`;
    group.append(wide, svg("path", { d: path }), tip, title);
    group.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      node.parents = node.parents.filter((id) => id !== from);
      this.settle();
    });
    return group;
  }

  private snapped(value: number): number {
    const { snap } = this.sheet;
    return snap ? Number((Math.round(value / snap) * snap).toFixed(6)) : Number(value.toFixed(4));
  }

  private grab(event: PointerEvent, id: number): void {
    if (event.button !== 0) return;
    event.preventDefault();
    this.picture.host.focus({ preventScroll: true });
    if (event.shiftKey)
      return this.choose(this.chosen.has(id) ? [...this.chosen].filter((each) => each !== id) : [...this.chosen, id]);
    if (!this.chosen.has(id)) this.choose([id]);
    const target = event.currentTarget as HTMLElement, start = this.picture.place(event.clientX, event.clientY);
    const moved =
      this.sheet.nodes.filter((node) => this.chosen.has(node.id)).map((node) => ({ node, x: node.x, y: node.y }));
    target.setPointerCapture(event.pointerId);
    this.moving = true;
    target.onpointermove = (next) => {
      const [x, y] = this.picture.place(next.clientX, next.clientY);
      let other = false;
      for (const each of moved) {
        const to = [this.snapped(each.x + x - start[0]), this.snapped(each.y + y - start[1])];
        other ||= to[0] !== each.node.x || to[1] !== each.node.y;
        [each.node.x, each.node.y] = to;
      }
      if (other) this.changed();
    };
    target.onpointerup = target.onpointercancel = () => {
      target.onpointermove = target.onpointerup = target.onpointercancel = null;
      this.moving = false;
      this.settle();
    };
  }

  /** Drags a link from a node's port to another node. */
  private pull(event: PointerEvent, from: number): void {
    event.preventDefault();
    event.stopPropagation();
    const port = event.currentTarget as HTMLElement, box = this.picture.host.getBoundingClientRect();
    const node = this.sheet.nodes.find((each) => each.id === from)!;
    const [x0, y0] = this.picture.pixel(node.x, node.y);
    const line = svg("path", { class: "pulled" });
    this.links.append(line);
    port.setPointerCapture(event.pointerId);
    port.onpointermove = (next) => line.setAttribute("d",
      `M${x0} ${y0}L${next.clientX - box.left} ${next.clientY - box.top}`);
    port.onpointerup = port.onpointercancel = (end) => {
      port.onpointermove = port.onpointerup = port.onpointercancel = null;
      line.remove();
      const over = document.elementsFromPoint(end.clientX, end.clientY)
        .map((each) => each.closest<HTMLElement>(".node")).find((each) => each && each.dataset.id !== String(from));
      if (over) this.link(from, Number(over.dataset.id));
    };
  }

  private link(from: number, to: number): void {
    const node = this.sheet.nodes.find((each) => each.id === to)!;
    if (node.parents.includes(from)) return;
    if (makesCircle(this.sheet, from, to)) return this.tell("That link would go round in a circle", null);
    node.parents.push(from);
    this.choose([to]);
    this.settle();
  }

  choose(ids: number[]): void {
    this.chosen = new Set(ids);
    for (const each of this.layer.querySelectorAll<HTMLElement>(".node"))
      each.classList.toggle("chosen", this.chosen.has(Number(each.dataset.id)));
    this.inspect();
  }

  private add(kind: NodeKind): void {
    const id = 1 + Math.max(0, ...this.sheet.nodes.map((node) => node.id));
    const chosen = [...this.chosen], [w, h] = this.picture.size;
    const last = this.sheet.nodes.find((node) => node.id === chosen[chosen.length - 1]);
    const [x, y] = last ? [last.x + 60 * this.picture.scale, last.y + 20 * this.picture.scale]
      : this.picture.place(w / 2, h / 2);
    const parents = kind.parents ? chosen : [];
    this.sheet.nodes.push({ id, name: kind.name, x: this.snapped(x), y: this.snapped(y), code: kind.code,
      values: { ...kind.values }, parents });
    this.draw();
    this.choose([id]);
    this.settle();
  }

  remove(): void {
    if (!this.chosen.size) return;
    this.sheet.nodes = this.sheet.nodes.filter((node) => !this.chosen.has(node.id));
    for (const node of this.sheet.nodes) node.parents = node.parents.filter((id) => !this.chosen.has(id));
    this.choose([]);
    this.draw();
    this.settle();
  }

  private copied: SheetNode[] = [];

  private paste(): void {
    const first = 1 + Math.max(0, ...this.sheet.nodes.map((node) => node.id));
    const number = new Map(this.copied.map((node, i) => [node.id, first + i]));
    const away = this.snapped(30 * this.picture.scale) || this.sheet.snap;
    const made = this.copied.map((node) => ({
      ...structuredClone(node), id: number.get(node.id)!, x: node.x + away, y: node.y - away,
      parents: node.parents.map((id) => number.get(id) ?? id)
        .filter((id) => id >= first || this.sheet.nodes.some((each) => each.id === id)),
    }));
    if (!made.length) return;
    this.sheet.nodes.push(...made);
    this.draw();
    this.choose(made.map((node) => node.id));
    this.settle();
  }

  private key(event: KeyboardEvent): void {
    if (event.target !== this.picture.host) return;
    const chosen = this.sheet.nodes.filter((node) => this.chosen.has(node.id));
    const control = event.ctrlKey || event.metaKey;
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
      ArrowDown: [0, -1] };
    const way = arrows[event.key], step = (this.sheet.snap || 0.1) * (event.shiftKey ? 10 : 1);
    if (control && event.key === "c" && chosen.length) this.copied = structuredClone(chosen);
    else if (control && event.key === "v") this.paste();
    else if (control && event.key === "a") this.choose(this.sheet.nodes.map((node) => node.id));
    else if (control) return;
    else if (way && chosen.length) {
      for (const node of chosen)
        node.x = this.snapped(node.x + way[0] * step), node.y = this.snapped(node.y + way[1] * step);
      this.settle();
    } else if (event.key === "Delete" || event.key === "Backspace") this.remove();
    else if (event.key === "a") this.openPalette();
    else if (event.key === "Tab" && this.sheet.nodes.length && (chosen.length || !event.shiftKey)) {
      const at = this.sheet.nodes.findIndex((node) => this.chosen.has(node.id)), next = at + (event.shiftKey ? -1 : 1);
      if (next < 0 || next >= this.sheet.nodes.length) return;
      this.choose([this.sheet.nodes[next].id]);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // The inspector

  private closeCode(): void {
    this.code?.editor.destroy();
    this.code = null;
  }

  private inspect(): void {
    const host = by("inspector");
    const node = this.chosen.size === 1 ? this.sheet.nodes.find((each) => this.chosen.has(each.id)) : undefined;
    pressed(by("remove-node"), false);
    by<HTMLButtonElement>("remove-node").disabled = !this.chosen.size;
    if (!node) {
      this.closeCode();
      this.inspected = "";
      host.replaceChildren(element("p", { className: "quiet" },
        this.chosen.size ? `${this.chosen.size} nodes`
        : this.sheet.nodes.length
        ? "Choose a node to see its numbers and its code; drag its ring to another node to link them."
        : "An empty sheet: + Node adds one."));
      return;
    }
    const sliders = this.results.get(node.id)?.sliders ?? [];
    const key =
      JSON.stringify([node.id, node.name, sliders.map((each) => [each.name, each.low, each.high, typeof each.value])]);
    const place = host.querySelector(".place");
    if (place) place.textContent = `${short(node.x, 6)}, ${short(node.y, 6)} mm`;
    if (key === this.inspected && this.code?.node === node.id) return;
    const sameNode = this.code?.node === node.id;
    this.inspected = key;
    const name = element("input", { className: "title", value: node.name, ariaLabel: "Name of the node" });
    name.onchange = () => { node.name = name.value.trim() || "Node"; this.draw(); this.settle(); };
    const keep = element("button", { title: "Keep this node's code as a kind of node of your own" }, "Save as my own");
    keep.onclick = () => {
      saveKind({ name: node.name, group: "My own", meaning: "", code: node.code, parents: node.parents.length,
        values: node.values });
      keep.textContent = "Saved";
    };
    const head = element("div", { className: "row" }, name, element("span", { className: "place quiet" },
      `${short(node.x, 6)}, ${short(node.y, 6)} mm`), element("span", { className: "space" }), keep);
    const current = (): SheetNode | undefined => this.sheet.nodes.find((each) => each.id === node.id);
    const rows = sliders.map((each) => {
      const set = (value: number | string): void => { const now = current(); if (now) now.values[each.name] = value; };
      if (typeof each.value === "number")
        return slider(each.name, each.value, [each.low ?? 0, each.high ?? 10], "", (value) => {
          this.moving = true;
          set(value);
          this.changed();
        }, () => { this.moving = false; this.settle(); });
      const box = element("input", { value: each.value, ariaLabel: each.name });
      box.oninput = () => { set(box.value); this.settle(`${node.id} ${each.name}`); };
      return element("label", { className: "slider words" }, element("span", {}, each.name), box);
    });
    const holder = element("div", { className: "code" });
    if (sameNode) {
      // Keeps the editor and its cursor.
      const numbers = host.querySelector(".numbers");
      if (!numbers?.contains(document.activeElement)) numbers?.replaceChildren(...rows);
      return;
    }
    this.closeCode();
    host.replaceChildren(head, element("div", { className: "numbers" }, ...rows), holder);
    const editor = codeEditor(holder, node.code, (text) => {
      const now = current();
      if (now) { now.code = text; this.settle(`${node.id} code`); }
    });
    this.code = { node: node.id, editor };
    markLine(editor, this.results.get(node.id)?.line ?? null, this.mistakes.get(node.id) ?? null);
  }

  // The library

  private openPalette(): void {
    by<HTMLInputElement>("find-node").value = "";
    this.listKinds();
    by<HTMLDialogElement>("palette").showModal();
  }

  private listKinds(): void {
    const wanted = by<HTMLInputElement>("find-node").value.toLowerCase(), groups = new Map<string, NodeKind[]>();
    for (const kind of [...ownKinds(), ...this.kinds])
      if (`${kind.name} ${kind.meaning} ${kind.group}`.toLowerCase().includes(wanted))
        groups.set(kind.group, [...(groups.get(kind.group) ?? []), kind]);
    by("nodes").replaceChildren(
      ...[...groups].map(([group, kinds]) => element("section", {}, element("h3", {}, group), ...kinds.map((kind) => {
        const button = element("button", { title: kind.meaning }, kind.name);
        button.onclick = () => { by<HTMLDialogElement>("palette").close(); this.add(kind); this.picture.host.focus(); };
        return button;
      }))));
  }
}
