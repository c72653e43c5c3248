"""Boundary representation: a solid's mesh as faces on planes, cylinders, cones, spheres, tori and B-splines."""
