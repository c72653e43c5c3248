for(x=[0:5],y=[0:5]) translate([x*10,y*10*sin(60),0]) translate([y%2*5,0,0]) difference(){ cylinder(h=5,r=10/2/cos(30),$fn=6); translate([0,0,1]) cylinder(h=5,r=4.5,$fn=6);}
