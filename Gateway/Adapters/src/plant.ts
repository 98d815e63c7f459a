import { OfferedClock } from './clock/offeredClock';
import type { CheckedConfiguration } from './configuration/configuration';
import { silenceMs } from './configuration/plantFile';
import { diagnosticsOf } from './gateway/diagnosticsOf';
import { GatewayLink } from './gateway/link';
import { description, DIAGNOSTICS, ROBOT_DESCRIPTION, topicOf, VERSION_TOPIC } from './gateway/messages';
import { AdapterStatus } from './gateway/status';
import { load } from './kinds';
import type { Log } from './log';
import { PlantOutput } from './samples/plantOutput';
import { type Nanoseconds, ofMilliseconds, toMilliseconds } from './times';
import { compareVersions } from './version';
import { clockMessages } from './messages/gateway';

const DIAGNOSTICS_MS = 1000;
const SILENCE_CHECK_MS = 250;

/** Delay of the report after a change, so that the report includes further changes that follow immediately. */
const CHANGE_MS = 100;

/** Maximum difference between the time stamps of one sample, for kinds of plant without the entry `group_ms`. */
const GROUP_MS = 0.5;

/** Runs one adapter until it is aborted. */
export async function runPlant(configuration: CheckedConfiguration, log: Log, ending: AbortController): Promise<void> {
  const { plant, robot, robots } = configuration;
  let changed: NodeJS.Timeout | null = null;
  const status = new AdapterStatus(plant.kind, log, () => {
    changed ??= setTimeout(report, CHANGE_MS);
  });
  const gateway = new GatewayLink(configuration.gateway, log, 'gateway', {
    malformed: (topic, problem) => status.refuse('malformed', topic, problem),
    refused: (reason, isMeasuring) => {
      if (!isMeasuring) status.refusedByGateway(reason);
    },
  });
  const { clock_resolution_us: resolutionUs, group_ms: groupMs = GROUP_MS, stamp_delay_ms: delayMs = 0 } = plant;
  const fixed = resolutionUs === undefined ? null : ofMilliseconds(resolutionUs / 1000);
  const clock = new OfferedClock(gateway, plant.name, fixed, undefined, coarse => reportCoarse(status, log, coarse));
  const options = {
    tolerance: ofMilliseconds(groupMs),
    oldest: ofMilliseconds(plant.oldest_ms),
    faultAfterMs: silenceMs(plant.silence),
    stampDelay: ofMilliseconds(delayMs),
  };
  const output = new PlantOutput(configuration, options, clock, gateway, status);
  if (delayMs !== 0) status.detail('stamp_delay_ms', delayMs);
  clock.stepped = () => output.clockStepped();
  gateway.watch(output.signals.sender);
  gateway.watch(output.repeater);
  gateway.subscribe(VERSION_TOPIC, ({ data }) => compareVersions(log, data));
  const run = await load(plant.kind);
  // The first message, because until then, the gateway names this connection by its address.
  report();
  for (const [namespace, urdf] of Object.entries({ ...robots, ...(robot === null ? {} : { '': robot }) }))
    gateway.publishKept(topicOf(namespace, ROBOT_DESCRIPTION), description(urdf));

  const link = gateway.run(ending.signal);
  const reports = setInterval(report, DIAGNOSTICS_MS);
  const checks = setInterval(() => output.check(), SILENCE_CHECK_MS);
  try {
    await run({ configuration, gateway, clock, output, status, log, stopping: ending.signal });
  } finally {
    clearInterval(reports);
    clearInterval(checks);
    clearTimeout(changed ?? undefined);
    ending.abort();
    await link;
  }

  // Publishes only the newest diagnostics, so that they take no place in the queue of a gateway that is disconnected or slow.
  function report(): void {
    clearTimeout(changed ?? undefined);
    changed = null;
    let isSent = false;
    gateway.publishNewest(DIAGNOSTICS, () => {
      if (isSent) return null;
      isSent = true;
      return diagnosticsOf(plant.name, status, gateway.dropped);
    });
  }
}

function reportCoarse(status: AdapterStatus, log: Log, coarse: Nanoseconds | null): void {
  const steps = coarse === null ? null : clockMessages.steps(toMilliseconds(coarse));
  status.detail('clock', steps);
  if (steps === null) return log.resume('clock steps', clockMessages.fineAgain);
  log.change('clock steps', 'coarse', clockMessages.coarse(steps));
}
