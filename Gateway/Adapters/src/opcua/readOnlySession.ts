import {
  AttributeIds,
  type ClientMonitoredItem,
  type ClientMonitoredItemGroup,
  type ClientSession,
  type ClientSubscription,
  DataChangeFilter,
  DataChangeTrigger,
  type DataValue,
  makeBrowsePath,
  MessageSecurityMode,
  OPCUAClient,
  SecurityPolicy,
  TimestampsToReturn,
  type UserIdentityInfo,
} from 'node-opcua-client';
import { RequestParts } from './requestParts';
import type { OpcUaSettings } from './kind';
import { applicationUri, type OwnCertificate } from './security/ownCertificate';
import type { TrustList } from './security/trustList';
import { subscribe } from './subscription';
import { opcuaMessages } from '../messages/opcua';

/** Initial maximum number of nodes per read request. */
const NODES_PER_READ = 64;

const TIMEOUT_MS = 5000;
const CLOSING_MS = 1000;
const SESSION_MS = 30_000;

/** All requests that the adapter may send to a server. None of them can write a variable or call a method. */
const ALLOWED = new Set([
  'OpenSecureChannelRequest',
  'CloseSecureChannelRequest',
  'GetEndpointsRequest',
  'CreateSessionRequest',
  'ActivateSessionRequest',
  'CloseSessionRequest',
  'ReadRequest',
  'TranslateBrowsePathsToNodeIdsRequest',
  'CreateSubscriptionRequest',
  'ModifySubscriptionRequest',
  'DeleteSubscriptionsRequest',
  'CreateMonitoredItemsRequest',
  'DeleteMonitoredItemsRequest',
  'PublishRequest',
]);

/** A value of a node. `node` is the index in the list of monitored nodes. */
export interface NodeValue {
  node: number;
  value: DataValue;
}

/** The monitored nodes, and the intervals that the server grants. */
export interface Monitoring {
  /** For each node, the reason why the server does not monitor it; null if it does. */
  refusals: (string | null)[];
  samplingMs: number;
  publishingMs: number;
  /** Maximum interval between messages of the server, including keep-alive messages. */
  keepAliveMs: number;
  /** Message that the server has not adapted the subscription to the granted interval; null if it has. */
  unmodified: string | null;
}

/** Throws for a request that is not read-only. Called before a request is encoded, so that such a request is never sent. */
export function readsOnly(request: { schema: { name: string } }): void {
  if (!ALLOWED.has(request.schema.name)) throw new Error(opcuaMessages.notAllowed(request.schema.name));
}

/** A read-only session with an OPC UA server. For a new connection, create a new session. */
export class ReadOnlySession {
  /** Resolves with the reason when either side has ended the connection. */
  readonly ended: Promise<string>;
  readonly #client: OPCUAClient;
  #session: ClientSession | null = null;
  #subscription: ClientSubscription | null = null;
  /** The monitored item of each node. `#places` maps client handles to nodes. */
  #items: ClientMonitoredItem[] = [];
  #places = new Map<number, number>();
  #canTriggerByStamp = true;
  readonly #reads = new RequestParts(NODES_PER_READ);
  /** At first all nodes in one request, because a server samples the items of a request at the same time. */
  readonly #monitorings = new RequestParts();
  #heard: (values: NodeValue[]) => void = () => {};
  /** Notifications that arrived before their monitored items were known; null when all items are known. */
  #early: unknown[] | null = [];
  #end: (reason: string) => void = () => {};
  #answeredAt: Date | null = null;

  constructor(
    readonly settings: OpcUaSettings,
    own: OwnCertificate,
    trust: TrustList,
  ) {
    this.ended = new Promise(resolve => {
      this.#end = resolve;
    });
    const isOpen = settings.security.mode === 'none';
    this.#client = OPCUAClient.create({
      applicationName: 'Nowpose',
      applicationUri: applicationUri(),
      clientName: 'Nowpose',
      securityMode: isOpen ? MessageSecurityMode.None : MessageSecurityMode.SignAndEncrypt,
      securityPolicy: isOpen ? SecurityPolicy.None : SecurityPolicy[settings.security.policy],
      // Accepts an endpoint with another host name, because servers often report a host name that differs from the one in the configuration.
      endpointMustExist: false,
      connectionStrategy: { maxRetry: 0 },
      requestedSessionTimeout: SESSION_MS,
      transportTimeout: TIMEOUT_MS,
      defaultTransactionTimeout: TIMEOUT_MS,
      clientCertificateManager: trust,
      certificateKeyPairProvider: own,
    });
    this.#client.on('send_request', request => readsOnly(request as unknown as { schema: { name: string } }));
    this.#client.on('receive_response', response => {
      if ((response as { schema: { name: string } }).schema.name === 'ReadResponse') this.#answeredAt = response.responseHeader.timestamp;
    });
    this.#client.on('connection_lost', () => this.#end(opcuaMessages.lost));
    this.#client.on('abort', () => this.#end(opcuaMessages.aborted));
    this.#client.on('close', error => this.#end(error ? error.message : opcuaMessages.closed));
  }

  /**
   * Connects and creates a session.
   * @throws Error The server is not reachable or not trusted, or it refuses this adapter.
   */
  async open(user: UserIdentityInfo): Promise<void> {
    await this.#client.connect(this.settings.endpoint);
    this.#session = await this.#client.createSession(user);
    this.#session.on('session_closed', () => this.#end(opcuaMessages.sessionClosed));
  }

  /** Time on the server's clock at which it sent its newest response to a read request; null before the first response. */
  get answeredAt(): Date | null {
    return this.#answeredAt;
  }

  /** @throws Error The session is not open. */
  get #open(): ClientSession {
    if (this.#session === null) throw new Error(opcuaMessages.notConnected);
    return this.#session;
  }

  async read(node: string): Promise<DataValue> {
    return this.#open.read({ nodeId: node, attributeId: AttributeIds.Value }, 0);
  }

  /** Reads the values of nodes. */
  async readAll(nodes: string[]): Promise<DataValue[]> {
    const session = this.#open;
    return this.#reads.each(nodes, part =>
      session.read(
        part.map(nodeId => ({ nodeId, attributeId: AttributeIds.Value })),
        0,
      ),
    );
  }

  /** Reads a property of nodes; null for a node that does not have it. */
  async properties(nodes: string[], name: string): Promise<(DataValue | null)[]> {
    const session = this.#open;
    // A server has separate limits for the two services.
    const found = await new RequestParts(NODES_PER_READ).each(nodes, part =>
      session.translateBrowsePath(part.map(node => makeBrowsePath(node, `.${name}`))),
    );
    const ids = found.map(({ targets }) => targets?.[0]?.targetId.toString() ?? null);
    const values = await this.readAll(ids.filter(id => id !== null));
    return ids.map(id => (id === null ? null : values.shift()!));
  }

  /**
   * Replaces the monitored item of a node, because the server may have created the node again.
   * @returns The reason why the server does not monitor the node; null if it does.
   */
  async monitorAgain(node: number, id: string): Promise<string | null> {
    const old = this.#items[node];
    this.#places.delete(old.monitoringParameters.clientHandle);
    if (old.statusCode.isGood()) await old.terminate().catch(() => {});
    this.#early ??= [];
    const [group] = await this.#groups(this.#subscription!, [id], this.#canTriggerByStamp ? BY_STAMP() : null);
    this.#items[node] = group.monitoredItems[0] as ClientMonitoredItem;
    const {
      statusCode,
      monitoringParameters: { clientHandle },
    } = this.#items[node];
    this.#places.set(clientHandle, node);
    this.#takeEarly();
    return statusCode.isGood() ? null : statusCode.name;
  }

  /**
   * Monitors nodes.
   * @param heard Receives the values of one notification. Several values of one node are sorted, the oldest first.
   * @param alive Called for each message of the server.
   */
  async monitor(nodes: string[], heard: (values: NodeValue[]) => void, alive: () => void): Promise<Monitoring> {
    const { samplingMs, publishingMs } = this.settings;
    const { subscription, unmodified } = await subscribe(this.#session!, publishingMs);
    subscription.on('terminated', () => this.#end(opcuaMessages.subscriptionEnded));
    subscription.on('status_changed', status => this.#end(opcuaMessages.subscriptionStatus(status.name)));
    this.#heard = heard;
    subscription.on('raw_notification', message => {
      alive();
      this.#take(message.notificationData ?? []);
    });
    this.#subscription = subscription;
    const items = (this.#items = await this.#monitored(subscription, nodes));
    this.#places = new Map(items.map((item, node) => [item.monitoringParameters.clientHandle, node]));
    this.#takeEarly();
    const sampling = items.filter(item => item.statusCode.isGood()).map(item => item.result!.revisedSamplingInterval ?? samplingMs);
    return {
      refusals: items.map(item => (item.statusCode.isGood() ? null : item.statusCode.name)),
      samplingMs: Math.max(...sampling, 0),
      publishingMs: subscription.publishingInterval,
      keepAliveMs: subscription.publishingInterval * subscription.maxKeepAliveCount,
      unmodified,
    };
  }

  #take(data: unknown[]): void {
    if (this.#early === null) this.#heard(valuesIn(data, this.#places));
    else this.#early.push(...data);
  }

  #takeEarly(): void {
    const early = this.#early ?? [];
    this.#early = null;
    if (early.length > 0) this.#take(early);
  }

  async close(): Promise<void> {
    this.#end('closed');
    // Limits the wait, because the server may not respond, or the connection may still be in progress.
    await Promise.race([this.#closed(), new Promise(resolve => setTimeout(resolve, CLOSING_MS).unref())]);
  }

  async #closed(): Promise<void> {
    try {
      await this.#session?.close(true);
      await this.#client.disconnect();
    } catch {
      // The connection is already broken.
    }
  }

  // Monitors the nodes with a filter on time stamps, so that the server also sends values at rest. Omits the filter if the server does not support
  // it.
  async #monitored(subscription: ClientSubscription, nodes: string[]): Promise<ClientMonitoredItem[]> {
    const byStamp = await this.#groups(subscription, nodes, BY_STAMP());
    if (!itemsOf(byStamp).some(item => item.statusCode.name.includes('Filter'))) return itemsOf(byStamp);
    for (const group of byStamp) await group.terminate();
    this.#canTriggerByStamp = false;
    return itemsOf(await this.#groups(subscription, nodes, null));
  }

  /** Creates the monitored items of nodes. Returns one group of items per request. */
  async #groups(subscription: ClientSubscription, nodes: string[], filter: DataChangeFilter | null): Promise<ClientMonitoredItemGroup[]> {
    const { samplingMs } = this.settings;
    // Uses the publishing interval granted by the server, which may be longer than the requested one.
    const queueSize = 2 + Math.ceil((4 * subscription.publishingInterval) / samplingMs);
    const groups: ClientMonitoredItemGroup[] = [];
    await this.#monitorings.each(nodes, async part => {
      const group = await subscription.monitorItems(
        part.map(nodeId => ({ nodeId, attributeId: AttributeIds.Value })),
        { samplingInterval: samplingMs, queueSize, discardOldest: true, filter: filter ?? undefined },
        TimestampsToReturn.Both,
      );
      groups.push(group);
      return group.monitoredItems;
    });
    return groups;
  }
}

const itemsOf = (groups: ClientMonitoredItemGroup[]): ClientMonitoredItem[] => groups.flatMap(group => group.monitoredItems as ClientMonitoredItem[]);

const BY_STAMP = (): DataChangeFilter => new DataChangeFilter({ trigger: DataChangeTrigger.StatusValueTimestamp });

function valuesIn(data: unknown[], places: Map<number, number>): NodeValue[] {
  const items = data.flatMap(part => (part as { monitoredItems?: { clientHandle: number; value: DataValue }[] } | null)?.monitoredItems ?? []);
  return items.filter(item => places.has(item.clientHandle)).map(item => ({ node: places.get(item.clientHandle)!, value: item.value }));
}
