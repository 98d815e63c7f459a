// node-opcua for tests, as the tested modules have it (parts.mjs).
import { join } from 'node:path';
import { adapters } from '../program.mjs';
import { libraryFile } from './libraryFile.mjs';

/** A small set of nodes, from which a server starts faster. */
export const nodeset = join(adapters, 'node_modules', 'node-opcua-address-space', 'nodesets', 'mini.Nodeset2.xml');

export const {
  AttributeIds, ClientSubscription, crypto_utils, DataType, DataValue, EUInformation, MessageSecurityMode, MonitoredItem, OPCUAClient, OPCUAServer, SecurityPolicy, setWarningLogger,
  StatusCodes, Subscription, Variant, VariantArrayType,
} = await import(await libraryFile());
