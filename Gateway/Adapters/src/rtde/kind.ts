import type { Kind } from '../adapter';
import { readNames } from '../configuration/configuration';
import { placeOf } from '../sockets';
import { type Nanoseconds, ofMilliseconds } from '../times';
import { fieldsOf, type PositionSource, type RtdeAddress } from './recipe';
import { summaryMessages } from '../messages/gateway';
import { rtdeSettingMessages } from '../messages/rtde';

/** The included robot descriptions into which a calibration can be inserted. */
const ARMS = ['ur3e', 'ur5e', 'ur10e', 'ur16e', 'ur5'];

/** Maximum length of the names in a recipe, in bytes. */
const MAX_RECIPE = 2048;

/** The settings of the kind rtde. */
export interface RtdeSettings {
  host: string;
  port: number;
  rateHz: number;
  source: PositionSource;
  /** Maximum time from a package's timestamp until the controller sends the package; null for one control cycle of the controller's series. */
  sendDelay: Nanoseconds | null;
  /** Index of each configured joint in the controller's lists of six. */
  indices: number[];
  /** Whether to read the calibration from the controller's port `calibrationPort` and publish it in the robot description. */
  isCalibrated: boolean;
  calibrationPort: number;
  /** Addresses of the values of the frames, followed by those of the signals. */
  addresses: RtdeAddress[];
}

export const rtde: Kind<'rtde', RtdeSettings> = {
  address: ['field', 'index', 'bit'],
  silence: { fault_after_s: 1 },
  check(file, { plant, robot = '' }, { joints, values }) {
    const {
      host,
      port,
      rate_hz: rateHz,
      positions: source,
      calibration: isCalibrated,
      calibration_port: calibrationPort,
      send_delay_ms: delay,
    } = plant;
    const addresses = values.slice(joints.length).map(({ address }) => address as RtdeAddress);
    if (isCalibrated && !ARMS.includes(robot)) file.report(['robot'], rtdeSettingMessages.notCalibrated(robot, ARMS));
    const length = fieldsOf(source, addresses)
      .map(({ name }) => name)
      .join().length;
    if (length > MAX_RECIPE) file.report(['signals'], rtdeSettingMessages.recipeTooLong(length, MAX_RECIPE));
    // The place of a joint is its index only if its entry is valid.
    const isKnown = (i: number): boolean =>
      joints[i].index !== undefined || !(file.isInvalid(['joints', i]) || file.isInvalid(['joints', i, 'index']));
    const indices = joints.map(({ index }, i) => index ?? i);
    indices.forEach((index, i) => {
      const first = indices.findIndex((other, j) => other === index && isKnown(j));
      if (first < i && isKnown(i)) file.report(['joints', i, 'index'], rtdeSettingMessages.indexTwice(index, file.lineOf(['joints', first])));
    });
    return {
      host,
      port,
      rateHz,
      source,
      sendDelay: delay === undefined ? null : ofMilliseconds(delay),
      indices,
      isCalibrated,
      calibrationPort,
      addresses,
    };
  },
  summary(configuration) {
    const { rateHz, source } = configuration.settings;
    return rtdeSettingMessages.summary(placeOf(configuration.settings), source, rateHz, readNames(configuration, summaryMessages.onlyClock));
  },
};
