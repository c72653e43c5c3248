"""Draws docs/figures/fig_2_4.png, 2_5 and 2_6 from the CSV files that asdf_figures wrote into that folder."""

import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "docs/figures")


def rows(name):
    with open(folder / f"{name}.csv") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


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
image = axes.imshow([[cells[a, b] for a in alphas] for b in betas], origin="lower", extent=(0, 180, 0, 180), cmap="viridis")
figure.colorbar(image, label="cells")
values = list(cells.values())
axes.set(xlabel="alpha, degrees", ylabel="beta, degrees", title=f"A turned cube (Fig. 2-6): {max(values) / min(values):.1f}x")
save(figure, "fig_2_6")
