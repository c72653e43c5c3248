#!/bin/bash
# What a newcomer does with the packages in /packages, in a bare Debian, as root; pictures go to /shots. ./dev newcomer runs it.
set -euo pipefail
trap 'echo "newcomer: line $LINENO failed" >&2' ERR
step() { echo "== $*"; }
here=$(mktemp -d)
cd "$here"

files() { find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /root -o -path /run -o -path /newcomer -o -path /packages -o -path /shots \) -prune -o -iname '*fieldfab*' -print | sort; }

step "a screen, and who presses keys (no part of the packages)"
apt-get install -q -y --no-install-recommends xvfb xauth imagemagick xdotool >/dev/null

step "apt install ./*.deb"
apt-get install -q -y --no-install-recommends /packages/*.deb >/shots/install.log || { tail -20 /shots/install.log; exit 1; }
dpkg-query -W -f '${Package} ${Version} ${db:Status-Status}\n' '*fieldfab*'

# Recommended packages that MeshLab 2022.02 complains of when they are missing.
apt-get install -q -y --no-install-recommends libmuparser2v5 lib3ds-1-3 libopenctm1 >/dev/null

step "the command"
examples=/usr/share/doc/fieldfab/examples
fieldfab --version
fieldfab mesh $examples/bracket.frep -o bracket.stl --voxel 0.2
fieldfab render $examples/pawn.frep -o /shots/pawn.png --alpha 30 --beta=-60
fieldfab check $examples/bracket.frep | tail -n 1    # OpenVDB
python3 -c 'import sys; sys.stdout.buffer.write(b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n\n" + bytes(255 * (x + y + z < 14) for z in range(9) for y in range(9) for x in range(9)))' >scan.nrrd
fieldfab mesh scan.nrrd -o scan.stl                  # ITK
fieldfab build $examples/pawn.frep -o pawn.asdf
fieldfab convert $examples/pawn.frep -o pawn.vdb
fieldfab cam $examples/cam/knob_five_axis.toml -o knob.ngc
man -w fieldfab 2>/dev/null || ls /usr/share/man/man1/fieldfab.1.gz
bash -c 'source /usr/share/bash-completion/completions/fieldfab; COMP_WORDS=(fieldfab sim); COMP_CWORD=1; _fieldfab fieldfab sim; test "${COMPREPLY[*]}" = simulate'
/usr/libexec/fieldfab/thumbnailer pawn.asdf /shots/thumbnail.png 128

step "Python"
python3 -m fieldfab --version
python3 -c '
import fieldfab as ff
part = ff.shapes.difference(ff.shapes.box(20, 20, 10), ff.shapes.cylinder(4, 12))
print(ff.mesh(part, voxel=0.2).triangles.shape, ff.check(part).passed)'

step "fabserver, with what python3-fieldfab recommends for it"
apt-get install -q -y --no-install-recommends python3-aiohttp >/dev/null
fieldfab serve --no-browser --port 8765 >/shots/serve.txt 2>&1 &
server=$!
python3 -c '
import time, urllib.request
for _ in range(60):
    try:
        assert b"<title>" in urllib.request.urlopen("http://127.0.0.1:8765/").read()
        break
    except OSError:
        time.sleep(1)
else:
    raise SystemExit("no page")'
kill $server

step "FreeCAD without a window"
freecadcmd /newcomer/freecad_solid.py </dev/null 2>&1 | tee /shots/freecad.txt | grep 'solid:'

step "FreeCAD's window"
export QTWEBENGINE_DISABLE_SANDBOX=1 SHOT=/shots/freecad.png
timeout 300 xvfb-run -a -s "-screen 0 1400x900x24" freecad /newcomer/freecad_solid.py >/shots/freecad_window.txt 2>&1 || true
test -s /shots/freecad.png

step "MeshLab's plugin"
if command -v meshlabserver >/dev/null; then  # MeshLab 2022.02 has none
  xvfb-run -a meshlabserver -i bracket.stl -o remeshed.ply -s /newcomer/remesh.mlx 2>&1 | tee /shots/meshlab.txt | tail -n 5
  test -s remeshed.ply
fi
(xvfb-run -a -s "-screen 0 1400x900x24" bash /newcomer/meshlab_menu.sh "$here/bracket.stl")
test -s /shots/meshlab.png

step "a program against the SDK"
apt-get install -q -y --no-install-recommends cmake g++ ninja-build pkg-config >/dev/null
cmake -G Ninja -S $examples/cpp -B sdk >/dev/null && cmake --build sdk >/dev/null
sdk/formula_to_mesh 'sphere(r = 5)' ball.stl

step "removed, without a trace"
apt-get purge -q -y '*fieldfab*' >/dev/null
left=$(files)
[ -z "$left" ] || { echo "left: $left" >&2; exit 1; }
echo "newcomer: all of it works"
