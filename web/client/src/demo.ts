// The demo's page of static files. It works from a disk as well: browsers load scripts from there, but no .glb files.
// Each model is therefore also a script that contains the model as text.
import { readGlb, Scene } from "./scene";

const waiting = new Map<string, (data: string) => void>();
Object.assign(window, { fieldfabModel: (name: string, data: string) => waiting.get(name)?.(data) });

function modelOf(name: string): Promise<ArrayBuffer> {
  return new Promise((resolve, reject) => {
    waiting.set(name, (data) => resolve(Uint8Array.from(atob(data), (each) => each.charCodeAt(0)).buffer));
    document.head.append(Object.assign(document.createElement("script"),
      { src: `${name}.glb.js`, onerror: () => reject(new Error(`${name}.glb.js is missing`)) }));
  });
}

async function show(figure: HTMLElement): Promise<void> {
  const host = figure.querySelector<HTMLElement>(".scene")!;
  const { model, colour, height } = figure.dataset;
  const picture = [...host.children];
  try {
    const scene = new Scene(host);
    scene.model.add(await readGlb(await modelOf(model!), colour));
    for (const each of picture) each.remove();
    host.tabIndex = 0;
    scene.fit(0.6, Number(height));
    figure.dataset.shown = "yes";
  } catch (error) {  // without WebGL the picture remains
    host.querySelector("canvas")?.remove();
    console.warn(String(error));
  }
}

const seen = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    seen.unobserve(target);
    void show(target as HTMLElement);
  }
}, { rootMargin: "200px" });
for (const figure of document.querySelectorAll("figure[data-model]")) seen.observe(figure);

for (const film of document.querySelectorAll<HTMLElement>("figure[data-film]")) {
  const image = film.querySelector("img")!;
  const bar = film.querySelector("input")!;
  const button = film.querySelector("button")!;
  const last = Number(bar.max);
  const address = (i: number): string => `${film.dataset.film}/frame_${String(i).padStart(4, "0")}.png`;
  let timer = 0;
  const stop = (): void => { clearInterval(timer); timer = 0; button.textContent = "Play"; };
  const turn = (i: number): void => { bar.value = String(i); image.src = address(i); };
  for (const each of [bar, button]) each.hidden = false;
  bar.oninput = () => { stop(); turn(Number(bar.value)); };
  button.onclick = () => {
    if (timer) return stop();
    for (let i = 1; i <= last; ++i) new Image().src = address(i);
    if (Number(bar.value) >= last) turn(1);
    button.textContent = "Pause";
    timer = setInterval(() => { if (Number(bar.value) >= last) stop(); else turn(Number(bar.value) + 1); }, 120);
  };
}
