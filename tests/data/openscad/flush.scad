difference(){ cube(20); for(i=[1:3]) translate([5*i,-1,5*i]) rotate([-90,0,0]) cylinder(h=22,r=2,$fn=24); translate([0,0,10]) cube([20,10,10]); translate([10,10,0]) cube([10,10,20]);}
