import { ADS, type AdsCommandToSend, type AdsResponse, type AmsAddress, type AmsTcpPacket, Client } from 'ads-client';
import type { AdsEndpoint } from './endpoint';
import { isAdsError } from './reasons';
import { parseStream, type StampedSamples } from './stream';
import { adsMessages } from '../messages/ads';

const MAX_FRAME = 16 * 1024 * 1024;
const TIMEOUT_MS = 1500;
const CHECK_MS = 500;
const DOWN_MS = 1000;
const MAX_DELETIONS = 1024;

const { ADS_COMMAND: COMMAND, ADS_RESERVED_INDEX_GROUPS: GROUP } = ADS;
const READING: number[] = [COMMAND.ReadDeviceInfo, COMMAND.Read, COMMAND.ReadState, COMMAND.AddNotification, COMMAND.DeleteNotification];

/** Allowed index groups of ReadWrite, which write nothing: the request contains a name, and the response describes it. */
const LOOKING_UP: number[] = [GROUP.SymbolInfoByNameEx, GROUP.DataDataTypeInfoByNameEx];

/** Members of ads-client without a TypeScript declaration. The version of ads-client is pinned, and a test detects missing members. */
interface Hidden {
  socket?: { destroyed: boolean; readableEnded: boolean; destroy(): void };
  receiveBuffer: Buffer;
  handleReceivedData(): void;
  parseAmsTcpPacket(data: Buffer): void;
  parseAdsNotification(data: Buffer): unknown;
  onPlcSymbolVersionChanged(data: Buffer | { value: Buffer }): void;
  deleteNotificationHandle(handle: number, from: AmsAddress): Promise<unknown>;
}

/** An ADS client that cannot write to the PLC, keeps the full resolution of stamps, and closes the connection after an invalid frame. */
export class ReadOnlyClient extends Client {
  /** Receives the notifications of each frame. */
  onSamples: (samples: StampedSamples[]) => void = () => {};
  /** Number of subscriptions without a response. */
  #subscribing = 0;
  /**
   * Deletions of unknown handles, by address and handle, that have no response yet or that the PLC has refused, so that each further notification
   * does not request the same deletion.
   */
  readonly #deletions = new Map<string, Promise<unknown>>();

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
    });
    const hidden = this.#hidden;
    const parsed = hidden.parseAdsNotification.bind(this);
    const taken = hidden.parseAmsTcpPacket.bind(this);
    const received = hidden.handleReceivedData.bind(this);
    const deleted = hidden.deleteNotificationHandle.bind(this);
    hidden.deleteNotificationHandle = (handle, from) => {
      const address = `${from.amsNetId}:${from.adsPort}`;
      const key = `${address}/${handle}`;
      if (this.activeSubscriptions[address]?.[handle] !== undefined) return deleted(handle, from);
      const before = this.#deletions.get(key);
      if (before !== undefined) return before;
      if (this.#deletions.size >= MAX_DELETIONS) this.#deletions.clear();
      const deletion = deleted(handle, from).then(
        () => this.#deletions.delete(key),
        error => {
          if (!isAdsError(error)) this.#deletions.delete(key);
          throw error;
        },
      );
      this.#deletions.set(key, deletion);
      return deletion;
    };
    hidden.parseAdsNotification = data => {
      this.onSamples(parseStream(data));
      return parsed(data);
    };
    // ads-client would subscribe to the addresses of the old program again before it reports the new one. The PLC may use the freed handles in
    // another order, so that the values of one variable would arrive as those of another.
    hidden.onPlcSymbolVersionChanged = data => {
      const { plcSymbolVersion: before } = this.metaData;
      const version = (Buffer.isBuffer(data) ? data : data.value).readUInt8();
      this.metaData.plcSymbolVersion = version;
      if (before === undefined || before === version) return;
      this.onSamples = () => {};
      this.emit('plcSymbolVersionChange', version, before);
    };
    hidden.parseAmsTcpPacket = data => this.#unlessBroken(() => this.#isForOther(data) || taken(data));
    hidden.handleReceivedData = () =>
      this.#unlessBroken(() => {
        const { receiveBuffer } = hidden;
        if (receiveBuffer.length >= 6 && receiveBuffer.readUInt32LE(2) > MAX_FRAME) throw new RangeError(adsMessages.frameTooLarge);
        received();
      });
  }

  /** Whether the PLC has closed the connection. */
  get isHungUp(): boolean {
    const { socket } = this.#hidden;
    return socket === undefined || socket.destroyed || socket.readableEnded;
  }

  /** Whether a whole frame has arrived that ads-client has not taken yet. */
  get hasFrame(): boolean {
    const { receiveBuffer } = this.#hidden;
    return receiveBuffer.length >= 6 && receiveBuffer.length >= 6 + receiveBuffer.readUInt32LE(2);
  }

  /** Refuses commands that write. ads-client sends all its commands with this method. */
  override async sendAdsCommand<T = AdsResponse>(command: AdsCommandToSend): Promise<AmsTcpPacket<T>> {
    const isReading =
      READING.includes(command.adsCommand) || (command.adsCommand === COMMAND.ReadWrite && LOOKING_UP.includes(command.payload!.readUInt32LE(0)));
    if (!isReading) throw new Error(adsMessages.wouldWrite(command.adsCommand));
    if (command.adsCommand !== COMMAND.AddNotification) return super.sendAdsCommand<T>(command);
    // ads-client deletes a notification with an unknown handle: a PLC keeps the notifications of a lost connection, and sends them to the next one.
    // But the first notification of a subscription may arrive before the response that contains its handle.
    this.#subscribing++;
    this.settings.deleteUnknownSubscriptions = false;
    return super.sendAdsCommand<T>(command).finally(() => {
      this.settings.deleteUnknownSubscriptions = --this.#subscribing === 0;
    });
  }

  /** Disconnects. Without `force`, first deletes all notifications at once; ads-client deletes each one after the response to the previous one. */
  override async disconnect(force?: boolean): Promise<void> {
    const all = force ? [] : Object.values(this.activeSubscriptions).flatMap(ofAddress => Object.values(ofAddress));
    await Promise.allSettled(all.map(subscription => subscription.unsubscribe()));
    return super.disconnect(force);
  }

  // A PLC sends the frames for all clients of a machine over one connection. ads-client compares only the Net Id, and only after it has parsed the
  // frame, so a notification for another client would be used or deleted.
  #isForOther(frame: Buffer): boolean {
    if (frame.readUInt16LE(0) !== ADS.AMS_HEADER_FLAG.AMS_TCP_PORT_AMS_CMD) return false;
    const netId = ADS.byteArrayToAmsNetIdStr(frame.subarray(6, 12));
    const { localAmsNetId, localAdsPort } = this.connection;
    return (netId !== localAmsNetId && netId !== ADS.LOOPBACK_AMS_NET_ID) || frame.readUInt16LE(12) !== localAdsPort;
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
