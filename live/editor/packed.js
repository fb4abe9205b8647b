// Files come compressed, whatever the server does: NAME.gz is fetched in the place of NAME. To be imported before the compiler, which keeps this `fetch`.
const plain = self.fetch.bind(self);
export const progress = { done: 0, tell() {} };

self.fetch = async place => {
    const address = new URL(place), answer = await plain(`${address}.gz`);
    if (!answer.ok)
        throw new Error(`${address.pathname}.gz: ${answer.status}`);
    const counted = new TransformStream({
        transform(chunk, controller) {
            progress.done += chunk.length;
            progress.tell(progress.done);
            controller.enqueue(chunk);
        },
    });
    const type = address.pathname.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
    return new Response(answer.body.pipeThrough(counted).pipeThrough(new DecompressionStream("gzip")), { headers: { "content-type": type } });
};
