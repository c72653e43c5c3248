"""A solid from a CT volume, or from an .asdf file."""

import functools

import FreeCAD

from ..scans import DENOISING, SAMPLE_TYPES, AsdfSource, Cut, ScanFile, ScanSource
from ..words import marked, tr
from .outside import HIDDEN, OUTPUT, forget, path_of
from .solid import Solid

READ_ONLY = 1
MISSING, CHANGED, AS_READ, UNREAD = marked(("missing", "changed since it was read", "as it was read", "not read yet"))


class Scan(Solid):
    """The solid where the density of a CT volume exceeds a threshold. The file stays outside of the document. The
    document stores its path (also relative to the document, see outside.py) and its stamp when it was read."""

    NAME = "Scan"

    def add_own_properties(self, obj):
        add = functools.partial(self.add, obj)
        add("File", "File", "Scan", "The volume's file, or the folder of its slices")
        add("String", "FileBeside", "Scan", "The same path, relative to the document's folder", mode=HIDDEN | OUTPUT)
        add("String", "FileRead", "Scan",
            "Size and modification time of the file that the mesh was made from", mode=HIDDEN | OUTPUT)
        add("String", "FileState", "Scan", "Whether the file exists and is unchanged since it was read", UNREAD,
            mode=READ_ONLY | OUTPUT)
        add("Bool", "AutoThreshold", "Scan", "Threshold halfway between the two most frequent densities",
            True)
        add("Float", "Threshold", "Scan", "Density above which the volume is solid, if AutoThreshold is off", 0)
        add("Bool", "Below", "Scan", "Densities below the threshold are solid", False)
        add("Vector", "Spacing", "Scan", "Spacing of the samples along x, y and z, mm; 0 0 0: that of the file")
        add("IntegerList", "Crop", "Scan", "First sample along x, y and z, then the last; empty: the whole volume")
        self._add_choice(obj, "Denoise", "Clean-up", "Noise filter", DENOISING)
        add("Bool", "KeepLargest", "Clean-up", "Keep the largest piece only", False)
        add("Volume", "SmallestIsland", "Clean-up", "Pieces of less volume are removed", 0)
        add("Volume", "SmallestHole", "Clean-up", "Cavities of less volume are filled", 0)
        add("IntegerList", "Samples", "Raw file",
            "Number of samples along x, y and z; empty: from the file or its name")
        self._add_choice(obj, "SampleType", "Raw file", "Type of the samples", SAMPLE_TYPES)
        add("String", "Series", "Raw file", "Series of a DICOM folder that contains several")

    @staticmethod
    def _add_choice(obj, name, group, words, choices):
        if name not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", name, group, words)
            setattr(obj, name, list(choices))

    def onChanged(self, obj, name):
        if (name == "File" and not obj.Document.Restoring and not obj.Document.Transacting
                and "FileState" in obj.PropertiesList):
            forget(obj, "File")
            self.look(obj)

    def path(self, obj):
        """Returns the path of the file, or "" if none is set."""
        return path_of(obj, "File")

    def file(self, obj):
        """Returns the scans.ScanFile. Raises ValueError."""
        path = self.path(obj)
        if not path:
            raise ValueError(tr("{label}: choose the File of a scan").format(label=obj.Label))
        if len(obj.Samples) not in (0, 3):
            raise ValueError(tr("{label}: Samples are three numbers, or none").format(label=obj.Label))
        raw = obj.getEnumerationsOfProperty("SampleType").index(obj.SampleType)
        return ScanFile(path, tuple(obj.Samples) or None, SAMPLE_TYPES[raw] if raw else "",
                        tuple(obj.Spacing) if obj.Spacing.Length else None, obj.Series)

    def cut(self, obj):
        """Returns the scans.Cut. Raises ValueError."""
        crop = tuple(obj.Crop)
        if crop and (len(crop) != 6 or min(crop) < 0 or any(a >= b for a, b in zip(crop, crop[3:]))):
            raise ValueError(tr("{label}: Crop is the first sample along x, y and z, then the last, or nothing").format(
                label=obj.Label))
        return Cut(None if obj.AutoThreshold else obj.Threshold, obj.Below, crop or None,
                   "" if obj.Denoise == "none" else obj.Denoise,
                   obj.KeepLargest, obj.SmallestIsland.Value, obj.SmallestHole.Value)

    def source(self, obj):
        file, cut = self.file(obj), self.cut(obj)
        try:
            return (AsdfSource if file.path.lower().endswith(".asdf") else ScanSource)(file, cut)
        except ValueError as error:
            raise ValueError(
                tr("{label}: {error}; double-click it to find the file").format(label=obj.Label, error=error)) from None

    def execute(self, obj):
        self.look(obj)
        source = self.source(obj)
        super().execute(obj)
        obj.FileRead = source.stamp
        self.look(obj)

    def mustExecute(self, obj):
        self.look(obj)
        return obj.FileState == CHANGED

    def icon_name(self, obj):
        return {MISSING: "ScanMissing", CHANGED: "ScanChanged"}.get(obj.FileState, "Scan")

    def look(self, obj):
        """Updates the file state (unread, as read, changed or missing) and the icon. Reads the file's stamp, not its
        contents."""
        path = self.path(obj)
        try:
            stamp = ScanFile(path).stamp() if path else ""
            state = UNREAD if not obj.FileRead else AS_READ if stamp == obj.FileRead else CHANGED
        except ValueError:
            state = MISSING
        if obj.FileState != state:
            obj.FileState = state
            if FreeCAD.GuiUp:
                obj.ViewObject.signalChangeIcon()

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        self.look(obj)
        if obj.FileState in (MISSING, CHANGED):
            FreeCAD.Console.PrintWarning(tr("{label}: the scan {path} is {state}; the mesh is unchanged").format(
                label=obj.Label, path=self.path(obj), state=tr(obj.FileState)) + "\n")
