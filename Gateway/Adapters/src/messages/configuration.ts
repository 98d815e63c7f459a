import { shown } from '../configuration/problem';

/** Formats an error message about a value: the value as written in the file, then the allowed values or the remedy. */
export const wrongValue = (value: unknown, remedy: string): string => `value ${shown(value)}; ${remedy}`;

/** Error messages about entries that exist for several kinds of plant. */
export const configurationMessages = {
  address: (value: unknown) => wrongValue(value, 'allowed: SCHEME://HOST:PORT with a port from 1 to 65535'),
  noKind: (allowed: string[]) => `missing; add a section plant with an entry kind; allowed kinds: ${allowed.join(', ')}`,
  misspelt: (meant: string) => `unknown entry; did you mean ${meant}?`,
  tooMany: (count: number, most: number) => `${count} entries; allowed: at most ${most}`,
  /** @param guess The entry that was probably meant; undefined if there is none. */
  unknownEntry: (guess: string | undefined, allowed: readonly string[]) => `unknown entry; ${question(guess)}allowed: ${allowed.join(', ')}`,
  notAllowed: (value: unknown, guess: string | undefined, allowed: readonly string[]) =>
    wrongValue(value, `${question(guess)}allowed: ${allowed.join(', ')}`),
  tokenInClear: (value: unknown) => wrongValue(value, "a token is sent only over wss:// or within this machine; use wss:// with the gateway's pin"),
  /** @param kind Kind of object that has the name, such as joint. */
  nameTwice: (value: unknown, line: number | undefined, kind: string) =>
    wrongValue(value, `line ${line} already has this ${kind}; list each ${kind} once`),
  /** @param label The joint or the number that is also read from this address. */
  addressTwice: (address: string, label: string, line: number) =>
    `${address} is also the address of ${label} (line ${line}); correct it, unless both are computed from this variable`,
  valueTwice: (value: unknown, kind: string) => `value ${shown(value)} occurs twice; list each ${kind} once`,
  offsetBeyondATurn: (value: number, radians: number) =>
    wrongValue(value, `an offset is in rad, and this is more than a full turn; for ${value}°, enter ${Number(radians.toPrecision(6))}`),
  publishingTooShort: (publishingMs: number, samplingMs: number) => wrongValue(publishingMs, `allowed: ${samplingMs} ms (sampling_ms) to 10000 ms`),
  noTimeVariable: (entry: string) => wrongValue('variable', `add the section time with the ${entry} of the time variable`),
  unusedTime: (timestamp: string) => `timestamp is ${timestamp}; remove time, or set timestamp to variable`,
  notPlain: (scheme: string) =>
    `missing; ${scheme}:// to another machine is neither encrypted nor authenticated: `
    + `use ${scheme}s://, or set plain: true if all machines on its network are trusted`,
  pinWithoutTls: 'not used with ws://; use wss://, or remove the pin',
  passwordInClear: (remedy: string) => `the password would be sent unencrypted; use ${remedy}`,
  /** @param shared The environment variable that several plants have in common. */
  noPassword: (variable: string, shared: string) =>
    `missing; add the path of a file that contains only the password, or set the environment variable ${variable}`
    + (variable === shared ? '' : `; ${shared} is used only with shared_password: true`),
  twoPasswords: 'password_file and shared_password are both set; remove one of the two',
};

/** Error messages about the configuration of frames. */
export const frameMessages = {
  world: (name: string) => wrongValue(name, 'this is the name of the anchored frame of the cell, which has no parent; choose another name'),
  severalRotations: (names: string[]) => `${names.join(' and ')} are set; keep one of them`,
  /** @param value The components x, y, z and w. */
  constantQuaternion: (value: number[], frame: string, norm: number, minNorm: number, maxNorm: number) =>
    wrongValue(
      value,
      `the quaternion x, y, z, w of frame ${frame} has the norm ${Number(norm.toPrecision(9))}; `
        + `allowed: ${minNorm} to ${maxNorm}; divide its components by the norm`,
    ),
  noAddress: (entry: string) => `missing; add the ${entry} of the variable that contains this number`,
  separateSelector: (entry: 'node' | 'topic') =>
    `the ${entry} of the parent is not the ${entry} of the pose, so their changes arrive separately, and a new parent is shown later; `
    + (entry === 'node' ? 'write the parent and the pose to one array' : 'send the parent and the pose in one message'),
  tooFar: (value: number, metres: number) => wrongValue(value, `this is ${metres} m; allowed: -1000000 to 1000000 m`),
  noLink: (value: unknown, namespace: string, guess: string | undefined) =>
    wrongValue(
      value,
      `the description of robot ${namespace} has no such link; ${guess === undefined ? 'enter a link of the description' : `did you mean ${guess}?`}`,
    ),
  otherParent: (value: unknown, guess: string | undefined) =>
    wrongValue(
      value,
      `this file has no frame or link with this name; ${question(guess)}the object is shown only if another source publishes the frame`,
    ),
  tooDeep: (value: unknown, depth: number, most: number) =>
    wrongValue(value, `the frame is ${depth} transforms below its root; allowed: at most ${most}; use a parent that is nearer to the root`),
  /** @param chain Names of the frames in the cycle: the frame, its parent, and so on, with the frame again at the end. */
  cycle: (value: unknown, chain: string[], world: string) =>
    wrongValue(
      value,
      `${chain.length === 2 ? 'a frame cannot be its own parent' : `the parents form a cycle: ${chain.join(', ')}`}; `
        + `enter ${world}, a link of a robot, or another frame`,
    ),
};

/** Error messages about the configuration of robots and about their descriptions. */
export const robotMessages = {
  tooLarge: (value: unknown, bytes: number, most: number) =>
    wrongValue(
      value,
      `the description is a JSON string of ${bytes} bytes; allowed: at most ${most}; `
        + 'remove comments and the elements that headsets do not use, such as <collision>',
    ),
  wrongUnit: (value: unknown, name: string, type: string, allowed: string[]) =>
    wrongValue(value, `joint ${name} is ${type} in the robot description; allowed: ${allowed.join(', ')}`),
  notUrdf: (value: unknown) => wrongValue(value, 'the file has no <robot> element; specify a URDF file'),
  notReadable: (value: unknown, code: string | undefined, included: string[]) =>
    wrongValue(value, `the file cannot be read (${code}); enter an existing URDF file or one of ${included.join(', ')}`),
  noRobot: (value: unknown, namespace: string, guess: string | undefined) =>
    wrongValue(value, `this file has no robot ${namespace}; ${question(guess)}add robots: { ${namespace}: ROBOT }, or correct the name of the joint`),
  noNamespace: (value: unknown, namespace: string, name: string) =>
    wrongValue(
      value,
      `the joint is published for the robot without a namespace; for a robot ${namespace}, set namespace: ${namespace} under plant and enter ${name}`,
    ),
  noJoint: (value: unknown, guess: string | undefined) =>
    wrongValue(
      value,
      `the robot description has no such joint; ${guess === undefined ? 'enter a joint of the description' : `did you mean ${guess}?`}`,
    ),
};

/** Error messages about the files that a configuration names, and about the configuration file itself. */
export const fileMessages = {
  notReadable: (value: unknown, code: string | undefined) => wrongValue(value, `the file cannot be read (${code}); enter an existing file`),
  notOneLine: (value: unknown, most: number) => wrongValue(value, `the file must contain exactly one line of 1 to ${most} characters`),
  readableByAll: (value: unknown, path: string) =>
    wrongValue(value, `every user of this machine has access to the file; remove this access: chmod o= ${path}`),
  configurationNotReadable: (code: string | undefined) => `cannot be read (${code}); enter an existing file`,
  circular: 'an alias (*) is inside the entry that it refers to; remove the alias',
  tab: 'the line is indented with a tab; YAML allows only spaces, so replace the tab with spaces',
  tag: (tag: string) => `the tag ${tag} is not allowed; enter the value without a tag`,
  keyTwice: 'this key occurs twice; remove one of the two entries',
  indent: (problem: string) => `${problem}; entries of the same level must start in the same column`,
  notYaml: (problem: string) => `not valid YAML: ${problem}`,
};

/** Error messages about the files of a certificate and its private key. */
export const certificateFileMessages = {
  noPart: (part: string) => `missing; add the path of the user's ${part}, a PEM file`,
  otherKey: 'the key does not belong to plant.user.certificate; enter a certificate and its key',
  /** @param formats Allowed formats, such as PEM. */
  noCertificate: (formats: string) => `the file contains no certificate; enter a certificate in ${formats} format (-----BEGIN CERTIFICATE-----)`,
  encryptedKey: 'the key is encrypted with a password, which cannot be entered at startup; use a file with an unencrypted key',
  noKey: 'the file contains no private key; enter a key in PEM format (-----BEGIN PRIVATE KEY-----)',
  withoutTls: 'not used with mqtt://, because only TLS uses a certificate; use mqtts://, or remove certificate and key',
};

const question = (guess: string | undefined): string => (guess === undefined ? '' : `did you mean ${guess}? `);
