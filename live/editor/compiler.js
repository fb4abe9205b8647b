// The worker that compiles and links: clang and wasm-ld in WebAssembly. It sees the files of docs/tools/editor.py's archive under /usr:
// the course's headers, Eigen's and the compiler's own, the layers as an archive, and the C++ library that they were compiled with.
import { progress } from "./packed.js";
import { Exit, runLLVM } from "@yowasp/clang";

// What live/CMakeLists.txt and cmake/exercises.cmake say: layers and answers have to agree in exceptions, lanes, alignment and contraction.
// As for the program of `./course check`, an answer is compiled with -O1.
const defined = ["EMSCRIPTEN", "__EMSCRIPTEN_major__=3", "__EMSCRIPTEN_minor__=1", "__EMSCRIPTEN_tiny__=6", "_LIBCPP_ABI_VERSION=2", "unix", "__unix", "__unix__",
    "__SSE__=1", "__SSE2__=1", "__asm__(...)=", "EIGEN_MAX_ALIGN_BYTES=16", "EIGEN_UNALIGNED_VECTORIZE=0"];
const searched = ["compat", "include/c++/v1", "clang", "include"];
const options = ["clang", "-cc1", "-triple", "wasm32-unknown-emscripten", "-disable-free", "-disable-llvm-verifier", "-discard-value-names", "-mrelocation-model", "static",
    "-mframe-pointer=none", "-ffp-contract=off", "-fno-rounding-math", "-mconstructor-aliases", "-target-cpu", "mvp", "-target-feature", "+exception-handling",
    "-target-feature", "+simd128", "-mllvm", "-wasm-enable-eh", "-exception-model=wasm", "-fcxx-exceptions", "-fexceptions", "-fno-threadsafe-statics", "-fgnuc-version=7.0",
    "-std=c++20", "-O1", "-Werror=return-type", "-fno-caret-diagnostics", "-ferror-limit", "19", ...defined.flatMap(word => ["-D", word]),
    "-I", "/usr/course", "-isystem", "/usr/headers", ...searched.flatMap(folder => ["-internal-isystem", `/usr/${folder}`])];
const libraries = ["standalonewasm-memgrow", "stubs", "c", "dlmalloc", "compiler_rt", "c++-except", "c++abi-except", "unwind-except"];
const megabyte = 1 << 20;

let offered; // what docs/tools/editor.py says of the exercises
let headers; // the precompiled ones
const checks = new Map();

/** Runs a tool. @return {files} that it leaves, and what it {says}; files is null where it fails */
async function run(words, files) {
    let says = "";
    const decoder = new TextDecoder(), hear = bytes => { says += bytes ? decoder.decode(bytes, { stream: true }) : ""; };
    try {
        return { says, files: await runLLVM(words, files, { stdout: hear, stderr: hear, decodeASCII: false, fetchProgress() {} }) };
    } catch (error) {
        if (!(error instanceof Exit))
            throw error;
        return { says, files: null };
    }
}

/** The headers that every answer is compiled with, as the programs are: parsed once. */
async function precompile() {
    if (!headers) {
        const made = await run([...options, "-emit-pch", "-fno-pch-timestamp", "-o", "headers.pch", "-x", "c++-header", "headers.hpp"], { "headers.hpp": offered.headers });
        if (!made.files)
            throw new Error(made.says);
        headers = { "headers.hpp": offered.headers, "headers.pch": made.files["headers.pch"] };
    }
    return headers;
}

async function compile(exercise, name, text) {
    const words = [...options, "-emit-obj", "-vectorize-loops", "-vectorize-slp", "-iquote", `/usr/course/chapters/${exercise.chapter}`, "-iquote", `/usr/course/exercises/${exercise.chapter}`,
        "-include-pch", "headers.pch", "-o", "made.o", "-x", "c++", name];
    const made = await run(words, { ...await precompile(), ...text === undefined ? {} : { [name]: text } });
    return { says: made.says, object: made.files?.["made.o"] };
}

async function check_of(exercise) {
    if (!checks.has(exercise.number)) {
        const made = await compile(exercise, `/usr/course/${exercise.check}`);
        if (!made.object)
            throw new Error(made.says);
        checks.set(exercise.number, made.object);
    }
    return checks.get(exercise.number);
}

/** The program that judges an answer: of the objects that others rebuild, all but this exercise's. A layer's object is a whole folder, which may have a
 *  function of the answer's name; then the first one counts, the answer's. */
async function link(exercise, answer) {
    const rebuilt = offered.rebuilt.filter(name => name !== exercise.rebuilt).map(name => `/usr/lib/${name}`);
    return run(["wasm-ld", "-o", "check.wasm", "/usr/lib/crt1.o", "answer.o", "check.o", ...rebuilt, "/usr/lib/liblayers.a", "/usr/lib/libjudge.a",
        ...libraries.map(name => `/usr/lib/lib${name}.a`), "--strip-debug", "--stack-first", "-z", `stack-size=${8 * megabyte}`, `--initial-memory=${32 * megabyte}`,
        `--max-memory=${2048 * megabyte}`, "--allow-undefined-file=/usr/lib/imported", "--allow-multiple-definition", "-mllvm", "-wasm-enable-eh", "-mllvm", "-exception-model=wasm"],
    { "answer.o": answer, "check.o": await check_of(exercise) });
}

const asked = {
    async load(given) {
        offered = given;
        progress.tell = done => postMessage({ loaded: done });
        await runLLVM(null, {}, { fetchProgress() {} });
    },
    async prepare(exercise) {
        await check_of(exercise);
    },
    /** @return {program}, or what the compiler or the linker says */
    async build(exercise, text) {
        const made = await compile(exercise, "answer.cpp", text);
        if (!made.object)
            return { compiler: made.says };
        const linked = await link(exercise, made.object);
        return linked.files ? { program: linked.files["check.wasm"] } : { linker: linked.says };
    },
};

let last = Promise.resolve(); // one after the other
onmessage = ({ data: { id, what, words } }) => {
    last = last.then(async () => {
        try {
            postMessage({ id, answer: await asked[what](...words) });
        } catch (error) {
            postMessage({ id, error: String(error?.stack ?? error) });
        }
    });
};
