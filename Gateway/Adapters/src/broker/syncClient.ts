import { connect, type Socket } from 'node:net';
import { connect as connectSecurely, type TLSSocket } from 'node:tls';
import type { ClockReading } from '../clock/offeredClock';
import { pinProblem } from '../gateway/pin';
import { afterArrivals, opened, placeOf } from '../sockets';
import { monotonicTime, type Nanoseconds } from '../times';
import type { Upstream } from './kind';
import { FRAME, isAccepted, parseReply, type Reply, request, tokenRequest } from './syncFrame';
import { syncMessages } from '../messages/broker';

const ANSWER_MS = 2000;

/** Number of consecutive invalid exchanges after which the connection is closed. */
const MAX_INVALID = 10;

type SyncFault = 'sync-malformed' | 'sync-other-request' | 'sync-time-reversed' | 'sync-too-long';

/** Called for each invalid exchange. */
export type Invalid = (fault: SyncFault) => void;

/** A connection to the sync port of another gateway. Makes one exchange at a time. */
export class SyncClient {
  #received = Buffer.alloc(0);
  #waiting: ((frame: Buffer) => void) | null = null;
  #fail: ((error: Error) => void) | null = null;
  #sequence = 0;

  private constructor(
    readonly socket: Socket,
    readonly closed: Promise<string>,
    readonly invalid: Invalid,
  ) {
    socket.on('data', bytes => this.#hear(bytes));
    void closed.then(reason => this.#fail?.(new Error(reason)));
  }

  /**
   * Connects, and sends the token if there is one.
   * @throws Error The server is not reachable, has another key, or refuses the token. The message names the reason.
   */
  static async open(upstream: Upstream, invalid: Invalid): Promise<SyncClient> {
    const socket = await connected(upstream);
    socket.setNoDelay(true);
    let reason = syncMessages.closed(placeOf(upstream));
    socket.on('error', error => {
      reason = error.message;
    });
    const client = new SyncClient(socket, new Promise(resolve => socket.once('close', () => resolve(reason))), invalid);
    if (upstream.token === null) return client;
    if (isAccepted(await client.#ask(tokenRequest(upstream.token))) === true) return client;
    client.close();
    throw new Error(syncMessages.tokenRefused(placeOf(upstream)));
  }

  close(): void {
    this.socket.destroy();
  }

  /**
   * Makes exchanges until one is valid.
   * @throws Error No reply arrived within 2 s, a reply is malformed, or 10 exchanges are invalid, after which the connection is closed; or another
   * exchange is running.
   */
  async read(): Promise<ClockReading> {
    for (let i = 0; i < MAX_INVALID; i++) {
      const sequence = (this.#sequence = (this.#sequence + 1) >>> 0);
      const t1 = monotonicTime();
      const reply = parseReply(await this.#ask(request(sequence, t1)));
      const reason = reply === undefined ? 'sync-malformed' : faultOf(reply, sequence, t1, monotonicTime() - t1);
      if (reason === null) return reply!.reading;
      this.invalid(reason);
      if (reply === undefined) break;
    }
    this.close();
    throw new Error(syncMessages.invalidReply);
  }

  #ask(bytes: Buffer): Promise<Buffer> {
    if (this.socket.destroyed) return Promise.reject(new Error(syncMessages.connectionClosed));
    if (this.#waiting !== null) return Promise.reject(new Error(syncMessages.busy));
    return new Promise<Buffer>((resolve, reject) => {
      const cancel = afterArrivals(ANSWER_MS, () => {
        this.close();
        reject(new Error(syncMessages.noAnswer(ANSWER_MS / 1000)));
      });
      const end = (): void => {
        cancel();
        this.#waiting = this.#fail = null;
      };
      this.#waiting = frame => {
        end();
        resolve(frame);
      };
      this.#fail = error => {
        end();
        reject(error);
      };
      this.socket.write(bytes);
    });
  }

  // Closes the connection if the server sends data without a request, or more than one frame, because this violates the protocol.
  #hear(bytes: Buffer): void {
    this.#received = Buffer.concat([this.#received, bytes]);
    if (this.#waiting === null || this.#received.length > FRAME) return this.close();
    if (this.#received.length < FRAME) return;
    const frame = this.#received;
    this.#received = Buffer.alloc(0);
    this.#waiting(frame);
  }
}

function faultOf(reply: Reply, sequence: number, t1: Nanoseconds, took: Nanoseconds): SyncFault | null {
  const { received, sent, resolution = 0n } = reply.reading;
  if (reply.sequence !== sequence || reply.t1 !== t1) return 'sync-other-request';
  if (sent < received) return 'sync-time-reversed';
  return sent - received > took + resolution ? 'sync-too-long' : null;
}

async function connected(upstream: Upstream): Promise<Socket> {
  const { host, port, isTls, pin } = upstream;
  const socket = isTls ? connectSecurely({ host, port, minVersion: 'TLSv1.2', rejectUnauthorized: pin === null }) : connect(port, host);
  try {
    await opened(socket, isTls ? 'secureConnect' : 'connect', ANSWER_MS);
    const problem = pin === null ? null : pinProblem(socket as TLSSocket, pin);
    if (problem !== null) throw new Error(problem);
    return socket;
  } catch (error) {
    socket.destroy();
    throw new Error(syncMessages.notReachable(placeOf(upstream), (error as Error).message));
  }
}
