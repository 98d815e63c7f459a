import type { AdapterContext } from '../adapter';
import { pause } from '../backoff';
import { monotonicTime, type Nanoseconds, ofMilliseconds } from '../times';
import { ofFraction } from '../samples/timeUnit';
import { afterArrivals, placeOf } from '../sockets';
import { RefusalError, RtdeConnection } from './connection';
import { controllerVersion, protocolVersion, type RtdePackage, setUpOutputs, start, textOf, TYPE } from './packages';
import { CycleOutput } from './cycleOutput';
import { Following } from './following';
import { Pace } from './pace';
import { type Cycle, type Field, Recipe } from './recipe';
import { ControllerClock } from './controllerClock';
import { isProgramRunning, Power, programOf, safetyStopOf } from './robotState';
import type { RtdeSettings } from './kind';
import { robotStateMessages, rtdeMessages } from '../messages/rtde';

const VERSION = 2;
const ANSWER_MS = 2000;
const VERSION_ANSWER_MS = 1000;

/** Maximum time without data. The connection is then closed and opened again. */
const SILENT_MS = 2000;
const CHECK_MS = 250;

/** Interval between the requests whose responses bound the controller's clock from above. */
const ASK_MS = 50;

/** Minimum backward step of the timestamp that indicates a controller restart. */
const RESTART_S = 0.5;

/** First major version of e-Series controllers. A controller that does not return its version counts as e-Series. */
const E_SERIES = 5;
const E_SERIES_HZ = 500;
const CB3_HZ = 125;

/** One connection to a controller, from its first package to its end. */
export class RtdeSession {
  #connection!: RtdeConnection;
  #recipe!: Recipe;
  #output!: CycleOutput;
  /** Payload of the response with the controller's version; null if the controller did not respond. */
  #controller: Buffer | null = null;
  #clock!: ControllerClock;
  #awaited: { type: number; take: (payload: Buffer, arrived: Nanoseconds) => void } | null = null;
  /** Time of the request whose response arrived last; null if a data package has arrived since then, or if no response has arrived. */
  #answered: Nanoseconds | null = null;
  /** The shortest round-trip time of the requests during the set-up. */
  #roundTrip: Nanoseconds | null = null;
  #question: { asked: Nanoseconds; sentMs: number } | null = null;
  readonly #pace = new Pace();
  readonly #power = new Power();
  readonly #following = new Following();
  readonly #over = new AbortController();
  #lastMs = 0;
  #rateHz = 0;
  #timestamp: number | null = null;
  #isReading = false;
  #hasClock = false;
  #fail: (error: Error) => void = () => {};

  constructor(
    readonly context: AdapterContext,
    readonly settings: RtdeSettings,
    readonly fields: Field[],
  ) {}

  /**
   * Reads until the connection or the adapter ends.
   * @returns The reason why it ended.
   * @throws RefusalError, RecipeError, MissingFieldsError, Error The controller cannot be read.
   */
  async run(): Promise<string> {
    const { stopping, output, clock, status } = this.context;
    output.restart();
    this.#connection = await RtdeConnection.open(this.settings, stopping);
    const stop = (): void => this.#connection.close();
    stopping.addEventListener('abort', stop);
    const failed = new Promise<never>((_, reject) => {
      this.#fail = reject;
    });
    failed.catch(() => {});
    this.#connection.onPackage = (received, arrived) => this.#hear(received, arrived);
    try {
      const ended = this.#connection.ended.then(error => {
        throw this.#because(error);
      });
      await Promise.race([this.#setUp(), failed, ended]);
      return await Promise.race([this.#watch(), failed, ended]);
    } finally {
      stopping.removeEventListener('abort', stop);
      this.#over.abort();
      clock.detach();
      status.notice(null, 'rate');
      status.notice(null);
      for (const key of ['program', 'following_ms']) status.detail(key, null);
      this.#connection.close();
    }
  }

  // Gets the error to report. Before the first data, it names other clients as a possible cause, because a controller accepts few clients.
  #because(error: Error): Error {
    if (error instanceof RefusalError) return this.#isReading ? new Error(rtdeMessages.damaged(placeOf(this.settings))) : error;
    const { endedWhileReading, endedBeforeAnswer } = rtdeMessages;
    return new Error(this.#isReading ? endedWhileReading(error.message) : endedBeforeAnswer(error.message));
  }

  async #setUp(): Promise<void> {
    const { settings } = this;
    const { status } = this.context;
    const version = await this.#ask(protocolVersion(VERSION), TYPE.protocolVersion, ANSWER_MS);
    if (version === null) throw new RefusalError(rtdeMessages.noRtdeAnswer(placeOf(settings)));
    if (version[0] !== 1) throw new RefusalError(rtdeMessages.oldProtocol(placeOf(settings)));
    const controller = (this.#controller = await this.#ask(controllerVersion(), TYPE.controllerVersion, VERSION_ANSWER_MS));
    const major = controller !== null && controller.length >= 16 ? controller.readUInt32BE(0) : null;
    if (major !== null) status.detail('controller', [0, 4, 8, 12].map(i => controller!.readUInt32BE(i)).join('.'));
    const cyclesHz = major === null || major >= E_SERIES ? E_SERIES_HZ : CB3_HZ;
    const rateHz = (this.#rateHz = Math.min(settings.rateHz, cyclesHz));
    this.#clock = new ControllerClock(settings.sendDelay ?? ofMilliseconds(1000 / cyclesHz), by => this.#reportStep(by));
    status.detail('rate_hz', rateHz);
    const names = this.fields.map(field => field.name);
    const types = await this.#ask(setUpOutputs(rateHz, names), TYPE.setUpOutputs, ANSWER_MS);
    if (types === null) throw new Error(rtdeMessages.noRecipe(placeOf(settings)));
    this.#recipe = new Recipe(this.fields, types, settings.source);
    this.#output = new CycleOutput(this.context.output, settings, this.#recipe);
    const started = await this.#ask(start(), TYPE.start, ANSWER_MS, asked => {
      this.#answered = asked;
    });
    if (started?.[0] !== 1) throw new Error(rtdeMessages.notStarted(placeOf(settings)));
  }

  /**
   * Sends a request and waits for its response.
   * @param answered Called with the time of the request when the response arrives, before later data are processed.
   * @returns Payload of the response; null after a timeout.
   */
  async #ask(request: Buffer, type: number, ms: number, answered: (asked: Nanoseconds) => void = () => {}): Promise<Buffer | null> {
    const asked = monotonicTime();
    const answer = new Promise<Buffer | null>(resolve => {
      const cancel = afterArrivals(ms, () => resolve(null));
      this.#over.signal.addEventListener('abort', cancel);
      this.#awaited = {
        type,
        take: (payload, arrived) => {
          cancel();
          const roundTrip = arrived - asked;
          if (this.#roundTrip === null || roundTrip < this.#roundTrip) this.#roundTrip = roundTrip;
          answered(asked);
          resolve(Buffer.from(payload));
        },
      };
    });
    this.#connection.send(request);
    return answer;
  }

  /** Waits until the stream of data ends. Returns the reason. */
  async #watch(): Promise<string> {
    this.#lastMs = performance.now();
    void this.#askAgain();
    while (performance.now() - this.#lastMs < SILENT_MS) {
      await pause(CHECK_MS, this.#over.signal);
      if (this.#over.signal.aborted) return 'stopped';
      this.#reportRate();
    }
    const { halfPackage, silent } = rtdeMessages;
    return (this.#connection.hasHalfPackage ? halfPackage : silent)(placeOf(this.settings), SILENT_MS / 1000);
  }

  /** Requests the version repeatedly. The data package after each response gives an upper bound of the controller's clock. */
  async #askAgain(): Promise<void> {
    const over = this.#over.signal;
    // Stops after an unanswered request, because a late response could be mistaken for the response to a later request.
    if (this.#controller === null) return this.#clock.expectNoAnswers(this.#roundTrip!);
    while (!over.aborted) {
      await pause(ASK_MS, over);
      await pause(this.#untilPackageMs(), over);
      if (over.aborted) return;
      if (this.#question === null) {
        this.#question = { asked: monotonicTime(), sentMs: performance.now() };
        this.#connection.send(controllerVersion());
      } else if (performance.now() - this.#question.sentMs > ANSWER_MS) {
        this.#clock.expectNoAnswers(this.#roundTrip!);
        return;
      }
    }
  }

  /**
   * Gets a random time to wait before a request, mostly until shortly before the next package: the shorter the time between a response and the next
   * package, the tighter the bound. The time is random, because the transmission time of the request is unknown.
   */
  #untilPackageMs(): number {
    const intervalMs = 1000 * (this.#pace.usual ?? 0);
    const passedMs = performance.now() - this.#lastMs;
    return Math.max(0, intervalMs * (1 - Math.random() ** 2) - (passedMs % intervalMs) || 0);
  }

  #hear({ type, payload }: RtdePackage, arrived: Nanoseconds): void {
    if (this.#awaited?.type === type) {
      const { take } = this.#awaited;
      this.#awaited = null;
      return take(payload, arrived);
    }
    if (type === TYPE.data && this.#recipe !== undefined) return this.#hearData(payload, arrived);
    if (type === TYPE.textMessage) {
      const text = textOf(payload);
      if (text !== null) this.context.log.change('message', text, rtdeMessages.message(text));
    } else if (type === TYPE.controllerVersion && this.#question !== null) {
      this.#answered = this.#question.asked;
      this.#question = null;
    }
  }

  #hearData(payload: Buffer, arrived: Nanoseconds): void {
    const cycle = this.#recipe.decode(payload);
    if (typeof cycle === 'string') return this.#fail(new Error(rtdeMessages.invalidData(placeOf(this.settings), cycle)));
    this.#lastMs = performance.now();
    const { status } = this.context;
    const before = this.#timestamp;
    if (before !== null && cycle.timestamp <= before) {
      if (before - cycle.timestamp <= RESTART_S) return status.count('stamp-not-newer');
      return this.#fail(new Error(rtdeMessages.restarted(before, cycle.timestamp)));
    }
    this.#timestamp = cycle.timestamp;
    const stamp = ofFraction(cycle.timestamp, 's');
    this.#clock.heard(stamp, arrived, this.#answered);
    this.#answered = null;
    this.#countLost(cycle.timestamp);
    this.#following.add(cycle);
    // Publishes nothing before the clock is measured, because stamps after a restart would be compared with the previous clock.
    if (this.#reportState(cycle) && this.#hasClock) this.#output.publish(cycle, payload, stamp);
  }

  /** Reports the state of the robot. Returns whether the controller measures the positions. */
  #reportState(cycle: Cycle): boolean {
    const { status, log } = this.context;
    const lack = this.#power.lackIn(cycle);
    const program = programOf(cycle);
    const stop = safetyStopOf(cycle);
    if (lack !== null) {
      status.enter('waiting', lack);
    } else if (!this.#isReading || status.state !== 'connected') {
      status.enter('connected');
    }
    if (!this.#isReading) void this.#attachClock();
    this.#isReading = true;
    status.detail('program', program);
    status.detail('following_ms', this.#following.lagMs?.toFixed(1) ?? null);
    if (lack === null) {
      if (program !== null && !isProgramRunning(cycle)) log.change('program', program, robotStateMessages.programStopped(program));
      else log.resume('program', robotStateMessages.programRuns);
    }
    status.notice(stop);
    return lack === null;
  }

  async #attachClock(): Promise<void> {
    try {
      this.#hasClock = await this.context.clock.attach(async () => this.#clock.at(monotonicTime()), this.#over.signal);
    } catch (error) {
      this.#fail(error as Error);
    }
  }

  #countLost(timestamp: number): void {
    const lost = this.#pace.lostBefore(timestamp);
    const { status, log } = this.context;
    if (lost === 0) return;
    for (let i = 0; i < Math.min(lost, 1000); i++) status.count('package-lost');
    log.change('packages', 'lost', rtdeMessages.lostPackages);
  }

  #reportRate(): void {
    this.context.status.notice(this.#pace.isBelowHalfOf(this.#rateHz) ? rtdeMessages.slow(this.#rateHz) : null, 'rate');
  }

  #reportStep(by: Nanoseconds): void {
    this.context.log.change('controller clock', 'stepped', rtdeMessages.clockStepped(Number(by) / 1e6));
  }
}
