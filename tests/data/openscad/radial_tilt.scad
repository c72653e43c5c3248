module arm(){translate([10,-1,0]) cube([12,2,4]); translate([22,-2,0]) cube([3,4,4]); translate([12,-1,4]) cube([4,2,3]);} for(a=[0:37:359]) rotate([a/5,a/7,a]) translate([0,0,a/8]) arm();
