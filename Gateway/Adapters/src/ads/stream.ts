import { adsMessages } from '../messages/ads';

/** Values of variables that the PLC sampled at the same time. */
export interface StampedSamples {
  /** Time in units of 100 ns since 1601 UTC, as written by the PLC. */
  stamp: bigint;
  samples: { handle: number; data: Buffer }[];
}

/**
 * Parses the notifications in an ADS frame. Keeps the 100 ns resolution of the stamps, which ads-client reduces to 1 ms.
 * @throws RangeError The data are shorter than their length fields indicate.
 */
export function parseStream(data: Buffer): StampedSamples[] {
  const stamps: StampedSamples[] = [];
  let at = 8;
  for (let s = data.readUInt32LE(4); s > 0; s--) {
    const stamp = data.readBigUInt64LE(at);
    const samples: StampedSamples['samples'] = [];
    let count = data.readUInt32LE(at + 8);
    for (at += 12; count > 0; count--) {
      const handle = data.readUInt32LE(at);
      const length = data.readUInt32LE(at + 4);
      if (at + 8 + length > data.length) throw new RangeError(adsMessages.sampleTooLarge(length, data.length));
      samples.push({ handle, data: data.subarray(at + 8, at + 8 + length) });
      at += 8 + length;
    }
    stamps.push({ stamp, samples });
  }
  return stamps;
}
