// The worker that runs one program: what it writes to each descriptor is told as it comes, for it may never end.
onmessage = async ({ data: program }) => {
    const decoders = {}, failed = 8, noFile = -44; // as WASI calls a bad descriptor, and a file that is not there
    let memory;
    const view = () => new DataView(memory.buffer);
    const wasi = {
        fd_write(descriptor, pieces, count, done) {
            let total = 0;
            for (let i = 0; i < count; ++i) {
                const start = view().getUint32(pieces + 8 * i, true), length = view().getUint32(pieces + 8 * i + 4, true);
                decoders[descriptor] ??= new TextDecoder();
                postMessage({ descriptor, text: decoders[descriptor].decode(new Uint8Array(memory.buffer, start, length), { stream: true }) });
                total += length;
            }
            view().setUint32(done, total, true);
            return 0;
        },
        environ_sizes_get(count, size) {
            view().setUint32(count, 0, true);
            view().setUint32(size, 0, true);
            return 0;
        },
        environ_get: () => 0,
        clock_time_get(_clock, _precision, at) {
            view().setBigUint64(at, BigInt(Math.round(1e6 * performance.now())), true);
            return 0;
        },
        proc_exit(code) { throw { code }; },
    };
    const module = await WebAssembly.compile(program), imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module))
        (imports[from] ??= {})[name] = wasi[name] ?? (name.startsWith("__syscall") ? () => noFile : from === "env" ? () => {} : () => failed);
    try {
        const instance = await WebAssembly.instantiate(module, imports);
        memory = instance.exports.memory;
        instance.exports._start();
        postMessage({ ended: "itself", code: 0 });
    } catch (error) {
        postMessage(error?.code === undefined ? { ended: "trap" } : { ended: "itself", code: error.code });
    }
};
