"""packaging/check.py: the tests that ./dev check takes in the time that it has."""

import check
import reach

INSIDE = reach.INSIDE


def report(cases):
    rows = "".join(f'<testcase classname="{name}" name="{test}" time="{seconds}"/>' for name, test, seconds in cases)
    return f"<testsuites><testsuite>{rows}</testsuite></testsuites>"


def test_times_are_those_of_the_last_run(tmp_path, monkeypatch):
    monkeypatch.setattr(check, "TIMES", tmp_path / "python.xml")
    assert check.last_times() == {}
    check.TIMES.write_text(report([("tests.hosts.cam_test", "test_a@cam_test", 1.5), ("tests.text_test", "test_b", 0.5),
                                   ("tests.hosts.cam_test", "test_c@cam_test", 2),
                                   ("tests.hosts.freecad_inside_test", "test_in_the_window[window_cam]", 8)]))
    assert check.last_times() == {"tests/hosts/cam_test.py": 3.5, "tests/text_test.py": 0.5, INSIDE: 8,
                                  f"{INSIDE}::test_in_the_window[window_cam]": 8}


def test_the_quickest_are_taken_and_what_is_left_is_told():
    times = {"a": 50.0, "b": 1.0, "c": 10.0, "d": 3.0}
    assert check.within("abcd", 20, times) == (["b", "d", "c"], ["a"])
    assert check.within("abcd", 0, times) == ([], ["b", "d", "c", "a"])
    assert check.within(["a", "new"], check.UNKNOWN, times) == (["new"], ["a"])


def test_what_runs_within_freecad_is_taken_test_by_test():
    times = {INSIDE: 9.0, f"{INSIDE}::test_in_the_window[window_cam]": 4.0,
             f"{INSIDE}::test_without_window[inside_cam]": 5.0}
    assert check.as_single_tests({INSIDE, "a"}, times) == {"a", *(set(times) - {INSIDE})}
    assert check.as_single_tests({INSIDE}, {}) == {INSIDE}
    assert check.as_single_tests({"a"}, times) == {"a"}
