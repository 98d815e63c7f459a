import { connect, type Socket } from 'node:net';
import { isUnknownHost } from '../connectionErrors';
import { opened, placeOf } from '../sockets';
import { monotonicTime, type Nanoseconds } from '../times';
import { NotRtdeError, PackageReader, type RtdePackage } from './packages';
import { rtdeMessages } from '../messages/rtde';

const CONNECT_MS = 3000;

/** Error after which a later attempt to connect is unlikely to succeed, such as an unsupported protocol. */
export class RefusalError extends Error {}

export interface Peer {
  host: string;
  port: number;
  /** Name of the service in PolyScope; RTDE if absent. */
  service?: string;
}

/** A TCP connection to a controller that passes on complete packages with the time of their arrival. */
export class RtdeConnection {
  readonly #reader = new PackageReader();
  readonly #socket: Socket;
  #end: (reason: Error) => void = () => {};
  onPackage: (received: RtdePackage, arrived: Nanoseconds) => void = () => {};

  /** Resolves with the reason when the connection ends. */
  readonly ended = new Promise<Error>(resolve => {
    this.#end = resolve;
  });

  private constructor(
    readonly peer: Peer,
    socket: Socket,
  ) {
    this.#socket = socket;
    socket.setNoDelay(true);
    socket.on('data', bytes => this.#hear(bytes));
    // Uses one message for both events, because their order is not defined.
    socket.on('error', () => {}).on('close', () => this.#end(new Error(rtdeMessages.ended(placeOf(peer)))));
  }

  /**
   * Opens a connection.
   * @throws Error The controller does not respond. The message contains the remedy.
   */
  static async open(peer: Peer, stop: AbortSignal): Promise<RtdeConnection> {
    try {
      return new RtdeConnection(peer, await opened(connect({ host: peer.host, port: peer.port }), 'connect', CONNECT_MS, stop));
    } catch (error) {
      throw new Error(unreachable(peer, error as Error));
    }
  }

  /** Whether the newest package has been received only in part. */
  get hasHalfPackage(): boolean {
    return this.#reader.waiting > 0;
  }

  send(bytes: Buffer): void {
    this.#socket.write(bytes);
  }

  close(): void {
    this.#socket.destroy();
  }

  #hear(bytes: Buffer): void {
    const arrived = monotonicTime();
    try {
      for (const received of this.#reader.add(bytes)) this.onPackage(received, arrived);
    } catch (error) {
      this.#end(error instanceof NotRtdeError ? new RefusalError(rtdeMessages.notRtde(placeOf(this.peer))) : (error as Error));
      this.close();
    }
  }
}

const codeOf = (error: Error): string => (error as NodeJS.ErrnoException).code ?? error.message;

/** Gets the reason why a connection failed, with the remedy. */
export function unreachable(peer: Peer, error: Error): string {
  const code = codeOf(error);
  if (code === 'ECONNREFUSED') return rtdeMessages.refuses(placeOf(peer), peer.service ?? 'RTDE');
  if (isUnknownHost(code)) return rtdeMessages.unknownHost(peer.host);
  return rtdeMessages.noAnswer(placeOf(peer), code);
}
