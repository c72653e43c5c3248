"""Draws docs/figures/fig_2_4.png, 2_5, 2_6 and the costs of f-reps from the CSV files of asdf_figures and frep_figures
in that folder. Prints the slopes of the log-log plots."""

import csv
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "docs/figures")


def rows(name):
    with open(folder / f"{name}.csv") as file:
        return [{key: value if key == "what" else float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


def save(figure, name):
    figure.tight_layout()
    figure.savefig(folder / f"{name}.png", dpi=110)


figure, axes = plt.subplots(figsize=(5, 3.6))
data = rows("fig_2_4")
for key, label in (("octree", "octree"), ("asdf", "ASDF, max. error 0.001")):
    axes.loglog([r["resolution"] for r in data], [r[key] for r in data], "o-", label=label)
axes.set(xlabel="lattice cells a side", ylabel="cells", title="A wheel (Fig. 2-4)")
axes.legend()
save(figure, "fig_2_4")

figure, axes = plt.subplots(figsize=(5, 3.6))
data = rows("fig_2_5")
for error in sorted({r["max_error"] for r in data}):
    part = [r for r in data if r["max_error"] == error]
    axes.loglog([r["resolution"] for r in part], [r["leafs"] for r in part], "o-", label=f"max. error {error:g}")
axes.set(xlabel="lattice cells a side", ylabel="leafs", title="A circle (Fig. 2-5)")
axes.legend()
save(figure, "fig_2_5")

figure, axes = plt.subplots(figsize=(5, 3.6))
data = rows("fig_2_6")
alphas, betas = sorted({r["alpha"] for r in data}), sorted({r["beta"] for r in data})
cells = {(r["alpha"], r["beta"]): r["cells"] for r in data}
image = axes.imshow([[cells[a, b] for a in alphas] for b in betas], origin="lower", extent=(0, 180, 0, 180),
                    cmap="viridis")
figure.colorbar(image, label="cells")
values = list(cells.values())
axes.set(xlabel="alpha, degrees", ylabel="beta, degrees",
         title=f"A turned cube (Fig. 2-6): {max(values) / min(values):.1f}x")
save(figure, "fig_2_6")

figure, axes = plt.subplots(figsize=(5.4, 3.8))
data = rows("cost_resolution")
for what in dict.fromkeys(r["what"] for r in data):
    part = [r for r in data if r["what"] == what]
    first, last = part[len(part) // 2 - 1], part[-1]
    slope = math.log(last["seconds"] / first["seconds"]) / math.log(last["resolution"] / first["resolution"])
    print(f"{what}: time grows as resolution^{slope:.2f}")
    axes.loglog([r["resolution"] for r in part], [1000 * r["seconds"] for r in part], "o-",
                label=f"{what}, slope {slope:.2f}")
axes.set(xlabel="cells or pixels a side", ylabel="ms, one thread", title="Cost against resolution")
axes.legend()
save(figure, "cost_resolution")

figure, axes = plt.subplots(figsize=(5.4, 3.8))
data = rows("cost_size")
axes.loglog([r["nodes"] for r in data], [1000 * r["seconds"] for r in data], "o-")
for r in data:
    axes.annotate(f"{r['lines']:.0f} lines", (r["nodes"], 1000 * r["seconds"]), textcoords="offset points",
                  xytext=(4, -10), fontsize=7)
axes.set(xlabel="nodes of the expression", ylabel="ms for a bitmap 1024 pixels high, one thread",
         title="Cost against size: text (Figs 3-7 to 3-9)")
save(figure, "cost_size")

figure, axes = plt.subplots(figsize=(5.4, 3.8))
data = rows("active_nodes")
axes.semilogy([r["level"] for r in data], [r["nodes"] for r in data], "o-")
print(f"prospero: {data[0]['nodes'] / data[-1]['nodes']:.0f}x fewer active nodes at level {data[-1]['level']:.0f}")
axes.set(xlabel="level of recursion", ylabel="mean active nodes", title="Prospero: active nodes by level (Fig. 3-4)")
save(figure, "active_nodes")
