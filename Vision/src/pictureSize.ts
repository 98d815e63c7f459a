import { pictureMessages } from './messages';

/**
 * Maximum size of a picture. It allows for pictures from phone cameras. A decoded picture takes four bytes per pixel in each of several workers.
 */
const maxMegapixels = 110;

/** Throws an error if the size in the header of a PNG or JPEG file is too large, or if the file is truncated. */
export function checkSize(bytes: Buffer): void {
  const [width, height] = isPng(bytes) ? pngSize(bytes) : jpegSize(bytes);
  if (width * height > maxMegapixels * 1e6) throw new Error(pictureMessages.tooLarge(width, height, maxMegapixels));
}

export const isPng = (bytes: Buffer) => bytes.subarray(0, 4).equals(Buffer.from([0x89, 0x50, 0x4e, 0x47]));

export const isJpeg = (bytes: Buffer) => bytes[0] === 0xff && bytes[1] === 0xd8;

/** Returns whether a file has the container format of HEIC and AVIF pictures. The file type follows the length of the first box. */
export const isHeic = (bytes: Buffer) => bytes.subarray(4, 8).equals(Buffer.from('ftyp'));

function pngSize(bytes: Buffer): [number, number] {
  // The size follows the signature, the length and the name of the first chunk.
  if (bytes.length < 24) throw cutOff();
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
}

/** Returns the size in the frame header. Also requires the end-of-image marker, because decoders fill in missing data. */
function jpegSize(bytes: Buffer): [number, number] {
  const frame = segment(bytes, isFrame);
  const scan = segment(bytes, marker => marker === startOfScan);
  if (bytes.indexOf(endOfImage, scan) < 0) throw cutOff();
  return [bytes.readUInt16BE(frame + 7), bytes.readUInt16BE(frame + 5)];
}

/** Returns the start of the first segment of a kind. Skips from marker to marker, because segments can contain embedded pictures. */
function segment(bytes: Buffer, isWanted: (marker: number) => boolean): number {
  for (let at = 2; at + 9 <= bytes.length;) {
    const marker = bytes[at + 1];
    if (bytes[at] !== 0xff) throw new Error(pictureMessages.damaged);
    if (marker === 0xff) at++;
    else if (isWanted(marker)) return at;
    else at += 2 + bytes.readUInt16BE(at + 2);
  }
  throw cutOff();
}

/** Returns whether a marker starts a frame. C4, C8 and CC are in the range of frame markers but start no frame. */
const isFrame = (marker: number) => (marker >= 0xc0 && marker <= 0xcf && marker % 4 !== 0) || marker === 0xc0;

const startOfScan = 0xda;
const endOfImage = Buffer.from([0xff, 0xd9]);

const cutOff = () => new Error(pictureMessages.incomplete);
