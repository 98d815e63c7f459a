import type { AdapterContext } from '../adapter';
import { publish } from './publish';
import { settingsOf } from './settings';
import { subscribe } from './subscribe';
import { brokerMessages } from '../messages/broker';

/** Transfers a plant's messages between a gateway and a broker, in one direction, until it is stopped. */
export async function run(context: AdapterContext): Promise<void> {
  const { configuration, status, log } = context;
  const settings = settingsOf(configuration);
  status.detail('endpoint', settings.endpoint);
  status.detail('security', settings.endpoint.startsWith('mqtts:') ? 'tls' : 'none');
  status.detail('direction', settings.direction);
  if (settings.isPlain) log.line(brokerMessages.notSecure);
  status.enter('connecting');
  await (settings.direction === 'publish' ? publish : subscribe)(context, settings);
}
