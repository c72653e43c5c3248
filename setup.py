"""Builds the wheel of `pip install .`: CMake installs its component python into the package's folder."""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).parent.resolve()
BUILD = ROOT / "build" / "pip"
TARGETS = ["fieldfab_command", "fieldfab_python", "fieldfab_web"]
VERSION = re.search(r"project\(fieldfab VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class Build(build_py):
    def run(self):
        folder = pathlib.Path(self.build_lib).resolve()
        run("cmake", "-G", "Ninja", "-S", ROOT, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release", "-DFIELDFAB_WHEEL=ON",
            "-DBUILD_TESTING=OFF", f"-DPYTHON_EXECUTABLE={sys.executable}")
        run("cmake", "--build", BUILD, "--target", *TARGETS, "--", f"-j{len(os.sched_getaffinity(0))}")
        run("cmake", "--install", BUILD, "--prefix", folder, "--component", "python")
        for link in [path for path in folder.rglob("*.so*") if path.is_symlink()]:  # a wheel would hold each file twice
            link.resolve().rename(link)


class WithLibraries(Distribution):
    """Has its wheel named after the processor and the Python that it was built for."""

    def has_ext_modules(self):
        return True


def run(*words):
    subprocess.run([str(word) for word in words], check=True)


BUILD.mkdir(parents=True, exist_ok=True)
setup(version=VERSION, packages=["fieldfab"], package_dir={"": "python"}, cmdclass={"build_py": Build},
      distclass=WithLibraries,
      options={"build": {"build_base": str(BUILD / "wheel")}, "egg_info": {"egg_base": str(BUILD)}})
