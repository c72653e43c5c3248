"""FreeCAD's self-test of the installed workbench: `freecadcmd -t TestFieldfab`."""

import unittest

import FreeCAD


class TestFieldfab(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def test_a_sphere_has_its_volume(self):
        from fieldfab_workbench.objects import frep_solid, solid

        obj = solid.create(frep_solid.FrepSolid, self.document)
        obj.Expression = "sphere(r = 10)"
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.getStatusString())
        self.assertAlmostEqual(obj.Volume.Value / 4188.79, 1, 2)

    def test_a_mistake_is_told(self):
        from fieldfab_workbench.objects import frep_solid, solid

        obj = solid.create(frep_solid.FrepSolid, self.document)
        obj.Expression = "spheer(r = 10)"
        self.document.recompute()
        self.assertIn("did you mean 'sphere'", obj.getStatusString())
