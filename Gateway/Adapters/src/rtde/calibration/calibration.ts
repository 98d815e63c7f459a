import type { AdapterContext } from '../../adapter';
import { pause } from '../../backoff';
import { description, ROBOT_DESCRIPTION, topicOf } from '../../gateway/messages';
import type { RtdeSettings } from '../kind';
import { readKinematics } from './primary';
import { calibrated } from './urdf';
import { calibrationMessages } from '../../messages/rtde';

const RETRY_MS = 10_000;

/** Publishes the robot description with the calibration of the controller, as soon as the calibration can be read. */
export async function publishCalibrated({ configuration, gateway, status, log, stopping }: AdapterContext, settings: RtdeSettings): Promise<void> {
  const { robot, robots } = configuration;
  const [namespace, nominal] = robot === null ? Object.entries(robots)[0] : ['', robot];
  const peer = { host: settings.host, port: settings.calibrationPort, service: calibrationMessages.service };
  while (!stopping.aborted) {
    try {
      const { urdf, difference } = calibrated(nominal, await readKinematics(peer, stopping));
      gateway.publishKept(topicOf(namespace, ROBOT_DESCRIPTION), description(urdf));
      status.detail('calibration', `${(1000 * difference).toFixed(1)} mm`);
      return log.line(calibrationMessages.used(1000 * difference));
    } catch (error) {
      if (stopping.aborted) return;
      status.detail('calibration', 'none');
      log.change('calibration', (error as Error).message, calibrationMessages.none((error as Error).message));
      await pause(RETRY_MS, stopping);
    }
  }
}
