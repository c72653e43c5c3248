"""packaging/dearest.py lists objects with the sources that were compiled as one; packaging/slowest.py lists tests."""

import pathlib

import dearest
import slowest

ROOT = pathlib.Path(__file__).resolve().parent.parent


def test_the_dearest_come_first_with_their_sources(tmp_path):
    together = tmp_path / "cam" / "CMakeFiles" / "fieldfab_cam.dir" / "Unity" / "unity_1_cxx.cxx"
    together.parent.mkdir(parents=True)
    together.write_text(f'#include "{ROOT}/cam/plan/order.cpp"\n\n#include "{ROOT}/cam/plan/tilt.cpp"\n')
    rows = [(0, 9000, "kernel/CMakeFiles/fieldfab_mesh.dir/src/mesh/winding.cpp.o"),
            (1000, 3500, "kernel/CMakeFiles/fieldfab_mesh.dir/src/mesh/winding.cpp.o"),  # the later compilation counts
            (2000, 14400, f"{together.relative_to(tmp_path)}.o"), (0, 99000, "lib/libfieldfab.so")]
    log = "".join(f"{start}\t{end}\t0\t{name}\tabc\n" for start, end, name in rows)
    (tmp_path / ".ninja_log").write_text(f"# ninja log v5\n{log}")
    assert dearest.table(tmp_path, 20).splitlines()[2:] == [
        "| 12 | `cam/plan`: order.cpp, tilt.cpp |", "| 2 | `kernel/src/mesh`: winding.cpp |", "| 15 | all 2 |"]


def test_the_slowest_come_first(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(slowest, "COUNT", 2)
    (tmp_path / "cpp.xml").write_text('<testsuite><testcase name="unit.A" classname="unit.A" time="1.5"/></testsuite>')
    (tmp_path / "python.xml").write_text('<testsuites><testsuite>'
                                         '<testcase name="test_a" classname="tests.hosts.cli_test" time="0.5"/>'
                                         '<testcase name="test_b" classname="tests.hosts.cli_test" time="7"/>'
                                         '</testsuite></testsuites>')
    monkeypatch.setattr("sys.argv", ["slowest.py", str(tmp_path / "cpp.xml"), str(tmp_path / "python.xml")])
    slowest.main()
    assert [line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines()] == [
        ["1.5", "all 1 of cpp"], ["7.5", "all 2 of python"],
        ["7.0", "python: cli_test: test_b"], ["1.5", "cpp: unit.A"]]
