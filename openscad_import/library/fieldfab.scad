// Fieldfab in OpenSCAD: scans, formulas, and unions with fillets. Put there by `fieldfab openscad FILE.scad`, which also makes
// the meshes that this file imports from fieldfab-cache/; after that plain OpenSCAD opens the design, too.
//
//   use <fieldfab.scad>
//   fieldfab("scan.nrrd", threshold = 80, voxel = 1);      // anything that `fieldfab mesh` reads, beside the design
//   frep("sphere(10) - 1 + sin(x) / 2", voxel = 0.5);      // .frep text; bounds = [x0, y0, z0, x1, y1, z1] where it has no end
//   smooth_union(r = 2) { cube(10); sphere(6); }           // also smooth_difference, smooth_intersection
//   chamfer_union(size = 1) { cube(10); sphere(6); }       // also chamfer_difference, chamfer_intersection
//   offset3d(r = 1) cube(10);                              // rounded outwards, or inwards where r < 0
//   shell3d(thickness = 1) cube(10);                       // a wall about the surface
//
// Two of the last three kinds with the same numbers but other children need names: smooth_union(r = 2, name = "lid").

module fieldfab(file, threshold = undef, voxel = undef) _fieldfab("file", [_fieldfab_codes(file), threshold, voxel]);
module frep(expression, bounds = undef, voxel = undef) _fieldfab("frep", [_fieldfab_codes(expression), bounds, voxel]);
module smooth_union(r = 1, voxel = undef, name = "") _fieldfab("smooth_union", [_fieldfab_codes(name), r, voxel]) children();
module smooth_difference(r = 1, voxel = undef, name = "") _fieldfab("smooth_difference", [_fieldfab_codes(name), r, voxel]) { children(0); children([1:1:$children - 1]); }
module smooth_intersection(r = 1, voxel = undef, name = "") _fieldfab("smooth_intersection", [_fieldfab_codes(name), r, voxel]) children();
module chamfer_union(size = 1, voxel = undef, name = "") _fieldfab("chamfer_union", [_fieldfab_codes(name), size, voxel]) children();
module chamfer_difference(size = 1, voxel = undef, name = "") _fieldfab("chamfer_difference", [_fieldfab_codes(name), size, voxel]) { children(0); children([1:1:$children - 1]); }
module chamfer_intersection(size = 1, voxel = undef, name = "") _fieldfab("chamfer_intersection", [_fieldfab_codes(name), size, voxel]) children();
module offset3d(r = 1, voxel = undef, name = "") _fieldfab("offset", [_fieldfab_codes(name), r, voxel]) children();
module shell3d(thickness = 1, voxel = undef, name = "") _fieldfab("shell", [_fieldfab_codes(name), thickness, voxel]) children();

// Words as numbers: OpenSCAD does not mark quotes within words that it prints.
function _fieldfab_codes(words) = [for (c = words) ord(c)];
function _fieldfab_hash(words, factor, i = 0, sum = 7) =
  i >= len(words) ? sum + 100000 : _fieldfab_hash(words, factor, i + 1, (sum * factor + ord(words[i])) % 99991);
function _fieldfab_key(words) =
  str(_fieldfab_hash(words, 31), _fieldfab_hash(words, 131), _fieldfab_hash(words, 257), _fieldfab_hash(words, 521));

// While the cache is made, $fieldfab_finding is set: then what is wanted is told in place of a mesh.
module _fieldfab(kind, wanted) {
  words = str(wanted);
  key = _fieldfab_key(str(kind, words));
  if (!is_undef($fieldfab_finding)) {
    group() {
      text(str("fieldfab:", kind, ":", key, ":", words));
      children();
    }
  } else import(str("fieldfab-cache/", key, ".stl"), convexity = 10);
}
