// The sheet on the page: nodes at their positions, in millimetres, over the live picture of the model.
import type { EditorView } from "@codemirror/view";
import { by, element, pressed, short, slider, svg } from "./elements";
import { around, copies, isGroup, type Item, makeGroup, membersOf, nextId, openGroups, portsOf, prune, shownAs,
  shownItems, toCopy, toggle, ungroup, withMembers } from "./groups";
import type { History } from "./history";
import { kindsOf, type NodeKind, saveKind } from "./library";
import { menu } from "./menu";
import { Palette } from "./palette";
import type { Picture } from "./picture";
import { dragRectangle, linkBetween } from "./sheet_drawing";
import { Sandbox } from "./sandbox";
import type { LibraryFunction, Mistake } from "./server";
import { emptySheet, type Group, makesCircle, Past, readSheet, type Result, type Sheet, type SheetNode, textOf,
  writeSheet } from "./sheet";
import { codeEditor, MadeText, markLine, showMistake } from "./text_view";

const PORTS = 15; // pixels between the inputs of a closed group

export class SheetView {
  sheet: Sheet = emptySheet();
  private past = new Past("");
  private results = new Map<number, Result>();
  private lines: number[] = [];
  private chosen = new Set<number>();
  private sandbox = new Sandbox();
  private frames = element("div", { className: "frames" });
  private layer = element("div", { className: "nodes" });
  private links = svg("svg", { class: "links", "aria-hidden": "true" });
  private code: { node: number; editor: EditorView } | null = null;
  private inspected = "";
  private palette = new Palette();
  private mistakes = new Map<number, string>();
  private made = new MadeText(by("made"));
  onText: (text: string) => void = () => {};
  onChange: (document: string) => void = () => {};

  constructor(private picture: Picture) {
    picture.host.append(this.frames, this.links, this.layer);
    picture.fixed = true;
    picture.camera.alpha = picture.camera.beta = 0;
    picture.onView = () => this.place();
    this.sandbox.onResults = (sheet, results) => this.took(sheet, results);
    this.sandbox.onLate = (id) => this.tell(
      `${this.sheet.nodes.find((each) => each.id === id)?.name ?? "A node"} was stopped: it ran longer than a second`,
      id);
    by("add-node").onclick = () => this.palette.open();
    this.palette.onKind = (kind) => { this.add(kind); this.picture.host.focus(); };
    by("remove-node").onclick = () => this.remove();
    by<HTMLSelectElement>("snap").onchange = () => {
      this.sheet.snap = Number(by<HTMLSelectElement>("snap").value);
      this.settle();
    };
    menu(by("groups"), () => [
      { words: "Group the chosen nodes", keys: "Ctrl+G", act: () => this.group() },
      { words: "Expand or collapse", keys: "E", act: () => this.toggle() },
      { words: "Ungroup", keys: "Ctrl+Shift+G", act: () => this.ungroup() },
    ].map((each) => ({ ...each, act: () => { this.picture.host.focus(); each.act(); } })));
    by("show-text").onclick = () => this.showText(!this.made.isShown);
    by("inspector").addEventListener("keydown", (event) => {
      // In the editor of the code Escape and Tab lead on, as the list of keys says.
      if (event.key === "Escape" && !(event.target as HTMLElement).closest(".cm-editor")) this.picture.host.focus();
    });
    picture.host.addEventListener("keydown", (event) => this.key(event), true);
    picture.host.addEventListener("pointerdown", (event) => {
      if (event.target !== picture.canvas) return;
      if (event.shiftKey && event.button === 0) this.chooseWithin(event);
      else this.choose([]);
    }, true);
    new ResizeObserver(() => this.place()).observe(picture.host);
  }

  /** Shows the text that the sheet makes, beside the inspector. */
  showText(on: boolean): void {
    pressed(by("show-text"), on);
    this.made.show(on, this.sheet.text);
  }

  know(functions: LibraryFunction[]): void { this.palette.kinds = kindsOf(functions); }

  /** Shows a document. `kept`: its undo history; another state than the history's becomes a step of it. Throws Error
   * for an invalid document. */
  open(text: string, kept: History | null = null): void {
    this.sheet = readSheet(text);
    this.past = new Past(this.state());
    if (kept && this.past.take(kept.past)) this.past.keep(this.state());
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

  /** Returns the undo history for storage. */
  history(): History { return { now: this.past.now, past: this.past.stored() }; }

  /** Fits all nodes and the model to the view. */
  fit(): void {
    const { bounds } = this.picture;
    const xs = this.sheet.nodes.map((node) => node.x);
    const ys = this.sheet.nodes.map((node) => node.y);
    if (bounds && this.sheet.text) {
      xs.push(bounds[0], bounds[3]);
      ys.push(bounds[1], bounds[4]);
    }
    if (xs.length) this.picture.frame(Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys));
  }

  undo(): void { this.restore(this.past.undo()); }
  redo(): void { this.restore(this.past.redo()); }

  private restore(state: string | null): void {
    if (state === null) return;
    this.sheet = readSheet(state);
    const shown = new Set(shownItems(this.sheet).map((each) => each.id));
    this.chosen = new Set([...this.chosen].filter((id) => shown.has(id)));
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
    this.made.follow(text);
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
    this.made.mark(mistakes);
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
    showMistake(by("sheet-message"), message, node === null ? null : () => this.reveal(node));
    if (message !== null && node !== null) this.mistakes.set(node, message.replace(/^[^:]*: /, ""));
    const wrong = new Set(this.sheet.nodes.filter((each) => this.mistakes.has(each.id))
      .map((each) => shownAs(this.sheet, each)));
    for (const each of this.layer.querySelectorAll<HTMLElement>(".node"))
      each.classList.toggle("wrong", wrong.has(Number(each.dataset.id)));
    if (this.code) {
      const said = this.mistakes.get(this.code.node) ?? null;
      markLine(this.code.editor, this.results.get(this.code.node)?.line ?? null, said);
    }
  }

  /** Goes to the node with the next mistake, after the last one to the first. */
  nextMistake(): void {
    const wrong = this.sheet.nodes.map((node) => node.id).filter((id) => this.mistakes.has(id));
    const at = this.chosen.size === 1 ? wrong.indexOf([...this.chosen][0]) : -1;
    if (wrong.length) this.reveal(wrong[(at + 1) % wrong.length]);
    this.picture.host.focus();
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
    this.layer.replaceChildren(...shownItems(this.sheet).map((item) => this.elementOf(item)));
    this.frames.replaceChildren(...openGroups(this.sheet).map((group) => this.frameOf(group)));
    this.place();
  }

  private elementOf(item: Item): HTMLElement {
    const made = element("div", { className: "node", tabIndex: -1, title: item.name },
      element("span", { className: "dot" }), element("span", { className: "label" }, item.name));
    made.dataset.id = String(item.id);
    made.classList.toggle("chosen", this.chosen.has(item.id));
    if (isGroup(item)) this.addPorts(made, item);
    else {
      const port = element("span", { className: "port", title: "Drag to a node that is to take this one" });
      port.onpointerdown = (event) => this.pull(event, item.id);
      made.append(port);
    }
    made.onpointerdown = (event) => this.grab(event, item.id);
    made.ondblclick = () => {
      if (isGroup(item)) this.toggle();
      else this.code?.editor.focus();
    };
    return made;
  }

  /** Adds the inputs and outputs of a closed group. */
  private addPorts(made: HTMLElement, group: Group): void {
    const { inputs, outputs } = portsOf(this.sheet, group.id);
    made.classList.add("closed");
    made.style.setProperty("--ports", String(Math.max(1, inputs.length, outputs.length)));
    for (const [kind, nodes] of [["in", inputs], ["out", outputs]] as const)
      for (const [i, node] of nodes.entries()) {
        const port = element("span", { className: `port ${kind}`,
          title: kind === "in" ? `Input of ${node.name}` : `Output of ${node.name}: drag it to a node` });
        port.dataset.node = String(node.id);
        port.style.top = `${(i - (nodes.length - 1) / 2) * PORTS - 7}px`;
        if (kind === "out") port.onpointerdown = (event) => this.pull(event, node.id);
        made.append(port);
      }
  }

  private frameOf(group: Group): HTMLElement {
    const title = element("span", { className: "frame-title", title: "Double click collapses it" }, group.name);
    const made = element("div", { className: "frame" }, title);
    made.dataset.id = String(group.id);
    title.onpointerdown = (event) => {
      this.choose(this.shownWithin(group));
      this.grab(event, [...this.chosen][0]);
    };
    title.ondblclick = () => this.toggle(group);
    return made;
  }

  /** Returns the ids of what is shown of an open group. */
  private shownWithin(group: Group): number[] {
    return shownItems(this.sheet)
      .filter((item) => around(this.sheet, item).includes(group)).map((item) => item.id);
  }

  private at(id: number): HTMLElement | null { return this.layer.querySelector(`[data-id="${id}"]`); }

  private itemOf(id: number): Item | undefined {
    return this.sheet.nodes.find((each) => each.id === id) ?? this.sheet.groups.find((each) => each.id === id);
  }

  private place(): void {
    if (!this.picture.scale) return;
    const items = shownItems(this.sheet), pixels = new Map(items.map((item) =>
      [item.id, this.picture.pixel(item.x, item.y)]));
    for (const item of items) {
      const [x, y] = pixels.get(item.id)!, made = this.at(item.id);
      if (made) made.style.transform = `translate(${x}px, ${y}px)`;
    }
    for (const frame of this.frames.querySelectorAll<HTMLElement>(".frame")) {
      const group = this.sheet.groups.find((each) => each.id === Number(frame.dataset.id));
      const within = group ? this.shownWithin(group).map((id) => pixels.get(id)!) : [];
      frame.hidden = !within.length;
      if (!within.length) continue;
      const depth = this.sheet.groups.filter((each) => around(this.sheet, each).includes(group!)).length;
      const xs = within.map(([x]) => x), ys = within.map(([, y]) => y), more = 26 + 16 * depth;
      frame.style.left = `${Math.min(...xs) - more}px`;
      frame.style.top = `${Math.min(...ys) - more - 12}px`;
      frame.style.width = `${Math.max(...xs) - Math.min(...xs) + 2 * more}px`;
      frame.style.height = `${Math.max(...ys) - Math.min(...ys) + 2 * more + 12}px`;
    }
    this.links.replaceChildren(
      ...this.sheet.nodes.flatMap((node) => node.parents.map((id) => this.linkOf(id, node)))
        .filter((each) => each !== null));
  }

  /** Returns the pixel where a link of a node begins or ends: the node, or a port of the group that shows it. */
  private end(node: SheetNode, kind: "in" | "out"): [number, number] {
    const id = shownAs(this.sheet, node);
    if (id === node.id) return this.picture.pixel(node.x, node.y);
    const group = this.itemOf(id)!, [x, y] = this.picture.pixel(group.x, group.y);
    const port = this.at(id)?.querySelector<HTMLElement>(`.port.${kind}[data-node="${node.id}"]`);
    return [x + (kind === "in" ? -17 : 17), y + (port ? parseFloat(port.style.top) + 7 : 0)];
  }

  private linkOf(from: number, node: SheetNode): SVGElement | null {
    const parent = this.sheet.nodes.find((each) => each.id === from)!;
    if (shownAs(this.sheet, parent) === shownAs(this.sheet, node)) return null;
    const group = linkBetween(this.end(parent, "out"), this.end(node, "in"),
      `${parent.name} → ${node.name}: click to cut`);
    group.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      node.parents = node.parents.filter((id) => id !== from);
      this.settle();
      this.draw();
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
    const moved = this.moved().map((node) => ({ node, x: node.x, y: node.y }));
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

  /** Returns all nodes and groups that move with what is chosen. */
  private moved(): Item[] {
    const { nodes, groups } = withMembers(this.sheet, this.chosen);
    return [...nodes, ...groups];
  }

  /** Drags a link from a node's port to another node. */
  private pull(event: PointerEvent, from: number): void {
    event.preventDefault();
    event.stopPropagation();
    const port = event.currentTarget as HTMLElement, box = this.picture.host.getBoundingClientRect();
    const [x0, y0] = this.end(this.sheet.nodes.find((each) => each.id === from)!, "out");
    const line = svg("path", { class: "pulled" });
    this.links.append(line);
    port.setPointerCapture(event.pointerId);
    port.onpointermove = (next) => line.setAttribute("d",
      `M${x0} ${y0}L${next.clientX - box.left} ${next.clientY - box.top}`);
    port.onpointerup = port.onpointercancel = (end) => {
      port.onpointermove = port.onpointerup = port.onpointercancel = null;
      line.remove();
      const under = document.elementsFromPoint(end.clientX, end.clientY);
      const input = under.find((each) => each.matches(".port.in")) as HTMLElement | undefined;
      const own = port.closest<HTMLElement>(".node");
      const over = under.map((each) => each.closest<HTMLElement>(".node")).find((each) => each && each !== own);
      const group = over && this.sheet.groups.find((each) => each.id === Number(over.dataset.id));
      if (input && input.closest(".node") === over) this.link(from, Number(input.dataset.node));
      else if (group) this.linkToGroup(from, group);
      else if (over) this.link(from, Number(over.dataset.id));
    };
  }

  private linkToGroup(from: number, group: Group): void {
    const { inputs } = portsOf(this.sheet, group.id);
    if (inputs.length === 1) this.link(from, inputs[0].id);
    else
      this.tell(inputs.length ? `“${group.name}” has ${inputs.length} inputs: drag to one of its rings on the left`
        : `“${group.name}” has no input`, null);
  }

  private link(from: number, to: number): void {
    const node = this.sheet.nodes.find((each) => each.id === to)!;
    if (node.parents.includes(from)) return;
    if (makesCircle(this.sheet, from, to))
      return this.tell("That link would make a cycle: a node cannot take what depends on itself", null);
    node.parents.push(from);
    this.draw();
    this.choose([shownAs(this.sheet, node)]);
    this.settle();
  }

  /** Chooses what a rectangle contains that is dragged with Shift. */
  private chooseWithin(event: PointerEvent): void {
    const before = [...this.chosen];
    dragRectangle(this.picture.host, event, (left, top, right, bottom) => {
      const within = shownItems(this.sheet).filter((item) => {
        const [x, y] = this.picture.pixel(item.x, item.y);
        return x >= left && x <= right && y >= top && y <= bottom;
      });
      this.choose([...new Set([...before, ...within.map((item) => item.id)])]);
    });
  }

  // Groups

  private group(): void {
    const items = shownItems(this.sheet).filter((item) => this.chosen.has(item.id));
    if (!items.length) return this.tell("Choose the nodes of the group first: Shift adds to what is chosen", null);
    const made = makeGroup(this.sheet, items);
    this.draw();
    this.choose([made.id]);
    this.settle();
  }

  /** Returns the group that is chosen: as one node, or by nodes within it. */
  private groupInHand(): Group | null {
    const items = [...this.chosen].map((id) => this.itemOf(id)).filter((each) => each !== undefined);
    if (items.length === 1 && isGroup(items[0])) return items[0];
    if (!items.length) return null;
    return around(this.sheet, items[0])
      .find((group) => items.every((item) => around(this.sheet, item).includes(group))) ?? null;
  }

  private toggle(group = this.groupInHand()): void {
    if (!group) return this.tell("Choose a group, or a node in one, first", null);
    toggle(this.sheet, group);
    this.draw();
    this.choose(group.open ? this.shownWithin(group) : [group.id]);
    this.settle();
  }

  private ungroup(group = this.groupInHand()): void {
    if (!group) return this.tell("Choose a group, or a node in one, first", null);
    const members = shownItems({ ...this.sheet, groups: this.sheet.groups.map((each) =>
      (each === group ? { ...each, open: true } : each)) })
      .filter((item) => around(this.sheet, item).includes(group)).map((item) => item.id);
    ungroup(this.sheet, group);
    this.draw();
    this.choose(members);
    this.settle();
  }

  /** Chooses a node; expands the groups that hide it. */
  private reveal(id: number): void {
    const node = this.itemOf(id);
    if (!node) return;
    const closed = around(this.sheet, node).filter((each) => !each.open);
    for (const each of closed) toggle(this.sheet, each);
    if (closed.length) {
      this.draw();
      this.settle();
    }
    this.choose([id]);
  }

  private pinned = new Set<number>(); // chosen by Space: Tab adds the next one to them
  private pulled: number | null = null; // the node whose link L begins

  /** Begins a link at a node, or ends it there; cuts one that is there already. */
  private linkByKey(item: Item): void {
    const from = this.pulled === null ? undefined : this.sheet.nodes.find((each) => each.id === this.pulled);
    if (!from || from.id === item.id) {
      const outputs = isGroup(item) ? portsOf(this.sheet, item.id).outputs : [item];
      this.pulled = outputs[0]?.id ?? null;
      return this.tell(`Choose the node that is to take “${item.name}” (Tab), and press L`, null);
    }
    this.pulled = null;
    this.tell(null, null);
    if (isGroup(item)) return this.linkToGroup(from.id, item);
    if (!item.parents.includes(from.id)) return this.link(from.id, item.id);
    item.parents = item.parents.filter((id) => id !== from.id);
    this.settle();
    this.draw();
  }

  choose(ids: number[]): void {
    this.chosen = new Set(ids);
    this.pinned = new Set();
    for (const each of this.layer.querySelectorAll<HTMLElement>(".node"))
      each.classList.toggle("chosen", this.chosen.has(Number(each.dataset.id)));
    this.inspect();
  }

  private add(kind: NodeKind): void {
    const id = nextId(this.sheet), items = [...this.chosen].map((each) => this.itemOf(each)!);
    const chosen = items.flatMap((item) => (isGroup(item) ? portsOf(this.sheet, item.id).outputs : [item]))
      .map((node) => node.id);
    const [w, h] = this.picture.size, last = items[items.length - 1];
    const [x, y] = last ? [last.x + 60 * this.picture.scale, last.y + 20 * this.picture.scale]
      : this.picture.place(w / 2, h / 2);
    const parents = kind.parents ? chosen : [];
    this.sheet.nodes.push({ id, name: kind.name, x: this.snapped(x), y: this.snapped(y), code: kind.code,
      values: { ...kind.values }, parents, ...(last?.group === undefined ? {} : { group: last.group }) });
    this.draw();
    this.choose([id]);
    this.settle();
  }

  remove(): void {
    if (!this.chosen.size) return;
    const { nodes, groups } = withMembers(this.sheet, this.chosen), gone = new Set(nodes.map((node) => node.id));
    this.sheet.nodes = this.sheet.nodes.filter((node) => !gone.has(node.id));
    this.sheet.groups = this.sheet.groups.filter((each) => !groups.includes(each));
    for (const node of this.sheet.nodes) node.parents = node.parents.filter((id) => !gone.has(id));
    prune(this.sheet);
    this.choose([]);
    this.draw();
    this.settle();
  }

  private copied: { nodes: SheetNode[]; groups: Group[] } = { nodes: [], groups: [] };

  private paste(): void {
    const away = this.snapped(30 * this.picture.scale) || this.sheet.snap;
    const { nodes, groups } = this.copied;
    const made = copies(this.sheet, nodes, groups, away).map((each) => ({ ...each, y: each.y - 2 * away }));
    if (!made.length) return;
    for (const each of made)
      if (isGroup(each)) this.sheet.groups.push(each);
      else this.sheet.nodes.push(each);
    this.draw();
    const pasted = new Set(made.map((each) => shownAs(this.sheet, each)));
    this.choose([...pasted].filter((id) => made.some((each) => each.id === id)));
    this.settle();
  }

  private key(event: KeyboardEvent): void {
    if (event.target !== this.picture.host) return;
    const items = shownItems(this.sheet), chosen = items.filter((item) => this.chosen.has(item.id));
    const control = event.ctrlKey || event.metaKey;
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
      ArrowDown: [0, -1] };
    const way = arrows[event.key], step = (this.sheet.snap || 0.1) * (event.shiftKey ? 10 : 1);
    if (control && event.key === "c" && chosen.length) this.copied = toCopy(this.sheet, this.chosen);
    else if (control && event.key.toLowerCase() === "g") {
      if (event.shiftKey) this.ungroup();
      else this.group();
    } else if (control && event.key === "v") this.paste();
    else if (control && event.key === "a") this.choose(items.map((item) => item.id));
    else if (control) return;
    else if (way && chosen.length) {
      for (const each of this.moved()) {
        each.x = this.snapped(each.x + way[0] * step);
        each.y = this.snapped(each.y + way[1] * step);
      }
      this.settle();
    } else if (event.key === "Delete" || event.key === "Backspace") this.remove();
    else if (event.key === "a") this.palette.open();
    else if (event.key === "e") this.toggle();
    else if (event.key === "l" && chosen.length === 1) this.linkByKey(chosen[0]);
    else if (event.key === " " && chosen.length) this.pinned = new Set(this.chosen);
    else if (event.key === "Enter" && by("inspector").querySelector("input"))
      by("inspector").querySelector<HTMLInputElement>("input")!.select();
    else if (event.key === "Escape") this.choose([]);
    else if (event.key === "Tab" && items.length && (chosen.length || !event.shiftKey)) {
      const last = [...this.chosen].pop(), at = items.findIndex((item) => item.id === last);
      const next = at + (event.shiftKey ? -1 : 1);
      if (next < 0 || next >= items.length) return;
      const pinned = this.pinned;
      this.choose([...pinned, items[next].id]);
      this.pinned = pinned;
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // The inspector

  private closeCode(): void {
    this.code?.editor.destroy();
    this.code = null;
  }

  /** Returns the sliders and boxes of a node's numbers and words. `prefix`: before their names. */
  private numbersOf(id: number, prefix = ""): HTMLElement[] {
    const current = (): SheetNode | undefined => this.sheet.nodes.find((each) => each.id === id);
    return (this.results.get(id)?.sliders ?? []).map((each) => {
      const set = (value: number | string): void => { const now = current(); if (now) now.values[each.name] = value; };
      if (typeof each.value === "number")
        return slider(prefix + each.name, each.value, [each.low ?? 0, each.high ?? 10], "", (value) => {
          this.moving = true;
          set(value);
          this.changed();
        }, () => { this.moving = false; this.settle(); });
      const box = element("input", { value: each.value, ariaLabel: prefix + each.name });
      box.oninput = () => { set(box.value); this.settle(`${id} ${each.name}`); };
      return element("label", { className: "slider words" }, element("span", {}, prefix + each.name), box);
    });
  }

  /** Shows a group's name, inputs and outputs, and the numbers of all its members. */
  private inspectGroup(group: Group): void {
    const members = membersOf(this.sheet, group.id), { inputs, outputs } = portsOf(this.sheet, group.id);
    const names = (nodes: SheetNode[]): string => nodes.map((node) => node.name).join(", ") || "none";
    const told = `Inputs: ${names(inputs)}. Outputs: ${names(outputs)}. ${members.length} nodes.`;
    const key = JSON.stringify([group.id, group.name, group.open, told,
      members.map((node) => this.results.get(node.id)?.sliders.map((each) => [each.name, each.low, each.high]))]);
    if (key === this.inspected) return;
    this.closeCode();
    this.inspected = key;
    const name = element("input", { className: "title", value: group.name, ariaLabel: "Name of the group" });
    name.onchange = () => { group.name = name.value.trim() || "Group"; this.draw(); this.settle(); };
    const open = element("button", { title: "Or E, or double click" }, group.open ? "Collapse" : "Expand");
    open.onclick = () => this.toggle(group);
    const apart = element("button", { title: "Or Ctrl+Shift+G: its nodes stay" }, "Ungroup");
    apart.onclick = () => this.ungroup(group);
    const numbers = members.flatMap((node) => this.numbersOf(node.id, `${node.name}: `));
    by("inspector").replaceChildren(
      element("div", { className: "row" }, name, element("span", { className: "space" }), open, apart),
      element("p", { className: "quiet" }, told), element("div", { className: "numbers" }, ...numbers));
  }

  private inspect(): void {
    const host = by("inspector");
    const node = this.chosen.size === 1 ? this.sheet.nodes.find((each) => this.chosen.has(each.id)) : undefined;
    pressed(by("remove-node"), false);
    by<HTMLButtonElement>("remove-node").disabled = !this.chosen.size;
    const group = this.groupInHand();
    if (!node && group && (this.chosen.has(group.id) || this.shownWithin(group).every((id) => this.chosen.has(id))))
      return this.inspectGroup(group);
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
    const rows = this.numbersOf(node.id);
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
}
