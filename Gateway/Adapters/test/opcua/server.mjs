// Runs a real OPC UA server (node-opcua) that moves a youBot. The true position of the robot is a function of the time of the control
// system, whose clock has an offset and a skew.
import { isDeepStrictEqual } from 'node:util';
import {
  AttributeIds, DataType, DataValue, EUInformation, MessageSecurityMode, MonitoredItem, nodeset, OPCUAServer, SecurityPolicy, setWarningLogger,
  StatusCodes, Subscription, Variant, VariantArrayType,
} from './library.mjs';
import { angle, arm, opening } from '../ads/youbot.mjs';
import { freePort } from '../freePort.mjs';
import { identity } from './identity.mjs';
import { OpenStore } from './openStore.mjs';

const URI = 'urn:nowpose:youbot';

/** Key and certificate of all servers of this process, because creating a key takes 0.1 s of processor time. */
let certificate = null;

// A PLC can sample at any rate, but node-opcua's default minimum interval is 50 ms.
MonitoredItem.minimumSamplingInterval = 1;
Subscription.minimumPublishingInterval = 1;

/** Clock of the control system: this machine's monotonic clock with an offset and a skew. */
export class ControlClock {
  #start = process.hrtime.bigint();
  #from = BigInt(Date.now()) * 1_000_000n;

  constructor({ offsetMs = 0, ppm = 0 } = {}) {
    this.#from += BigInt(Math.round(offsetMs * 1e6));
    this.ppm = ppm;
  }

  /** Time of the clock in nanoseconds since 1970. */
  get now() {
    const passed = Number(process.hrtime.bigint() - this.#start);
    return this.#from + BigInt(Math.round(passed * (1 + this.ppm * 1e-6)));
  }

  step(ms) {
    this.#from += BigInt(Math.round(ms * 1e6));
  }
}

/** Splits a time into a date of whole milliseconds and the remaining picoseconds, because the library takes them separately. */
const dated = ns => ({ date: new Date(Number(ns / 1_000_000n)), picoseconds: Number(ns % 1_000_000n / 100n) * 100_000 });

const halves = ns => [Number(BigInt.asUintN(64, ns) >> 32n), Number(ns & 0xffffffffn)];

/** Returns a DateTime with a resolution of 100 ns. */
function dateTime(ns) {
  const { date, picoseconds } = dated(ns);
  return Object.assign(date, { picoseconds });
}

const positions = t => [...arm.map((_, joint) => angle(joint, t)), opening(t), opening(t)];

/** Name, data type and value. The value is a function of the time of the motion and of the time of the control system. */
const VARIABLES = [
  ...arm.map((name, joint) => [name, DataType.Double, t => angle(joint, t)]),
  ['gripper_mm', DataType.Float, t => opening(t) * 1000],
  ['axis_1_deg', DataType.Double, t => angle(0, t) * 180 / Math.PI],
  ['encoder_2', DataType.Int64, t => halves(BigInt(Math.round(angle(1, t) * 1e6)))],
  ['positions', DataType.Double, t => Float64Array.from(positions(t)), VariantArrayType.Array],
  ['is_open', DataType.Boolean, t => opening(t) > 0.005],
  ['name', DataType.String, () => 'youBot'],
  ['not_a_number', DataType.Double, () => NaN],
  ['time_date', DataType.DateTime, (_, t) => dateTime(t)],
  ['time_ns', DataType.Int64, (_, t) => halves(t)],
  ['time_s', DataType.Double, (_, t) => Number(t) / 1e9],
  ['time_real', DataType.Float, (_, t) => Number(t) / 1e9],
];

/** Properties EngineeringUnits of variables. The second one has no code. */
const UNITS = { axis_1_deg: { unitId: 17476, displayName: '°' }, gripper_mm: { unitId: -1, displayName: 'mm' } };

export class YoubotServer {
  /** Number of received requests by their names. */
  asked = new Map();
  /** Number of read requests for the values of this server's variables. */
  valueReads = 0;
  /** Number of nodes in the largest read request. */
  largestRead = 0;
  /** Replaces a value before it is sent: receives the value that the server would send, and returns the value that it sends. */
  spoil = (name, sent) => sent;
  isStopped = false;
  /** Name of a response that becomes BadUserAccessDenied; null if there is none. */
  denied = null;
  /** Durations of the newest subscription: without a message, and without a request of the client. */
  subscription = null;
  /** Converts a time of the control system to the time of the motion, which does not advance while the robot is at rest. */
  motion = t => t;
  /** Whether an unchanged value keeps its time stamp. The server then sends no notification of it. */
  keepsStamps = false;
  #server = null;
  #frozen = new Map();
  #device = null;

  /**
   * @param security Security modes that the server offers: none, sign_and_encrypt.
   * @param users Names and passwords; null allows any client to read.
   * @param cycleUs Cycle time in µs; values change only at the start of a cycle.
   * @param clockStepUs Resolution of CurrentTime in µs.
   * @param nodesPerRead Maximum number of nodes in a read request.
   * @param itemsPerCall Maximum number of nodes in a request that creates or deletes monitored items.
   * @param pathsPerCall Maximum number of browse paths in a request that translates them.
   * @param canModify Whether the server modifies subscriptions.
   * @param minimumMs Minimum sampling and publishing interval in ms. On a Siemens S7-1500, 1000 ms is common.
   */
  constructor({
    port = 0, clock = new ControlClock(), security = ['none'], users = null, cycleUs = 10_000, clockStepUs = 0.1, own = null, trusted = null,
    nodesPerRead = 1000, itemsPerCall = 1000, pathsPerCall = 1000, canModify = true, minimumMs = 1,
  } = {}) {
    Object.assign(this, { nodesPerRead, itemsPerCall, pathsPerCall, canModify, minimumMs, port, clock, security, users, cycle: BigInt(cycleUs * 1000), clockStep: BigInt(clockStepUs * 1000), own, trusted });
  }

  get endpoint() { return `opc.tcp://127.0.0.1:${this.port}`; }

  /** Returns the true position of a joint at a given time of the control system. */
  static truth(joint, t) { return positions(t)[joint]; }

  async start() {
    setWarningLogger(() => {});
    this.port ||= await freePort();
    this.own ??= await (certificate ??= identity(URI));
    this.store = new OpenStore(this.trusted);
    this.#server = new OPCUAServer({
      port: this.port, hostname: '127.0.0.1', host: '127.0.0.1',
      nodeset_filename: [nodeset],
      serverInfo: { applicationUri: URI },
      serverCapabilities: {
        operationLimits: {
          maxNodesPerRead: this.nodesPerRead, maxMonitoredItemsPerCall: this.itemsPerCall, maxNodesPerTranslateBrowsePathsToNodeIds: this.pathsPerCall,
        },
      },
      securityModes: this.security.map(mode => mode === 'none' ? MessageSecurityMode.None : MessageSecurityMode.SignAndEncrypt),
      securityPolicies: [
        ...this.security.includes('none') ? [SecurityPolicy.None] : [],
        ...this.security.includes('sign_and_encrypt')
          ? [SecurityPolicy.Basic256Sha256, SecurityPolicy.Aes128_Sha256_RsaOaep, SecurityPolicy.Aes256_Sha256_RsaPss] : [],
      ],
      allowAnonymous: this.users === null,
      userManager: this.users && { isValidUser: (name, password) => this.users[name] === password },
      certificateFile: this.own.certificateFile, privateKeyFile: this.own.privateKeyFile,
      serverCertificateManager: this.store,
      userCertificateManager: new OpenStore(null),
    });
    this.#server.on('request', request => {
      const name = request.schema.name;
      this.asked.set(name, (this.asked.get(name) ?? 0) + 1);
      if (name === 'ReadRequest' && request.nodesToRead.some(({ nodeId: { namespace, value } }) => namespace === 1 && !value.endsWith?.('.EngineeringUnits'))) this.valueReads++;
      if (name === 'ReadRequest') this.largestRead = Math.max(this.largestRead, request.nodesToRead.length);
      const atLeast = ms => Math.max(ms, this.minimumMs);
      if (/^(Create|Modify)SubscriptionRequest$/.test(name)) request.requestedPublishingInterval = atLeast(request.requestedPublishingInterval);
      if (name === 'ModifySubscriptionRequest' && !this.canModify) request.subscriptionId = 0;
      if (name === 'CreateMonitoredItemsRequest')
        for (const { requestedParameters: asked } of request.itemsToCreate) asked.samplingInterval = atLeast(asked.samplingInterval);
    });
    this.#server.on('response', response => {
      if (response.schema.name === this.denied) response.responseHeader.serviceResult = StatusCodes.BadUserAccessDenied;
      if (!/^(Create|Modify)SubscriptionResponse$/.test(response.schema.name) || response.responseHeader.serviceResult.isNotGood()) return;
      const { revisedPublishingInterval: ms, revisedMaxKeepAliveCount: quiet, revisedLifetimeCount: all } = response;
      this.subscription = { keepAliveMs: ms * quiet, lifetimeMs: ms * all };
    });
    await this.#server.initialize();
    this.#build(this.#server.engine.addressSpace);
    await this.#server.start();
    return this;
  }

  /** Returns the namespace URIs, ordered by their indices. */
  namespaces() { return this.#server.engine.addressSpace.getNamespaceArray().map(namespace => namespace.namespaceUri); }

  /** Deletes the node of a variable, like a server with a new program. */
  remove(name) {
    this.#device.namespace.deleteNode(this.#device.namespace.addressSpace.findNode(`ns=1;s=${name}`));
    this.#frozen.delete(name);
  }

  /** Creates the node of a variable again with the same id. */
  restore(name) {
    this.#add(VARIABLES.find(([known]) => known === name));
  }

  /** Adds a namespace with a variable that has the values of the first joint, like a PLC whose program is loaded later. */
  addNamespace(uri, name) {
    const namespace = this.#device.namespace.addressSpace.registerNamespace(uri), [source, dataType, value] = VARIABLES[0];
    namespace.addVariable({
      organizedBy: this.#device, browseName: name, nodeId: `s=${name}`, dataType, minimumSamplingInterval: 1,
      value: { timestamped_get: () => this.#value(source, dataType, value, VariantArrayType.Scalar) },
    });
  }

  async stop() {
    await this.#server?.shutdown(0);
    this.#server = null;
  }

  #build(space) {
    const namespace = space.getOwnNamespace();
    this.#device = namespace.addObject({ organizedBy: space.rootFolder.objects, browseName: 'youBot' });
    VARIABLES.forEach(variable => this.#add(variable));
    // CurrentTime shows the control system's clock. Its read function is replaced, because the library cannot bind a part of ServerStatus.
    const currentTime = space.findNode('i=2258'), read = currentTime.readAttribute;
    currentTime.readAttribute = (context, attribute, ...rest) => attribute === AttributeIds.Value
      ? this.#value('CurrentTime', DataType.DateTime, (_, t) => dateTime(t), VariantArrayType.Scalar, this.clockStep)
      : read.call(currentTime, context, attribute, ...rest);
  }

  #add([name, dataType, value, arrayType = VariantArrayType.Scalar]) {
    const { namespace } = this.#device;
    const variable = namespace.addVariable({
      componentOf: this.#device, browseName: name, nodeId: `s=${name}`, dataType, valueRank: arrayType === VariantArrayType.Array ? 1 : -1,
      minimumSamplingInterval: 1,
      value: { timestamped_get: () => this.#value(name, dataType, value, arrayType) },
    });
    if (name in UNITS) this.#addUnits(variable, name);
  }

  /** Adds the property EngineeringUnits. Its read function is replaced, because the small set of nodes has no type for its value. */
  #addUnits(variable, name) {
    const property = this.#device.namespace.addVariable({
      propertyOf: variable, browseName: { name: 'EngineeringUnits', namespaceIndex: 0 }, nodeId: `s=${name}.EngineeringUnits`, dataType: 'BaseDataType',
    });
    const read = property.readAttribute, value = new Variant({ dataType: DataType.ExtensionObject, value: new EUInformation(UNITS[name]) });
    property.readAttribute = (context, attribute, ...rest) => attribute === AttributeIds.Value ? new DataValue({ value }) : read.call(property, context, attribute, ...rest);
  }

  #value(name, dataType, value, arrayType, cycle = this.cycle) {
    const now = this.clock.now, t = now - now % cycle;
    if (this.isStopped && this.#frozen.has(name)) return this.#frozen.get(name);
    const { date, picoseconds } = dated(t);
    const sent = {
      value: new Variant({ dataType, arrayType, value: value(this.motion(t), t) }), statusCode: StatusCodes.Good,
      sourceTimestamp: date, sourcePicoseconds: picoseconds, serverTimestamp: date, serverPicoseconds: picoseconds,
    };
    const result = new DataValue(this.spoil(name, sent)), last = this.#frozen.get(name);
    const isSame = last !== undefined && last.statusCode === result.statusCode && isDeepStrictEqual(last.value, result.value);
    if (this.keepsStamps && isSame) return last;
    this.#frozen.set(name, result);
    return result;
  }
}
