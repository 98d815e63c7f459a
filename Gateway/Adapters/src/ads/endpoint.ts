/** Address of a PLC: host and TCP port of the machine that receives the frames, and AMS Net Id and port of the PLC. */
export interface AdsEndpoint {
  host: string;
  tcpPort: number;
  netId: string;
  port: number;
}

const ROUTER_TCP_PORT = 48898;

/** Matches ads://HOST[:TCP PORT]/AMS NET ID:AMS PORT. The pattern in the schema is the same. */
const FORM = /^ads:\/\/([^\s/@:]+)(?::(\d{1,5}))?\/((?:\d{1,3}\.){5}\d{1,3}):(\d{1,5})$/;

/** Parses an address; undefined if the string is invalid. */
export function parseEndpoint(text: string): AdsEndpoint | undefined {
  const match = FORM.exec(text);
  if (match === null) return undefined;
  const endpoint = { host: match[1], tcpPort: Number(match[2] ?? ROUTER_TCP_PORT), netId: match[3], port: Number(match[4]) };
  return isNetId(endpoint.netId) && isPort(endpoint.tcpPort) && isPort(endpoint.port) ? endpoint : undefined;
}

/** Gets the address of the router, without the default TCP port. Several PLCs behind one address have different TCP ports. */
export const routerOf = ({ host, tcpPort }: AdsEndpoint): string => host.toLowerCase() + (tcpPort === ROUTER_TCP_PORT ? '' : `:${tcpPort}`);

/** Whether the string consists of six numbers from 0 to 255. */
export const isNetId = (text: string): boolean => /^(\d{1,3}\.){5}\d{1,3}$/.test(text) && text.split('.').every(part => Number(part) <= 255);

const isPort = (port: number): boolean => port > 0 && port < 65536;
