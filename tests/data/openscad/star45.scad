for(i=[0:7]) rotate([0,0,45*i]) { translate([5,-2,0]) cube([10,4,4]); translate([15,-4,0]) cube([2,8,4]); } translate([0,0,0]) cylinder(h=4,r=6,$fn=8);
