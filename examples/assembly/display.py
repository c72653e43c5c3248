"""The same display in Python: an engine from a CT scan on a stand that is made to fit it, with knobs from a mesh."""
import pathlib

import fieldfab as ff
from fieldfab import shapes as s

here = pathlib.Path(__file__).parent
engine = ff.open(here / "../../tests/data/ct/engine.nii.gz", threshold=100)
knob = ff.open(here / "knob.3mf")

plinth = s.move(s.rounded_box(190, 250, 40, 8), 3, -5, -62)
screws = s.array_xy(s.move(s.cylinder(5, 60), -80, -117, -62), 2, 2, 166, 224)
knobs = s.array_xy(s.move(s.scale(knob, 1.2), -80, -117, -33.5), 2, 2, 166, 224)

ff.part(engine, "engine", "silver")
ff.part(plinth - s.offset(engine, 1) - screws, "stand", "peru")
ff.part(knobs, "knobs", "#8b1a1a")
