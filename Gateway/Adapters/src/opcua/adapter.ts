import './libraryLog';
import { type UserIdentityInfo, UserTokenType } from 'node-opcua-client';
import type { AdapterContext } from '../adapter';
import { Backoff, pause, reconnecting } from '../backoff';
import { delayOf, silentAfterMs, STAMP_LAG_MS, unconfirmedAfterMs } from '../samples/silentValues';
import { type Nanoseconds, ofMilliseconds } from '../times';
import { clockOf } from './clockReader';
import { unitNotice } from './engineeringUnits';
import { byNumber, isByUri, NAMESPACES, NO_NODE } from './nodeIds';
import type { NodeMap } from './nodeMap';
import { reasonNotMonitored } from './nodeValues';
import { NotificationReader } from './notificationReader';
import { type Monitoring, ReadOnlySession } from './readOnlySession';
import { folderTrouble } from './security/folder';
import { ownCertificate, type OwnCertificate } from './security/ownCertificate';
import { thumbprints, TrustList } from './security/trustList';
import type { OpcUaSettings } from './kind';
import { SilentNodes } from './silentNodes';
import { Refused, refusalOf } from './troubles';
import { ServerSilence } from './serverSilence';
import { certificateMessages, nodeMessages, opcuaMessages } from '../messages/opcua';

/** Interval of sampling or publishing above which the positions of a moving robot are less accurate. With more than 100 ms, it is mostly held. */
const SLOW_MS = 50;

/** Reads an OPC UA server, and reconnects after failures, until the adapter is stopped. */
export async function run(context: AdapterContext<OpcUaSettings>): Promise<void> {
  const { status, log, stopping } = context;
  const { settings } = context.configuration;
  status.detail('endpoint', settings.endpoint);
  status.detail('security', settings.security.mode === 'none' ? 'none' : `SignAndEncrypt ${settings.security.policy}`);
  const trust = new TrustList(settings.security);
  const own = await certificateOf(context, settings, trust);
  if (own === null) return;
  if (settings.security.mode === 'none') log.line(opcuaMessages.notSecure);
  else log.line(certificateMessages.own(own.file, thumbprints(own.getCertificate()).sha1));

  const reader = new NotificationReader(context, settings);
  await reconnecting(
    stopping,
    () => attempt(context, settings, own, trust, reader),
    ({ wasConnected }) => {
      if (wasConnected) status.reconnected();
    },
    () => {},
    ({ isLoginRefused }) => isLoginRefused,
  );
}

/** Gets the certificate of this application. Waits until its folder is accessible; returns null if the adapter is stopped first. */
async function certificateOf({ status, stopping }: AdapterContext, { security }: OpcUaSettings, trust: TrustList): Promise<OwnCertificate | null> {
  const backoff = new Backoff();
  while (!stopping.aborted) {
    try {
      await trust.initialize();
      return await ownCertificate(security.folder);
    } catch (error) {
      status.enter('refused', folderTrouble(security.folder, error as Error));
      await pause(backoff.next(), stopping);
    }
  }
  return null;
}

/**
 * Uses one connection until it ends, and reports the reason why it ended in the status. Returns whether the connection was established, and whether the
 * server has refused user and password.
 */
async function attempt(
  context: AdapterContext,
  settings: OpcUaSettings,
  own: OwnCertificate,
  trust: TrustList,
  reader: NotificationReader,
): Promise<{ wasConnected: boolean; isLoginRefused: boolean }> {
  const { status, stopping } = context;
  const { map } = reader;
  const session = new ReadOnlySession(settings, own, trust);
  trust.refusal = null;
  status.enter('connecting');
  const stop = (): void => void session.close();
  stopping.addEventListener('abort', stop);
  let isLoggedIn = false;
  let wasConnected = false;
  let isLoginRefused = false;
  try {
    await session.open(identity(settings));
    isLoggedIn = true;
    const { ids: nodes, lost } = await idsOf(session, map);
    const serverSilence = new ServerSilence();
    const clock = await clockOf(session, settings, settings.time === null ? null : nodes.at(-1)!, context.log);
    await context.clock.attach(clock.read, stopping, clock.atOnce);
    reader.restart();
    const silent = new SilentNodes(
      session,
      reader,
      map.valueNodes.map((_, i) => nodes[i]),
      node => map.whereIs(node),
    );
    reader.stopOf = node => silent.stopOf(node);
    const monitoring = await Promise.race([
      session.monitor(
        nodes,
        values => {
          silent.heard(values);
          serverSilence.valued();
          reader.read(values);
        },
        () => serverSilence.alive(),
      ),
      session.ended.then(reason => Promise.reject(new Error(reason))),
    ]);
    if (monitoring.unmodified !== null) context.log.line(monitoring.unmodified);
    reader.samplingMs = monitoring.samplingMs;
    const delayMs = (silent.delayMs = delayOf(monitoring));
    silent.silentMs = silentAfterMs(monitoring);
    context.output.unconfirmedMs = unconfirmedAfterMs(delayMs);
    refuseUnknown(map, silent, monitoring.refusals, lost);
    if (map.nodes.length > 0) {
      status.detail('sampling_ms', monitoring.samplingMs);
      const hasPositions = context.configuration.values.some(({ path }) => path[0] !== 'signals');
      status.notice(hasPositions ? slownessOf(settings, monitoring) : null, 'server intervals');
    }
    status.detail('publishing_ms', monitoring.publishingMs);
    wasConnected = true;
    status.enter('connected');
    // Does not wait, because a server may not answer this request.
    const ids = new Map(map.valueNodes.map((node, i) => [node, nodes[i]]));
    void unitNotice(session, context.configuration.values, ids).then(
      text => status.notice(text, 'engineering units'),
      () => {},
    );
    const lag = ofMilliseconds(STAMP_LAG_MS + monitoring.samplingMs);
    const look = async (time: Nanoseconds | null): Promise<void> => {
      if (lost.size > 0 && String((await idsOf(session, map)).ids) !== String(nodes)) throw new Error(nodeMessages.otherNamespaces);
      const unchanged = await silent.read();
      if (time !== null) reader.holdNodes(time - lag, unchanged);
    };
    const detected = serverSilence.detect(context.clock, monitoring.keepAliveMs, session.ended, () => silent.hasSilent, look);
    const reason = await Promise.race([session.ended, detected]);
    if (!stopping.aborted) status.enter('waiting', reason);
  } catch (error) {
    const trouble = refusalOf(error as Error, trust, settings, own, isLoggedIn);
    isLoginRefused = trouble.isLoginRefused === true;
    if (!stopping.aborted) status.enter(trouble.isRefusal ? 'refused' : 'waiting', trouble.text);
  } finally {
    stopping.removeEventListener('abort', stop);
    await session.close();
    context.clock.detach();
  }
  return { wasConnected, isLoginRefused };
}

/** Gets the notice that the server samples or sends too rarely, although the configuration requests shorter intervals; null if it does not. */
function slownessOf({ samplingMs, publishingMs }: OpcUaSettings, granted: Monitoring): string | null {
  const isSlow = (requestedMs: number, grantedMs: number): boolean => grantedMs > Math.max(requestedMs, SLOW_MS);
  if (!isSlow(samplingMs, granted.samplingMs) && !isSlow(publishingMs, granted.publishingMs)) return null;
  return opcuaMessages.slow(granted.samplingMs, granted.publishingMs);
}

/**
 * Converts node ids with namespace URIs to the current namespace indices of the server. `lost` has the nodes whose namespace the server does not
 * have, with the reason, so that the other nodes can still be read.
 * @throws Refused The server has the namespace of none of the values, or not that of the time variable.
 */
async function idsOf(session: ReadOnlySession, map: NodeMap): Promise<{ ids: string[]; lost: Map<number, string> }> {
  const { nodes, valueNodes } = map;
  if (!nodes.some(isByUri)) return { ids: nodes, lost: new Map() };
  const { value } = await session.read(NAMESPACES);
  const namespaces = Array.isArray(value.value) ? (value.value as string[]) : [];
  const found = nodes.map(node => byNumber(node, namespaces));
  const lost = new Map<number, string>();
  for (const [i, id] of found.entries()) if (id === undefined) lost.set(i, nodeMessages.noNamespace(map.whereIs(i), nodes[i]));
  const inWords = (problems: string): string => nodeMessages.namespaces(problems, namespaces);
  if (lost.has(valueNodes.length) || (lost.size > 0 && lost.size >= valueNodes.length)) throw new Refused(inWords([...lost.values()].join('; ')));
  return { ids: found.map(id => id ?? NO_NODE), lost: new Map([...lost].map(([i, problem]) => [i, inWords(problem)])) };
}

/**
 * Reports the configured values whose nodes the server does not have, so that the other nodes can still be read.
 * @throws Refused The server does not have the time variable, or none of the values.
 */
function refuseUnknown(map: NodeMap, silent: SilentNodes, refusals: (string | null)[], lost: Map<number, string>): void {
  const { nodes, valueNodes } = map;
  const wrong = refusals.flatMap((refusal, node) => {
    if (refusal === null) return [];
    const text = lost.get(node) ?? nodeMessages.unknown(map.whereIs(node), nodes[node], refusal);
    return [{ node, reason: reasonNotMonitored(refusal), text }];
  });
  const problems = wrong.map(({ text }) => text).join('; ');
  const wrongValues = wrong.filter(({ node }) => node < valueNodes.length).length;
  if (wrongValues > 0 && wrongValues === valueNodes.length) throw new Refused(nodeMessages.noneReadable(problems));
  if (wrongValues < wrong.length) throw new Refused(problems);
  for (const { node, ...refusal } of wrong) silent.refused(node, refusal);
}

function identity({ user, userCertificate }: OpcUaSettings): UserIdentityInfo {
  if (user !== null) return { type: UserTokenType.UserName, userName: user.name, password: user.password };
  if (userCertificate === null) return { type: UserTokenType.Anonymous };
  const der = Buffer.from(userCertificate.certificate.replace(/-----[^-]+-----|\s/g, ''), 'base64');
  return { type: UserTokenType.Certificate, certificateData: der, privateKey: userCertificate.key };
}
