import type { Kind } from '../adapter';
import { requireAddress } from '../configuration/address';
import { besides } from '../configuration/besides';
import { type Configuration, readNames } from '../configuration/configuration';
import { shown } from '../configuration/problem';
import { secretText } from '../configuration/secret';
import { type User, userIn } from '../configuration/user';
import type { Path, YamlFile } from '../configuration/yamlFile';
import type { TimeUnit } from '../samples/timeUnit';
import { requireCertificate, requirePair } from './security/certificateFiles';
import { folderTrouble, tryFolder } from './security/folder';
import { type OpcUaSettings, settingsOf } from './settings';
import { configurationMessages } from '../messages/configuration';
import { summaryMessages } from '../messages/gateway';
import { opcuaSettingMessages } from '../messages/opcua';

const SAMPLING_MS = 10;
const PUBLISHING_MS = 20;

/** The plant section as specified in the schema. */
interface Section {
  endpoint: string;
  security?: {
    mode?: 'sign_and_encrypt' | 'none';
    i_know_this_is_open?: boolean;
    policy?: OpcUaSettings['security']['policy'];
    folder?: string;
    thumbprint?: string;
    server_certificate?: string;
  };
  user?: { name?: string; password_file?: string; certificate?: string; key?: string };
  timestamp?: OpcUaSettings['timestamp'];
  time?: { node: string; unit?: TimeUnit };
  sampling_ms?: number;
  publishing_ms?: number;
}

export const opcua: Kind = {
  check: (file, configuration, environment) => {
    const section = configuration.plant as unknown as Section;
    const at = ['plant'] as const;
    requireAddress(file, [...at, 'endpoint'], section.endpoint);
    for (const { path, address } of configuration.values) if (address.node !== undefined) requireNode(file, [...path, 'node'], address.node);
    if (section.time !== undefined) requireNode(file, [...at, 'time', 'node'], section.time.node);
    const samplingMs = section.sampling_ms ?? SAMPLING_MS;
    const publishingMs = section.publishing_ms ?? Math.max(samplingMs, PUBLISHING_MS);
    if (publishingMs < samplingMs && !file.isInvalid([...at, 'sampling_ms']))
      file.report([...at, 'publishing_ms'], configurationMessages.publishingTooShort(publishingMs, samplingMs));
    const timestamp = section.timestamp ?? (section.time === undefined ? 'source' : 'variable');
    if (timestamp === 'variable' && section.time === undefined && !file.isInvalid([...at, 'time']))
      file.report([...at, 'timestamp'], configurationMessages.noTimeVariable('node'));
    if (timestamp !== 'variable' && section.time !== undefined) file.report([...at, 'time'], configurationMessages.unusedTime(timestamp));
    const settings: OpcUaSettings = {
      endpoint: section.endpoint,
      security: securityOf(file, section, environment),
      user: userOf(file, section, configuration, environment),
      userCertificate: userCertificateOf(file, section),
      timestamp,
      time: section.time === undefined ? null : { node: section.time.node, unit: section.time.unit ?? null },
      samplingMs,
      publishingMs,
    };
    configuration.plant.settings = settings;
  },
  checkMachine: (file, configuration) => {
    const { folder } = settingsOf(configuration).security;
    try {
      tryFolder(folder);
    } catch (error) {
      file.report(['plant', 'security', 'folder'], folderTrouble(folder, error as Error));
    }
  },
  summary: configuration => {
    const { endpoint, security, timestamp, time, samplingMs, publishingMs } = settingsOf(configuration);
    const guard = security.mode === 'none' ? 'NO SECURITY' : `SignAndEncrypt, ${security.policy}`;
    const stamp = timestamp === 'variable' ? summaryMessages.timeVariable(time!.node) : `the ${timestamp} time stamp`;
    return [
      `OPC UA ${endpoint}, ${guard}`,
      summaryMessages.stamps(stamp, samplingMs, publishingMs),
      readNames(configuration, summaryMessages.onlyClock),
    ].join('; ');
  },
};

// Checks the numbers in a node id, whose size the pattern in the schema does not limit.
function requireNode(file: YamlFile, entry: Path, node: string): void {
  const [, namespace = 0, id = 0] = /^(?:ns=(\d+);|nsu=[^;]+;)?(?:i=(\d+)$)?/.exec(node)!;
  if (Number(namespace) > 65535) file.report(entry, opcuaSettingMessages.namespace(node));
  if (Number(id) > 4294967295) file.report(entry, opcuaSettingMessages.numericId(node));
}

function securityOf(file: YamlFile, { security = {} }: Section, environment: NodeJS.ProcessEnv): OpcUaSettings['security'] {
  const at = ['plant', 'security'] as const;
  const mode = security.mode ?? 'sign_and_encrypt';
  if (mode === 'none' && security.i_know_this_is_open !== true && !file.isInvalid([...at, 'i_know_this_is_open']))
    file.report([...at, 'mode'], opcuaSettingMessages.open);
  if (mode !== 'none' && security.i_know_this_is_open !== undefined && !file.isInvalid([...at, 'mode']))
    file.report([...at, 'i_know_this_is_open'], opcuaSettingMessages.notOpen(mode));
  const text = (name: 'folder' | 'server_certificate'): string | null => (security[name] === undefined ? null : besides(file.path, security[name]));
  if (security.server_certificate !== undefined) requireCertificate(file, [...at, 'server_certificate'], security.server_certificate);
  return {
    mode,
    policy: security.policy ?? 'Basic256Sha256',
    folder: text('folder') ?? (environment.STATE_DIRECTORY ? `${environment.STATE_DIRECTORY}/opcua` : besides(file.path, 'opcua-certificates')),
    thumbprint: security.thumbprint?.replace(/[:\s]/g, '').toLowerCase() ?? null,
    serverCertificate: text('server_certificate'),
  };
}

function userOf(file: YamlFile, { user, security }: Section, configuration: Configuration, environment: NodeJS.ProcessEnv): User | null {
  if (user?.name !== undefined && security?.mode === 'none')
    file.report(['plant', 'user'], configurationMessages.passwordInClear('sign_and_encrypt'));
  return userIn(file, user, configuration, environment);
}

function userCertificateOf(file: YamlFile, { user }: Section): OpcUaSettings['userCertificate'] {
  if (user?.certificate === undefined && user?.key === undefined) return null;
  const at = ['plant', 'user'] as const;
  if (user.name !== undefined) file.report([...at, 'certificate'], opcuaSettingMessages.passwordAndCertificate(shown(user.name)));
  for (const part of ['certificate', 'key'] as const) if (user[part] === undefined) file.report([...at, part], opcuaSettingMessages.noPart(part));
  const certificate = user.certificate && secretText(file, [...at, 'certificate'], user.certificate, false);
  const key = user.key && secretText(file, [...at, 'key'], user.key, true);
  if (!certificate || !key) return null;
  requirePair(file, at, { ...user, certificate, key });
  return { certificate, key };
}
