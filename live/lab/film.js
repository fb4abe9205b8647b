// A film of a canvas, as the browser's own recorder writes it.
const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
const PICTURES_A_SECOND = 30, BITS_A_SECOND = 8e6, LAST_PICTURE = 200; // the recorder needs some milliseconds for the last one

export const filmType = () => TYPES.find(type => globalThis.MediaRecorder?.isTypeSupported(type));

// `draw(seconds)` paints the canvas, and says whether there is more to come. @return the film, a Blob
export function record(canvas, draw) {
  const type = filmType(), recorder = new MediaRecorder(canvas.captureStream(PICTURES_A_SECOND), { mimeType: type, videoBitsPerSecond: BITS_A_SECOND }), pieces = [];
  return new Promise((done, failed) => {
    recorder.ondataavailable = ({ data }) => data.size && pieces.push(data);
    recorder.onerror = ({ error }) => failed(error ?? new Error("the recorder stopped"));
    recorder.onstop = () => done(new Blob(pieces, { type: type.split(";")[0] }));
    const paint = () => {
      if (draw((performance.now() - begun) / 1000)) requestAnimationFrame(paint);
      else setTimeout(() => recorder.stop(), LAST_PICTURE);
    };
    draw(0);
    recorder.start();
    const begun = performance.now();
    requestAnimationFrame(paint);
  });
}
