// A sheet: a graph of nodes, each a piece of JavaScript at a position in millimetres. Independent of the page.
import { checkGroups } from "./groups";
import { MOST } from "./history";

export interface SheetNode {
  id: number; name: string; x: number; y: number; code: string; values: Record<string, number | string>;
  parents: number[]; group?: number;
}
/** A group of nodes (groups.ts). `group`: the one around it. Its place is that of the closed group's node. */
export interface Group { id: number; name: string; x: number; y: number; open: boolean; group?: number }
export interface Sheet {
  format: "fieldfab sheet"; version: 1; snap: number; nodes: SheetNode[]; groups: Group[]; text: string
}

/** Result of a node's code. */
export interface Result {
  id: number; text: string | null; error: string | null; line: number | null;
  sliders: { name: string; value: number | string; low?: number; high?: number }[];
}

export const VERSION = 1;

export function emptySheet(): Sheet {
  return { format: "fieldfab sheet", version: VERSION, snap: 1, nodes: [], groups: [], text: "" };
}

/** Reads a document. Throws Error with a description of the fault. */
export function readSheet(text: string): Sheet {
  let given: Partial<Sheet>;
  try {
    given = JSON.parse(text);
  } catch (error) {
    throw new Error(`This is not a sheet: ${(error as Error).message}`, { cause: error });
  }
  if (given?.format !== "fieldfab sheet") throw new Error("This .json file is not a sheet of fabserver");
  if (typeof given.version !== "number" || given.version > VERSION)
    throw new Error(`This sheet is of version ${given.version}; this page knows version ${VERSION}. ` +
      "It is left as it is: open it with a newer Fieldfab");
  const ids = new Set<number>();
  for (const node of given.nodes ?? []) {
    if (!Number.isInteger(node.id) || ids.has(node.id) || typeof node.code !== "string" ||
        typeof node.name !== "string" || !Number.isFinite(node.x) || !Number.isFinite(node.y) ||
        !Array.isArray(node.parents))
      throw new Error("A node of this sheet has no number of its own, or no name, place, code or links");
    ids.add(node.id);
    node.values ??= {};
  }
  const sheet = { ...emptySheet(), ...given } as Sheet;
  for (const node of sheet.nodes) node.parents = node.parents.filter((id) => ids.has(id));
  for (const each of sheet.groups) {
    if (!Number.isInteger(each.id) || ids.has(each.id) || typeof each.name !== "string" ||
        !Number.isFinite(each.x) || !Number.isFinite(each.y) || typeof each.open !== "boolean")
      throw new Error("A group of this sheet has no number of its own, or no name, place or state");
    ids.add(each.id);
  }
  checkGroups(sheet);
  inOrder(sheet);
  return sheet;
}

export function writeSheet(sheet: Sheet): string { return JSON.stringify(sheet, null, 1) + "\n"; }

/** Returns the nodes in topological order, parents first. Throws Error for a cycle. */
export function inOrder(sheet: Sheet): SheetNode[] {
  const byId = new Map(sheet.nodes.map((node) => [node.id, node])), done = new Set<number>(), order: SheetNode[] = [];
  for (const start of sheet.nodes) {
    const stack: [SheetNode, number][] = [[start, 0]], under = new Set([start.id]);
    while (stack.length) {
      const top = stack[stack.length - 1], [node, next] = top;
      if (done.has(node.id)) { under.delete(node.id); stack.pop(); continue; }
      if (next < node.parents.length) {
        ++top[1];
        const parent = byId.get(node.parents[next])!;
        if (under.has(parent.id)) throw new Error("The links of this sheet make a cycle: a node depends on itself");
        if (!done.has(parent.id)) { under.add(parent.id); stack.push([parent, 0]); }
      } else {
        done.add(node.id);
        order.push(node);
      }
    }
  }
  return order;
}

/** Whether a link from one node to another would make a cycle. */
export function makesCircle(sheet: Sheet, from: number, to: number): boolean {
  const byId = new Map(sheet.nodes.map((node) => [node.id, node])), todo = [from], seen = new Set<number>();
  while (todo.length) {
    const id = todo.pop()!;
    if (id === to) return true;
    if (seen.has(id)) continue;
    seen.add(id);
    todo.push(...byId.get(id)!.parents);
  }
  return false;
}

/** Returns the name of a node's shape in the text. */
export function shapeName(node: SheetNode): string {
  return (node.name.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^_+|_+$/g, "").replace(/^(\d)/, "n$1") ||
    "node") + `_${node.id}`;
}

/** Returns the sheet's f-rep text and, for each of its lines, the node that made it. */
export function textOf(sheet: Sheet, results: Map<number, Result>): { text: string; nodes: number[] } {
  const lines: string[] = [], nodes: number[] = [], used = new Set<number>(), shapes: SheetNode[] = [];
  for (const node of inOrder(sheet)) {
    const text = results.get(node.id)?.text;
    if (typeof text !== "string" || !text.trim()) continue;
    const line = `${shapeName(node)} = ${text.trim()}`;
    lines.push(line);
    nodes.push(...line.split("\n").map(() => node.id));
    shapes.push(node);
    for (const parent of node.parents) used.add(parent);
  }
  // A shape that another one uses is not a shape of the model.
  const last = shapes.filter((node) => !used.has(node.id)).map(shapeName);
  return { text: last.length ? [...lines, last.join(" | ")].join("\n") + "\n" : "", nodes };
}

/** Unlimited undo and redo: states of a document, as text. */
export class Past {
  private states: string[];
  private at = 0;

  constructor(first: string) { this.states = [first]; }

  private merging = "";
  private kept = 0;

  /** Adds a state. `merging`: name of the input; quick successive changes of one input are one step. */
  keep(state: string, merging = ""): void {
    if (state === this.states[this.at]) return;
    const now = Date.now(), goesOn = merging !== "" && merging === this.merging && now - this.kept < 1500;
    this.merging = merging;
    this.kept = now;
    this.states.length = this.at + (goesOn ? 0 : 1);
    this.states.push(state);
    this.at = this.states.length - 1;
  }

  get now(): string { return this.states[this.at]; }

  /** Returns the present state and those next to it, within a limit of characters: for storage. */
  stored(): { states: string[]; at: number } {
    let first = this.at, last = this.at, size = this.now.length;
    while (last + 1 < this.states.length && (size += this.states[last + 1].length) <= MOST / 2) ++last;
    while (first > 0 && (size += this.states[first - 1].length) <= MOST) --first;
    return { states: this.states.slice(first, last + 1), at: this.at - first };
  }

  /** Takes stored states. Returns whether they were usable. */
  take(given: unknown): boolean {
    const { states, at } = (given ?? {}) as { states?: string[]; at?: number };
    if (!Array.isArray(states) || !states.every((each) => typeof each === "string") ||
        !Number.isInteger(at) || states[at!] === undefined) return false;
    this.states = states;
    this.at = at!;
    return true;
  }

  undo(): string | null { this.merging = ""; return this.at > 0 ? this.states[--this.at] : null; }
  redo(): string | null { return this.at + 1 < this.states.length ? this.states[++this.at] : null; }
}
