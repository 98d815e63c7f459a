import { wrongValue } from './configuration';

const NET_ID = 'each part of an AMS Net Id must be a number from 0 to 255';

/** Error messages about a configuration of kind ads. */
export const adsSettingMessages = {
  endpoint: (value: unknown) => wrongValue(value, `${NET_ID}, and each port from 1 to 65535`),
  netId: (value: unknown) => wrongValue(value, NET_ID),
  notPlain: 'missing; ADS is neither encrypted nor authenticated: if all machines on its network are trusted, set plain: true',
  manyValues: (count: number) =>
    `${count} values are read, each with a notification of its own; Beckhoff recommends at most 550 notifications per PLC, including those of other `
    + 'clients: read fewer values, or read arrays over OPC UA',
  restWithoutOnChange: wrongValue(
    'rest',
    'without on_change: true, the PLC also sends values at rest, so missing values are always a fault; remove silence, or set on_change: true',
  ),
};

/** Messages about a PLC. */
export const adsMessages = {
  notSecure:
    "ADS is neither encrypted nor authenticated (plain: true): anyone with access to this network can read the PLC's data and impersonate the PLC",
  notRunning: (netId: string, state: string) => `TwinCAT at ${netId} is in ${state} mode; switch it to RUN mode so that the adapter can read`,
  stopped: (netId: string, state: string) =>
    `TwinCAT at ${netId} has changed to ${state} mode; switch it to RUN mode so that the adapter can read again`,
  noRouter: (host: string, port: number, code: string) =>
    `no response from ${host}:${port} (${code}); check that TwinCAT or its router is running there and that its firewall allows TCP port ${port}`,
  noRuntime: (port: number, netId: string) =>
    `${netId} has no PLC runtime at AMS port ${port}; check plant.endpoint: the first runtime of TwinCAT 3 has port 851, that of TwinCAT 2 port 801`,
  unknownNetId: (host: string, netId: string) =>
    `the AMS Net Id ${netId} is unknown to ${host}; check plant.endpoint, and check that ${host} has this AMS Net Id or a route to it`,
  /** @param localNetId AMS Net Id of this machine; null if the router at the host assigns an address. */
  noAnswer: (host: string, localNetId: string | null) =>
    `${host} accepts the connection but does not respond${
      localNetId === null
        ? ''
        : `; if it has never responded, add a route to this machine in TwinCAT: `
          + `SYSTEM > Routes > Add, AMS Net Id ${localNetId}, transport TCP_IP, address of this machine`
    }`,
  /** @param localNetId AMS Net Id of this machine; null if a router on this machine has the connection. */
  ended: (host: string, localNetId: string | null) =>
    `${host} has ended the connection${
      localNetId === null ? '' : '; if this happens again, end other ADS clients on this machine, because the PLC accepts one connection per machine'
    }`,
  noTimeOfCycle: (symbol: string) => `the time ${symbol} of the same cycle has not arrived`,
  newProgram: 'the PLC has a new program; its variables are looked up again',
  moved: (symbol: string) => `the size of ${symbol} has changed; the PLC's variables are looked up again`,
  notNotified: (symbol: string, reason: string) =>
    `the PLC refuses the notification of ${symbol}: ${reason}; it is requested again about every 10 s; if this happens only with some symbols, read fewer, or `
    + 'end other clients of this PLC, because its number of notifications is limited',
  notReadable: (symbol: string, reason: string) => `${symbol} cannot be read: ${reason}`,
  valuesStopped: "the PLC's program is not running, so its variables are not current",
  programState: (state: string) => `the PLC's program is in state ${state}; positions are sent again when it is running`,
  programStopped: "the PLC's program is not running; start it",
  clockNotReadable: (reason: string) => `the PLC's clock cannot be read: ${reason}`,
  noTime: (symbol: string) => `${symbol} does not contain a valid time; let the PLC's program write its time to this variable`,
  clockStopped: (symbol: string) => `the time in ${symbol} does not advance`,
  noNotification: (maxMs: number) => `the PLC did not send the first notification within ${maxMs} ms`,
  frameTooLarge: 'the PLC sent a frame larger than 16 MiB',
  sampleTooLarge: (size: number, most: number) => `a sample of ${size} bytes does not fit into its frame of ${most} bytes`,
  wouldWrite: (command: number) => `command ${command} would write to the control system; adapters only read`,
};

/** Reasons why a symbol is not usable. */
export const symbolMessages = {
  /** @param similar Symbols with similar names; empty if there are none; undefined if the PLC's symbol table is too long to be read. */
  unknown: (place: string, symbol: string, similar: string[] | undefined) =>
    `${place}: the PLC has no symbol ${symbol}${
      similar === undefined ? '' : similar.length === 0 ? '; look up the name in the PLC program' : `; similar symbols are ${similar.join(', ')}`
    }`,
  unusable: (place: string, symbol: string, type: string, reason: string) => `${place}: ${symbol} has the type ${type}; ${reason}`,
  array: (element: string) => `enter one element of the array, such as ${element}`,
  notNumber: 'a position must have a numeric type: LREAL, REAL or an integer type',
  notTime: 'a time must have a 64-bit type: LINT, ULINT, LREAL, LTIME or T_FILETIME',
};
