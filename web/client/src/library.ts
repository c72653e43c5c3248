// Kinds of nodes: built-in ones, one for each function of the shape library, and kinds saved by the user.
import type { LibraryFunction } from "./server";

export interface NodeKind {
  name: string; group: string; meaning: string; code: string; parents: number; values?: Record<string, number | string>
}

const OWN: NodeKind[] = [
  { name: "Point", group: "Places", parents: 0, meaning: "a place for others to take",
    code: "// A place, which nodes after this one take as parents[0].x and parents[0].y.\nreturn { x, y };\n" },
  { name: "Midpoint", group: "Places", parents: 2, meaning: "the middle of the nodes before it", code:
      "// The middle of all parents, wherever this node is.\n" +
      "return {\n" +
      "  x: parents.reduce((sum, each) => sum + each.x, 0) / parents.length,\n" +
      "  y: parents.reduce((sum, each) => sum + each.y, 0) / parents.length,\n" +
      "};\n" },
  { name: "Number", group: "Places", parents: 0, meaning: "a number for others to take",
    code: "return { number: value(\"number\", 5, 0, 50) };\n" },
  { name: "Circle through", group: "From places", parents: 1,
    meaning: "a circle about the node before it, through this one", code:
      "// The circle's centre is the node before it; its radius reaches to this node.\n" +
      "const [centre] = parents;\n" +
      "const r = distance(centre, { x, y });\n" +
      "return `move(circle(${mm(r)}), ${mm(centre.x)}, ${mm(centre.y)})`;\n" },
  { name: "Rectangle between", group: "From places", parents: 1,
    meaning: "a rectangle from the node before it to this one", code:
      "const [corner] = parents;\n" +
      "const dx = Math.abs(x - corner.x), dy = Math.abs(y - corner.y);\n" +
      "const r = Math.min(value(\"round\", 2, 0, 10), dx / 2, dy / 2);\n" +
      "return `move(rounded_rectangle(${mm(dx)}, ${mm(dy)}, ${mm(r)}), " +
      "${mm((x + corner.x) / 2)}, ${mm((y + corner.y) / 2)})`;\n" },
  { name: "Bar between", group: "From places", parents: 2,
    meaning: "a bar with round ends through the nodes before it", code:
      "// A bar from each parent to the next one.\n" +
      "const width = value(\"width\", 6, 0.5, 40);\n" +
      "return parents.slice(1).map((to, i) => {\n" +
      "  const from = parents[i];\n" +
      "  return `stroke(${mm(from.x)}, ${mm(from.y)}, ${mm(to.x)}, ${mm(to.y)}, ${mm(width)})`;\n" +
      "}).join(\" | \");\n" },
  { name: "Plate", group: "From places", parents: 1, meaning: "the shapes before it as a plate", code:
      "// All shapes before this node, as thick as its slider says.\n" +
      "const flat = parents.filter((each) => each.shape).map((each) => each.shape).join(\" | \");\n" +
      "return `extrude(${flat}, ${mm(value(\"thickness\", 5, 0.2, 40))})`;\n" },
  { name: "Cut", group: "Sets", parents: 2, meaning: "the first shape without the others",
    code: "// The first shape without all others.\nreturn parents.map((each) => each.shape).join(\" - \");\n" },
];

const SHAPES = new Set(["shape", "a", "b"]);

/** Initial value of a number without a default. */
const START: Record<string, number> = { angle: 30, whole: 3, number: 5, expression: 5 };

/** Calls that show nothing with the usual numbers: constants in place of coordinates, shapes without end. */
const CALLS: Record<string, string> = {
  map: "map(${parents[0].shape}, x, y + ${mm(value(\"bend\", 2, 0, 10))} * sin(x / " +
    "${mm(value(\"length\", 5, 1, 20))}), z)",
  repeat_x: "repeat_x(${parents[0].shape}, ${mm(value(\"period\", 20, 1, 100))}) & " +
    "rectangle(${mm(value(\"end\", 80, 1, 400))}, 1000)",
  repeat_y: "repeat_y(${parents[0].shape}, ${mm(value(\"period\", 20, 1, 100))}) & " +
    "rectangle(1000, ${mm(value(\"end\", 80, 1, 400))})",
  repeat_z: "repeat_z(${parents[0].shape}, ${mm(value(\"period\", 20, 1, 100))}) & " +
    "box(1000, 1000, ${mm(value(\"end\", 80, 1, 400))})",
  taper: "taper(${parents[0].shape}, ${mm(value(\"height\", 20, 1, 200))}, ${mm(value(\"factor\", 0.6, 0, 2))})",
};

/** Cuts off what has no end. */
const BLOCK = "box(${Array(3).fill(mm(value(\"size\", 30, 1, 200))).join(\", \")})";

function codeOf(each: LibraryFunction): { code: string; parents: number } {
  const shapes = each.parameters.filter((p) => SHAPES.has(p.name) && p.default === null);
  const moved = shapes.length === 0;
  const numbers = each.parameters.filter((p) => !shapes.includes(p)).map((p) => {
    if (p.kind === "text") return `\${word(${JSON.stringify(p.name)}, "fab")}`;
    const start = p.default ?? START[p.kind] ?? 5;
    // Lengths of the table are 1 mm; ten times that gives a shape of visible size.
    const scaled = p.kind === "expression" && moved && start !== 0 ? 10 * start : start;
    const [low, high] = p.kind === "angle" ? [-180, 180] : p.kind === "whole" ? [1, Math.max(40, 2 * scaled)]
      : scaled === 0 ? [-20, 20] : [0, 4 * scaled];
    const digits = p.kind === "whole" ? `Math.round(value(${JSON.stringify(p.name)}, ${scaled}, ${low}, ${high}))`
      : `value(${JSON.stringify(p.name)}, ${scaled}, ${low}, ${high})`;
    return `\${mm(${digits})}`;
  });
  const all = each.any_number && shapes.length ? ["${parents.map((each) => each.shape).join(\", \")}"]
    : shapes.map((_, i) => `\${parents[${i}].shape}`);
  let call = CALLS[each.name] ?? `${each.name}(${[...all, ...numbers].join(", ")})`;
  if (each.group === "Lattices") call = `shell(${call}, \${mm(value("wall", 1, 0.1, 10))}) & ${BLOCK}`;
  else if (each.name === "plane") call += ` & ${BLOCK}`;
  const meaning = each.meaning ? `// ${each.signature}: ${each.meaning.replaceAll("\n", " ")}\n`
    : `// ${each.signature}\n`;
  const text = moved ? `move(${call}, \${mm(x)}, \${mm(y)})` : call;
  return { code: `${meaning}return \`${text}\`;\n`, parents: shapes.length };
}

const saved = "fabserver nodes";

export function ownKinds(): NodeKind[] {
  try {
    return JSON.parse(localStorage.getItem(saved) ?? "[]");
  } catch {
    return [];
  }
}

export function saveKind(kind: NodeKind): void {
  localStorage.setItem(saved, JSON.stringify([...ownKinds().filter((each) => each.name !== kind.name), kind]));
}

/** Returns all kinds, from the shape library's table. */
export function kindsOf(functions: LibraryFunction[]): NodeKind[] {
  const skipped = new Set(["numbers", "Circuit boards (flat copper)"]);
  const unfit = new Set(["outline", "solid", "difference"]);
  const made = functions.filter((each) => !skipped.has(each.group) && !unfit.has(each.name) &&
    !(each.group === "Sets" && ["min", "max"].includes(each.name)))
    .map((each) => ({ name: each.name, group: each.group, meaning: each.meaning, ...codeOf(each) }));
  return [...OWN, ...made];
}
