import { shown } from '../configuration/problem';

const S = 1000;
const MINUTE = 60 * S;
const HOUR = 60 * MINUTE;

/** The gateway states lengths with the same units. */
function lengthOf(ms: number): string {
  if (ms < S) return `${ms.toFixed(1)} ms`;
  if (ms < 10 * MINUTE) return `${(ms / S).toFixed(1)} s`;
  return ms < 2 * HOUR ? `${(ms / MINUTE).toFixed(1)} minutes` : `${(ms / HOUR).toFixed(1)} hours`;
}

const TOLERANCE = 2 * S;
const QUARTER = 15 * MINUTE;
const MAX_ZONE = 14 * HOUR;

/** TAI and GPS time minus UTC, since 2017. UTC has had no leap second since then. */
const TAI = 37 * S;
const GPS = 18 * S;

/**
 * The probable cause of a difference that is typical of another time scale; an empty string for other differences.
 * @param aheadMs Time stamp minus control time, ms.
 */
function otherScale(aheadMs: number): string {
  const isNear = (ms: number, typical: number): boolean => Math.abs(ms - typical) <= TOLERANCE;
  if (isNear(aheadMs, TAI)) return '; the source probably sends TAI instead of UTC';
  if (isNear(aheadMs, GPS)) return '; the source probably sends GPS time instead of UTC';
  // The offsets of time zones are multiples of 15 minutes.
  const ms = Math.abs(aheadMs);
  const quarters = Math.round(ms / QUARTER) * QUARTER;
  return quarters > 0 && quarters <= MAX_ZONE && isNear(ms, quarters) ? '; the source probably sends local time instead of UTC' : '';
}

/** Reasons why a value is refused. */
export const refusalMessages = {
  noStamp:
    'the value has no time stamp; let the source send the time of the value (header.stamp in ROS), or select another timestamp of OPC UA in the configuration',
  zeroStamp: 'the time stamp is 0; let the source set it to the time of the value (header.stamp in ROS)',
  before1970: 'the time stamp is before 1970; set the clock of the control system',
  sameStamp:
    "the time stamp is the same as that of the previous value; check that the control system's clock runs, and that the value has only one source",
  notNewer: (apartMs: number) =>
    `the time stamp is ${lengthOf(apartMs)} older than that of the previous value; check that the value has only one source, and that its clock was not set back`,
  ahead: (apartMs: number, maxMs: number) =>
    `the time stamp is ${lengthOf(apartMs)} ahead of the control clock; the maximum is ${lengthOf(maxMs)}${otherScale(apartMs)}`,
  behind: (apartMs: number, maxMs: number) =>
    `the time stamp is ${lengthOf(apartMs)} behind the control clock; the maximum is ${lengthOf(maxMs)}${otherScale(-apartMs)}`,
  /** @param day Date of the time stamp; null if it is beyond the range of dates. */
  farApart: (day: string | null) =>
    `the time stamp is ${day ?? 'beyond the year 275760'}, more than a day away from the control clock; check the unit of the time and the clock that stamps the value`,
  noField: (topic: string, field: string) => `the message on ${topic} has no field ${field}`,
  notNumber: (value: unknown) => `value ${shown(value)} is not a number; use a numeric variable`,
  noBits: (number: number) => `value ${number} has no bits; use a variable with a whole number, or remove bit`,
  noPosition: 'the source publishes no position for this joint; if the joint has none, list only the joints that are needed under joints',
  nameTwice: (name: string) => `the name ${name} occurs twice in one message; let the source send each joint once`,
  notPosition: (text: string) => `value ${text} is not a finite number`,
  scaledNotPosition: (number: number, scale: number) => `value ${number} multiplied by the scale ${scale} is not a finite number`,
  parent: (choice: number, last: number) => `the number ${choice} selects no parent; allowed: a whole number from 0 to ${last}`,
  tooFar: (axis: string, metres: number) => `the coordinate ${axis} is ${metres} m; allowed: -1000000 to 1000000 m`,
  quaternion: (length: number) => `the quaternion has the length ${length.toFixed(3)}; allowed: 0.99 to 1.01`,
};

/** Messages about the states of joints, frames and signals and the reasons for them. */
export const stateMessages = {
  noValueYet: 'no value has arrived since the start',
  disconnected: 'the plant is not connected',
  noValueAgain: (reason: string) => `no value has arrived since the plant became available again; before: ${reason}`,
  /**
   * @param knowledge The reason why the joint is assumed to be at rest.
   * @param uncertainty The reason why the joint may not be at rest; an empty string if there is none.
   */
  assumedAtRest: (knowledge: string, kind: string, uncertainty: string) =>
    `${knowledge}; the ${kind} is assumed to be at rest${uncertainty === '' ? '' : `; ${uncertainty}`}`,
  liveAgain: (name: string) => `${name} is live again`,
  restWithoutFault: (name: string) => `${name} is at rest and no longer has a fault`,
  notExpected: (name: string) => `${name} is no longer expected`,
  uncertainRest: (name: string, uncertainty: string) => `${name} may not be at rest: ${uncertainty}`,
  validAgain: (name: string) => `${name} is valid again`,
  tooMany: (kind: string, most: number) =>
    `more than ${most} ${kind} have been received, and further ones are not forwarded; remove those that are not needed at the source, then restart this adapter`,
  droppedByGateway: (reason: string) => `the gateway drops messages: ${reason}`,
};

// The gateway recognises this remedy by its beginning "set ".
const CURE = 'set silence: { fault_after_s: N } if the source sends its values repeatedly, even at rest';

/** Messages about a joint or frame without new values: the reason for its state, and the reason why it may not be at rest. */
export const silenceMessages = {
  confirmed: 'the source confirms the last value',
  noValue: 'no new value has arrived',
  /**
   * @param evidence Fact about the joint or frame without new values.
   * @param maxMs Time after which missing values are a fault, ms; null if they count as rest.
   */
  basis: (evidence: string, maxMs: number | null) =>
    `${evidence}; ${maxMs === null ? 'missing values count as rest' : `missing values are a fault after ${maxMs / 1000} s`}`,
  unconfirmed: `nothing confirms the last value, so rest cannot be distinguished from an end of the data; ${CURE}`,
  allUnconfirmed: `nothing arrives from the source, so rest cannot be distinguished from a failure of the source; ${CURE}`,
  tooLong: (maxMs: number) => `no new value for more than ${maxMs / 1000} s, which is a fault (silence in the plant's configuration)`,
  notConfirmed: (maxMs: number) => `no new value for more than ${maxMs / 1000} s, and the source does not confirm the last value`,
  ended: 'its data ended in mid-motion: the joint cannot have stopped at its last position',
  endedBecause: (reason: string) => `its data ended in mid-motion: ${reason}`,
  /** @param basis Origin of the limit. */
  stopTooHard: (required: number, limit: number, unit: string, basis: keyof typeof LIMITS) =>
    `a stop at the last position requires a deceleration of ${required.toFixed(1)} ${unit}, above the ${limit.toFixed(1)} ${unit} ${LIMITS[basis]}`,
  unobservedStop: (required: number, unit: string) =>
    `the stop itself was not observed; it would require a deceleration of ${required.toFixed(1)} ${unit}`,
  notWritten: "the server's source timestamps show that the value is no longer written, although it was written at rest before",
};

const LIMITS = {
  configured: 'of max_deceleration',
  observed: 'observed in the samples; if a harder stop is possible, set max_deceleration',
  assumed: 'assumed; if a harder stop is possible, set max_deceleration',
};
