// Drawings of a sheet that do not depend on its nodes.
import { element, svg } from "./elements";

type Pixel = [number, number];

/** Returns the curve of a link, with a point in its middle and a wider curve for the pointer. */
export function linkBetween([x0, y0]: Pixel, [x1, y1]: Pixel, words: string): SVGElement {
  const far = Math.hypot(x1 - x0, y1 - y0) || 1, bow = Math.min(24, far / 6);
  const mx = (x0 + x1) / 2 + (y1 - y0) / far * bow, my = (y0 + y1) / 2 - (x1 - x0) / far * bow;
  const path = `M${x0} ${y0}Q${mx} ${my} ${x1} ${y1}`;
  const group = svg("g", { class: "link" });
  const wide = svg("path", { d: path, class: "wide" });
  const tip = svg("circle", { cx: (x0 + 2 * mx + x1) / 4, cy: (y0 + 2 * my + y1) / 4, r: 3 });
  const title = svg("title");
  title.textContent = words;
  group.append(wide, svg("path", { d: path }), tip, title);
  return group;
}

/** Shows a rectangle while the pointer drags. `changed`: called with its sides in pixels of the host. */
export function dragRectangle(host: HTMLElement, event: PointerEvent,
    changed: (left: number, top: number, right: number, bottom: number) => void): void {
  event.preventDefault();
  event.stopPropagation();
  const box = host.getBoundingClientRect(), x0 = event.clientX - box.left, y0 = event.clientY - box.top;
  const shown = element("div", { className: "rectangle" });
  host.focus({ preventScroll: true });
  host.append(shown);
  host.setPointerCapture(event.pointerId);
  const move = (next: PointerEvent): void => {
    const x1 = next.clientX - box.left, y1 = next.clientY - box.top;
    const [left, right, top, bottom] = [Math.min(x0, x1), Math.max(x0, x1), Math.min(y0, y1), Math.max(y0, y1)];
    Object.assign(shown.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`,
      height: `${bottom - top}px` });
    changed(left, top, right, bottom);
  };
  const up = (): void => {
    shown.remove();
    host.removeEventListener("pointermove", move);
    host.removeEventListener("pointerup", up);
    host.removeEventListener("pointercancel", up);
  };
  host.addEventListener("pointermove", move);
  host.addEventListener("pointerup", up);
  host.addEventListener("pointercancel", up);
}
