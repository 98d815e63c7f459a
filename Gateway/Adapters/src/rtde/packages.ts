import { rtdeMessages } from '../messages/rtde';

/**
 * Package types of RTDE: ASCII codes of the characters in UR's guide. The packages that write to the robot (I, and U from a client) are not
 * sent.
 */
export const TYPE = { protocolVersion: 86, controllerVersion: 118, textMessage: 77, data: 85, setUpOutputs: 79, start: 83, pause: 80 } as const;

/** The requests that the adapter sends. All of them are read-only. */
export type Request = 'protocolVersion' | 'controllerVersion' | 'setUpOutputs' | 'start';

const HEADER = 3;

const KNOWN = new Set<number>(Object.values(TYPE));

export interface RtdePackage {
  type: number;
  payload: Buffer;
}

/** The error for received data that are not RTDE. */
export class NotRtdeError extends Error {}

/** Creates a package: uint16 size of the whole package, uint8 type, payload; big-endian, as are all numbers in RTDE. */
function packageOf(request: Request, payload: Buffer = Buffer.alloc(0)): Buffer {
  const bytes = Buffer.alloc(HEADER + payload.length);
  bytes.writeUInt16BE(bytes.length, 0);
  bytes.writeUInt8(TYPE[request], 2);
  payload.copy(bytes, HEADER);
  return bytes;
}

export function protocolVersion(version: number): Buffer {
  const payload = Buffer.alloc(2);
  payload.writeUInt16BE(version);
  return packageOf('protocolVersion', payload);
}

export const controllerVersion = (): Buffer => packageOf('controllerVersion');

/** Creates the request for the output recipe. In protocol version 2, the frequency, a double in Hz, precedes the names. */
export function setUpOutputs(frequencyHz: number, names: string[]): Buffer {
  const frequency = Buffer.alloc(8);
  frequency.writeDoubleBE(frequencyHz);
  return packageOf('setUpOutputs', Buffer.concat([frequency, Buffer.from(names.join(','), 'ascii')]));
}

export const start = (): Buffer => packageOf('start');

/**
 * Gets the text in a message of protocol version 2 or 1; null if the payload is neither. A message of version 1 starts with its level and has no
 * source.
 */
export function textOf(payload: Buffer): string | null {
  const length = payload[0] ?? 0;
  const source = payload[1 + length] ?? 0;
  if (payload.length === length + source + 3) {
    const from = payload.toString('utf8', 2 + length, 2 + length + source);
    const text = payload.toString('utf8', 1, 1 + length);
    return from === '' ? text : `${from}: ${text}`;
  }
  return payload.length > 1 && payload[0] <= 3 ? payload.toString('utf8', 1) : null;
}

/** Splits a stream of bytes into packages. Stores at most one package of at most 64 KiB. */
export class PackageReader {
  #rest: Buffer = Buffer.alloc(0);

  /** Number of received bytes of the incomplete package. */
  get waiting(): number {
    return this.#rest.length;
  }

  /**
   * Adds received bytes and returns the packages that are now complete. Their payloads are valid until the next call.
   * @throws NotRtdeError A header is invalid. The packages before it are also lost, and the connection is unusable.
   */
  add(bytes: Buffer): RtdePackage[] {
    const all = this.#rest.length === 0 ? bytes : Buffer.concat([this.#rest, bytes]);
    const packages: RtdePackage[] = [];
    let at = 0;
    while (all.length - at >= HEADER) {
      const size = all.readUInt16BE(at);
      const type = all[at + 2];
      if (size < HEADER || !KNOWN.has(type)) throw new NotRtdeError(rtdeMessages.header(size, type));
      if (all.length - at < size) break;
      packages.push({ type, payload: all.subarray(at + HEADER, at + size) });
      at += size;
    }
    this.#rest = at === all.length ? Buffer.alloc(0) : Buffer.from(all.subarray(at));
    return packages;
  }
}
