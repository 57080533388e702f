"""One wheel for all Pythons: py3-none-PLATFORM, with the C library of the build that $TAUT_BUILD names (../build/release)."""
import os
import pathlib
import re
import shutil
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(os.environ.get("TAUT_BUILD", HERE.parent / "build/release"))
VERSION = re.search(r'VERSION = "(.*?)"', (HERE / "taut/_library.py").read_text())[1]


def carried():
    """What of the build goes into the wheel: the library, and beside it in taut/ what it loads when it is asked for more."""
    libraries = [path for pattern in ("libtaut*.so.0", "bin/libtaut*.dll") for path in sorted(BUILD.glob(pattern))]
    if not libraries:
        raise SystemExit(f"setup.py: there is no libtaut in {BUILD}: build it first (cmake --build --preset release), or set TAUT_BUILD")
    helpers = sorted((BUILD / "modules").glob("taut-*.so"))
    programs = [path for path in (BUILD / "libexec/taut-cad",) if path.exists()][:1]
    return [(path, path.name) for path in libraries + programs] + [(path, f"taut/{path.name}") for path in helpers]


class Build(build_py):
    """The package, with the library in it."""

    def run(self):
        super().run()
        folder = pathlib.Path(self.build_lib, "taut/lib")
        shutil.rmtree(folder, ignore_errors=True)
        for path, name in carried():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path.resolve(), folder / name)


class Wheel(bdist_wheel):
    """Any Python, one platform: the oldest glibc that the libraries say they run on."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        _, _, platform = super().get_tag()
        if all(path.suffix == ".dll" for path, _ in carried()):  # packed elsewhere: the library of the build preset mingw
            return "py3", "none", "win_amd64"
        if sys.platform == "linux":
            newest = max(int(minor) for path, _ in carried() for minor in re.findall(rb"GLIBC_2\.(\d+)", path.read_bytes()))
            platform = f"manylinux_2_{newest}_{os.uname().machine}"
        return "py3", "none", platform


class Platform(Distribution):
    """Not for every platform, though nothing is compiled here."""

    def has_ext_modules(self):
        return True


setup(version=VERSION, cmdclass={"build_py": Build, "bdist_wheel": Wheel}, distclass=Platform)
