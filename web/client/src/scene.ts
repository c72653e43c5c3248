// A 3D view of a model, rotated by mouse, touch or keys, drawn by three.js. Lengths are mm, z is up.
import { AmbientLight, Box3, Color, DirectionalLight, Group, PerspectiveCamera, Scene as World, Spherical,
  Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

export class Scene {
  readonly model = new Group();
  private world = new World();
  private camera = new PerspectiveCamera(30, 1, 0.1, 1e5);
  private renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  private controls: any;
  private waiting = false;

  /** Throws if the browser has no WebGL. */
  constructor(readonly host: HTMLElement) {
    this.camera.up.set(0, 0, 1);
    const light = new DirectionalLight(new Color(1, 1, 1), 2.4);
    light.position.set(-0.5, 0.8, 1);  // in camera coordinates: above the left shoulder
    this.camera.add(light);
    this.world.add(this.model, this.camera, new AmbientLight(new Color(1, 1, 1), 0.8));
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    host.append(this.renderer.domElement);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.enableZoom = false;  // without focus the wheel scrolls the page
    host.addEventListener("pointerdown", () => host.focus({ preventScroll: true }));
    host.addEventListener("focus", () => { this.controls.enableZoom = true; });
    host.addEventListener("blur", () => { this.controls.enableZoom = false; });
    host.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.fill()).observe(host);
    this.fill();
  }

  private fill(): void {
    const w = Math.max(1, this.host.clientWidth), h = Math.max(1, this.host.clientHeight), before = this.distance();
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.camera.position.sub(this.controls.target).multiplyScalar(this.distance() / before).add(this.controls.target);
    this.draw();
  }

  /** Distance from which a ball of radius 1 fits the narrower side of the view. */
  private distance(): number {
    return Math.hypot(1, 1 / Math.tan(Math.PI / 360 * this.camera.fov) / Math.min(1, this.camera.aspect));
  }

  private forEachCorner(visit: (corner: any) => void): void {
    const corner = new Vector3();
    this.model.traverse((each: any) => {
      const corners = each.geometry?.attributes.position;
      for (let i = 0; i < (corners?.count ?? 0); ++i)
        visit(corner.fromBufferAttribute(corners, i).applyMatrix4(each.matrixWorld));
    });
  }

  draw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.renderer.render(this.world, this.camera);
      this.host.dataset.drawn = String(1 + Number(this.host.dataset.drawn ?? 0));
    });
  }

  /** Fits the model to the view, seen from a corner: in its middle, and so far away that no turn leads out of it. */
  fit(alpha = 0.6, height = 0.45): void {
    const { target } = this.controls, seen = new Box3(), middle = new Vector3();
    const way = new Vector3(Math.sin(-alpha) * Math.cos(height), -Math.cos(alpha) * Math.cos(height), Math.sin(height));
    const place = (): void => {
      let radius = 1e-3;
      this.forEachCorner((corner) => { radius = Math.max(radius, corner.distanceTo(target)); });
      const far = 1.05 * radius * this.distance();
      Object.assign(this.camera, { near: far / 100, far: far * 10 });
      this.camera.updateProjectionMatrix();
      this.camera.position.copy(way).multiplyScalar(far).add(target);
      this.controls.update();
      this.camera.updateMatrixWorld();
    };
    new Box3().setFromObject(this.model).getCenter(target);
    place();
    this.forEachCorner((corner) => seen.expandByPoint(corner.project(this.camera)));
    const { z } = target.clone().project(this.camera);
    target.copy(seen.getCenter(middle).setZ(z).unproject(this.camera));
    place();
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    const ways: Record<string, [number, number, number]> = { ArrowLeft: [-1, 0, 1], ArrowRight: [1, 0, 1],
      ArrowUp: [0, -1, 1], ArrowDown: [0, 1, 1], "+": [0, 0, 0.85], "-": [0, 0, 1 / 0.85] };
    const way = ways[event.key];
    if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const from = new Vector3().subVectors(this.camera.position, this.controls.target);
    const at = new Spherical().setFromCartesianCoords(from.y, from.z, from.x);
    at.set(at.radius * way[2], Math.min(Math.PI - 0.01, Math.max(0.01, at.phi + 0.1 * way[1])),
      at.theta - 0.1 * way[0]);
    const to = new Vector3().setFromSpherical(at);
    this.camera.position.set(to.z, to.x, to.y).add(this.controls.target);
    this.controls.update();
    this.draw();
  }
}

/**
 * The model of a .glb file as Fieldfab writes it (metres, y up), in mm with z up. Parts without a colour get `colour`,
 * and are smooth.
 */
export async function readGlb(data: ArrayBuffer, colour?: string): Promise<unknown> {
  const { scene } = await new GLTFLoader().parseAsync(data, "");
  scene.rotation.x = Math.PI / 2;
  scene.scale.setScalar(1000);
  scene.traverse((each: any) => {
    if (!each.isMesh) return;
    each.material.roughness = 0.65;
    each.material.metalness = 0;
    if (colour) {
      each.material.color.set(colour);
      each.geometry.computeVertexNormals();
      each.material.flatShading = false;
      each.material.needsUpdate = true;
    }
  });
  return scene;
}
