module p(){cube([10,5,3]); translate([10,0,0]) cube([3,5,8]);} p(); mirror([1,0,0]) p(); mirror([0,1,1]) p();
