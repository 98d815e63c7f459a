import library from '@techstark/opencv-js';

type OpenCv = typeof library;

/** OpenCV, available after `loaded` has resolved. Its objects are not garbage-collected: the code that creates one must delete it. */
export let cv: OpenCv;

/** Resolves when OpenCV is ready. Depending on its version, the package exports a promise, or a module with a callback. */
export const loaded: Promise<void> = (async () => {
  // Does not await the module itself: its `then` yields the module again, so the await would never end.
  const given = library instanceof Promise ? ((await library) as OpenCv) : library;
  if (!given.Mat)
    await new Promise<void>(resolve => {
      given.onRuntimeInitialized = () => resolve();
    });
  cv = given;
})();
