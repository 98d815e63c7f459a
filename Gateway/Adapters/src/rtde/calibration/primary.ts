import { connect } from 'node:net';
import { at, type Peer, unreachable } from '../connection';
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
export function readKinematics(peer: Peer, stop: AbortSignal): Promise<DhJoint[]> {
  return new Promise((resolve, reject) => {
    const socket = connect({ host: peer.host, port: peer.port });
    let rest: Buffer = Buffer.alloc(0);
    const end = (error: Error): void => {
      clearTimeout(late);
      stop.removeEventListener('abort', stopped);
      socket.destroy();
      reject(error);
    };
    const late = setTimeout(() => end(new Error(calibrationMessages.late(at(peer), TIMEOUT_MS / 1000))), TIMEOUT_MS);
    const stopped = (): void => end(new Error('stopped'));
    stop.addEventListener('abort', stopped);
    socket.on('error', error => end(new Error(unreachable(peer, error))));
    socket.on('close', () => end(new Error(calibrationMessages.ended(at(peer)))));
    socket.on('data', bytes => {
      const { parts, rest: incomplete } = partsOf(Buffer.concat([rest, bytes]));
      const packages = parts.filter(({ type }) => type === ROBOT_STATE).flatMap(({ payload }) => partsOf(payload).parts);
      const found = packages.find(({ type, payload }) => type === KINEMATICS_INFO && payload.length >= CHECKSUMS + 4 * 8 * JOINTS);
      if (found !== undefined) {
        resolve(dhOf(found.payload));
        end(new Error('done'));
      } else if (incomplete === null) {
        end(new Error(calibrationMessages.notPrimary(at(peer))));
      } else {
        rest = incomplete;
      }
    });
  });
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
