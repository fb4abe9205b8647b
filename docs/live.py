"""The live figures: compiles the chapters to WebAssembly, where the compiler is installed, and brings them into the book."""
import hashlib
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "build/live"
SOURCES = [
    "live/*.cpp", "common/geometry/*_shapes.cpp", "common/geometry/surface_topology.cpp", "common/geometry/surface_checks.cpp",
    "common/rigid/rigid_motion.cpp", "common/rigid/free_rotation.cpp", "common/rigid/mass_properties.cpp",
    "common/simulation/rigid_body.cpp", "common/simulation/static_body.cpp", "common/simulation/step.cpp",
    "common/experiments/run/timings.cpp", "common/simulation/contact_geometry.cpp", "common/simulation/contact_parameters.cpp",
    "chapters/0[1-6]_*/*.cpp", "chapters/05_categorisation/experiments/corner.cpp"]
LEFT_OUT = ["main.cpp", "query_files.cpp", "body_broad_phase.cpp"]  # the last needs Bullet, and has a stand-in in live
# As the programs are compiled: no contraction of products and sums, so the same numbers come out.
OPTIONS = ["-std=c++20", "-O2", "-fexceptions", "-ffp-contract=off", "-DNDEBUG", "-DEIGEN_MAX_ALIGN_BYTES=16",
           f"-I{ROOT}", f"-I{ROOT}/live", "-isystem", "/usr/include/eigen3",
           "-idirafter", f"{WORK}/include"]
NODE_MODULES = "/usr/share/nodejs"  # where Debian keeps what the compiler's own scripts need, for a node that is not Debian's
LINKED = ["--bind", "-sMODULARIZE=1", "-sEXPORT_NAME=enduring_live", "-sSINGLE_FILE=1", "-sALLOW_MEMORY_GROWTH=1", "-sENVIRONMENT=web,node"]


def possible():
    """Whether the compiler is there."""
    return shutil.which("em++") is not None


def sources():
    found = sorted(path for pattern in SOURCES for path in ROOT.glob(pattern))
    return [path for path in found if path.name not in LEFT_OUT]


def digest_of(paths):
    """Of what is in some files, and of how they are compiled."""
    digest = hashlib.sha256(" ".join(OPTIONS + LINKED).encode())
    for path in paths:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def compile_module():
    """build/live/live.js, the module with the compiled code inside it; made anew only where a source has changed.
    @throws SystemExit when the compiler is missing, or refuses"""
    if not possible():
        sys.exit("The live figures need emscripten. On Debian: apt-get install emscripten   (or: ./course setup)")
    headers = sorted(path for folder in ("live", "common", "chapters") for path in (ROOT / folder).rglob("*.h*"))
    stamp, made_of = WORK / "made_of", digest_of(sources() + headers)
    if (WORK / "live.js").is_file() and stamp.is_file() and stamp.read_text() == made_of:
        return
    WORK.mkdir(parents=True, exist_ok=True)
    link_headers()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(lambda source: compile_source(source, headers), sources()))
    run(["em++", *map(str, objects), *OPTIONS[1:3], *LINKED, "-o", str(WORK / "live.part.js")])
    (WORK / "live.part.js").replace(WORK / "live.js")
    stamp.write_text(made_of)


def link_headers():
    """Debian's header-only libraries, without the rest of /usr/include, which is not the browser's."""
    include = WORK / "include"
    include.mkdir(exist_ok=True)
    for name in ("nlohmann", "boost"):
        if not (include / name).exists():
            (include / name).symlink_to(f"/usr/include/{name}")


def compile_source(path, headers):
    """One object, named by what it is made of: what did not change is not compiled again."""
    target = WORK / f"{path.relative_to(ROOT).as_posix().replace('/', '_')}.{digest_of([path, *headers])}.o"
    if not target.is_file():
        run(["em++", *OPTIONS, "-iquote", str(path.parent), "-c", str(path), "-o", f"{target}.part"])
        Path(f"{target}.part").replace(target)
    return target


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"NODE_PATH": NODE_MODULES})
    if done.returncode:
        sys.exit(f"The live figures were not built: {' '.join(command[-4:])}\n{done.stderr[-3000:]}")


def bring(book):
    """The module and the scripts that draw with it."""
    place = book / "live"
    place.mkdir(exist_ok=True)
    shutil.copyfile(WORK / "live.js", place / "live.js")
    for script in sorted((ROOT / "live").glob("*.js")):
        shutil.copyfile(script, place / script.name)


if __name__ == "__main__":
    compile_module()
