for(a=[0:30:359]) rotate(a) { translate([10,-1,0]) cube([12,2,4]); translate([22,0,0]) cylinder(h=4,r=3,$fn=20);} cylinder(h=4,r=11,$fn=48);
