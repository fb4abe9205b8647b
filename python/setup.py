"""Builds the module `enduring` with CMake (preset `python`), for a wheel; its version is that of CITATION.cff."""
import re
import shutil
import subprocess
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[1]


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        for words in (["--preset", "python"], ["--build", "build/python", "--target", extension.name]):
            subprocess.run(["cmake", *words], cwd=ROOT, check=True)
        place = Path(self.get_ext_fullpath(extension.name))
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / "build/python" / (extension.name + sysconfig.get_config_var("EXT_SUFFIX")), place)


# (The schema of pyproject.toml refuses the hyphen in the name of a package of types, PEP 561.)
setup(packages=["enduring-stubs"], package_data={"enduring-stubs": ["*.pyi"]},
      version=re.search(r'^version: "(.+)"$', (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.M)[1],
      ext_modules=[Extension("enduring", sources=[])], cmdclass={"build_ext": BuildByCMake})
