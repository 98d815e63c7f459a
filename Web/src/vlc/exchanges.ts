import { abortAfter, noAnswer, reasonOf } from '../gateway';
import { clockCodeReasons } from '../messages/codes';
import { gatewayReasons } from '../messages/gateway';
import { ControlClock, MIN_EXCHANGES } from './controlClock';
import { grainOf } from './grain';

const QUICK_MS = 60;
const SLOW_MS = 250;
const TIMEOUT_MS = 1000;

/** Time without a reply after which the control time counts as unknown. It allows for two consecutive lost exchanges. */
const SILENCE_MS = 2000;

/** Maximum error bound. A code with a larger error would be misleading, so no code is shown. */
const MAX_BOUND_MS = 3;

interface Answer {
  t2_ns: string;
  t3_ns: string;
  resolution_ns: number;
  is_synchronised: boolean;
}

/** Synchronises a clock with the gateway that serves this page. */
export class Exchanges {
  readonly clock = new ControlClock(grainOf(() => performance.now()));
  private problem = clockCodeReasons.waiting;
  private token = '';
  private isWaiting = false;
  private goOn = () => {};

  /** @param onToken Called when the gateway requires a token that the page does not have. */
  constructor(private readonly onToken: () => void) {}

  /** Sets the token. The page keeps it in memory only. */
  authorise(token: string): void {
    this.token = token.trim();
    this.isWaiting = false;
    this.goOn();
  }

  /** Returns the reason why no code can be shown; null if the clock is accurate enough. */
  reasonWithoutCode(now: number): string | null {
    const age = this.clock.age(now);
    if (this.problem) return this.problem;
    if (age > SILENCE_MS) return noAnswer;
    if (this.clock.count < MIN_EXCHANGES) return clockCodeReasons.exchanges(this.clock.count, MIN_EXCHANGES);
    const { boundMs } = this.clock.at(now)!;
    return boundMs <= MAX_BOUND_MS ? null : clockCodeReasons.boundTooLarge(boundMs, MAX_BOUND_MS);
  }

  async run(): Promise<never> {
    for (;;) {
      await this.exchange();
      const pause = this.clock.count < MIN_EXCHANGES && !this.problem ? QUICK_MS : SLOW_MS;
      await new Promise<void>(done => {
        // Waits for a token, because each request without it would add a line to the gateway's log.
        if (this.isWaiting) this.goOn = done;
        else setTimeout(done, pause);
      });
    }
  }

  private async exchange(): Promise<void> {
    const headers: HeadersInit = this.token ? { Authorization: `Bearer ${this.token}` } : {};
    try {
      const t1 = performance.now();
      const response = await fetch('/vlc/time', { method: 'POST', cache: 'no-store', headers, signal: abortAfter(TIMEOUT_MS) });
      const t4 = performance.now();
      if (response.status === 401) return this.askForToken();
      if (!response.ok) return this.fail(gatewayReasons.refused(await reasonOf(response)));
      const answer = (await response.json()) as Answer;
      this.problem = answer.is_synchronised ? '' : clockCodeReasons.controlClock;
      this.clock.add({ t1, t2: BigInt(answer.t2_ns), t3: BigInt(answer.t3_ns), t4, resolutionNs: answer.resolution_ns });
    } catch {
      // The gateway is not reachable or too slow. This is reported when the newest exchange is too old.
      if (this.clock.age(performance.now()) > SILENCE_MS) this.fail(noAnswer);
    }
  }

  private askForToken(): void {
    this.fail(this.token ? gatewayReasons.tokenRefused : gatewayReasons.tokenRequired);
    this.token = '';
    this.isWaiting = true;
    this.onToken();
  }

  private fail(problem: string): void {
    this.problem = problem;
    this.clock.forget();
  }
}
