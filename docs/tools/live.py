"""The live figures: has the chapters built as WebAssembly (the preset `live`), where the compiler is installed, and brings them into the book."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build/live"
NODE_MODULES = "/usr/share/nodejs"  # where Debian keeps what the compiler's own scripts need, for a node that is not Debian's


def possible():
    """Whether the compiler is there."""
    return shutil.which("em++") is not None


def compile_module():
    """build/live/live.js, the module of the figures, and lab.js, that of the laboratory, with the compiled code inside them.
    @throws SystemExit when the compiler is missing, or refuses"""
    if not possible():
        sys.exit("The live figures need emscripten. On Debian: apt-get install emscripten   (or: ./course setup)")
    run(["cmake", "--preset", "live"])
    run(["cmake", "--build", str(WORK)])


def run(command, environment=None):
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, env=os.environ | {"NODE_PATH": NODE_MODULES} | (environment or {}))
    if done.returncode:
        sys.exit(f"The live figures were not built: {' '.join(command)}\n{(done.stdout + done.stderr)[-3000:]}")


def bring(book):
    """The module and the scripts that draw with it."""
    place = book / "live"
    place.mkdir(exist_ok=True)
    shutil.copyfile(WORK / "live.js", place / "live.js")
    for script in sorted((ROOT / "live").glob("*.js")):
        shutil.copyfile(script, place / script.name)


if __name__ == "__main__":
    compile_module()
