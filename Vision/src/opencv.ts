import library from '@techstark/opencv-js';

type OpenCv = typeof library;

/** OpenCV, available once `loaded` has resolved. Its objects are outside JavaScript's heap: their creator must delete them. */
export let cv: OpenCv;

/** Depending on its version, the package exports a promise or a module that calls back. */
export const loaded: Promise<void> = (async () => {
  // Awaiting the module itself would never end: it has a `then` that yields itself.
  const given = library instanceof Promise ? ((await library) as OpenCv) : library;
  if (!given.Mat)
    await new Promise<void>(resolve => {
      given.onRuntimeInitialized = () => resolve();
    });
  cv = given;
})();
