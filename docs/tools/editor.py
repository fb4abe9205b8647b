#!/usr/bin/env python3
"""The exercises in the page: on a served book each exercise has an editor, and clang in WebAssembly judges there as `./course check` does.

    docs/tools/editor.py                  build/editor: its files; into build/book, where that stands
    docs/tools/editor.py --serve          and serves the book

All that is loaded comes compressed and on demand. From npm, in the versions and with the digests of docs/tools/npm/editor/package-lock.json: clang (YoWASP),
CodeMirror, which edits, and esbuild, which makes one file of each script. Where npm does not give them, the book has no editor.
"""
import argparse
import gzip
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import exercise_pages
import lab
import live
import npm
from judge import properties_of  # beside the catalogue, where exercise_pages found it

ROOT = Path(__file__).resolve().parents[2]
WORK, NPM = ROOT / "build/editor", ROOT / "build/editor_npm"
EIGEN = Path("/usr/include/eigen3")
CLANG = NPM / "node_modules/@yowasp/clang/gen"
LIBRARIES = ["standalonewasm-memgrow", "stubs", "c", "dlmalloc", "compiler_rt", "c++-except", "c++abi-except", "unwind-except"]
# What the C library asks of the page: growth, signals, and files, of which a page has none.
IMPORTED = "".join(f"{name}\n" for name in ("emscripten_notify_memory_growth __call_sighandler "
                                             "__syscall_stat64 __syscall_lstat64 __syscall_fstat64 __syscall_fstatat64").split())
# Of the C library's headers, those of screens, sound and networks are left out; of clang's, those of processors.
LEFT_OUT = re.compile(r"(AL|EGL|GL|GLES\d?|GLFW|KHR|SDL|X11|webgl|webgpu|net|netinet|netpacket|sanitizer|scsi|mach-o|c\+\+/v1/(experimental|ext))/")
OTHER_PROCESSORS = re.compile(r"/arch/(?!Default|Generic|SSE)")  # of Eigen
CLANGS_OWN = re.compile(r"include/((__)?(std|float|limits|inttypes|iso646|tgmath|varargs|wasm)\w*\.h)")
# A written file is copied for each piece of some kilobytes that is added: for 28 MB of precompiled headers, a minute. So it grows by halves.
GROWS = ("const newData = new Uint8Array(Math.max(this.file.data.length, offset + contents.length));\n    newData.set(this.file.data);\n",
         """const size = Math.max(this.file.data.length, offset + contents.length);
    if (!this.file.room || this.file.room.length < size) {
      this.file.room = new Uint8Array(size + (size >> 1));
      this.file.room.set(this.file.data);
    }
    const newData = this.file.room.subarray(0, size);
""")


def bundle():
    """The scripts, each with what it needs, in one file."""
    script = CLANG / "bundle.js"
    text = script.read_text(encoding="utf-8")
    if GROWS[1] not in text:
        if text.count(GROWS[0]) != 1:
            sys.exit(f"{script}: another version than the one that docs/tools/editor.py changes")
        script.write_text(text.replace(*GROWS), encoding="utf-8")
    for name in ("page.js", "compiler.js", "runner.js", "offer.js"):
        shape = "iife" if name == "offer.js" else "esm"
        live.run([str(NPM / "node_modules/.bin/esbuild"), str(ROOT / "live/editor" / name), "--bundle", "--minify", f"--format={shape}", "--legal-comments=none",
                  "--external:node:*", "--external:./page.js", f"--outfile={WORK / name}"], {"NODE_PATH": str(NPM / "node_modules")})


class Entry(tarfile.TarInfo):
    """A folder's name without a slash, as the compiler's reader wants it."""
    def get_info(self):
        return super().get_info() | {"name": self.name}


def archive(files):
    """The bytes of a tar file. @param files  {name: bytes}"""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        folders = {str(folder) for name in files for folder in Path(name).parents} - {"."}
        for name in sorted(folders | set(files)):
            entry = Entry(name)
            if len(name) > 99:
                sys.exit(f"{name}: too long a name for the archive")
            if name in files:
                entry.size = len(files[name])
                tar.addfile(entry, io.BytesIO(files[name]))
            else:
                entry.type = tarfile.DIRTYPE
                tar.addfile(entry)
    return out.getvalue()


def header(path, root):
    """A header's bytes; what it includes by a path with "..", which the compiler's file system does not know, by the path from the root."""
    above = path.parent.relative_to(root)
    return re.sub(rb'(#\s*include\s*)"(\.\./[^"]+)"', lambda found: found[1] + b'"' + os.path.normpath(above / found[2].decode()).encode() + b'"', path.read_bytes())


def headers_read():
    """The headers that the layers' build has read: the folder of the C and C++ library, and those of Eigen and of the other libraries."""
    told = subprocess.run(["ninja", "-C", str(live.WORK), "-t", "deps"], capture_output=True, text=True, check=True).stdout
    read = {Path(line.strip()) for line in told.splitlines() if line.startswith("    ")}
    system = next(Path(str(path).partition("/c++/v1/")[0]) for path in read if "/c++/v1/" in str(path))
    return system, {path for path in read if path.is_relative_to(EIGEN)}, {path for path in read if path.is_relative_to(live.WORK / "include")}


def layers(files):
    """The archive of the layers without what exercises rebuild; these objects apart. @return their names"""
    names = sorted(Path(exercise.source).name + ".o" for exercises in exercise_pages.by_chapter(ROOT).values() for exercise in exercises if exercise.kind == "rebuild")
    folder = WORK / "objects"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    shutil.copyfile(live.WORK / "liblayers.a", folder / "liblayers.a")
    for word in ("x", "d"):
        subprocess.run(["emar", word, "liblayers.a", *names], cwd=folder, check=True)
    for name in ("liblayers.a", *names):
        files[f"lib/{name}"] = (folder / name).read_bytes()
    files["lib/libjudge.a"] = (live.WORK / "libjudge.a").read_bytes()
    return names


def course_headers(files):
    for pattern in ("common/**/*.hpp", "chapters/**/*.hpp", "exercises/*.hpp", "exercises/*/*.hpp", "exercises/*/*.check.cpp", "live/charconv_of_doubles.hpp"):
        files |= {f"course/{path.relative_to(ROOT)}": path.read_bytes() for path in ROOT.glob(pattern) if "/engines/" not in str(path)}
    return files


def library(files):
    """What the layers were compiled with: the C and C++ library, Eigen, doctest, and clang's own headers."""
    system, eigen, others = headers_read()
    eigen |= {path for path in (EIGEN / "Eigen").rglob("*") if path.is_file() and not OTHER_PROCESSORS.search(str(path))}
    for path in [*system.glob("*.h"), *(path for path in system.glob("*/**/*") if path.is_file())]:
        name = str(path.relative_to(system))
        if not LEFT_OUT.match(name):
            files[name if name.startswith("compat/") else f"include/{name}"] = path.read_bytes()
    files |= {f"headers/{path.relative_to(EIGEN)}": header(path, EIGEN) for path in eigen}
    files |= {f"headers/{path.relative_to(live.WORK / 'include')}": path.read_bytes() for path in others if "/boost/" not in str(path)}
    with tarfile.open(CLANG / "llvm-resources.tar") as tar:
        for entry in tar:
            if found := CLANGS_OWN.fullmatch(entry.name.removeprefix("./")):
                files[f"clang/{found[1]}"] = tar.extractfile(entry).read()
    place = system.parent / "lib/wasm32-emscripten"
    files |= {f"lib/lib{name}.a": (place / f"lib{name}.a").read_bytes() for name in LIBRARIES} | {"lib/crt1.o": (place / "crt1.o").read_bytes(), "lib/imported": IMPORTED.encode()}


def precompiled():
    """The headers that all answers are compiled with, as cmake/precompiled.cmake lists them, behind that of the browser's build."""
    names = re.findall(r"<[\w/]+>", (ROOT / "cmake/precompiled.cmake").read_text(encoding="utf-8"))
    return "".join(f"#include {name}\n" for name in ['"live/charconv_of_doubles.hpp"', *names])


def entry_of(exercise):
    """What the page has to know of an exercise."""
    rebuilt = Path(exercise.source).name + ".o" if exercise.kind == "rebuild" else ""
    return {"number": exercise.number, "title": exercise.title, "chapter": exercise.chapter, "rebuilt": rebuilt, "file": exercise_pages.catalogue.shown(exercise.answer),
            "check": str(exercise.published_check.relative_to(ROOT)), "properties": properties_of(exercise), "stub": exercise.stub_text(),
            "mutants": [{"name": mutant.name, "fails": mutant.fails, "diagnosis": " ".join(mutant.diagnosis.split()), "text": exercise.mutated(mutant)} for mutant in exercise.mutants]}


def offered():
    """All exercises, in their order."""
    return [exercise for exercises in exercise_pages.by_chapter(ROOT).values() for exercise in exercises]


def pack(data, place):
    place.write_bytes(gzip.compress(data, 6, mtime=0))


def build():
    """build/editor, from compiled layers. @return the bytes that a reader loads"""
    WORK.mkdir(parents=True, exist_ok=True)
    bundle()
    shutil.copyfile(ROOT / "live/editor/editor.css", WORK / "editor.css")
    files = {}
    rebuilt = layers(files)
    course_headers(files)
    library(files)
    pack(archive(files), WORK / "llvm-resources.tar.gz")
    for module in CLANG.glob("*.wasm"):
        packed = WORK / f"{module.name}.gz"
        if not packed.is_file() or packed.stat().st_mtime < module.stat().st_mtime:
            pack(module.read_bytes(), packed)
    size = sum(path.stat().st_size for path in [*WORK.glob("*.wasm.gz"), WORK / "llvm-resources.tar.gz"])
    about = {"size": size, "rebuilt": rebuilt, "headers": precompiled(), "exercises": [entry_of(exercise) for exercise in offered()]}
    pack(json.dumps(about).encode(), WORK / "exercises.json.gz")
    return size


def bring(book):
    """Its files into the book, and into each page of exercises the script that offers an editor; nothing where npm does not give them."""
    if not npm.installed(ROOT / "docs/tools/npm/editor", NPM):
        print("The exercises in the page: left out, npm does not give what they need")
        return
    size = build()
    exercises = offered()
    place = book / "live/editor"
    shutil.copytree(WORK, place, dirs_exist_ok=True, ignore=shutil.ignore_patterns("objects"))
    for page in book.glob("exercises_[0-9][0-9].html"):
        numbers = [exercise.number for exercise in exercises if exercise.chapter.startswith(page.stem[-2:])]
        text = re.sub(r'<link [^>]*editor\.css"/><script [^>]*offer\.js"></script>', "", page.read_text(encoding="utf-8"))
        script = (f'<link rel="stylesheet" href="live/editor/editor.css"/><script defer="defer" data-exercises="{" ".join(numbers)}" data-size="{size / 1e6:.0f}" '
                  'src="live/editor/offer.js"></script>')
        page.write_text(text.replace("</body>", f"{script}</body>") if numbers else text, encoding="utf-8")
    print(f"The exercises in the page: {len(exercises)} of them, {size / 1e6:.1f} MB compressed, loaded on demand")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--book", type=Path, default=ROOT / "build/book", help="the book, built with --live")
    parser.add_argument("--serve", action="store_true", help="serves the book until Ctrl-C, and opens it")
    parser.add_argument("--no-browser", action="store_true", help="only serves it")
    options = parser.parse_args()
    if not (options.book / "live").is_dir():
        sys.exit(f"{options.book} has no live figures: ./course docs --live builds them")
    live.compile_module()
    bring(options.book)
    if options.serve:
        lab.serve(not options.no_browser, options.book, "exercises_01.html", "The exercises")


if __name__ == "__main__":
    main()
