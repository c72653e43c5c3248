"""Counts the models with certain meshes. Compares mesh() with mesh(depth = 0): processor time and number of triangles.

    PYTHONPATH=build/release/python /usr/bin/python3 tests/bench/certainty_figures.py examples/*.frep
"""

import pathlib
import sys
import time

import fieldfab as ff


def timed(solid, depth):
    start = time.process_time()
    mesh = ff.mesh(solid, depth=depth)
    return time.process_time() - start, mesh


def main(paths):
    print(f"{'model':<24} {'plain s':>8} {'looked s':>8} {'ratio':>6} {'plain tri':>10} {'looked tri':>10}  certain")
    certain = 0
    for path in paths:
        solid = ff.load(path)
        plain, before = timed(solid, 0)
        looked, after = timed(solid, 6)
        certain += after.certainty.certain
        print(
            f"{pathlib.Path(path).stem:<24} {plain:8.2f} {looked:8.2f} {looked / plain:6.2f} "
            f"{len(before.triangles):10} {len(after.triangles):10}  "
            f"{'yes' if after.certainty.certain else after.certainty}",
            flush=True,
        )
    print(f"{certain} of {len(paths)} certain")


main(sys.argv[1:])
