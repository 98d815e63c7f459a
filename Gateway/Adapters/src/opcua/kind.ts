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
    if (publishingMs < samplingMs)
      file.report([...at, 'publishing_ms'], `value ${publishingMs}; allowed: a time from sampling_ms, ${samplingMs}, to 10000 ms`);
    const timestamp = section.timestamp ?? (section.time === undefined ? 'source' : 'variable');
    if (timestamp === 'variable' && section.time === undefined)
      file.report([...at, 'timestamp'], 'value "variable"; add time with the node of the time variable');
    if (timestamp !== 'variable' && section.time !== undefined)
      file.report([...at, 'time'], `timestamp is ${timestamp}; remove time, or set timestamp to variable`);
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
  obstacle: configuration => {
    const { folder } = settingsOf(configuration).security;
    try {
      tryFolder(folder);
      return null;
    } catch (error) {
      return `${configuration.where(['plant', 'security', 'folder'])}: ${folderTrouble(folder, error as Error)}`;
    }
  },
  summary: configuration => {
    const { endpoint, security, timestamp, time, samplingMs, publishingMs } = settingsOf(configuration);
    const guard = security.mode === 'none' ? 'NO SECURITY' : `SignAndEncrypt, ${security.policy}`;
    const stamp = timestamp === 'variable' ? `the variable ${time!.node}` : `the ${timestamp} time stamp`;
    return [
      `OPC UA ${endpoint}, ${guard}`,
      `t_k is ${stamp}, sampled every ${samplingMs} ms, published every ${publishingMs} ms`,
      readNames(configuration, 'only its clock'),
    ].join('; ');
  },
};

// The schema's pattern does not limit the size of numbers.
function requireNode(file: YamlFile, entry: Path, node: string): void {
  const [, namespace = 0, id = 0] = /^(?:ns=(\d+);|nsu=[^;]+;)?(?:i=(\d+)$)?/.exec(node)!;
  if (Number(namespace) > 65535) file.report(entry, `value ${shown(node)}; a namespace (ns) must be a number from 0 to 65535`);
  if (Number(id) > 4294967295) file.report(entry, `value ${shown(node)}; a numeric id (i) must be from 0 to 4294967295`);
}

function securityOf(file: YamlFile, { security = {} }: Section, environment: NodeJS.ProcessEnv): OpcUaSettings['security'] {
  const at = ['plant', 'security'] as const;
  const mode = security.mode ?? 'sign_and_encrypt';
  if (mode === 'none' && security.i_know_this_is_open !== true)
    file.report(
      [...at, 'mode'],
      'value "none"; anyone on the network could read the data and imitate the plant: ' + 'use sign_and_encrypt, or add i_know_this_is_open: true',
    );
  if (mode !== 'none' && security.i_know_this_is_open !== undefined)
    file.report([...at, 'i_know_this_is_open'], `security.mode is ${mode}, so the connection is not open; remove this entry`);
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
    file.report(['plant', 'user'], 'the password would be sent unencrypted; use sign_and_encrypt');
  return userIn(file, user, configuration, environment);
}

function userCertificateOf(file: YamlFile, { user }: Section): OpcUaSettings['userCertificate'] {
  if (user?.certificate === undefined && user?.key === undefined) return null;
  const at = ['plant', 'user'] as const;
  if (user.name !== undefined)
    file.report(
      [...at, 'certificate'],
      `the user ${shown(user.name)} has a password already; keep either name and password_file or certificate and key`,
    );
  for (const part of ['certificate', 'key'] as const)
    if (user[part] === undefined) file.report([...at, part], `missing; add the path of the user's ${part}, a PEM file`);
  const certificate = user.certificate && secretText(file, [...at, 'certificate'], user.certificate, false);
  const key = user.key && secretText(file, [...at, 'key'], user.key, true);
  if (!certificate || !key) return null;
  requirePair(file, at, { ...user, certificate, key });
  return { certificate, key };
}
