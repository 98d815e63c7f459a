import { ADS, type AdsCommandToSend, type AdsResponse, type AmsTcpPacket, Client } from 'ads-client';
import type { AdsEndpoint } from './endpoint';
import { parseStream, type StampedSamples } from './stream';

const LARGEST_FRAME = 16 * 1024 * 1024;
const TIMEOUT_MS = 1500, CHECK_MS = 500, DOWN_MS = 1000;

const { ADS_COMMAND: COMMAND, ADS_RESERVED_INDEX_GROUPS: GROUP } = ADS;
const READING: number[] = [COMMAND.ReadDeviceInfo, COMMAND.Read, COMMAND.ReadState, COMMAND.AddNotification, COMMAND.DeleteNotification];

/** What ReadWrite may be for: a name goes out, what it means comes back. */
const LOOKING_UP: number[] = [GROUP.SymbolInfoByNameEx, GROUP.DataDataTypeInfoByNameEx];

/** Members that ads-client hides from TypeScript; its version is pinned, and a test notices if they go. */
interface Hidden {
  socket?: { destroyed: boolean; readableEnded: boolean; destroy(): void };
  receiveBuffer: Buffer;
  handleReceivedData(): void;
  parseAmsTcpPacket(data: Buffer): void;
  parseAdsNotification(data: Buffer): unknown;
}

/** An ADS client through which nothing can be written, that keeps the stamps as they were sent and survives frames that are none. */
export class ReadOnlyClient extends Client {
  /** Gets all that was notified, frame by frame. */
  onSamples: (samples: StampedSamples[]) => void = () => {};

  constructor(endpoint: AdsEndpoint, local: { netId: string; port: number } | null) {
    super({
      routerAddress: endpoint.host,
      routerTcpPort: endpoint.tcpPort,
      targetAmsNetId: endpoint.netId,
      targetAdsPort: endpoint.port,
      ...(local === null ? {} : { localAmsNetId: local.netId, localAdsPort: local.port }),
      autoReconnect: false,
      timeoutDelay: TIMEOUT_MS,
      connectionCheckInterval: CHECK_MS,
      connectionDownDelay: DOWN_MS,
      hideConsoleWarnings: true,
      // What comes before the answer to its subscription is not unknown, only early.
      deleteUnknownSubscriptions: false,
    });
    const hidden = this.#hidden, parsed = hidden.parseAdsNotification.bind(this), taken = hidden.parseAmsTcpPacket.bind(this);
    const received = hidden.handleReceivedData.bind(this);
    hidden.parseAdsNotification = data => {
      this.onSamples(parseStream(data));
      return parsed(data);
    };
    hidden.parseAmsTcpPacket = data => this.#unlessBroken(() => taken(data));
    hidden.handleReceivedData = () => this.#unlessBroken(() => {
      const { receiveBuffer } = hidden;
      if (receiveBuffer.length >= 6 && receiveBuffer.readUInt32LE(2) > LARGEST_FRAME) throw new RangeError('a frame of more than 16 MiB');
      received();
    });
  }

  /** Whether the other end has hung up. */
  get isHungUp(): boolean {
    const { socket } = this.#hidden;
    return socket === undefined || socket.destroyed || socket.readableEnded;
  }

  /** The one way out for every command of ads-client. */
  override async sendAdsCommand<T = AdsResponse>(command: AdsCommandToSend): Promise<AmsTcpPacket<T>> {
    const isReading = READING.includes(command.adsCommand)
      || command.adsCommand === COMMAND.ReadWrite && LOOKING_UP.includes(command.payload!.readUInt32LE(0));
    if (!isReading) throw new Error(`command ${command.adsCommand} would write to the control system; adapters only read`);
    return super.sendAdsCommand<T>(command);
  }

  get #hidden(): Hidden {
    return this as unknown as Hidden;
  }

  #unlessBroken(take: () => void): void {
    try {
      take();
    } catch {
      this.#hidden.socket?.destroy();
    }
  }
}
