// Points of a text's model that are dragged in the picture: parameters NAME_x and NAME_y, with or without NAME_z.
import { element } from "./elements";
import { type Picture } from "./picture";
import type { Parameter } from "./server";

type Triple = [number, number, number];
interface Handle { name: string; axes: [Parameter, Parameter, Parameter | undefined] }

function handlesOf(parameters: Parameter[]): Handle[] {
  const byName = new Map(parameters.map((each) => [each.name, each]));
  return parameters.flatMap((x) => {
    const name = /^(\w+)_x$/.exec(x.name)?.[1], y = byName.get(`${name}_y`);
    return name && y ? [{ name, axes: [x, y, byName.get(`${name}_z`)] }] : [];
  });
}

export class Handles {
  private layer = element("div", { className: "handles" });
  private handles: Handle[] = [];
  onMove: (values: Record<string, number>) => void = () => {};

  constructor(private picture: Picture) {
    picture.host.append(this.layer);
    picture.onView = () => this.place();
    new ResizeObserver(() => this.place()).observe(picture.host);
  }

  follow(parameters: Parameter[]): void {
    const before = this.handles.map((each) => each.name).join();
    this.handles = handlesOf(parameters);
    if (before !== this.handles.map((each) => each.name).join())
      this.layer.replaceChildren(...this.handles.map((each, i) => this.elementOf(each.name, i)));
    this.place();
  }

  private at(handle: Handle): Triple {
    const [x, y, z] = handle.axes;
    return [x.value, y.value, z?.value ?? 0];
  }

  place(): void {
    const { picture } = this;
    this.layer.hidden = !picture.scale;
    for (const [i, handle] of this.handles.entries()) {
      const [u, v] = picture.project(this.at(handle));
      const [x, y] = picture.pixel(u, v);
      (this.layer.children[i] as HTMLElement).style.transform = `translate(${x}px, ${y}px)`;
    }
  }

  private elementOf(name: string, i: number): HTMLElement {
    const made = element("button", { className: "handle", title: `${name}: drag it`, ariaLabel: `Point ${name}` });
    made.onpointerdown = (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      event.stopPropagation();
      made.focus({ preventScroll: true });
      const start = this.at(this.handles[i]);
      made.setPointerCapture(event.pointerId);
      made.onpointermove = (next) => this.move(i, start,
        (next.clientX - event.clientX) * this.picture.scale, (event.clientY - next.clientY) * this.picture.scale);
      made.onpointerup = made.onpointercancel = () => {
        made.onpointermove = made.onpointerup = made.onpointercancel = null;
      };
    };
    made.onkeydown = (event) => {
      const ways: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
        ArrowDown: [0, -1] };
      const way = ways[event.key], step = this.picture.scale * (event.shiftKey ? 20 : 2);
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      this.move(i, this.at(this.handles[i]), way[0] * step, way[1] * step);
    };
    return made;
  }

  /** Moves a point in the picture's plane, mm; without NAME_z in the plane of its z. */
  private move(i: number, start: Triple, du: number, dv: number): void {
    const { picture } = this, { axes } = this.handles[i];
    let way: Triple = [du, dv, 0];
    if (!picture.twoD) {
      const [u, v] = picture.project(start);
      // Seen from the side, the plane of its z is a line: then it moves along that only.
      const to = axes[2] ? picture.through(u + du, v + dv, start, "view")
        : picture.through(u + du, v + dv, start, "z") ?? picture.through(u + du, v, start, "view");
      way = to!.map((each, axis) => each - start[axis]) as Triple;
      if (!axes[2]) way[2] = 0;
    }
    const digits = Math.min(6, Math.max(0, Math.ceil(-Math.log10(picture.scale))));
    const values: Record<string, number> = {};
    for (const [axis, parameter] of axes.entries()) {
      if (!parameter || Math.abs(way[axis]) < 1e-9) continue;
      const [low, high] = parameter.range ?? [-Infinity, Infinity];
      values[parameter.name] = Math.min(high, Math.max(low, Number((start[axis] + way[axis]).toFixed(digits))));
      parameter.value = values[parameter.name];
    }
    this.place();
    this.onMove(values);
  }
}
