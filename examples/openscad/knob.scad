// A knob: a fillet where the grip meets the flange, a grip from a formula, and OpenSCAD's own Booleans around them.
use <fieldfab.scad>

difference() {
  union() {
    smooth_union(r = 3, voxel = 0.6) {
      cylinder(h = 4, r = 16, $fn = 60);
      cylinder(h = 18, r = 9, $fn = 60);
    }
    translate([0, 0, 20])
      frep("rounded_box(24, 12, 16, 4)", voxel = 0.6);
  }
  translate([0, 0, -1]) cylinder(h = 14, r = 3, $fn = 6);
}
