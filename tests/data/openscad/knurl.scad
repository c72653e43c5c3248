difference(){ cylinder(h=20,r=10,$fn=72); for(i=[0:17]) rotate(i*20) translate([10,0,-1]) rotate(45) cube([1.5,1.5,60],center=true);}
