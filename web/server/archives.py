"""Scans of formats that can refer to other files, and archives of files, in a worker: each becomes one .nii file.

A header may name files of its own archive only. The uploaded files lie in a folder of their own."""

import os
import re
import shutil
import zipfile

import fieldfab as ff

from .limits import LIMITS
from .models import Mistakes

HEADERS = (".mhd", ".mha", ".nhdr", ".nrrd", ".nii", ".nii.gz", ".vdb")
SLICES = (".tif", ".tiff"), (".png",)
SAMPLES = (".raw", ".vol")  # with sizes in their names
DISTANCES = "dimensions.txt"  # of slices
HEADER_BYTES = 1 << 16
REFERENCE = re.compile(rb"^[ \t]*(?:data ?file|element ?data ?file)[ \t]*(?::=?|=)[ \t]*([^\r\n]*)", re.I | re.M)
SERIES = re.compile(r"(\d+): \S+ \((\d+) files\)")


def unpack(path, folder):
    """Writes the files of a .zip archive into a folder, without their folders."""
    try:
        with zipfile.ZipFile(path) as archive:
            entries = [each for each in archive.infolist() if not each.is_dir()
                       and not os.path.basename(each.filename).startswith(".") and "__MACOSX" not in each.filename]
            if len(entries) > LIMITS.scan_files:
                raise Mistakes(f"the archive has {len(entries):,} files; {LIMITS.scan_files:,} are possible")
            if (size := sum(each.file_size for each in entries)) > LIMITS.unpacked:
                raise Mistakes(f"the files of the archive have {size:,} bytes; {LIMITS.unpacked:,} are possible")
            for number, entry in enumerate(entries):
                name = re.split(r"[/\\]", entry.filename)[-1].replace("\0", "")[-120:] or "file"
                target = os.path.join(folder, name)
                if os.path.exists(target):  # of another folder of the archive
                    target = os.path.join(folder, f"{number}_{name}")
                with archive.open(entry) as packed, open(target, "xb") as file:
                    shutil.copyfileobj(packed, file, 1 << 20)  # reads no more than the size of the entry
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, OSError) as error:
        raise Mistakes(f"the archive cannot be read: {str(error)[:200]}") from None


def check_references(path):
    """Raises Mistakes if a header names a file outside of its folder."""
    if not path.lower().endswith((".mhd", ".mha", ".nhdr", ".nrrd")):
        return
    with open(path, "rb") as file:
        head = file.read(HEADER_BYTES)
    if path.lower().endswith((".nhdr", ".nrrd")):
        head, blank, _ = head.replace(b"\r\n", b"\n").partition(b"\n\n")
        if not blank and os.path.getsize(path) > HEADER_BYTES:
            raise Mistakes(f"{os.path.basename(path)}: its header has no end within {HEADER_BYTES:,} bytes")
    elif not REFERENCE.search(head):
        raise Mistakes(f"{os.path.basename(path)}: its header has no 'ElementDataFile'")
    for found in REFERENCE.findall(head):
        name = found.strip().decode("utf-8", "replace")
        if name.upper() == "LOCAL":
            continue
        if os.path.basename(name) != name or not os.path.isfile(os.path.join(os.path.dirname(path), name)):
            raise Mistakes(f"{os.path.basename(path)} names the file '{name[:80]}', which was not uploaded with it")


def is_dicom(path):
    with open(path, "rb") as file:
        return file.read(132)[128:] == b"DICM"


def to_read(folder):
    """Returns the path to open: the only header, or the folder with nothing but slices of one kind."""
    paths = sorted(os.path.join(folder, name) for name in os.listdir(folder))
    if not paths:
        raise Mistakes("the archive has no files")
    for endings in (HEADERS, SAMPLES):
        found = [path for path in paths if path.lower().endswith(endings)]
        if len(found) > 1:
            names = ", ".join(os.path.basename(path) for path in found[:5])
            raise Mistakes(f"these are {len(found)} scans: {names}; one at a time")
        if found:
            check_references(found[0])
            return found[0]
    kinds = [*([path for path in paths if path.lower().endswith(endings)] for endings in SLICES),
             [path for path in paths if is_dicom(path)]]
    slices = next(filter(None, kinds), paths)
    for path in set(paths) - set(slices):
        if os.path.basename(path) != DISTANCES:
            os.remove(path)
    return folder


def open_volume(path):
    """Returns a volume and a remark; of several DICOM series the longest is taken."""
    try:
        return ff.Volume.open(path), ""
    except ff.Error as error:
        found = SERIES.findall(str(error))
        if not found:
            raise
    number, count = max(found, key=lambda each: int(each[1]))
    return ff.Volume.open(path, series=number), f"the longest of {len(found)} series, with {count} slices"


def convert(path, into):
    """Writes `into`, a .nii file, from an uploaded file or archive. Returns the values of the answer."""
    folder = os.path.dirname(path)
    if path.lower().endswith(".zip"):
        folder = os.path.join(folder, "unpacked")
        os.mkdir(folder)
        unpack(path, folder)
    try:
        volume, note = open_volume(to_read(folder))
        samples = volume.size[0] * volume.size[1] * volume.size[2]
        if 4 * samples > LIMITS.unpacked:
            raise Mistakes(f"the scan has {samples:,} samples; {LIMITS.unpacked // 4:,} are possible")
        volume.save(into)
    except ff.Error as error:
        raise Mistakes(str(error).replace(folder + os.sep, "").replace(folder, "the scan")) from None
    return {"note": note}
