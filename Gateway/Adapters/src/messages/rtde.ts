import { wrongValue } from './configuration';

/** Error messages about a configuration of kind rtde. */
export const rtdeSettingMessages = {
  notCalibrated: (value: unknown, arms: string[]) => wrongValue(value, `with calibration: true, the allowed robots are ${arms.join(', ')}`),
  recipeTooLong: (size: number, most: number) => `the list of fields has ${size} bytes; the maximum is ${most} bytes; remove signals`,
  summary: (place: string, source: string, rateHz: number, read: string) =>
    `RTDE ${place}, NO SECURITY; t_k is the controller's timestamp; ${source} positions at ${rateHz} Hz; ${read}`,
  indexTwice: (value: unknown, line: number) => wrongValue(value, `line ${line} already has this joint of the arm; use each index once`),
};

/** Messages about the connection to a controller. */
export const rtdeMessages = {
  notSecure: "RTDE is neither encrypted nor authenticated: anyone with access to this network can read the robot's data and impersonate the robot",
  ended: (place: string) => `${place} ended the connection`,
  refuses: (place: string, service: string) =>
    `${place} refuses the connection; start the robot's controller, and enable ${service} in PolyScope under Settings > Security > Services`,
  unknownHost: (host: string) =>
    `the host name ${host} is unknown; correct plant.host, or enter the robot's IP address, which PolyScope shows under Settings > Network`,
  noAnswer: (place: string, code: string) => `${place} does not respond (${code}); check plant.host, the robot's network and its firewalls`,
  notRtde: (place: string) => `${place} does not use RTDE; set host to the robot's address, and remove port unless RTDE is forwarded`,
  header: (size: number, type: number) => `the data have an invalid header with size ${size} and type ${type}`,
  noRtdeAnswer: (place: string) => `${place} accepts the connection but its response is not RTDE; check plant.host and plant.port`,
  oldProtocol: (place: string) => `${place} supports RTDE protocol version 1 only; version 2 is required, so update the controller's software`,
  noRecipe: (place: string) => `${place} does not respond to the request for the output recipe; if this happens again, restart the controller`,
  notStarted: (place: string) => `${place} does not start sending data; if this happens again, restart the controller`,
  damaged: (place: string) => `the data stream from ${place} is corrupt; the adapter reconnects. If this happens again, check the robot's network`,
  endedBeforeAnswer: (problem: string) => `${problem} before it responded; if other programs read this robot over RTDE, stop one of them`,
  endedWhileReading: (problem: string) =>
    `${problem}; check whether the controller was switched off or restarted. The adapter continues when the controller responds`,
  silent: (place: string, seconds: number) =>
    `nothing has arrived from ${place} for ${seconds} s; check the robot's network and whether its controller is running`,
  halfPackage: (place: string, seconds: number) =>
    `only part of a package has arrived from ${place} for ${seconds} s; check the robot's network and whether its controller is running`,
  invalidData: (place: string, problem: string) =>
    `${place} sends ${problem}; the adapter reconnects. If this happens again, update the controller's software`,
  restarted: (before: number, after: number) =>
    `the controller was restarted: its time went from ${before.toFixed(1)} s back to ${after.toFixed(1)} s; the adapter reconnects`,
  message: (text: string) => `message from the controller: ${text}`,
  lostPackages:
    "packages are missing from the controller's data stream (counted as refused/package-lost); "
    + 'lower rate_hz, or reduce the load on the controller and the network',
  slow: (rateHz: number) =>
    `the controller sends less than half of the ${rateHz} samples per second of rate_hz; reduce its load and that of the network, or lower rate_hz`,
  clockStepped: (stepMs: number) => `the controller's clock has stepped by ${stepMs.toFixed(1)} ms; the clock is measured again`,
  noData: 'the robot sends no data',
  clockNotMeasured: "the robot's clock is not measured yet",
};

/** Messages about the fields that a controller sends. */
export const fieldMessages = {
  recipe: (fields: number, types: number) =>
    `the controller returned ${types} types for the recipe of ${fields} fields; check that it is an RTDE server of protocol version 2`,
  missing: (names: string[]) => `the controller does not have the fields ${names.join(', ')}; update the controller's software`,
  readWithout: (problem: string) => `${problem}; the adapter reads the other fields`,
  needed: (field: string) => `the controller has no field ${field}; update the controller's software`,
  unknown: (field: string) => `the controller has no field ${field}; correct the field, or update the controller's software`,
  otherType: (field: string, type: string, needed: string) =>
    `the controller's field ${field} is ${type}, not ${needed} as in UR's guide; update this adapter or the controller`,
  notType: 'a type of RTDE',
  unknownType: 'of an unknown type',
  oneNumber: (field: string) => `${field} is a single number; remove index`,
  index: (field: string, count: number) => `${field} has ${count} numbers; set index to 0 to ${count - 1}`,
  noBits: (field: string) => `${field} has no bits; remove bit`,
  packageSize: (size: number, expected: number) => `a data package of ${size} bytes instead of ${expected}`,
  packageRecipe: (recipe: number, expected: number) => `a data package of recipe ${recipe} instead of ${expected}`,
  packageTime: (timestamp: number) => `a data package with the invalid timestamp ${timestamp} s`,
  bit: (field: string, count: number) => `${field} has ${count} bits; set bit to 0 to ${count - 1}`,
};

/** Messages about the state of a robot. */
export const robotStateMessages = {
  programStopped: (program: string) => `the state of the robot's program is ${program}; the positions are still sent`,
  programRuns: "the robot's program is running again",
  noPower: (mode: string) => `the arm has no power (robot mode ${mode}), so its joint angles are not measured; switch it on at the teach pendant`,
};

/** Safety modes in which a program cannot move the arm, with the remedy. In the other modes, the speed is normal or reduced. */
export const safetyStops: Record<number, string> = {
  3: 'protective stop; find its cause, and release it on the teach pendant',
  4: 'recovery mode; move the arm back within its safety limits with Freedrive or the Move tab of the teach pendant',
  5: 'safeguard stop; close the safeguard and continue on the teach pendant',
  6: 'system emergency stop; release the emergency stop of the cell',
  7: 'robot emergency stop; release the button on the teach pendant',
  8: 'safety violation; read the log on the teach pendant and restart the robot',
  9: 'safety fault; read the log on the teach pendant and restart the controller',
  12: 'automatic mode safeguard stop; close the safeguard and continue on the teach pendant',
  13: 'three-position enabling stop; hold the enabling device in its middle position',
};

/** Messages about the calibration of an arm. */
export const calibrationMessages = {
  used: (apartMm: number) =>
    `the controller's calibration is used; it moves the tool by up to ${apartMm.toFixed(1)} mm compared with the published kinematics`,
  none: (reason: string) => `no calibration: ${reason}; the published kinematics are used`,
  service: 'the primary client interface',
  late: (place: string, seconds: number) => `${place} did not send its kinematics within ${seconds} s`,
  ended: (place: string) => `${place} ended the connection before it sent its kinematics`,
  notPrimary: (place: string) => `${place} does not use UR's primary client interface`,
  otherRobot: (apartMm: number) =>
    `the tool is up to ${apartMm.toFixed(0)} mm away from the tool in the robot description, so this is another robot; correct the entry robot`,
};
