import type { ClockReading } from '../clock/offeredClock';
import type { Nanoseconds } from '../times';

/** Length of a frame in the clock sync protocol, in bytes. */
export const FRAME = 48;

const MAGIC = 0x434e5953;
const VERSION = 1;
const REQUEST = 1;
const REPLY = 2;
const TOKEN = 0x10;
const TOKEN_REPLY = 0x11;
const MAX_BOUND = 0xffff_ffff;

export interface Reply {
  sequence: number;
  t1: Nanoseconds;
  reading: ClockReading & { received: Nanoseconds; sent: Nanoseconds };
}

function frame(kind: number, sequence: number, t1: Nanoseconds): Buffer {
  const bytes = Buffer.alloc(FRAME);
  bytes.writeUInt32LE(MAGIC, 0);
  bytes.writeUInt8(VERSION, 4);
  bytes.writeUInt8(kind, 5);
  bytes.writeUInt32LE(sequence, 8);
  bytes.writeBigInt64LE(t1, 16);
  return bytes;
}

export const request = (sequence: number, t1: Nanoseconds): Buffer => frame(REQUEST, sequence, t1);

/** Creates the first frame for a server that requires a token, including the token. */
export function tokenRequest(token: string): Buffer {
  const text = Buffer.from(token, 'utf8');
  const length = Buffer.alloc(2);
  length.writeUInt16LE(text.length);
  return Buffer.concat([frame(TOKEN, 0, 0n), length, text]);
}

const isOfKind = (bytes: Buffer, kind: number): boolean =>
  bytes.readUInt32LE(0) === MAGIC && bytes.readUInt8(4) === VERSION && bytes.readUInt8(5) === kind;

/** Whether the server accepted the token; undefined if the frame is not the response to a token. */
export const isAccepted = (bytes: Buffer): boolean | undefined => (isOfKind(bytes, TOKEN_REPLY) ? (bytes.readUInt16LE(6) & 1) !== 0 : undefined);

/** Parses a reply to a time request; undefined if the frame is not such a reply. */
export function parseReply(bytes: Buffer): Reply | undefined {
  if (!isOfKind(bytes, REPLY)) return undefined;
  const bound = bytes.readUInt32LE(12);
  const flags = bytes.readUInt16LE(6);
  return {
    sequence: bytes.readUInt32LE(8),
    t1: bytes.readBigInt64LE(16),
    reading: {
      received: bytes.readBigInt64LE(24),
      sent: bytes.readBigInt64LE(32),
      // Zero means unknown. The resolution is then determined from the times.
      resolution: BigInt(bytes.readUInt32LE(40)) || undefined,
      errorBound: BigInt(bound) * 1000n,
      // The maximum value of the bound means that it is unknown, so the clock is not synchronised.
      synchronised: (flags & 1) === 0 && bound !== MAX_BOUND,
    },
  };
}
