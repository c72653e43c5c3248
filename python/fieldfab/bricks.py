"""Import a volume, or mesh one, with several processes, on this machine or on a cluster, through Dask.

    python3 -m fieldfab.bricks scan.nrrd -o scan.asdf --workers 4
    python3 -m fieldfab.bricks scan.asdf -o scan.ply --workers 4
    python3 -m fieldfab.bricks scan.asdf -o tiles/tileset.json --workers 4

An .asdf file equals that of `fieldfab build` byte for byte: each process makes the blocks of some layers of the volume.
A mesh has the triangles of `fieldfab mesh`: each process meshes bricks, cubes of cells, and reads what is around them.
Tiles (3D Tiles, with a .glb file for each brick) show every resolution level of the .asdf file. A volume is imported
before it is meshed. On a cluster (--scheduler) all processes need access to the volume and the output's folder.
"""

import argparse
import contextlib
import os
import pathlib
import signal
import sys
import tempfile

from . import brick_mesh


def open_volume(task):
    import fieldfab as ff

    return ff.Volume.open(task["volume"], **task["file"])


def make_part(task, part):
    """Writes one share of an import; runs in a worker. Returns the name of its file."""
    import fieldfab as ff

    ff.set_threads(task["threads"])
    name = os.path.join(task["folder"], f"{part}.part")
    open_volume(task).save_part(name, part, task["parts"], **task["surface"])
    return name


@contextlib.contextmanager
def processes(workers, scheduler):
    """Dask's client of so many processes here, or of a cluster."""
    from dask.distributed import Client, LocalCluster

    cluster = None if scheduler else LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=40)
    try:
        with Client(scheduler or cluster) as client:
            yield client
    finally:
        if cluster is not None:
            cluster.close()


def threads_of(workers, scheduler):
    """Threads of a process; 0: as many as its machine has processors."""
    return 0 if scheduler else max(1, os.cpu_count() // workers)


def all_done(client, work, task, arguments, said):
    """The results of work(task, argument) for all arguments, in their order; says on a terminal how many are done."""
    from dask.distributed import as_completed

    # Dask gives the task of a process that ends to another, three times.
    futures = [client.submit(work, task, *argument, pure=False) for argument in arguments]
    for done, _ in enumerate(as_completed(futures), 1):
        if sys.stderr.isatty():
            print(f"\r{said}: {done} of {len(futures)}", end="\n" if done == len(futures) else "", file=sys.stderr)
    return client.gather(futures)


def build(volume, output, threshold=None, workers=2, parts=None, scheduler=None, file=None, **surface):
    """Imports the volume file `volume` into the .asdf file `output`. Returns the result of save_asdf()."""
    output = pathlib.Path(output).absolute()
    task = {"volume": os.path.abspath(volume), "file": file or {}, "threads": threads_of(workers, scheduler)}
    whole = open_volume(task)
    # Computed once, since a percentile such as 90% needs all samples.
    task["surface"] = {"threshold": whole.threshold(threshold), **surface}
    task["parts"] = parts or workers
    with tempfile.TemporaryDirectory(dir=output.parent, prefix=f".{output.name}.") as folder:
        task["folder"] = folder
        with processes(workers, scheduler) as client:
            files = all_done(client, make_part, task, [(part,) for part in range(task["parts"])], "parts")
        return whole.merge_parts(output, files, **task["surface"])


def mesh(asdf, output, workers=2, scheduler=None, **settings):
    """Meshes the .asdf file `asdf`, with the `settings` of MeshBricks.

    `output` is a .ply file, or tileset.json in a folder that is made if need be: its tiles are in the folder tileset
    beside it. Returns the number of bricks with a surface, of vertices and of triangles; of tiles, of bricks only.
    """
    output = pathlib.Path(output).absolute()
    tiles = output.suffix == ".json"
    if tiles:
        output.parent.mkdir(parents=True, exist_ok=True)
    task = {"asdf": os.path.abspath(asdf), "settings": settings, "threads": threads_of(workers, scheduler),
            "suffix": ".glb" if tiles else ".npz"}
    plans = [brick_mesh.bricks_of(task)]
    if tiles:
        plans += [brick_mesh.bricks_of(task, level) for level in range(1, plans[0].levels - settings.get("level", 0))]
    work = [(brick, level) for level, plan in enumerate(plans) for brick in brick_mesh.all_bricks(plan.count)]
    with tempfile.TemporaryDirectory(dir=output.parent, prefix=f".{output.name}.") as folder:
        task["folder"] = os.path.join(folder, "tiles")
        os.mkdir(task["folder"])
        with processes(workers, scheduler) as client:
            made = all_done(client, brick_mesh.make_brick, task, work, "bricks")
        if not any(made):
            raise ValueError(f"{asdf}: no surface was found, and no mesh was written")
        if not tiles:
            made = [part for part in made if part]
            return {"bricks": len(made), **brick_mesh.join(made, folder, output)}
        levels = [[part for part, (_, of) in zip(made, work) if part and of == level] for level in range(len(plans))]
        brick_mesh.write_tiles(levels, [plan.voxel for plan in plans], folder, output)
        return {"bricks": sum(map(len, levels))}


def make(given, file):
    """Does what the command line asks for. Returns what to say of it."""
    output = pathlib.Path(given.output)
    surface = {"below": given.below, "levels": given.levels, "quantum": given.quantum}
    error = {} if given.max_error is None else {"max_error": given.max_error}
    if output.suffix == ".asdf":
        made = build(given.input, output, given.threshold, given.workers, given.parts, given.scheduler, file,
                     **surface, **error)
        return (f"{made['cells']} cells ({made['leafs']} leafs) in {made['blocks']} blocks, "
                f"{os.path.getsize(output) / 1e6:.2f} MB")
    if output.suffix not in (".ply", ".json"):
        raise ValueError(f"{output}: write an .asdf, a .ply or a tileset.json")
    settings = {"cells": given.cells, **error}
    if given.voxel is not None:
        settings["voxel"] = given.voxel
    with contextlib.ExitStack() as stack:
        asdf = pathlib.Path(given.input)
        if asdf.suffix == ".asdf":
            settings["level"] = given.level
        else:
            folder = stack.enter_context(tempfile.TemporaryDirectory(dir=output.absolute().parent,
                                                                     prefix=f".{output.name}."))
            asdf = pathlib.Path(folder) / "volume.asdf"
            build(given.input, asdf, given.threshold, given.workers, given.parts, given.scheduler, file, **surface)
        made = mesh(asdf, output, given.workers, given.scheduler, **settings)
    if output.suffix == ".json":
        return f"{made['bricks']} tiles in {output.with_suffix('')}"
    return f"{made['vertices']} vertices and {made['triangles']} triangles of {made['bricks']} bricks"


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python3 -m fieldfab.bricks", description=__doc__.splitlines()[0])
    parser.add_argument("input", help="a volume, as `fieldfab build` takes it, or an .asdf file")
    parser.add_argument("-o", "--output", required=True,
                        help="the .asdf file to write, the .ply file of the mesh, or tileset.json for tiles of it")
    parser.add_argument("--workers", type=int, default=2, help="processes on this machine")
    parser.add_argument("--scheduler", help="the address of a Dask scheduler to use instead, such as tcp://host:8786")
    parser.add_argument("--max-error", type=float, help="permitted deviation of what is written, mm")
    volume = parser.add_argument_group("volumes")
    volume.add_argument("--parts", type=int, help="how many parts to make; one for each worker where not given")
    volume.add_argument("--threshold", help="a density, a share such as 90%%, otsu or halfway (the default)")
    volume.add_argument("--below", action="store_true", help="densities below the threshold are solid")
    volume.add_argument("--levels", type=int, default=1, help="resolutions to keep")
    volume.add_argument("--quantum", type=float, default=-1.0, help="mm")
    volume.add_argument("--dims", help="X,Y,Z of a .raw or .vol file")
    volume.add_argument("--type", default="", help="type of the samples")
    volume.add_argument("--spacing", help="X,Y,Z in mm")
    volume.add_argument("--series", default="", help="of a DICOM folder")
    meshes = parser.add_argument_group("meshes")
    meshes.add_argument("--voxel", type=float, help="edge of the cells, mm; that of the .asdf file where not given")
    meshes.add_argument("--level", type=int, default=0, help="of the .asdf file; 0 is the finest")
    meshes.add_argument("--cells", type=int, default=256, help="along the edge of a brick: a power of two from 32 on")
    given = parser.parse_args(arguments)
    import fieldfab as ff

    try:
        if given.workers < 1 or (given.parts or 1) < 1:
            raise ValueError("workers and parts must be 1 or more")
        file = {"type": given.type, "series": given.series}
        if given.dims:
            file["dims"] = tuple(map(int, given.dims.split(",")))
        if given.spacing:
            file["spacing"] = tuple(map(float, given.spacing.split(",")))
        said = make(given, file)
    except (ff.Error, ValueError, OSError) as error:
        print(f"fieldfab.bricks: {error}", file=sys.stderr)
        return 2
    print(f"{given.output}: {said}")
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))  # the exit removes the parts
    sys.exit(main())
