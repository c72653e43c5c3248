// Runs the code of nodes with a time limit, in a frame without access to network, storage or this page (sandbox.html).
import { by } from "./elements";
import { inOrder, type Result, type Sheet, shapeName } from "./sheet";

export const MILLISECONDS = 1000;

interface Said { ready?: boolean; run?: number; results?: Result[]; late?: number | null }

export class Sandbox {
  private frame = by<HTMLIFrameElement>("sandbox");
  private run = 0;
  private ready = false;
  private waiting: Sheet | null = null;
  private busy = false;
  onResults: (sheet: Sheet, results: Map<number, Result>) => void = () => {};
  onLate: (node: number | null) => void = () => {};
  private sheet: Sheet | null = null;

  constructor() {
    addEventListener("message", ({ source, data }) => { if (source === this.frame.contentWindow) this.take(data); });
    this.frame.contentWindow?.postMessage({}, "*");
  }

  /** Runs a sheet's nodes. During a run, only the newest sheet is queued. */
  evaluate(sheet: Sheet): void {
    this.waiting = sheet;
    if (this.ready && !this.busy) this.start();
  }

  private start(): void {
    this.sheet = this.waiting!;
    this.waiting = null;
    this.busy = true;
    const nodes = inOrder(this.sheet).map((node) => ({ id: node.id, name: shapeName(node), x: node.x, y: node.y,
      code: node.code, values: node.values, parents: node.parents }));
    this.frame.contentWindow!.postMessage({ run: ++this.run, nodes, milliseconds: MILLISECONDS }, "*");
  }

  private take(said: Said): void {
    if (said.ready) this.ready = true;
    else if (said.run === this.run) {
      this.busy = false;
      if (said.results) this.onResults(this.sheet!, new Map(said.results.map((each) => [each.id, each])));
      else this.onLate(said.late ?? null);
    } else return;
    if (this.waiting && !this.busy) this.start();
  }
}
