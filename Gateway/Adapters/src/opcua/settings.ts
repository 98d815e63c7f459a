import type { Configuration } from '../configuration/configuration';
import type { User } from '../configuration/user';
import type { TimeUnit } from '../samples/timeUnit';

type TimestampKind = 'source' | 'server' | 'variable';

export interface SecuritySettings {
  mode: 'sign_and_encrypt' | 'none';
  policy: 'Basic256Sha256' | 'Aes128_Sha256_RsaOaep' | 'Aes256_Sha256_RsaPss';
  /** Path of the folder with the own, trusted and rejected certificates. */
  folder: string;
  thumbprint: string | null;
  serverCertificate: string | null;
}

/** The settings of the kind opcua, with defaults and the contents of files. */
export interface OpcUaSettings {
  endpoint: string;
  security: SecuritySettings;
  user: User | null;
  userCertificate: { certificate: string; key: string } | null;
  timestamp: TimestampKind;
  time: { node: string; unit: TimeUnit | null } | null;
  samplingMs: number;
  publishingMs: number;
}

/** Gets the settings that `check` has stored in the configuration. */
export const settingsOf = (configuration: Configuration): OpcUaSettings => configuration.plant.settings as OpcUaSettings;
