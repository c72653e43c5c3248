difference(){ sphere(20,$fn=40); difference(){ cube(24,center=true); sphere(15,$fn=30);} for(a=[[0,0,0],[90,0,0],[0,90,0]]) rotate(a) cylinder(h=60,r=4,center=true,$fn=20);}
