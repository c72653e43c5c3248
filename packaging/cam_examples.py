#!/usr/bin/python3
"""Runs the jobs of examples/cam and leaves their programs, pictures and set-up sheets in docs/cam (made by ./dev docs).

    cam_examples.py [FOLDER]   FOLDER: where to write, docs/cam by default
"""

import gzip
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXTENSION = {"pcb_modela": ".rml", "pcb_gcode": ".ngc", "bearing": ".ngc", "text_vcarve": ".ngc",
             "cthead_shopbot5": ".sbp", "mtm_az_laser": ".epi", "knob_five_axis": ".ngc"}
LARGEST = 1_000_000  # bytes of a program that is kept in full


def run(job, folder):
    program = folder / (job.stem + EXTENSION[job.stem])
    pictures = ["--picture", folder / (job.stem + ".png")] + (
        ["--oblique"] if job.stem in ("bearing", "cthead_shopbot5", "knob_five_axis") else [])
    command = [ROOT / "build/release/bin/fieldfab", "cam", job, "-o", program, "--sheet", folder / (job.stem + ".html"),
               *pictures]
    print(subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout.strip())
    if program.stat().st_size > LARGEST:
        with (open(str(program) + ".gz", "wb") as out,
              gzip.GzipFile(filename="", fileobj=out, mode="wb", mtime=0) as packed):
            packed.write(program.read_bytes())
        program.unlink()


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "cam"
    folder.mkdir(parents=True, exist_ok=True)
    for job in sorted((ROOT / "examples" / "cam").glob("*.toml")):
        run(job, folder)


if __name__ == "__main__":
    main()
