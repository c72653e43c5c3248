"""Import a volume with several processes, on this machine or on a cluster, through Dask.

    python3 -m fieldfab.bricks scan.nrrd -o scan.asdf --workers 4

Each process makes the blocks of some layers of the volume. Joined, they equal the file of `fieldfab build` byte for
byte. On a cluster (--scheduler) all processes need access to the volume and the output's folder.
"""

import argparse
import os
import pathlib
import signal
import sys
import tempfile


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


def build(volume, output, threshold=None, workers=2, parts=None, scheduler=None, file=None, **surface):
    """Imports the volume file `volume` into the .asdf file `output`. Returns the result of save_asdf()."""
    import fieldfab as ff
    from dask.distributed import Client, LocalCluster

    task = {"volume": os.path.abspath(volume), "file": file or {},
            "threads": 0 if scheduler else max(1, os.cpu_count() // workers)}
    whole = open_volume(task)
    # Computed once, since a percentile such as 90% needs all samples.
    task["surface"] = {"threshold": whole.threshold(threshold), **surface}
    task["parts"] = parts or workers
    output = pathlib.Path(output).absolute()
    with tempfile.TemporaryDirectory(dir=output.parent, prefix=f".{output.name}.") as folder:
        task["folder"] = folder
        cluster = None if scheduler else LocalCluster(
            n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=40)
        try:
            with Client(scheduler or cluster) as client:
                files = client.gather(client.map(make_part, [task] * task["parts"], range(task["parts"]), pure=False))
        finally:
            if cluster is not None:
                cluster.close()
        return whole.merge_parts(output, files, **task["surface"])


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python3 -m fieldfab.bricks", description=__doc__.splitlines()[0])
    parser.add_argument("volume", help="as `fieldfab build` takes it")
    parser.add_argument("-o", "--output", required=True, help="the .asdf file to write")
    parser.add_argument("--workers", type=int, default=2, help="processes on this machine")
    parser.add_argument("--parts", type=int, help="how many parts to make; one for each worker where not given")
    parser.add_argument("--scheduler", help="the address of a Dask scheduler to use instead, such as tcp://host:8786")
    parser.add_argument("--threshold", help="a density, a share such as 90%%, otsu or halfway (the default)")
    parser.add_argument("--below", action="store_true", help="densities below the threshold are solid")
    parser.add_argument("--max-error", type=float, default=-1.0, help="mm")
    parser.add_argument("--levels", type=int, default=1, help="resolutions to keep")
    parser.add_argument("--quantum", type=float, default=-1.0, help="mm")
    parser.add_argument("--dims", help="X,Y,Z of a .raw or .vol file")
    parser.add_argument("--type", default="", help="type of the samples")
    parser.add_argument("--spacing", help="X,Y,Z in mm")
    parser.add_argument("--series", default="", help="of a DICOM folder")
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
        threshold = given.threshold
        made = build(given.volume, given.output, threshold, given.workers, given.parts, given.scheduler, file,
                     below=given.below, max_error=given.max_error, levels=given.levels, quantum=given.quantum)
    except (ff.Error, ValueError, OSError) as error:
        print(f"fieldfab.bricks: {error}", file=sys.stderr)
        return 2
    size = os.path.getsize(given.output)
    print(f"{given.output}: {made['cells']} cells ({made['leafs']} leafs) in {made['blocks']} blocks, "
          f"{size / 1e6:.2f} MB")
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))  # the exit removes the parts
    sys.exit(main())
