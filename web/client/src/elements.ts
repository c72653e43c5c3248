// Elements of the page. Text is inserted as text only, never as HTML.

export function by<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, values: Partial<HTMLElementTagNameMap[K]> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const made = Object.assign(document.createElement(tag), values);
  made.append(...children);
  return made;
}

export function svg(tag: string, attributes: Record<string, string | number> = {}): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  return made;
}

/** Returns a number in short decimal notation. */
export function short(value: number, digits = 4): string {
  return String(Number(value.toPrecision(digits)));
}

export function pressed(button: HTMLElement, on: boolean): void {
  button.setAttribute("aria-pressed", String(on));
}

/** Returns a number input with a slider. `changed` is called during a drag, `settled` at its end. */
export function slider(name: string, now: number, range: [number, number], hint: string,
    changed: (value: number) => void, settled: () => void): HTMLElement {
  const low = Math.min(range[0], now), high = Math.max(range[1], now, low + 1e-6);
  const digits = Math.max(0, 2 - Math.floor(Math.log10(high - low)));
  const bar = element("input", { type: "range", min: String(low), max: String(high), step: String(10 ** -digits),
    value: String(now), ariaLabel: name, title: hint });
  const box = element("input", { type: "number", step: "any", value: String(now), ariaLabel: `${name}, a number` });
  const take = (text: string): void => {
    const value = Number(text);
    if (text === "" || !Number.isFinite(value)) return;
    changed(Number(value.toFixed(6)));
  };
  bar.oninput = () => { box.value = bar.value; take(bar.value); };
  box.oninput = () => { bar.value = box.value; take(box.value); };
  bar.onchange = box.onchange = settled;
  return element("label", { className: "slider", title: hint }, element("span", {}, name), bar, box);
}
