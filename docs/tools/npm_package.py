#!/usr/bin/env python3
"""The solvers as a package for npm: live/npm with the compiled module, packed by `npm pack`.

    docs/tools/npm_package.py           build/npm/enduring-contacts-VERSION.tgz; the version is that of CITATION.cff
"""
import json
import shutil
import subprocess
import sys
from pathlib import Path

import live
import release

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build/npm"


def version():
    """As npm wants it, in three numbers."""
    told = release.version_of((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    return ".".join([*told.split("."), "0", "0"][:3])


def pack(module, work=WORK):
    """The package's file.
    @param module  the compiled solvers: lab.js of build/live"""
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(ROOT / "live/npm", work / "package")
    shutil.copyfile(module, work / "package/solver.cjs")
    about = work / "package/package.json"
    about.write_text(json.dumps(json.loads(about.read_text(encoding="utf-8")) | {"version": version()}, indent=2) + "\n", encoding="utf-8")
    done = subprocess.run(["npm", "pack", "--silent", "--pack-destination", str(work)], cwd=work / "package", capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"npm pack: {done.stderr}")
    return work / done.stdout.split()[-1]


def main():
    if not shutil.which("npm"):
        sys.exit("The package needs npm. On Debian: apt-get install npm")
    live.compile_module()
    made = pack(live.WORK / "lab.js")
    print(f"{made}: {made.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
