import { connect } from 'node:net';
import { addAbortSignal } from 'node:stream';
import { placeOf } from '../../sockets';
import { type Peer, unreachable } from '../connection';
import { calibrationMessages } from '../../messages/rtde';

/** Timeout for the connection and the kinematics, which the controller sends with its state several times per second. */
const TIMEOUT_MS = 5000;

/** Types of messages and packages from UR's guide to the primary client interface. */
const ROBOT_STATE = 16;
const KINEMATICS_INFO = 5;

/** Length of the header: int32 size of the whole message or package and uint8 type, big-endian. */
const HEADER = 5;
const MAX_SIZE = 65_536;

const JOINTS = 6;
const CHECKSUMS = 4 * JOINTS;

/** Denavit-Hartenberg parameters of a joint in m and rad, including the corrections from the arm's calibration. */
export interface DhJoint {
  theta: number;
  a: number;
  d: number;
  alpha: number;
}

/** Reads the kinematics from the controller's primary client interface. Sends nothing. */
export async function readKinematics(peer: Peer, stop: AbortSignal): Promise<DhJoint[]> {
  const socket = addAbortSignal(stop, connect({ host: peer.host, port: peer.port }));
  let isLate = false;
  const late = setTimeout(() => {
    isLate = true;
    socket.destroy();
  }, TIMEOUT_MS);
  let rest: Buffer | null = Buffer.alloc(0);
  try {
    for await (const bytes of socket as AsyncIterable<Buffer>) {
      const { parts, rest: incomplete } = partsOf(Buffer.concat([rest, bytes]));
      const packages = parts.filter(({ type }) => type === ROBOT_STATE).flatMap(({ payload }) => partsOf(payload).parts);
      const found = packages.find(({ type, payload }) => type === KINEMATICS_INFO && payload.length >= CHECKSUMS + 4 * 8 * JOINTS);
      if (found !== undefined) return dhOf(found.payload);
      rest = incomplete;
      if (rest === null) break;
    }
  } catch (error) {
    throw new Error(isLate ? calibrationMessages.late(placeOf(peer), TIMEOUT_MS / 1000) : unreachable(peer, error as Error));
  } finally {
    clearTimeout(late);
  }
  throw new Error(rest === null ? calibrationMessages.notPrimary(placeOf(peer)) : calibrationMessages.ended(placeOf(peer)));
}

interface Part {
  type: number;
  payload: Buffer;
}

/** Splits bytes into messages, or a message into packages. `rest` is the incomplete part at the end; null if the bytes are invalid. */
function partsOf(bytes: Buffer): { parts: Part[]; rest: Buffer | null } {
  const parts: Part[] = [];
  let from = 0;
  while (bytes.length - from >= HEADER) {
    const size = bytes.readUInt32BE(from);
    if (size < HEADER || size > MAX_SIZE) return { parts, rest: null };
    if (bytes.length - from < size) break;
    parts.push({ type: bytes[from + 4], payload: bytes.subarray(from + HEADER, from + size) });
    from += size;
  }
  return { parts, rest: bytes.subarray(from) };
}

/** Reads the kinematics: six checksums, then theta of the six joints, then a, d and alpha in the same way. */
function dhOf(payload: Buffer): DhJoint[] {
  const number = (list: number, joint: number): number => payload.readDoubleBE(CHECKSUMS + 8 * (JOINTS * list + joint));
  return Array.from({ length: JOINTS }, (_, i) => ({ theta: number(0, i), a: number(1, i), d: number(2, i), alpha: number(3, i) }));
}
