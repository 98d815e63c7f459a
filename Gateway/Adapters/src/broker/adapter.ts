import type { AdapterContext } from '../adapter';
import { reportAddress } from '../mqtt/address';
import { publish } from './publish';
import type { BrokerSettings } from './kind';
import { subscribe } from './subscribe';

/** Forwards a plant's messages in one direction between a gateway and a broker, until the adapter is stopped. */
export async function run(context: AdapterContext<BrokerSettings>): Promise<void> {
  const { configuration, status } = context;
  const { settings } = configuration;
  reportAddress(settings.broker, context);
  status.detail('direction', settings.direction);
  status.enter('connecting');
  await (settings.direction === 'publish' ? publish : subscribe)(context, settings);
}
