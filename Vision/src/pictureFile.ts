import { readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import decodeJpeg, { init as initDecoder } from '@jsquash/jpeg/decode.js';
import encodeJpeg, { init as initEncoder } from '@jsquash/jpeg/encode.js';
import decoder from '@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm';
import encoder from '@jsquash/jpeg/codec/enc/mozjpeg_enc.wasm';
import { PNG } from 'pngjs';
import { greyOf, rgbaOf, type Grey } from './levels';
import { pictureMessages } from './messages';
import { checkSize, isHeic, isJpeg, isPng } from './pictureSize';

// Defines a class of browsers that the codecs need and Node does not have.
(globalThis as { ImageData?: unknown }).ImageData ??= class {
  constructor(
    readonly data: Uint8ClampedArray,
    readonly width: number,
    readonly height: number,
  ) {}
};

let isDecoding = false;
let isEncoding = false;

/**
 * Reads a PNG or JPEG file as grey values. Throws an error that names the defect. Ignores the orientation stored in the file, so that each row
 * of the picture is a row of the exposure.
 */
export async function readPicture(path: string): Promise<Grey> {
  const bytes = readFileSync(path);
  if (bytes.length === 0) throw new Error(pictureMessages.empty);
  if (isHeic(bytes)) throw new Error(pictureMessages.heic);
  if (!isPng(bytes) && !isJpeg(bytes)) throw new Error(pictureMessages.otherFormat);
  checkSize(bytes);
  try {
    return greyOf(isPng(bytes) ? PNG.sync.read(bytes) : await readJpeg(bytes));
  } catch {
    // Replaces the error from the decoder, which is of no help to users and may have no message.
    throw new Error(pictureMessages.damagedOrIncomplete);
  }
}

async function readJpeg(bytes: Buffer): Promise<ImageData> {
  if (!isDecoding) await initDecoder(new WebAssembly.Module(decoder));
  // A decoder that has thrown an error is not used again.
  isDecoding = false;
  const picture = await decodeJpeg(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length) as ArrayBuffer);
  isDecoding = true;
  return picture;
}

/** Colour spaces of JPEG files, as MozJPEG numbers them. */
const greyscale = 1;
const yCbCr = 3;

/** @param path Path with the extension .png or .jpg. */
export async function writePicture(path: string, grey: Grey): Promise<void> {
  if (path.endsWith('.png')) return writePng(path, grey);
  if (!isEncoding) await initEncoder(new WebAssembly.Module(encoder));
  isEncoding = true;
  const { buffer, byteOffset, length } = grey.colours ?? rgbaOf([grey.data, grey.data, grey.data]);
  const picture = new ImageData(new Uint8ClampedArray(buffer as ArrayBuffer, byteOffset, length), grey.width, grey.height);
  const options = {
    quality: 88,
    color_space: grey.colours ? yCbCr : greyscale,
    progressive: false,
    optimize_coding: false,
    trellis_multipass: false,
  };
  writeWhole(path, Buffer.from(await encodeJpeg(picture, options)));
}

function writePng(path: string, { width, height, data, colours }: Grey): void {
  const png = new PNG({ width, height });
  const bytes = colours ?? data;
  png.data = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.length);
  const format = colours ? { inputColorType: 6, colorType: 2 } : { inputColorType: 0, colorType: 0 };
  writeWhole(path, PNG.sync.write(png, { ...format, deflateLevel: 1, filterType: 1 } as Parameters<typeof PNG.sync.write>[1]));
}

/** Writes a file under a temporary name first, so that it is complete as soon as it has its own name. */
function writeWhole(path: string, content: Buffer): void {
  const unfinished = `${path}.new`;
  try {
    writeFileSync(unfinished, content);
    renameSync(unfinished, path);
  } catch (fault) {
    rmSync(unfinished, { force: true });
    throw fault;
  }
}
