import './quiet';
import { type UserIdentityInfo, UserTokenType } from 'node-opcua-client';
import type { AdapterContext } from '../adapter';
import { Backoff, pause } from '../backoff';
import { clockOf } from './clockReader';
import { byNumber, isByUri, NAMESPACES } from './nodeIds';
import type { NodeJoint } from './nodeValues';
import { NotificationReader } from './notificationReader';
import { ReadOnlySession } from './readOnlySession';
import { folderTrouble } from './security/folder';
import { ownCertificate, type OwnCertificate } from './security/ownCertificate';
import { thumbprints, TrustList } from './security/trustList';
import { type OpcUaSettings, settingsOf } from './settings';
import { Refused, refusalOf } from './troubles';
import { Watch } from './watch';

/** A server looks and sends a little later than it grants. */
const SLACK_MS = 100;

/** Reads an OPC UA server, and again after every end of the connection, until it is stopped. */
export async function run(context: AdapterContext): Promise<void> {
  const { status, log, stopping } = context, settings = settingsOf(context.configuration);
  status.detail('endpoint', settings.endpoint);
  status.detail('security', settings.security.mode === 'none' ? 'none' : `SignAndEncrypt ${settings.security.policy}`);
  const trust = new TrustList(settings.security), own = await certificateOf(context, settings, trust);
  if (own === null) return;
  if (settings.security.mode === 'none')
    log.line('WARNING: plant.security.mode is none: nobody checks who the server is, and everybody on the network can read and change what it says');
  else
    log.line(`own certificate ${own.file}, thumbprint ${thumbprints(own.getCertificate()).sha1}: the server must trust it`);

  const backoff = new Backoff(), reader = new NotificationReader(context, settings);
  while (!stopping.aborted) {
    status.enter('connecting');
    const wasConnected = await attempt(context, settings, own, trust, reader);
    context.clock.detach();
    if (wasConnected) {
      status.reconnected();
      backoff.reset();
    }
    await pause(backoff.next(), stopping);
  }
}

/** This application's certificate, as soon as its folder can be had; null when the adapter shall end before. */
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

/** One connection from its beginning to its end, whose reason goes to the status. Returns whether values came. */
async function attempt(
  context: AdapterContext, settings: OpcUaSettings, own: OwnCertificate, trust: TrustList, reader: NotificationReader,
): Promise<boolean> {
  const { status, stopping } = context, session = new ReadOnlySession(settings, own, trust);
  trust.refusal = null;
  const stop = (): void => void session.close();
  stopping.addEventListener('abort', stop);
  let isConnected = false;
  try {
    await session.open(identity(settings));
    const nodes = await idsOf(session, context, reader);
    const watch = new Watch();
    await context.clock.attach(await clockOf(session, settings, settings.time === null ? null : nodes.at(-1)!, context.log), stopping);
    reader.startAnew();
    let delayMs = Infinity;
    const monitoring = await session.monitor(nodes, values => reader.read(values), isQuiet => {
      watch.alive();
      const time = isQuiet ? watch.settledTime(delayMs) : null;
      if (time !== null) reader.hold(time);
    });
    reader.samplingMs = monitoring.samplingMs;
    delayMs = SLACK_MS + monitoring.samplingMs + monitoring.publishingMs;
    refuseUnknown(context, reader, monitoring.refusals);
    if (reader.nodes.length > 0) status.detail('sampling_ms', monitoring.samplingMs);
    status.detail('publishing_ms', monitoring.publishingMs);
    isConnected = true;
    status.enter('connected');
    const reason = await Promise.race([session.ended, watch.silence(context.clock, monitoring.keepAliveMs, session.ended)]);
    if (!stopping.aborted) status.enter('waiting', reason);
  } catch (error) {
    const trouble = refusalOf(error as Error, trust, settings, own);
    if (!stopping.aborted) status.enter(trouble.isRefusal ? 'refused' : 'waiting', trouble.text);
  } finally {
    stopping.removeEventListener('abort', stop);
    await session.close();
  }
  return isConnected;
}

/** The nodes by the numbers that their namespaces have at this server today. */
async function idsOf(session: ReadOnlySession, context: AdapterContext, { nodes }: NotificationReader): Promise<string[]> {
  if (!nodes.some(isByUri)) return nodes;
  const { value } = await session.read(NAMESPACES), namespaces = Array.isArray(value.value) ? value.value as string[] : [];
  const ids = nodes.map(node => byNumber(node, namespaces));
  const lost = nodes.filter((_, i) => ids[i] === undefined);
  const wrong = lost.map(node => `${whereIs(context, node)}: value ${node}; the server has no such namespace`);
  if (wrong.length > 0) throw new Refused(`${wrong.join('; ')}; it has ${namespaces.join(', ')}`);
  return ids as string[];
}

function whereIs({ configuration }: AdapterContext, node: string): string {
  const joint = (configuration.joints as NodeJoint[]).findIndex(j => j.node === node);
  return configuration.where(joint >= 0 ? ['joints', joint, 'node'] : ['plant', 'time', 'node']);
}

function refuseUnknown(context: AdapterContext, { nodes }: NotificationReader, refusals: (string | null)[]): void {
  const wrong = refusals.flatMap((refusal, i) =>
    refusal === null ? [] : [`${whereIs(context, nodes[i])}: value ${nodes[i]}; the server says ${refusal}`]);
  if (wrong.length > 0) throw new Refused(`${wrong.join('; ')}; take the id of the node from an OPC UA browser`);
}

function identity({ user, userCertificate }: OpcUaSettings): UserIdentityInfo {
  if (user !== null) return { type: UserTokenType.UserName, userName: user.name, password: user.password };
  if (userCertificate === null) return { type: UserTokenType.Anonymous };
  const der = Buffer.from(userCertificate.certificate.replace(/-----[^-]+-----|\s/g, ''), 'base64');
  return { type: UserTokenType.Certificate, certificateData: der, privateKey: userCertificate.key };
}
