// What the command line starts: a request per line of standard input, an answer per line of standard output, in that order.
import { createInterface } from 'node:readline';
import { Finder, type Found } from './finder';
import type { Grey } from './levels';
import { loaded } from './opencv';
import type { Pattern } from './pattern';
import { readPicture, writePicture } from './pictureFile';
import { take, type Shot } from './render/camera';

/** Exactly one of the first four: a file's path, grey bytes in Base64, or a picture to be made; the pattern comes first of all. */
interface Request {
  pattern?: Pattern;
  file?: string;
  grey?: { width: number; height: number; data: string };
  shot?: Shot;
  /** Where a picture that is made goes; without it, it is searched at once. */
  to?: string;
}

type Answer = { width: number; height: number; codes: Found[] } | { error: string } | Record<string, never>;

let finder: Finder;

async function answer(request: Request): Promise<Answer> {
  if (request.pattern) {
    await loaded;
    finder = new Finder(request.pattern);
    return {};
  }
  const picture = await pictureOf(request);
  if (request.to) {
    await writePicture(request.to, picture);
    return {};
  }
  return { width: picture.width, height: picture.height, codes: finder.find(picture) };
}

async function pictureOf({ file, grey, shot }: Request): Promise<Grey> {
  if (file) return readPicture(file);
  if (grey) return { ...grey, data: new Uint8Array(Buffer.from(grey.data, 'base64')) };
  return take(shot!);
}

for await (const line of createInterface({ input: process.stdin })) {
  let answered: Answer;
  try {
    answered = await answer(JSON.parse(line) as Request);
  } catch (error) {
    answered = { error: error instanceof Error ? error.message : String(error) };
  }
  process.stdout.write(JSON.stringify(answered) + '\n');
}
