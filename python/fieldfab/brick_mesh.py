"""Meshes made in bricks: what a worker of fieldfab.bricks does, and how the bricks' files become one file or tiles."""

import json
import os
import pathlib
import shutil

import numpy as np


def bricks_of(task, level=0):
    """The MeshBricks of a task: {"asdf": file, "settings": arguments of MeshBricks}."""
    import fieldfab as ff

    settings = {"level": 0, **task["settings"]}
    return ff.MeshBricks(task["asdf"], **{**settings, "level": settings["level"] + level})


def all_bricks(count):
    """The places of all bricks, x fastest."""
    return [(x, y, z) for z in range(count[2]) for y in range(count[1]) for x in range(count[0])]


def make_brick(task, brick, level=0):
    """Meshes one brick; runs in a worker.

    Returns None where no surface is, or {"brick", "file", "box", "triangles"}: the box, mm, has the shape (2, 3), and
    "triangles" is their number. The file is complete or not there: .npz with "vertices" (n, 3), "triangles" (m, 3) and
    "seam" (k,), or .glb for tiles.
    """
    import fieldfab as ff

    ff.set_threads(task["threads"])
    mesh, seam = bricks_of(task, level).mesh(brick)
    if not len(mesh.triangles):
        return None
    name = os.path.join(task["folder"], "-".join(map(str, (level, *brick))) + task["suffix"])
    if task["suffix"] == ".npz":
        # Another worker may make the same brick, when Dask takes this one for lost.
        unfinished = f"{name}.{os.uname().nodename}.{os.getpid()}.npz"
        np.savez(unfinished, vertices=mesh.vertices, triangles=mesh.triangles, seam=seam)
        os.replace(unfinished, name)
    else:
        mesh.save(name)
    box = [mesh.vertices.min(axis=0).tolist(), mesh.vertices.max(axis=0).tolist()]
    return {"brick": brick, "file": name, "box": box, "triangles": len(mesh.triangles)}


class Seams:
    """Numbers the vertices of all bricks, each vertex of a seam once: as one of the first brick that has it."""

    def __init__(self, files):
        self.files = files
        counts, seams = [], []
        for file in files:
            with np.load(file) as part:
                vertices, seam = part["vertices"], part["seam"]
                counts.append(len(vertices))
                seams.append(vertices[seam])
        # A seam's vertices have the same coordinates in all bricks, to the bit.
        ends = np.cumsum([0] + [len(seam) for seam in seams])
        bytes_of = np.ascontiguousarray(np.concatenate(seams)).view("V12")
        _, first, which = np.unique(bytes_of.ravel(), return_index=True, return_inverse=True)
        which = which.ravel()
        own = first[which] == np.arange(len(which))
        self.which = [which[a:b] for a, b in zip(ends, ends[1:])]
        self.own = [own[a:b] for a, b in zip(ends, ends[1:])]
        self.number = np.zeros(len(first), np.int64)
        self.first = np.cumsum([0] + [count - int((~own).sum()) for count, own in zip(counts, self.own)])
        self.vertices = int(self.first[-1])

    def parts(self):
        """Yields of each brick: its new vertices, its triangles in numbers of all, and which corners are on seams."""
        for i, file in enumerate(self.files):
            with np.load(file) as part:
                vertices, triangles, seam = part["vertices"], part["triangles"], part["seam"]
            new = np.ones(len(vertices), bool)
            new[seam[~self.own[i]]] = False
            number = self.first[i] + np.cumsum(new) - 1
            self.number[self.which[i][self.own[i]]] = number[seam[self.own[i]]]
            number[seam] = self.number[self.which[i]]
            on_seam = np.zeros(len(vertices), bool)
            on_seam[seam] = True
            yield vertices[new], number[triangles], on_seam[triangles]


def open_edges(seams):
    """Counts the edges between two vertices of seams that no second triangle has in the other direction."""
    found = []
    for _, triangles, on_seam in seams.parts():
        for a, b in ((0, 1), (1, 2), (2, 0)):
            both = on_seam[:, a] & on_seam[:, b]
            found.append(triangles[both][:, [a, b]])
    edges = np.concatenate(found)
    there = np.sort(edges[:, 0] << 32 | edges[:, 1])
    back = np.sort(edges[:, 1] << 32 | edges[:, 0])
    return len(np.setxor1d(there, back)) + int((there[1:] == there[:-1]).sum())


def join(made, made_in, output):
    """Joins the bricks that make_brick() made into one .ply file, which is `output` once it is complete, and in the
    folder `made_in` until then. Returns how many vertices and triangles, by name."""
    seams = Seams([part["file"] for part in made])
    triangles = sum(part["triangles"] for part in made)
    if seams.vertices >= 2**31 or triangles >= 2**31:
        raise ValueError(f"{triangles} triangles are more than a .ply file can have; write tiles (tileset.json)")
    if wrong := open_edges(seams):
        raise RuntimeError(f"the seams between bricks leave {wrong} edges open; please report this")
    unfinished = pathlib.Path(made_in) / output.name
    with open(unfinished, "wb") as file:
        file.write((
            "ply\nformat binary_little_endian 1.0\ncomment by Fieldfab, mm\n"
            f"element vertex {seams.vertices}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {triangles}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        for vertices, _, _ in seams.parts():
            file.write(np.ascontiguousarray(vertices, "<f4").data)
        for _, of_part, _ in seams.parts():
            rows = np.empty(len(of_part), [("count", "u1"), ("corners", "<i4", 3)])
            rows["count"] = 3
            rows["corners"] = of_part
            file.write(rows.data)
        file.flush()
        os.fsync(file.fileno())
    unfinished.replace(output)
    return {"vertices": seams.vertices, "triangles": triangles}


def tileset_of(levels, voxels, folder):
    """The JSON of 3D Tiles (OGC 22-025r4) for `levels`: of each, the finest first, what make_brick() returned.

    A tile is a brick; its children are those bricks of the next finer level whose middle is in its half of the count.
    Lengths are metres there, and z is up; viewers turn the .glb files, whose y is up.
    """
    below = {}
    for level, (made, voxel) in enumerate(zip(levels, voxels)):
        tiles = {}
        for part in made:
            tiles[tuple(part["brick"])] = {
                "box": np.array(part["box"]), "error": 0 if level == 0 else voxel, "children": [],
                "file": f"{folder}/{os.path.basename(part['file'])}"}
        for brick, child in below.items():
            parent = tuple(i // 2 for i in brick)
            tile = tiles.setdefault(parent, {"box": child["box"], "error": voxel, "children": []})
            tile["box"] = np.array([np.minimum(tile["box"][0], child["box"][0]),
                                    np.maximum(tile["box"][1], child["box"][1])])
            tile["children"].append(child)
        below = tiles

    def written(tile):
        middle, half = (tile["box"][0] + tile["box"][1]) / 2000, (tile["box"][1] - tile["box"][0]) / 2000
        box = [*middle, half[0], 0, 0, 0, half[1], 0, 0, 0, half[2]]
        done = {"boundingVolume": {"box": [float(number) for number in box]}, "geometricError": tile["error"] / 1000,
                "refine": "REPLACE"}
        if "file" in tile:
            done["content"] = {"uri": tile["file"]}
        if tile["children"]:
            done["children"] = [written(child) for child in tile["children"]]
        return done

    tops = list(below.values())
    corners = np.array([tile["box"] for tile in tops])
    box = np.array([corners[:, 0].min(axis=0), corners[:, 1].max(axis=0)])
    size = float(np.linalg.norm(box[1] - box[0]))
    root = written({"box": box, "error": size, "children": tops})
    return {"asset": {"version": "1.1", "generator": "Fieldfab"}, "geometricError": size / 1000, "root": root}


def write_tiles(levels, voxels, made_in, output):
    """Moves the bricks' .glb files from the folder `made_in` beside the tileset `output`, and writes it."""
    folder = output.with_suffix("")
    text = json.dumps(tileset_of(levels, voxels, folder.name), indent=1)
    if folder.exists() and not output.exists():
        raise ValueError(f"{folder} is there already, without {output.name}: its files may be others")
    unfinished = pathlib.Path(made_in) / output.name
    unfinished.write_text(text)
    if folder.exists():
        shutil.move(folder, pathlib.Path(made_in) / "before")
    (pathlib.Path(made_in) / "tiles").rename(folder)
    unfinished.replace(output)
