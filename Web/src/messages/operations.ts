/** Messages that the operations page shows in place of empty tables. */
export const emptyMessages = {
  adapters: 'No adapter is running: joint positions come from the gateway itself, or from other rosbridge clients.',
  joints: 'No joint is configured, and no joint positions have arrived.',
  sources: 'No joint positions are arriving.',
  clocks: 'No plant offers its clock: the gateway serves its own.',
  frames: 'No source publishes objects.',
  signals: 'No source publishes signals.',
  headsets: 'No headset is connected.',
  latencies: 'No headset has reported its latency yet.',
  events: 'No fault has occurred since the gateway was started.',
  recordings: 'There are no recordings in the folder.',
};

/** Text of the operations page. */
export const operationsMessages = {
  loggedOut: 'Log in to see the state of the gateway.',
  stateNotReported: 'Not known: the gateway does not report its state.',
  noState: 'Not known: the gateway sends no state to this page.',
  /** @param shownAt Time of the data that the page still shows; empty if it shows none. */
  noNewState: (reason: string, shownAt: string) => (shownAt === '' ? ended(reason) : `${ended(reason)} The data shown are from ${shownAt}.`),
  beyondLimits: (joints: string[]) =>
    `Outside the limits of the robot description: ${joints.join(', ')}. Headsets draw these joints at the limit. `
    + 'Check that the description belongs to this robot, and that the source sends rad and m, not degrees and mm.',
  noFolder: 'This gateway has no folder for recordings: start it with --recordings FOLDER.',
  recordAsOperator: "To start or stop the recorder, log in with an operator's token.",
  listAsOperator: "To see and download recordings, log in with an operator's token.",
  notListed: (reason: string) => `The recordings cannot be listed: ${ended(reason)}`,
};

/** Parts of the messages on the operations page. */
export const operationsLabels = {
  operations: 'Operations',
  host: (host: string) => `host ${host}`,
  gateway: (version: string) => `Nowpose gateway ${version}`,
  product: (version: string) => `Nowpose ${version}`,
  timesIn: (zone: string) => `times in ${zone}`,
  level: (level: string, text: string) => `${level}: ${text}`,
  since: (event: string, time: string) => `${event} – since ${time}`,
  /** @param headset The selected headset; null before the first headset has connected. */
  plots: (headset: string | null, isConnected: boolean) =>
    `Last two minutes${headset === null ? '' : `: ${headset}`}${headset === null || isConnected ? '' : ' (not connected)'}`,
  forwarding: (median: string, p99: string) => `${median}, P99 ${p99}`,
  nothingForwarded: 'nothing forwarded',
  downloadEvents: 'Download all events as',
  or: 'or',
  moreEvents: (count: number) => `and ${count} more, in the list of events`,
  profileMismatch: (reason: string) => `the latency profile does not match this headset: ${reason}`,
  errorWithheld: (reason: string) => `the headset withholds its pose errors, because its frames may be late: ${reason}`,
  missingJoints: (joints: string) => `missing joints: ${joints}`,
  object: (name: string, state: string) => `object ${name}: ${state}`,
  signal: (name: string, state: string) => `signal ${name}: ${state}`,
  objectsNotListed: (count: number) => `objects not current and not listed: ${count}`,
  signalsNotListed: (count: number) => `signals not current and not listed: ${count}`,
  lastFailure: (reason: string) => `last failure: ${reason}`,
  refusedValues: (reasons: string) => `refused values: ${reasons}`,
};

/** State and controls of the recorder. */
export const recorderLabels = {
  record: 'Record',
  stop: 'Stop recording',
  hasStarted: 'recording started',
  hasStopped: 'recording stopped',
  off: 'off',
  recording: (file: string, size: string) => `recording ${file}: ${size}`,
  stopped: (file: string, size: string) => `stopped; last ${file}: ${size}`,
  /** @param fileCount Number of files with these lines; 0 from an older gateway. */
  size: (lines: string, size: string, fileCount: number) => `${lines} lines, ${size}${fileCount > 1 ? ` in ${fileCount} files` : ''}`,
  lost: (lines: string) => `${lines} lines are missing`,
  problem: (state: string, reason: string) => `${state}. Problem: ${reason}`,
  fileDeleted: 'the file was deleted',
  /** Predicate of the gateway's event about a deleted recording. */
  wasDeleted: 'was deleted',
  deleted: (files: string) => `Deleted: ${files}`,
};

/** Definitions of the hops, which add up to the end-to-end latency. */
export const hopMeanings = {
  plant: 'from taking the sample to its arrival at the gateway',
  gateway: 'within the gateway',
  network: 'half of the round-trip time',
  queue: 'waiting in queues',
  render: 'duration of the render job',
  display: 'from the rendered frame until its light reaches the eye',
};

/** Descriptions of the plots for screen readers. */
export const livePlotDescriptions = {
  latency: 'Latencies of the selected headset over the last two minutes.',
  clock: 'Error bounds of the clocks over the last two minutes.',
  error: 'Tool error of the selected headset over the last two minutes, as measured by the headset.',
  rate: 'Joint position messages per second over the last two minutes, from the fastest and the slowest source.',
};

const ended = (text: string) => (/[.?!]$/.test(text) ? text : `${text}.`);
