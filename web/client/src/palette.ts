// The library of nodes: a dialog that finds kinds of nodes by their words.
import { by, element } from "./elements";
import { type NodeKind, ownKinds } from "./library";

export class Palette {
  kinds: NodeKind[] = [];
  onKind: (kind: NodeKind) => void = () => {};

  constructor() {
    by("find-node").oninput = () => this.list();
    by("close-palette").onclick = () => by<HTMLDialogElement>("palette").close();
  }

  open(): void {
    by<HTMLInputElement>("find-node").value = "";
    this.list();
    by<HTMLDialogElement>("palette").showModal();
  }

  private list(): void {
    const wanted = by<HTMLInputElement>("find-node").value.toLowerCase(), groups = new Map<string, NodeKind[]>();
    for (const kind of [...ownKinds(), ...this.kinds])
      if (`${kind.name} ${kind.meaning} ${kind.group}`.toLowerCase().includes(wanted))
        groups.set(kind.group, [...(groups.get(kind.group) ?? []), kind]);
    by("nodes").replaceChildren(
      ...[...groups].map(([group, kinds]) => element("section", {}, element("h3", {}, group), ...kinds.map((kind) => {
        const button = element("button", { title: kind.meaning }, kind.name);
        button.onclick = () => { by<HTMLDialogElement>("palette").close(); this.onKind(kind); };
        return button;
      }))));
  }
}
