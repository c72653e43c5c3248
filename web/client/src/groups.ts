// Groups of a sheet's nodes. A closed group is shown as one node with the inputs and outputs of its members; the model
// does not depend on groups. Groups can be within groups. Independent of the page.
import type { Group, Sheet, SheetNode } from "./sheet";

export type Item = SheetNode | Group;

export function isGroup(item: Item): item is Group { return !("code" in item); }

function groupsById(sheet: Sheet): Map<number, Group> {
  return new Map(sheet.groups.map((each) => [each.id, each]));
}

/** Returns the groups around a node or group, the innermost first. */
export function around(sheet: Sheet, item: Item): Group[] {
  const byId = groupsById(sheet), found: Group[] = [];
  for (let at = byId.get(item.group!); at; at = byId.get(at.group!)) found.push(at);
  return found;
}

/** Throws Error for a group within itself. */
export function checkGroups(sheet: Sheet): void {
  const byId = groupsById(sheet);
  for (const item of [...sheet.nodes, ...sheet.groups])
    if (item.group !== undefined && !byId.has(item.group)) delete item.group;
  for (const start of sheet.groups) {
    const seen = new Set([start.id]);
    for (let at = byId.get(start.group!); at; at = byId.get(at.group!)) {
      if (seen.has(at.id)) throw new Error("A group of this sheet is within itself");
      seen.add(at.id);
    }
  }
}

/** Returns the id of what shows a node or group: itself, or the outermost closed group around it. */
export function shownAs(sheet: Sheet, item: Item): number {
  return around(sheet, item).filter((each) => !each.open).pop()?.id ?? item.id;
}

/** Returns what the sheet shows: nodes and closed groups. */
export function shownItems(sheet: Sheet): Item[] {
  return [...sheet.nodes, ...sheet.groups.filter((each) => !each.open)]
    .filter((each) => shownAs(sheet, each) === each.id);
}

/** Returns the open groups that are not within a closed one. */
export function openGroups(sheet: Sheet): Group[] {
  return sheet.groups.filter((each) => each.open && shownAs(sheet, each) === each.id);
}

/** Returns all nodes within a group. */
export function membersOf(sheet: Sheet, group: number): SheetNode[] {
  return sheet.nodes.filter((node) => around(sheet, node).some((each) => each.id === group));
}

/** Returns nodes and groups by their ids, with all that is within the groups. */
export function withMembers(sheet: Sheet, ids: Iterable<number>): { nodes: SheetNode[]; groups: Group[] } {
  const wanted = new Set(ids);
  const within = (item: Item): boolean =>
    wanted.has(item.id) || around(sheet, item).some((each) => wanted.has(each.id));
  return { nodes: sheet.nodes.filter(within), groups: sheet.groups.filter(within) };
}

/** Members that take nodes from outside, or could; members that give to nodes outside, or to none. */
export function portsOf(sheet: Sheet, group: number): { inputs: SheetNode[]; outputs: SheetNode[] } {
  const members = membersOf(sheet, group), inside = new Set(members.map((node) => node.id));
  const outside = sheet.nodes.filter((node) => !inside.has(node.id));
  return {
    inputs: members.filter((node) => node.parents.some((id) => !inside.has(id)) ||
      (!node.parents.length && /\bparents\b/.test(node.code.replace(/\/\/.*/g, "")))),
    outputs: members.filter((node) => outside.some((each) => each.parents.includes(node.id)) ||
      !members.some((each) => each.parents.includes(node.id))),
  };
}

export function nextId(sheet: Sheet): number {
  return 1 + Math.max(0, ...sheet.nodes.map((node) => node.id), ...sheet.groups.map((each) => each.id));
}

/** Removes groups without members. */
export function prune(sheet: Sheet): void {
  sheet.groups = sheet.groups.filter((each) => membersOf(sheet, each.id).length > 0);
}

/** Puts nodes and closed groups into a new closed group, in the middle of them. Returns it. */
export function makeGroup(sheet: Sheet, items: Item[]): Group {
  const [first] = items, same = items.every((each) => each.group === first.group);
  const middle = (of: (item: Item) => number): number =>
    Number((items.reduce((sum, each) => sum + of(each), 0) / items.length).toFixed(4));
  const names = new Set(sheet.groups.map((each) => each.name));
  let number = 1;
  while (names.has(`Group ${number}`)) ++number;
  const group: Group = { id: nextId(sheet), name: `Group ${number}`, x: middle((each) => each.x),
    y: middle((each) => each.y), open: false };
  if (same && first.group !== undefined) group.group = first.group;
  for (const each of items) each.group = group.id;
  sheet.groups.push(group);
  prune(sheet);
  return group;
}

/** Removes a group; its members stay. */
export function ungroup(sheet: Sheet, group: Group): void {
  for (const each of [...sheet.nodes, ...sheet.groups]) {
    if (each.group !== group.id) continue;
    if (group.group === undefined) delete each.group;
    else each.group = group.group;
  }
  sheet.groups = sheet.groups.filter((each) => each !== group);
}

/** Opens a group, or closes it in the middle of its members. */
export function toggle(sheet: Sheet, group: Group): void {
  group.open = !group.open;
  if (group.open) return;
  const members = membersOf(sheet, group.id);
  for (const side of ["x", "y"] as const)
    group[side] = Number((members.reduce((sum, each) => sum + each[side], 0) / members.length).toFixed(4));
}

/** Returns copies of nodes and groups with new ids, moved. Groups whose members are all copied are copied, too. */
export function copies(sheet: Sheet, nodes: SheetNode[], groups: Group[], away: number): Item[] {
  const first = nextId(sheet);
  const number = new Map([...nodes, ...groups].map((each, i) => [each.id, first + i]));
  const there = new Set([...sheet.nodes, ...sheet.groups].map((each) => each.id));
  return [...nodes, ...groups].map((each) => {
    const made = { ...structuredClone(each), id: number.get(each.id)!, x: each.x + away, y: each.y - away };
    if (!isGroup(made))
      made.parents = made.parents.filter((id) => number.has(id) || there.has(id)).map((id) => number.get(id) ?? id);
    if (made.group !== undefined) {
      const group = number.get(made.group) ?? (there.has(made.group) ? made.group : undefined);
      if (group === undefined) delete made.group;
      else made.group = group;
    }
    return made;
  });
}

/** Returns the nodes and groups to copy for what is chosen: with members, and the open groups that are chosen whole. */
export function toCopy(sheet: Sheet, ids: Iterable<number>): { nodes: SheetNode[]; groups: Group[] } {
  const { nodes, groups } = withMembers(sheet, ids), copied = new Set(nodes);
  const whole = sheet.groups.filter((each) => groups.includes(each) ||
    membersOf(sheet, each.id).every((node) => copied.has(node)));
  return structuredClone({ nodes, groups: whole });
}
