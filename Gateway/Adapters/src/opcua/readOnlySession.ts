import {
  AttributeIds, type ClientMonitoredItem, type ClientMonitoredItemGroup, type ClientSession, type ClientSubscription, DataChangeFilter,
  DataChangeTrigger, type DataValue, MessageSecurityMode, OPCUAClient, SecurityPolicy, TimestampsToReturn, type UserIdentityInfo,
} from 'node-opcua-client';
import type { OpcUaSettings } from './settings';
import { applicationUri, type OwnCertificate } from './security/ownCertificate';
import type { TrustList } from './security/trustList';

/** Nodes of one read request at first; halved where a server takes fewer. */
const NODES_PER_READ = 64;

const TIMEOUT_MS = 5000, CLOSING_MS = 1000, SESSION_MS = 30_000, KEEP_ALIVE_MS = 1000, LIFETIME_MS = 15_000;

/** All that is ever asked of a control system. Nothing here can write a variable or call a method. */
const ALLOWED = new Set([
  'OpenSecureChannelRequest', 'CloseSecureChannelRequest', 'GetEndpointsRequest', 'CreateSessionRequest', 'ActivateSessionRequest',
  'CloseSessionRequest', 'ReadRequest', 'CreateSubscriptionRequest', 'DeleteSubscriptionsRequest', 'CreateMonitoredItemsRequest',
  'DeleteMonitoredItemsRequest', 'PublishRequest',
]);

/** A value of the node at this place of the list that is monitored. */
export interface NodeValue {
  node: number;
  value: DataValue;
}

export interface Monitoring {
  /** For each node what the server said about monitoring it; null where it does. */
  refusals: (string | null)[];
  samplingMs: number;
  publishingMs: number;
  /** The server says something at least this often, even if it is only that it is there. */
  keepAliveMs: number;
}

/** Ends a request that is none of a reader's: thrown before it becomes a message, so that it never leaves. */
export function readsOnly(request: { schema: { name: string } }): void {
  if (!ALLOWED.has(request.schema.name)) throw new Error(`${request.schema.name} is nothing that a reader asks`);
}

/** A session with an OPC UA server that can read and listen. It ends once; for another connection make another. */
export class ReadOnlySession {
  /** Resolves with the reason when the connection has ended, whoever ended it. */
  readonly ended: Promise<string>;
  readonly #client: OPCUAClient;
  #session: ClientSession | null = null;
  #subscription: ClientSubscription | null = null;
  /** Monitored item of each node, and the node of each client handle. */
  #items: ClientMonitoredItem[] = [];
  #places = new Map<number, number>();
  #canTriggerByStamp = true;
  #nodesPerRead = NODES_PER_READ;
  #heard: (values: NodeValue[]) => void = () => {};
  /** Notifications that came before their monitored items are known; null while all are. */
  #early: unknown[] | null = [];
  #end: (reason: string) => void = () => {};
  #answeredAt: Date | null = null;

  constructor(readonly settings: OpcUaSettings, own: OwnCertificate, trust: TrustList) {
    this.ended = new Promise(resolve => { this.#end = resolve; });
    const isOpen = settings.security.mode === 'none';
    this.#client = OPCUAClient.create({
      applicationName: 'Nowpose',
      applicationUri: applicationUri(),
      clientName: 'Nowpose',
      securityMode: isOpen ? MessageSecurityMode.None : MessageSecurityMode.SignAndEncrypt,
      securityPolicy: isOpen ? SecurityPolicy.None : SecurityPolicy[settings.security.policy],
      // Servers tell the host name that they believe to have, which is seldom the one by which they are reached.
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
    this.#client.on('connection_lost', () => this.#end('the connection was lost'));
    this.#client.on('abort', () => this.#end('the server aborted the connection'));
    this.#client.on('close', error => this.#end(error ? error.message : 'the connection was closed'));
  }

  /** @throws Error The server is not there, not trusted, or does not take us. */
  async open(user: UserIdentityInfo): Promise<void> {
    await this.#client.connect(this.settings.endpoint);
    this.#session = await this.#client.createSession(user);
    this.#session.on('session_closed', () => this.#end('the server closed the session'));
  }

  /** When the server sent the newest answer to a read, by its own clock; null before the first. */
  get answeredAt(): Date | null { return this.#answeredAt; }

  async read(node: string): Promise<DataValue> {
    const session = this.#session;
    if (session === null) throw new Error('there is no session');
    return session.read({ nodeId: node, attributeId: AttributeIds.Value }, 0);
  }

  /** Reads the values of nodes. */
  async readAll(nodes: string[]): Promise<DataValue[]> {
    const session = this.#session;
    if (session === null) throw new Error('there is no session');
    const values: DataValue[] = [];
    while (values.length < nodes.length) {
      const part = nodes.slice(values.length, values.length + this.#nodesPerRead);
      try {
        values.push(...await session.read(part.map(nodeId => ({ nodeId, attributeId: AttributeIds.Value })), 0));
      } catch (error) {
        if (!String(error).includes('BadTooManyOperations') || part.length === 1) throw error;
        this.#nodesPerRead = Math.ceil(part.length / 2);
      }
    }
    return values;
  }

  /**
   * Replaces the monitored item of a node, which may be another node by now.
   * @returns Why the server does not monitor it; null when it does.
   */
  async monitorAgain(node: number, id: string): Promise<string | null> {
    const old = this.#items[node];
    this.#places.delete(old.monitoringParameters.clientHandle);
    if (old.statusCode.isGood()) await old.terminate().catch(() => {});
    this.#early ??= [];
    const group = await this.#group(this.#subscription!, [id], this.#canTriggerByStamp ? BY_STAMP() : null);
    this.#items[node] = group.monitoredItems[0] as ClientMonitoredItem;
    const { statusCode, monitoringParameters: { clientHandle } } = this.#items[node];
    this.#places.set(clientHandle, node);
    this.#takeEarly();
    return statusCode.isGood() ? null : statusCode.name;
  }

  /**
   * Listens to nodes.
   * @param heard What one notification brought, in the order of the server's queues: of each node oldest first.
   * @param alive The server said something at all; quiet, when it said that nothing has changed.
   */
  async monitor(nodes: string[], heard: (values: NodeValue[]) => void, alive: (isQuiet: boolean) => void): Promise<Monitoring> {
    const { samplingMs, publishingMs } = this.settings;
    const subscription = await this.#session!.createSubscription2({
      requestedPublishingInterval: publishingMs,
      requestedMaxKeepAliveCount: Math.max(1, Math.ceil(KEEP_ALIVE_MS / publishingMs)),
      requestedLifetimeCount: Math.max(3, Math.ceil(LIFETIME_MS / publishingMs)),
      maxNotificationsPerPublish: 0,
      publishingEnabled: true,
      priority: 100,
    });
    subscription.on('terminated', () => this.#end('the server ended the subscription'));
    subscription.on('status_changed', status => this.#end(`the server ended the subscription (${status.name})`));
    this.#heard = heard;
    subscription.on('raw_notification', message => {
      const data = message.notificationData ?? [];
      alive(data.length === 0);
      this.#take(data);
    });
    this.#subscription = subscription;
    const items = this.#items = await this.#monitored(subscription, nodes);
    this.#places = new Map(items.map((item, node) => [item.monitoringParameters.clientHandle, node]));
    this.#takeEarly();
    const sampling = items.filter(item => item.statusCode.isGood()).map(item => item.result!.revisedSamplingInterval ?? samplingMs);
    return {
      refusals: items.map(item => item.statusCode.isGood() ? null : item.statusCode.name),
      samplingMs: Math.max(...sampling, 0),
      publishingMs: subscription.publishingInterval,
      keepAliveMs: subscription.publishingInterval * subscription.maxKeepAliveCount,
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
    // A server that hangs, or a connection still being made, holds nobody up.
    await Promise.race([this.#closed(), new Promise(resolve => setTimeout(resolve, CLOSING_MS).unref())]);
  }

  async #closed(): Promise<void> {
    try {
      await this.#session?.close(true);
      await this.#client.disconnect();
    } catch {
      // A connection that is broken has nothing to be closed.
    }
  }

  // A robot that rests is reported too where the server goes by time stamps; not every server can.
  async #monitored(subscription: ClientSubscription, nodes: string[]): Promise<ClientMonitoredItem[]> {
    if (nodes.length === 0) return [];
    const byStamp = await this.#group(subscription, nodes, BY_STAMP());
    const items = byStamp.monitoredItems as ClientMonitoredItem[];
    if (!items.some(item => item.statusCode.name.includes('Filter'))) return items;
    await byStamp.terminate();
    this.#canTriggerByStamp = false;
    return (await this.#group(subscription, nodes, null)).monitoredItems as ClientMonitoredItem[];
  }

  #group(subscription: ClientSubscription, nodes: string[], filter: DataChangeFilter | null): Promise<ClientMonitoredItemGroup> {
    const { samplingMs } = this.settings;
    // What the server made of the interval: it may send more seldom than it was asked to.
    const queueSize = 2 + Math.ceil(4 * subscription.publishingInterval / samplingMs);
    return subscription.monitorItems(
      nodes.map(nodeId => ({ nodeId, attributeId: AttributeIds.Value })),
      { samplingInterval: samplingMs, queueSize, discardOldest: true, filter: filter ?? undefined },
      TimestampsToReturn.Both);
  }
}

const BY_STAMP = (): DataChangeFilter => new DataChangeFilter({ trigger: DataChangeTrigger.StatusValueTimestamp });

function valuesIn(data: unknown[], places: Map<number, number>): NodeValue[] {
  const items = data.flatMap(part => (part as { monitoredItems?: { clientHandle: number; value: DataValue }[] } | null)?.monitoredItems ?? []);
  return items.filter(item => places.has(item.clientHandle)).map(item => ({ node: places.get(item.clientHandle)!, value: item.value }));
}
