#!/bin/bash
# meshlab_menu.sh MESH: opens it in MeshLab's window, unfolds Fieldfab's menu, and takes /shots/meshlab.png.
set -euo pipefail
LIBGL_ALWAYS_SOFTWARE=1 meshlab "$1" >/shots/meshlab_window.txt 2>&1 &
program=$!
for second in $(seq 90); do
  sleep 1
  grep -q 'All files opened' /shots/meshlab_window.txt && break
  [ $((second % 10)) = 9 ] && xdotool key Return  # OK of MeshLab 2022.02's question about vertices of .stl files
done
grep -q 'All files opened' /shots/meshlab_window.txt
sleep 3
widest=0
for each in $(xdotool search --onlyvisible --name MeshLab); do
  eval "$(xdotool getwindowgeometry --shell "$each" | grep WIDTH)"
  if [ "$WIDTH" -gt "$widest" ]; then widest=$WIDTH window=$each; fi
done
xdotool windowsize --sync "$window" 1390 860 windowmove "$window" 0 0 windowfocus "$window"
sleep 1
for key in alt+l Down Down Down Down Right Down Down Down Down Down Down Down Down Down Down Down Down; do xdotool key "$key"; sleep 0.2; done
sleep 1
import -window root /shots/meshlab.png
kill "$program"
