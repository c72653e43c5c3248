// Scans: their upload, and the histogram of a scan that a text opens with a parameter as its threshold.
import { by, element, short, svg } from "./elements";
import { type Parameter, post, Refusal } from "./server";
import { zip } from "./zip";

export interface Scan {
  size: number[]; spacing: number[]; type: string; counts: number[]; from: number; to: number; halfway: number;
  otsu: number
}

/** The files of the picker as one file with a name that the server takes: several ones become an archive. */
export async function asOne(files: File[], progress: (share: number) => void): Promise<{ name: string; data: Blob }> {
  const plain = (name: string): string => name.replace(/[^A-Za-z0-9 .+-]/g, "_").replace(/^[^A-Za-z0-9]+/, "");
  const [first] = files;
  if (files.length > 1) {
    const header = files.find((each) => /\.(mhd|nhdr)$/i.test(each.name));
    const stem = plain((header ?? first).name).replace(/\.\w+$/, "") || "scan";
    return { name: `${stem.slice(0, 80)}.zip`, data: await zip(files, progress) };
  }
  const ending = /\.nii\.gz$|\.[A-Za-z]+$/i.exec(first.name)?.[0] ?? ".dcm";  // files of a CD have no ending
  const stem = plain(first.name.endsWith(ending) ? first.name.slice(0, -ending.length) : first.name) || "scan";
  return { name: stem.slice(0, 80) + ending, data: first };
}

/** Uploads a scan. Returns its name in the folder, and a remark. Throws Refusal, or TypeError if the server cannot be
 * reached. */
export function upload(name: string, data: Blob, progress: (share: number) => void, signal: AbortSignal):
    Promise<{ name: string; note: string }> {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();  // fetch reports no progress
    request.open("PUT", `/api/scans/${encodeURIComponent(name)}`);
    request.upload.onprogress = (event) => progress(event.loaded / data.size);
    request.onload = () => {
      if (request.status < 300) return resolve(JSON.parse(request.responseText));
      let told = { kind: "http", message: request.statusText };
      try { told = JSON.parse(request.responseText).error; } catch { /* not JSON: a proxy's answer */ }
      reject(new Refusal(request.status, told.kind, told.message));
    };
    request.onabort = () => reject(signal.reason as Error);
    signal.addEventListener("abort", () => request.abort());
    request.onerror = () => reject(new TypeError("the server is away"));
    request.send(data);
  });
}

export function lookAt(name: string): Promise<Scan> { return post<Scan>("/api/scan", { name }); }

/** Returns the text of a model that shows a scan; `note`: a remark about it. */
export function textOfScan(name: string, scan: Scan, note: string): string {
  return (note ? `# ${note}\n` : "") + `level = ${short(scan.halfway)}  # ${short(scan.from)} to ${short(scan.to)}, ` +
    "the density that separates the solid from its surroundings\n" +
    `open("${name}", threshold = level)\n`;
}

const WIDTH = 512, HEIGHT = 90;

/** The histogram next to the sliders. */
export class Histogram {
  private host = by("histogram");
  private scans = new Map<string, Promise<Scan | null>>();
  private shown = "";
  private line = svg("line", { y1: 0, y2: HEIGHT });
  private scan: Scan | null = null;
  onLevel: (parameter: string, value: number) => void = () => {};

  /** Shows the histogram of the scan that a text opens; hides it for other texts. */
  async follow(text: string, parameters: Parameter[]): Promise<void> {
    const found = /open\(\s*"([^"]+)"[^()]*\bthreshold\s*=\s*([A-Za-z_]\w*)/.exec(text);
    const parameter = found && parameters.find((each) => each.name === found[2]);
    this.host.hidden = !parameter;
    if (!found || !parameter) { this.shown = ""; return; }
    const [, name, level] = found;
    if (this.shown !== `${name} ${level}`) {
      this.shown = `${name} ${level}`;
      if (!this.scans.has(name)) this.scans.set(name, lookAt(name).catch(() => null));
      const scan = await this.scans.get(name)!;
      if (this.shown !== `${name} ${level}`) return;
      if (!scan) { this.scans.delete(name); this.host.hidden = true; return; }
      this.draw(name, level, scan);
    }
    this.mark(parameter.value);
  }

  private mark(level: number): void {
    if (!this.scan) return;
    const x = WIDTH * (level - this.scan.from) / (this.scan.to - this.scan.from);
    this.line.setAttribute("x1", String(x));
    this.line.setAttribute("x2", String(x));
  }

  private draw(name: string, level: string, scan: Scan): void {
    this.scan = scan;
    const highest = Math.log1p(Math.max(...scan.counts)), step = WIDTH / scan.counts.length;
    const picture = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", role: "img",
      "aria-label": `How often each density occurs in ${name}` });
    picture.append(svg("path", { d: `M0 ${HEIGHT}` + scan.counts.map((count, i) =>
      `V${HEIGHT * (1 - Math.log1p(count) / highest)}H${(i + 1) * step}`).join("") + `V${HEIGHT}Z` }), this.line);
    const set = (event: PointerEvent): void => {
      const box = picture.getBoundingClientRect();
      const share = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
      this.onLevel(level, Number(short(scan.from + share * (scan.to - scan.from))));
    };
    picture.addEventListener("pointerdown", (event) => {
      picture.setPointerCapture(event.pointerId);
      set(event);
    });
    picture.addEventListener("pointermove", (event) => { if (event.buttons) set(event); });
    const rules = ([["Halfway", scan.halfway], ["Otsu", scan.otsu]] as const).map(([words, value]) => {
      const button = element("button", { title: `${short(value)}` }, words);
      button.onclick = () => this.onLevel(level, Number(short(value)));
      return button;
    });
    const told = `${scan.size.join(" × ")} samples, ${scan.spacing.map((each) => short(each)).join(" × ")} mm apart`;
    this.host.replaceChildren(picture, element("div", { className: "row" }, element("small", {}, told),
      element("span", { className: "space" }), ...rules));
  }
}
