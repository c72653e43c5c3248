; a slot in inches; the second one begins with a rapid where a feed was meant
G20 G90
M3 S12000
T1
G0 Z0.2
G0 X0.5 Y0.5
G1 Z-0.08 F8
G1 X2.5 F30
G0 Z0.2
G0 X0.5 Y1.25
G0 Z-0.08
G1 X2.5 F30
G0 Z0.2
M5
M2
