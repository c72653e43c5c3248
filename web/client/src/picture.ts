// A view of the model: a canvas, the direction and window of the view, and requests for pictures of that window.
import type { Answer, Box, Connection, Window4 } from "./server";
import { post, Refusal } from "./server";
import { element, short } from "./elements";

export interface Model { text: string; language: string }
export interface Camera {
  alpha: number; beta: number; perspective: number; mode: string;
  section: { axis: string; at: number; keep: string } | null;
  z: number  // of slices
}

type Point = [number, number, number];

/** Inverse of turned(). */
function turnedBack([x, y, z]: Point, { alpha, beta }: { alpha: number; beta: number }): Point {
  const v = Math.cos(beta) * y + Math.sin(beta) * z, w = -Math.sin(beta) * y + Math.cos(beta) * z;
  return [Math.cos(alpha) * x + Math.sin(alpha) * v, -Math.sin(alpha) * x + Math.cos(alpha) * v, w];
}

const MOST_PIXELS = 3_900_000;
const AGAIN = 1000; // ms until a picture is asked for again that the server was too busy for

export function turned([x, y, z]: Point, { alpha, beta }: { alpha: number; beta: number }): Point {
  const u = Math.cos(alpha) * x - Math.sin(alpha) * y, v = Math.sin(alpha) * x + Math.cos(alpha) * y;
  return [u, Math.cos(beta) * v - Math.sin(beta) * z, Math.sin(beta) * v + Math.cos(beta) * z];
}

export class Picture {
  readonly canvas = element("canvas");
  readonly told = element("div", { className: "told" });
  private readonly scaled = element("div", { className: "told scale" });
  readonly camera: Camera = { alpha: 0.5, beta: -0.95, perspective: 0, mode: "shaded", section: null,
    z: 0 };
  bounds: Box | null = null;
  flat = false;
  scale = 0; // mm per pixel of the page; 0: unknown, fit the model
  private offset: [number, number] = [0, 0]; // from the pivot, in the picture's plane, mm
  private pivot: Point = [0, 0, 0];
  private model: Model | null = null;
  private wrong: Model | null = null; // the model, where its text has a mistake: the last good one is shown
  private good: Model | null = null; // that of the picture
  private sent = new Map<number, Model>(); // by the numbers of requests whose answers may come
  private crosshair: [number, number] | null = null; // pixels; null: hidden
  private image: { bitmap: ImageBitmap; window: Window4; mode: string } | null = null;
  private number = 0;
  private asked = 0; // time of the request without a picture yet; 0: none
  private again = false;
  private finished = false; // whether the picture is the last one of its request
  private fitting = true;
  private fitted = 0; // number of the request that fits the model; answers to others do not
  private measured: Point[] = [];
  measuring = false;
  fixed = false; // whether the view always is from above
  onParameters: (answer: Answer) => void = () => {};
  onError: (answer: Answer | null) => void = () => {};
  onView: () => void = () => {};
  onPicture: (answer: Answer) => void = () => {};

  constructor(readonly host: HTMLElement, private connection: Connection, private name: string) {
    this.told.setAttribute("role", "status");
    host.append(this.canvas, this.told, this.scaled);
    connection.listeners.set(name, (answer) => { this.taken = this.taken.then(() => this.take(answer)); });
    connection.onOpen.push(() => { this.asked = 0; this.ask(); });
    new ResizeObserver(() => { this.draw(); this.ask(); }).observe(host);
    host.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    host.addEventListener("pointerdown", (event) => this.down(event));
    host.addEventListener("contextmenu", (event) => event.preventDefault());
    host.addEventListener("keydown", (event) => this.key(event));
    new MutationObserver(() => {
      this.draw();
      this.ask();
    }).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  }

  get twoD(): boolean { return this.flat || this.camera.mode === "bitmap"; }
  get size(): [number, number] { return [this.host.clientWidth, this.host.clientHeight]; }

  show(model: Model | null): void {
    this.model = model;
    this.wrong = null;
    if (this.measured.length || !this.measuring) this.measure(this.measuring); // what was picked is of another model
    if (model === null) {
      this.image = this.good = null;
      this.bounds = null;
      this.scaled.textContent = "";
      this.draw();
      this.onError(null);
    } else this.ask();
  }

  /** Keeps the last good picture in place of a model that cannot be asked for. */
  hold(): void { this.model = this.wrong = { text: "", language: "" }; }

  fit(): void {
    this.fitting = true;
    this.ask();
  }

  /** Shows a rectangle of the picture's plane, with a margin. */
  frame(x0: number, y0: number, x1: number, y1: number): void {
    const [w, h] = this.size;
    this.pivot = [0, 0, 0];
    this.offset = [(x0 + x1) / 2, (y0 + y1) / 2];
    this.scale = Math.max((x1 - x0) / (w - Math.min(200, 0.35 * w)), (y1 - y0) / (h - Math.min(110, 0.35 * h)), 1e-6);
    this.moved();
  }

  look(alpha: number, beta: number): void {
    Object.assign(this.camera, { alpha, beta });
    this.fit();
  }

  private centre(): [number, number] {
    const [x, y] = this.twoD ? this.pivot : turned(this.pivot, this.camera);
    return [x + this.offset[0], y + this.offset[1]];
  }

  /** Returns the visible window in the picture's plane, mm; null before the first picture. */
  window(): Window4 | null {
    if (!this.scale) return null;
    const [x, y] = this.centre(), [w, h] = this.size;
    return [x - this.scale * w / 2, y - this.scale * h / 2, x + this.scale * w / 2, y + this.scale * h / 2];
  }

  /** Maps a point in pixels from the host's corner to the picture's plane, mm. */
  place(px: number, py: number): [number, number] {
    const [x, y] = this.centre(), [w, h] = this.size;
    return [x + this.scale * (px - w / 2), y - this.scale * (py - h / 2)];
  }

  /** Inverse of place(). */
  pixel(u: number, v: number): [number, number] {
    const [x, y] = this.centre(), [w, h] = this.size;
    return [w / 2 + (u - x) / this.scale, h / 2 - (v - y) / this.scale];
  }

  /** Maps a point of the model to the picture's plane, mm (the kernel's perspective: camera.cpp). */
  project(point: Point): [number, number] {
    if (this.twoD || this.fixed) return [point[0], point[1]];
    const [u, v, z] = turned(point, this.camera), eye = this.eye();
    if (!eye) return [u, v];
    const near = 1 - (z - eye.centre[2]) / eye.distance;
    return [eye.centre[0] + (u - eye.centre[0]) / near, eye.centre[1] + (v - eye.centre[1]) / near];
  }

  /** Returns the point of the model that is seen at a point of the picture's plane, in the plane of constant depth
   * (`along`: "view") or constant z ("z") through another point; null if they do not meet. */
  through(u: number, v: number, point: Point, along: "view" | "z"): Point | null {
    const eye = this.eye(), centre = eye?.centre ?? [0, 0, 0], distance = eye?.distance ?? Infinity;
    const at = (depth: number): Point => {
      const near = 1 - (depth - centre[2]) / distance;
      return turnedBack([centre[0] + (u - centre[0]) * near, centre[1] + (v - centre[1]) * near, depth], this.camera);
    };
    const depth = turned(point, this.camera)[2];
    if (along === "view") return at(depth);
    const z0 = at(depth)[2], slope = at(depth + 1)[2] - z0; // z depends linearly on the depth
    return Math.abs(slope) > 0.1 ? at(depth + (point[2] - z0) / slope) : null;
  }

  /** Returns the centre of the model in the view, and the eye's distance from it; null for a parallel view. */
  private eye(): { centre: Point; distance: number } | null {
    const { perspective } = this.camera, { bounds } = this;
    if (!perspective || !bounds) return null;
    const [x0, y0, z0, x1, y1, z1] = bounds;
    return { centre: turned([(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2], this.camera),
      distance: Math.hypot(x1 - x0, y1 - y0, z1 - z0) / 2 / Math.sin(perspective / 2) };
  }

  /** Requests a picture of the visible window; waits for the first answer to an earlier request. */
  ask(): void {
    const [width, height] = this.size, model = this.model === this.wrong ? this.good : this.model;
    if (!model || width < 8 || height < 8) return;
    if (this.asked && performance.now() - this.asked < 25_000) {
      this.again = true;
      return;
    }
    const ratio = Math.min(devicePixelRatio || 1, 2, Math.sqrt(MOST_PIXELS / (width * height)));
    const sent = this.connection.send({
      number: ++this.number, view: this.name, ...model, ...this.camera, coarse: true, smooth: true,
      width: Math.min(4096, Math.round(width * ratio)), height: Math.min(4096, Math.round(height * ratio)),
      window: this.fitting ? null : this.window(), near: this.fitting ? null : this.bounds,
    });
    this.sent.set(this.number, model);
    this.fitted = this.fitting ? this.number : 0;
    this.asked = sent ? performance.now() : 0;
    this.again = false;
    this.host.dataset.asked = String(this.number);
  }

  // Answers are shown in order; unpacking times differ.
  private taken: Promise<void> = Promise.resolve();

  private async take(answer: Answer): Promise<void> {
    const of = this.sent.get(answer.number), isNow = of === this.model;
    if (answer.number === this.number)
      for (const number of this.sent.keys()) if (number < answer.number) this.sent.delete(number);
    if (answer.type === "parameters") return isNow ? this.onParameters(answer) : undefined;
    if (answer.type === "picture" && answer.image) {
      const bitmap = await createImageBitmap(answer.image);
      if (answer.number < this.number && answer.quality !== "coarse") return;
      if (answer.bounds) { this.bounds = answer.bounds; this.flat = answer.flat ?? false; }
      if (this.fitting && answer.number === this.fitted && this.bounds) this.adopt(answer.window!);
      this.image = { bitmap: answer.mode === "bitmap" ? this.tinted(bitmap) : bitmap, window: answer.window!,
        mode: answer.mode! };
      if (of) this.good = of;
      this.draw();
      this.host.dataset.quality = answer.quality;
      this.finished = answer.last === true;
      this.host.dataset.shown = String(answer.number);
      this.scaled.textContent = `${short(this.scale, 3)} mm per pixel`;
      if (isNow) this.onError(null);
      this.onPicture(answer);
    } else if (answer.type === "error") {
      if (isNow) this.onError(answer);
      if (answer.kind === "busy" && answer.number === this.number) setTimeout(() => this.ask(), AGAIN);
      else if (isNow && of && answer.kind === "bad_input") this.showGood(of);
    }
    if (answer.number === this.number) {
      this.asked = 0;
      if (this.again) this.ask();
    }
  }

  /** After a mistake: finishes the picture of the text before it, which its newer text interrupted. */
  private showGood(wrong: Model): void {
    this.wrong = wrong;
    this.again ||= this.good !== null && this.good !== wrong && !this.finished;
  }

  private adopt(window: Window4): void {
    const [x0, y0, z0, x1, y1, z1] = this.bounds!;
    this.pivot = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2];
    const [x, y] = this.twoD ? this.pivot : turned(this.pivot, this.camera);
    this.offset = [(window[0] + window[2]) / 2 - x, (window[1] + window[3]) / 2 - y];
    this.scale = (window[2] - window[0]) / this.size[0];
    this.fitting = false;
    this.onView();
  }

  /** Returns a slice (white inside) in the theme's colour, transparent outside. */
  private tinted(bitmap: ImageBitmap): ImageBitmap {
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), context = canvas.getContext("2d")!;
    context.drawImage(bitmap, 0, 0);
    const image = context.getImageData(0, 0, bitmap.width, bitmap.height), data = image.data;
    const [red, green, blue] = getComputedStyle(document.documentElement).getPropertyValue("--flat").split(",")
      .map(Number);
    for (let i = 0; i < data.length; i += 4) {
      data[i + 3] = data[i];
      data[i] = red;
      data[i + 1] = green;
      data[i + 2] = blue;
    }
    context.putImageData(image, 0, 0);
    return canvas.transferToImageBitmap();
  }

  draw(): void {
    const [w, h] = this.size, ratio = Math.min(devicePixelRatio || 1, 2);
    if (this.canvas.width !== Math.round(w * ratio) || this.canvas.height !== Math.round(h * ratio)) {
      this.canvas.width = Math.round(w * ratio);
      this.canvas.height = Math.round(h * ratio);
    }
    const context = this.canvas.getContext("2d")!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, w, h);
    if (!this.scale) return;
    this.host.dataset.scale = String(this.scale / ratio); // mm per pixel of the canvas
    if (this.twoD || this.fixed) this.drawGrid(context);
    if (this.image) {
      const [x0, y0, x1, y1] = this.image.window;
      const [left, top] = this.pixel(x0, y1);
      const [right, bottom] = this.pixel(x1, y0);
      context.imageSmoothingEnabled = true;
      context.drawImage(this.image.bitmap, left, top, right - left, bottom - top);
    }
    this.drawMeasured(context);
    this.drawCrosshair(context);
  }

  private drawGrid(context: CanvasRenderingContext2D): void {
    const style = getComputedStyle(document.documentElement), [w, h] = this.size;
    const step = 10 ** Math.ceil(Math.log10(12 * this.scale));
    const [left, top] = this.place(0, 0);
    const [right, bottom] = this.place(w, h);
    const line = (major: boolean, x0: number, y0: number, x1: number, y1: number): void => {
      context.strokeStyle = style.getPropertyValue(major ? "--grid-major" : "--grid");
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
    };
    context.lineWidth = 1;
    for (let i = Math.ceil(left / step); i * step <= right; ++i) {
      const x = Math.round(this.pixel(i * step, 0)[0]) + 0.5;
      line(i % 10 === 0, x, 0, x, h);
    }
    for (let i = Math.ceil(bottom / step); i * step <= top; ++i) {
      const y = Math.round(this.pixel(0, i * step)[1]) + 0.5;
      line(i % 10 === 0, 0, y, w, y);
    }
  }

  private drawCrosshair(context: CanvasRenderingContext2D): void {
    if (!this.crosshair) return;
    const [x, y] = this.crosshair.map((each) => Math.round(each) + 0.5);
    const style = getComputedStyle(document.documentElement);
    for (const [colour, width] of [["--panel", 4], ["--accent", 2]] as const) {
      context.strokeStyle = style.getPropertyValue(colour);
      context.lineWidth = width;
      context.beginPath();
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        context.moveTo(x + 4 * dx, y + 4 * dy);
        context.lineTo(x + 16 * dx, y + 16 * dy);
      }
      context.stroke();
    }
  }

  private drawMeasured(context: CanvasRenderingContext2D): void {
    if (!this.measured.length) return;
    const flat = (place: Point): [number, number] => {
      const [u, v] = this.project(place);
      return this.pixel(u, v);
    };
    const pixels = this.measured.map(flat);
    const colour = getComputedStyle(document.documentElement).getPropertyValue("--accent");
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = 2;
    context.beginPath();
    for (const [x, y] of pixels) { context.moveTo(x + 4, y); context.arc(x, y, 4, 0, 7); }
    context.fill();
    if (pixels.length < 2) return;
    context.beginPath();
    context.moveTo(...pixels[0]);
    context.lineTo(...pixels[1]);
    context.stroke();
  }

  /** Starts or ends measuring. */
  measure(on: boolean): void {
    this.measuring = on;
    this.measured = [];
    this.host.classList.toggle("measuring", on);
    this.told.textContent = on ? "Click two points of the model, or show the crosshair (C)" : "";
    this.draw();
  }

  private async pick(px: number, py: number): Promise<void> {
    const model = this.model === this.wrong ? this.good : this.model;
    if (!model) return;
    try {
      const { text, language } = model, { alpha, beta, perspective, mode, section, z } = this.camera;
      const found = await post<{ place: Point | null; value: number | null; part: string | null }>(
        "/api/pick", { text, language, alpha, beta, perspective, mode, section, z, at: this.place(px, py) });
      if (!found.place) { this.told.textContent = "Nothing is there"; return; }
      if (this.measuring)
        this.measured = [...this.measured.slice(this.measured.length === 2 ? 2 : 0), found.place];
      const [a, b] = this.measured, shown = found.place.map((each) => short(each)).join(", ");
      const way = a && b ? a.map((each, i) => b[i] - each) : [];
      this.told.textContent = a && b
        ? `${short(Math.hypot(...way))} mm (${way.map((each) => short(each)).join(", ")})`
        : `${found.part ? found.part + ": " : ""}${shown} mm`;
      this.draw();
    } catch (error) {
      this.told.textContent = error instanceof Refusal ? error.message : "The server is away";
    }
  }

  // Mouse and keys

  private wheel(event: WheelEvent): void {
    if (!this.scale) return;
    event.preventDefault();
    const box = this.host.getBoundingClientRect();
    this.zoom(1.0015 ** event.deltaY, event.clientX - box.left, event.clientY - box.top);
  }

  zoom(factor: number, px = this.size[0] / 2, py = this.size[1] / 2): void {
    const [w, h] = this.size, scale = Math.min(1e6, Math.max(1e-9, this.scale * factor));
    this.offset[0] += (px - w / 2) * (this.scale - scale);
    this.offset[1] -= (py - h / 2) * (this.scale - scale);
    this.scale = scale;
    this.moved();
  }

  private moved(): void {
    this.fitting = false;
    this.draw();
    this.onView();
    this.ask();
  }

  pan(dx: number, dy: number): void {
    this.offset[0] -= dx * this.scale;
    this.offset[1] += dy * this.scale;
    this.moved();
  }

  turn(dx: number, dy: number): void {
    this.camera.alpha += 0.01 * dx;
    this.camera.beta = Math.min(0, Math.max(-Math.PI, this.camera.beta + 0.01 * dy));
    this.moved();
  }

  private touches = new Map<number, [number, number]>();

  private down(event: PointerEvent): void {
    if (!this.scale || event.defaultPrevented) return;
    this.host.focus({ preventScroll: true });
    this.touches.set(event.pointerId, [event.clientX, event.clientY]);
    this.host.setPointerCapture(event.pointerId);
    const panning = this.twoD || this.fixed || event.button !== 0 || event.shiftKey;
    let way = 0, alone = this.touches.size === 1;
    const move = (next: PointerEvent): void => {
      const last = this.touches.get(next.pointerId);
      if (!last) return;
      const dx = next.clientX - last[0], dy = next.clientY - last[1];
      way += Math.abs(dx) + Math.abs(dy);
      if (this.touches.size === 2) {
        alone = false;
        const other = [...this.touches].find(([id]) => id !== next.pointerId)![1];
        const box = this.host.getBoundingClientRect();
        const before = Math.hypot(last[0] - other[0], last[1] - other[1]);
        const after = Math.hypot(next.clientX - other[0], next.clientY - other[1]);
        this.pan(dx / 2, dy / 2);
        if (after > 0)
          this.zoom(before / after, (next.clientX + other[0]) / 2 - box.left, (next.clientY + other[1]) / 2 - box.top);
      } else if (panning) this.pan(dx, dy);
      else this.turn(dx, dy);
      this.touches.set(next.pointerId, [next.clientX, next.clientY]);
    };
    const up = (end: PointerEvent): void => {
      if (end.pointerId !== event.pointerId) return;
      this.touches.delete(event.pointerId);
      this.host.removeEventListener("pointermove", move);
      this.host.removeEventListener("pointerup", up);
      this.host.removeEventListener("pointercancel", up);
      const box = this.host.getBoundingClientRect();
      if (alone && way < 4 && event.button === 0 && !this.fixed)
        void this.pick(end.clientX - box.left, end.clientY - box.top);
    };
    this.host.addEventListener("pointermove", move);
    this.host.addEventListener("pointerup", up);
    this.host.addEventListener("pointercancel", up);
  }

  /** Shows or hides the crosshair, by which keys pick and measure. */
  aim(on: boolean): void {
    const [w, h] = this.size;
    this.crosshair = on ? [w / 2, h / 2] : null;
    this.host.dataset.crosshair = String(on);
    this.draw();
  }

  private moveCrosshair([dx, dy]: [number, number], far: boolean): void {
    const [w, h] = this.size, step = far ? 40 : 4, [x, y] = this.crosshair!;
    this.crosshair = [Math.min(w, Math.max(0, x + step * dx)), Math.min(h, Math.max(0, y + step * dy))];
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || event.target !== this.host) return;
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
      ArrowDown: [0, 1] };
    const way = arrows[event.key];
    if (event.key.toLowerCase() === "c" && !this.fixed) this.aim(!this.crosshair);
    else if (this.crosshair && way) this.moveCrosshair(way, event.shiftKey);
    else if (this.crosshair && event.key === "Enter") void this.pick(...this.crosshair);
    else if (this.crosshair && event.key === "Escape") this.aim(false);
    else if (way)
      (this.twoD || this.fixed || event.shiftKey) ? this.pan(20 * way[0], 20 * way[1])
        : this.turn(10 * way[0], 10 * way[1]);
    else if (event.key === "+" || event.key === "=") this.zoom(0.8);
    else if (event.key === "-") this.zoom(1.25);
    else return;
    event.preventDefault();
  }
}
