import type { Kind } from '../adapter';
import { requireAddress } from '../configuration/address';
import { besides } from '../configuration/besides';
import { type CertificateAndKey, requireCertificate, userCertificateIn } from '../configuration/certificateFiles';
import { type Configuration, readNames } from '../configuration/configuration';
import type { PlantFile } from '../configuration/plantFile';
import { shown } from '../configuration/problem';
import { requireTiming } from '../configuration/timing';
import { type User, userIn } from '../configuration/user';
import type { Path, YamlFile } from '../configuration/yamlFile';
import type { TimeUnit } from '../samples/timeUnit';
import { folderTrouble, tryFolder } from './security/folder';
import { configurationMessages } from '../messages/configuration';
import { summaryMessages } from '../messages/gateway';
import { opcuaSettingMessages } from '../messages/opcua';

/** Default of `publishing_ms`, unless the sampling interval is longer. */
const PUBLISHING_MS = 20;

type Section = PlantFile<'opcua'>['plant'];

export interface SecuritySettings extends Pick<Section['security'], 'mode' | 'policy'> {
  /** Path of the folder with the own, trusted and rejected certificates. */
  folder: string;
  thumbprint: string | null;
  serverCertificate: string | null;
}

/** The settings of the kind opcua, including the contents of files. */
export interface OpcUaSettings {
  endpoint: string;
  security: SecuritySettings;
  user: User | null;
  userCertificate: CertificateAndKey | null;
  timestamp: NonNullable<Section['timestamp']>;
  time: { node: string; unit: TimeUnit | null } | null;
  samplingMs: number;
  publishingMs: number;
  groupMs: number;
}

export const opcua: Kind<'opcua', OpcUaSettings> = {
  address: ['node', 'index'],
  arrivesBy: 'node',
  check(file, { plant }, configuration, environment) {
    const { endpoint, time, sampling_ms: samplingMs, publishing_ms: publishingMs = Math.max(samplingMs, PUBLISHING_MS), group_ms: groupMs } = plant;
    const { timestamp = time === undefined ? 'source' : 'variable' } = plant;
    requireAddress(file, ['plant', 'endpoint'], endpoint);
    for (const { path, address } of configuration.values) if (address.node !== undefined) requireNode(file, [...path, 'node'], address.node);
    if (time !== undefined) requireNode(file, ['plant', 'time', 'node'], time.node);
    requireTiming(file, plant, publishingMs, 'node');
    return {
      endpoint,
      security: securityOf(file, plant, environment),
      user: userOf(file, plant, configuration, environment),
      userCertificate: userCertificateIn(file, plant.user),
      timestamp,
      time: time === undefined ? null : { unit: null, ...time },
      samplingMs,
      publishingMs,
      groupMs,
    };
  },
  checkMachine(file, { security: { folder } }) {
    try {
      tryFolder(folder);
    } catch (error) {
      file.report(['plant', 'security', 'folder'], folderTrouble(folder, error as Error));
    }
  },
  summary(configuration) {
    const { endpoint, security, timestamp, time, samplingMs, publishingMs } = configuration.settings;
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

function securityOf(file: YamlFile, { security }: Section, environment: NodeJS.ProcessEnv): SecuritySettings {
  const at = ['plant', 'security'] as const;
  const { mode, policy } = security;
  if (mode === 'none' && security.i_know_this_is_open !== true && !file.isInvalid([...at, 'i_know_this_is_open']))
    file.report([...at, 'mode'], opcuaSettingMessages.open);
  if (mode !== 'none' && security.i_know_this_is_open !== undefined && !file.isInvalid([...at, 'mode']))
    file.report([...at, 'i_know_this_is_open'], opcuaSettingMessages.notOpen(mode));
  const text = (name: 'folder' | 'server_certificate'): string | null => (security[name] === undefined ? null : besides(file.path, security[name]));
  if (security.server_certificate !== undefined) requireCertificate(file, [...at, 'server_certificate'], security.server_certificate);
  return {
    mode,
    policy,
    folder: text('folder') ?? (environment.STATE_DIRECTORY ? `${environment.STATE_DIRECTORY}/opcua` : besides(file.path, 'opcua-certificates')),
    thumbprint: security.thumbprint?.replace(/[:\s]/g, '').toLowerCase() ?? null,
    serverCertificate: text('server_certificate'),
  };
}

function userOf(file: YamlFile, { user, security }: Section, configuration: Configuration, environment: NodeJS.ProcessEnv): User | null {
  if (user?.name !== undefined && security.mode === 'none') file.report(['plant', 'user'], configurationMessages.passwordInClear('sign_and_encrypt'));
  if (user?.name !== undefined && (user.certificate ?? user.key) !== undefined)
    file.report(['plant', 'user', 'certificate'], opcuaSettingMessages.passwordAndCertificate(shown(user.name)));
  return userIn(file, user, configuration, environment);
}
