import type { PlaybackData } from './data';
import { el } from './dom';
import { Legend } from './legend';
import { traceLabels } from './messages/plots';
import { reportLabels, reportMessages } from './messages/report';
import { robotDescriptions } from './messages/robot';
import { lastUpTo } from './numbers';
import type { Playhead } from './playhead';
import type { Part } from './robot/bodies';
import { Objects } from './robot/objects';
import { RobotView } from './robot/view';
import { type SignalStrips, signalStrips } from './signalStrips';
import type { Look } from './traces';

const SPEEDS = [1, 0.5, 0.25, 0.1];

const LEGEND: Record<Part, { label: string; look: Look }> = {
  truth: { label: traceLabels.truePose, look: { ink: '--truth', width: 2, dash: [], mark: 'filled' } },
  displayed: { label: traceLabels.compensated, look: { ink: '--compensated', width: 2, dash: [], mark: 'filled' } },
  hold: { label: traceLabels.uncompensated, look: { ink: '--hold', width: 2, dash: [], mark: 'filled' } },
};

/** Plays the session with three copies of the robot: at its true pose, at the displayed pose, and at the pose without compensation. */
export class Playback {
  readonly element: HTMLElement;
  private readonly view: RobotView;
  private readonly words = el('p', { class: 'apart' });
  private readonly button = el('button', { type: 'button', class: 'play' }, reportLabels.play);
  private readonly slider: HTMLInputElement;
  private readonly clock = el('output', { class: 'clock' });
  private readonly speed = el('select', {}, ...SPEEDS.map(s => el('option', { value: s }, `${s} ×`)));
  private readonly hidden = new Set<Part>();
  private readonly objects: Objects | null;
  private readonly signals: SignalStrips | null;
  private time: number;
  private playedAt: number | null = null;

  constructor(
    private readonly data: PlaybackData,
    private readonly playhead: Playhead,
  ) {
    const { t } = data;
    this.time = t[0];
    this.objects = data.objects ? new Objects(data.objects) : null;
    this.view = new RobotView(robotDescriptions.session(this.objects?.names ?? []));
    this.slider = el('input', { type: 'range', min: t[0], max: t[t.length - 1], step: 0.02, value: t[0], 'aria-label': reportLabels.moment });
    this.signals = signalStrips(data.signals, t[0], t[t.length - 1]);
    const legend = new Legend((Object.keys(LEGEND) as Part[]).map(part => ({ ...LEGEND[part], toggle: shown => this.toggle(part, shown) })));
    this.element = el(
      'section',
      { id: 'playback', 'aria-labelledby': 'playback-heading' },
      el('h2', { id: 'playback-heading' }, reportLabels.playback),
      el('p', { class: 'claim' }, reportMessages.playback),
      legend.element,
      this.words,
      this.view.element,
      this.signals?.element,
      el('div', { class: 'player' }, this.button, this.slider, this.clock, el('label', {}, `${reportLabels.speed} `, this.speed)),
    );
    this.button.addEventListener('click', () => this.toggleRun());
    this.slider.addEventListener('input', () => {
      this.stop();
      playhead.move(Number(this.slider.value), this);
    });
    playhead.follow((time, mover) => {
      if (mover !== this) this.stop();
      this.show(time);
    });
    this.view.describe(data.urdf);
    if (this.objects) this.view.add(this.objects);
    this.show(t[0]);
  }

  private toggleRun(): void {
    if (this.playedAt !== null) return this.stop();
    const { t } = this.data;
    if (this.time >= t[t.length - 1]) this.playhead.move(t[0], this);
    this.playedAt = performance.now();
    this.button.textContent = reportLabels.pause;
    requestAnimationFrame(() => this.step());
  }

  private step(): void {
    if (this.playedAt === null) return;
    const now = performance.now();
    const end = this.data.t[this.data.t.length - 1];
    const time = Math.min(end, this.time + ((now - this.playedAt) / 1000) * Number(this.speed.value));
    this.playedAt = now;
    this.playhead.move(time, this);
    if (time >= end) this.stop();
    else requestAnimationFrame(() => this.step());
  }

  private stop(): void {
    this.playedAt = null;
    this.button.textContent = reportLabels.play;
  }

  private toggle(part: Part, shown: boolean): void {
    if (shown) this.hidden.delete(part);
    else this.hidden.add(part);
    this.show(this.time);
  }

  private show(time: number): void {
    const { t, names, truth, displayed, hold } = this.data;
    this.time = Math.min(t[t.length - 1], Math.max(t[0], time));
    this.slider.value = String(this.time);
    const words = `${this.time.toFixed(2)} s`;
    this.clock.textContent = words;
    this.slider.setAttribute('aria-valuetext', words);
    this.signals?.show(this.time);
    const { bodies } = this.view;
    if (!bodies) return;
    const i = lastUpTo(t, this.time);
    const poses = { truth, displayed, hold };
    for (const part of Object.keys(poses) as Part[]) bodies.pose(part, names, poses[part][i]);
    const [compensated, held] = [bodies.distance('displayed', 'truth'), bodies.distance('hold', 'truth')];
    for (const part of this.hidden) bodies.pose(part, names, null);
    const texts = [reportMessages.toolError(compensated, held), this.showObjects(i)];
    this.view.ask();
    this.words.textContent = texts.filter(Boolean).join(' ');
  }

  private showObjects(instant: number): string {
    const { objects } = this.data;
    if (!objects || !this.objects) return '';
    const poses = { truth: objects.truth[instant], displayed: objects.displayed[instant], hold: objects.hold[instant] };
    for (const part of Object.keys(poses) as Part[]) this.objects.pose(part, this.hidden.has(part) ? null : poses[part]);
    const [compensated, held] = [poses.displayed, poses.hold].map(shown => shown && this.objects!.largestDistance(shown, poses.truth));
    return reportMessages.workpieceError(compensated, held);
  }
}
