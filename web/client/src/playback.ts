// A plan and its simulation in 3D: paths of the tools, stock at any time, the tool.
import { Box3, Box3Helper, BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, Quaternion, Vector3 } from "three";
import { element, short } from "./elements";
import { Scene } from "./scene";
import { ask } from "./server";

interface Surface {
  at: number; normals: number; corners: number; colours?: number; vertices: number; triangles: number
}
interface Lines { at: number; count: number }
interface Stock {
  seconds: number; stills: { seconds: number; pieces: (Surface & { piece: number })[] }[]; poses: number[][];
  tools: Record<string, Record<string, Surface>>
}
type Address = (name: string) => string;

const ROLES: Record<string, string> = { cutting: "#d4a017", shank: "#9aa3ab", holder: "#5d6b75" };

function surfaceOf(data: ArrayBuffer, told: Surface): any {
  const geometry = new BufferGeometry(), corners = 3 * told.triangles;
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(data, told.at, 3 * told.vertices), 3));
  // Four bytes each; the last is padding.
  geometry.setAttribute("normal", new BufferAttribute(Float32Array.from({ length: 3 * told.vertices },
    (_, i) => new Int8Array(data, told.normals + 4 * Math.trunc(i / 3) + i % 3, 1)[0] / 127), 3));
  if (told.colours !== undefined)
    geometry.setAttribute("color", new BufferAttribute(new Uint8Array(data, told.colours, 4 * told.vertices), 4, true));
  geometry.setIndex(new BufferAttribute(told.vertices < 65536 ? new Uint16Array(data, told.corners, corners)
    : new Uint32Array(data, told.corners, corners), 1));
  return geometry;
}

export class Playback {
  private scene: Scene;
  private bar = element("input", { type: "range", min: "0", max: "1000", ariaLabel: "Time" });
  private play = element("button", {}, "Play");
  private said = element("span", { className: "quiet" });
  private controls: HTMLElement;
  private pieces = new Map<number, any>();
  private tools = new Map<number, any>();
  private geometries = new Map<Surface, any>();
  private stock: Stock | null = null;
  private data: ArrayBuffer = new ArrayBuffer(0);
  private still = -1;
  private timer = 0;

  constructor(private host: HTMLElement) {
    const view = element("div",
      { className: "scene", role: "group", tabIndex: 0, ariaLabel: "Plan and stock in 3D: drag turns" });
    const close = element("button", { title: "Back to the picture" }, "✕");
    close.ariaLabel = "Back to the picture";
    close.onclick = () => { this.stop(); host.hidden = true; };
    this.controls = element("div", { className: "film" }, this.play, this.bar);
    host.replaceChildren(view, element("div", { className: "bar" }, this.controls, this.said, close));
    this.scene = new Scene(view);
    this.bar.oninput = () => { this.stop(); this.at(Number(this.bar.value) / 1000); };
    this.play.onclick = () => (this.timer ? this.stop() : this.start());
  }

  private stop(): void { clearInterval(this.timer); this.timer = 0; this.play.textContent = "Play"; }

  private start(): void {
    if (Number(this.bar.value) >= 1000) this.bar.value = "0";
    this.play.textContent = "Pause";
    this.timer = window.setInterval(() => {
      const next = Math.min(1000, Number(this.bar.value) + 4);
      this.bar.value = String(next);
      this.at(next / 1000);
      if (next >= 1000) this.stop();
    }, 40);
  }

  /** Shows a job's results; `address` gives the address of a file. */
  async show(address: Address, box: number[], simulated: boolean): Promise<void> {
    this.stop();
    const read = async (name: string): Promise<[any, ArrayBuffer]> => Promise.all([
      ask(address(`${name}.json`)).then((answer) => answer.json()),
      ask(address(`${name}.bin`)).then((answer) => answer.arrayBuffer())]);
    const [{ ways }, data] = await read("ways");
    for (const each of this.geometries.values()) each.dispose();
    this.geometries.clear();
    this.pieces.clear();
    this.tools.clear();
    this.still = -1;
    this.scene.model.clear();
    ways.forEach((each: { rapids: Lines; cuts: Lines }, i: number) => {
      for (const [told, colour] of [[each.rapids, "#b42318"],
          [each.cuts, `hsl(${(200 + 70 * i) % 360}, 65%, 42%)`]] as const) {
        if (!told.count) continue;
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(new Float32Array(data, told.at, 3 * told.count), 3));
        this.scene.model.add(new LineSegments(geometry, new LineBasicMaterial({ color: new Color(colour),
          transparent: true, opacity: colour === "#b42318" ? 0.35 : 0.85 })));
      }
    });
    this.scene.model.add(new Box3Helper(new Box3(new Vector3(...box.slice(0, 3)), new Vector3(...box.slice(3))),
      new Color("#7c8a90")));
    this.stock = null;
    if (simulated) {
      [this.stock, this.data] = await read("stock");
      for (const [number, parts] of Object.entries(this.stock!.tools)) {
        const tool = new Group();
        for (const [role, told] of Object.entries(parts))
          tool.add(new Mesh(surfaceOf(this.data, told), new MeshStandardMaterial({ color: new Color(ROLES[role]),
            roughness: 0.4, transparent: true, opacity: 0.8 })));
        this.tools.set(Number(number), tool);
      }
    }
    this.controls.hidden = !simulated;
    this.bar.value = "1000";
    if (simulated) this.at(1);
    else this.said.textContent = "";
    this.scene.fit();
    this.host.dataset.shown = String(1 + Number(this.host.dataset.shown ?? 0));
  }

  private geometry(told: Surface): any {
    if (!this.geometries.has(told)) this.geometries.set(told, surfaceOf(this.data, told));
    return this.geometries.get(told);
  }

  /** Shows stock and tool at a fraction of the time, 0 to 1. */
  private at(share: number): void {
    const { stills, poses, seconds } = this.stock!, wanted = Math.floor(share * (stills.length - 1) + 1e-9);
    if (wanted !== this.still) {
      const newest = new Map<number, Surface>();
      for (const still of stills.slice(0, wanted + 1)) for (const piece of still.pieces) newest.set(piece.piece, piece);
      for (const [piece, told] of newest) {
        let mesh = this.pieces.get(piece);
        if (!mesh) {
          mesh = new Mesh(new BufferGeometry(), new MeshStandardMaterial({ vertexColors: true, roughness: 0.75 }));
          this.pieces.set(piece, mesh);
          this.scene.model.add(mesh);
        }
        mesh.geometry = this.geometry(told);
      }
      this.still = wanted;
    }
    const [x, y, z, i, j, k, number, line] = poses[Math.round(share * (poses.length - 1))];
    for (const [each, tool] of this.tools) {
      if (each !== number) { this.scene.model.remove(tool); continue; }
      tool.position.set(x, y, z);
      tool.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(i, j, k)));
      this.scene.model.add(tool);
    }
    this.said.textContent = `${short(share * seconds, 3)} s, line ${line}`;
    this.host.dataset.still = String(wanted);
    this.scene.draw();
  }
}
