import type { AdapterContext } from '../adapter';
import { requireAddress } from '../configuration/address';
import { type CertificateAndKey, userCertificateIn } from '../configuration/certificateFiles';
import { type Configuration, isLoopback } from '../configuration/configuration';
import type { PlantFile } from '../configuration/plantFile';
import { requirePlain } from '../configuration/plain';
import { secretText } from '../configuration/secret';
import { type User, userIn } from '../configuration/user';
import type { YamlFile } from '../configuration/yamlFile';
import { brokerMessages } from '../messages/broker';
import { certificateFileMessages, configurationMessages } from '../messages/configuration';

/** The address of a broker and the login credentials, including the contents of the files that the configuration names. */
export interface BrokerAddress {
  endpoint: string;
  /** Whether the connection to another machine is neither encrypted nor authenticated. */
  isPlain: boolean;
  /** Certificate of the authority that issued the broker's certificate; null for the authorities that this machine trusts. */
  authority: string | null;
  user: User | null;
  /** Certificate of this client; null if it has none. */
  userCertificate: CertificateAndKey | null;
}

type BrokerSection = PlantFile<'mqtt' | 'broker'>['plant'];

/** Checks the address of a broker, and reads the files with the login credentials. */
export function brokerOf(file: YamlFile, section: BrokerSection, configuration: Configuration, environment: NodeJS.ProcessEnv): BrokerAddress {
  const { endpoint, plain, user, authority_file: authority } = section;
  const isOpen = endpoint.startsWith('mqtt:');
  requireAddress(file, ['plant', 'endpoint'], endpoint);
  requirePlain(file, section);
  if (user?.name !== undefined && isOpen && !isLoopback(endpoint)) file.report(['plant', 'user'], configurationMessages.passwordInClear('mqtts://'));
  if (user?.certificate !== undefined && isOpen) file.report(['plant', 'user', 'certificate'], certificateFileMessages.withoutTls);
  return {
    endpoint,
    isPlain: isOpen && plain === true,
    authority: authority === undefined ? null : secretText(file, ['plant', 'authority_file'], authority, false),
    user: userIn(file, user, configuration, environment),
    userCertificate: userCertificateIn(file, user),
  };
}

/** Adds the address to the diagnostics, and warns of a connection that is neither encrypted nor authenticated. */
export function reportAddress({ endpoint, isPlain }: BrokerAddress, { status, log }: Pick<AdapterContext, 'status' | 'log'>): void {
  status.detail('endpoint', endpoint);
  status.detail('security', endpoint.startsWith('mqtts:') ? 'tls' : 'none');
  if (isPlain) log.line(brokerMessages.notSecure);
}
