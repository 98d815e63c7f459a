import type { Matrix4 } from 'three';
import { el, setText } from '../dom';
import { jointReasons, robotDescriptions, robotMessages } from '../messages/robot';
import type { Bodies, Poses } from '../robot/bodies';
import { Frames } from '../robot/frames';
import { JointTracks } from '../robot/tracks';
import { RobotView } from '../robot/view';
import { LiveClock } from './liveClock';
import { OtherRobots } from './otherRobots';
import { JOINT_STATE, readJointState, type Rosbridge } from './rosbridge';
import { type CellFrame, type Headset, type Joint, namespaceOf, numberOf, robotsOf } from './state';
import { localTime } from './times';

/**
 * BEHIND_S: age of the displayed state, in seconds. After this time, the following samples and the headset's report have arrived. KEEP_S: length of
 * the stored history, in seconds.
 */
const BEHIND_S = 0.5;
const KEEP_S = 5;
/** Interval between two reports of a headset, in seconds, above which the pose between them is unknown. A headset sends up to 20 per second. */
const MAX_REPORT_GAP_S = 0.25;

const TRANSFORMS = 'tf2_msgs/msg/TFMessage';
const NUMBERS_MS = 500;

/**
 * Time from a picture to the request of the next frame, and interval at which the page looks for changes while nothing moves. The motion still looks
 * smooth, and the work is half of that at 60 frames per second.
 */
const PICTURE_MS = 25;

/** Interval of computation while the view is not visible, for the distances and the messages. */
const HIDDEN_MS = 100;

const seconds = () => performance.now() / 1000;

/** Shows the true poses of all robots half a second ago, and the pose that the selected headset displayed of its robot at that time. */
export class RobotPanel {
  readonly element: HTMLElement;
  private readonly view = new RobotView(robotDescriptions.live);
  private readonly words = el('p', { class: 'apart' }, robotMessages.noDescription);
  private readonly unknown = el('p', { class: 'level warning', hidden: true });
  private readonly objects = el('p', { class: 'level warning', hidden: true });
  private readonly truth = new JointTracks(KEEP_S, joint => this.rests.has(joint));
  private readonly displayed = new JointTracks(KEEP_S, undefined, MAX_REPORT_GAP_S);
  /** Namespace of the robot in the reports of the selected headset, empty for the robot without a namespace; null before the first report. */
  private reportedRobot: string | null = null;
  private readonly clock = new LiveClock();
  private readonly frames = new Frames();
  private readonly others: OtherRobots;
  private headset: Headset | null = null;
  /** Joints of the gateway's newest list whose position is current. */
  private current = new Set<string>();
  /** Joints of this list that are at rest, so that their sources send no samples. */
  private rests = new Set<string>();
  /** State of each other joint of this list. */
  private faults = new Map<string, string>();
  /** Namespaces of the robots, by the names of their joints. */
  private robots = new Map<string, string>();
  private shownAt = 0;
  private isMoving = false;

  constructor(
    private readonly link: Rosbridge,
    isCalm: boolean,
  ) {
    this.element = el('div', {}, this.words, this.unknown, this.objects, this.view.element);
    link.subscribe('/robot_description', 'std_msgs/msg/String', text => this.describe(text));
    link.subscribe('/joint_states', JOINT_STATE, text => this.sample(text));
    link.subscribe('/tf', TRANSFORMS, text => this.frames.take(text, false));
    link.subscribe('/tf_static', TRANSFORMS, text => this.frames.take(text, true));
    this.view.add(this.frames);
    this.others = new OtherRobots(link, KEEP_S, joint => this.rests.has(joint));
    this.view.add(this.others);
    // Has room for a message of each headset, because all headsets publish on this topic.
    link.subscribe('/nowpose/displayed', JOINT_STATE, text => this.shown(text), 256);
    link.onOpen(() => this.clear());
    if (isCalm) setInterval(() => this.draw(), 1000);
    else this.animate();
  }

  /**
   * @param control Current control time of the gateway, s.
   * @param steps Number of steps of the control clock; null if the gateway does not count them.
   */
  setTime(control: number, steps: number | null): void {
    this.clock.add(control, seconds(), steps);
  }

  /** Selects the headset whose displayed pose is drawn over the robot. */
  choose(headset: Headset | null): void {
    if (headset?.name !== this.headset?.name) this.setReportedRobot(null);
    this.headset = headset;
  }

  /**
   * Sets the states of all joints of the gateway. Links below a joint that is neither live nor at rest are drawn neither at the true pose nor at the
   * pose without compensation. The same applies to a joint that is not in the list: no source publishes it, so its last position is not current.
   */
  setJoints(joints: Joint[]): void {
    const isGood = (joint: Joint) => joint.state === 'live' || joint.state === 'rest';
    this.current = new Set(joints.filter(isGood).map(joint => joint.name));
    this.rests = new Set(joints.filter(joint => joint.state === 'rest').map(joint => joint.name));
    this.faults = new Map(joints.filter(joint => !this.current.has(joint.name)).map(joint => [joint.name, joint.state]));
    this.robots = robotsOf(joints);
    this.others.setRobots(new Set(this.robots.values()));
  }

  /** Sets the frames of the gateway. A robot whose base is one of them is drawn only while the pose of its base is known. */
  setFrames(frames: CellFrame[]): void {
    this.frames.setListed(new Map(frames.map(({ name, state }) => [name, state === 'live' || state === 'stationary' ? null : state])));
  }

  // Removes everything received on an earlier connection. The gateway may have restarted without some robots and objects; it sends the others again.
  private clear(): void {
    for (const part of [this.view, this.truth, this.frames, this.others]) part.clear();
    this.setReportedRobot(null);
  }

  private setReportedRobot(robot: string | null): void {
    this.displayed.clear();
    this.reportedRobot = robot;
  }

  /** Namespace of the robot that the selected headset displays; null while it is not known. */
  private get displayedRobot(): string | null {
    const robots = [...new Set(this.robots.values())];
    return this.reportedRobot ?? (robots.length === 1 ? robots[0] : null);
  }

  private describe(text: string): void {
    const { data } = JSON.parse(text).msg;
    if (typeof data === 'string') this.view.describe(data);
  }

  private sample(text: string): void {
    const state = readJointState(text);
    if (state) this.truth.add(state.stamp, state.names, state.positions);
  }

  private shown(text: string): void {
    if (!this.headset || !text.includes(JSON.stringify(this.headset.name))) return;
    const state = readJointState(text);
    if (state?.frame !== this.headset.name) return;
    const name = state.names[0] ?? '';
    const robot = this.robots.get(name) ?? namespaceOf(name);
    if (robot !== this.reportedRobot) this.setReportedRobot(robot);
    const names = robot === '' ? state.names : state.names.map(name => name.slice(robot.length + 1));
    this.displayed.add(state.stamp, names, state.positions);
  }

  private animate(): void {
    const next = () => {
      // First, so that the view goes on after a picture that throws an exception.
      this.animate();
      this.draw();
    };
    // Requests no frame while nothing moves, because the browser processes the whole page for each frame.
    const wait = () => (this.isMoving ? requestAnimationFrame(next) : next());
    setTimeout(wait, this.view.isVisible ? PICTURE_MS : HIDDEN_MS);
  }

  private draw(): void {
    // Before the first response, draws the stationary objects, whose poses apply to all times.
    const time = (this.clock.at(seconds()) ?? -Infinity) - BEHIND_S;
    const linkOf = this.pose(time);
    this.frames.pose(time, linkOf);
    if (performance.now() - this.shownAt >= NUMBERS_MS) {
      this.shownAt = performance.now();
      this.showUnknown(time);
      this.showNotDrawn();
      setText(this.words, this.distances(time));
    }
    this.isMoving = this.view.drawIfChanged();
  }

  /**
   * Poses all robots. A robot may stand on a link of another one, which is then posed first.
   * @returns A function that returns the pose of a robot's link in the world; null for an unknown link.
   */
  private pose(time: number): (name: string) => Matrix4 | null {
    const posed = new Set<string>();
    const linkOf = (name: string) => linkIn('', name) ?? linkIn(namespaceOf(name), name.slice(name.indexOf('/') + 1));
    const linkIn = (robot: string, link: string) => {
      place(robot);
      return this.find(robot).bodies?.linkOf('truth', link) ?? null;
    };
    const place = (robot: string) => {
      if (posed.has(robot)) return;
      posed.add(robot);
      const { bodies, tracks } = this.find(robot);
      bodies?.place(this.frames.baseAt(inCell(robot, bodies.rootName), time, linkOf));
      bodies?.show(this.posesOf(robot, tracks, time), joint => this.current.has(inCell(robot, joint)));
    };
    for (const robot of ['', ...this.others.names]) place(robot);
    return linkOf;
  }

  /** Returns the copies of a robot, null without a description, and its true positions. */
  private find(robot: string): { bodies: Bodies | null; tracks: JointTracks } {
    return robot === '' ? { bodies: this.view.bodies, tracks: this.truth } : this.others.find(robot);
  }

  /** @param truth True positions of the robot. */
  private posesOf(robot: string, truth: JointTracks, time: number): Poses {
    // Without the connection, the newest positions that have arrived are not the robot's present ones.
    if (this.link.closedAt) return { truth: null, displayed: null, hold: null };
    const isDisplayed = robot === this.displayedRobot;
    return { truth: truth.at(time), displayed: isDisplayed ? this.displayed.at(time) : null, hold: isDisplayed ? this.held(truth, time) : null };
  }

  // Names what makes the drawing incomplete: the lost connection, bases without a known pose, or joints without a current position. A joint that is drawn
  // at 0 or at its last position could be mistaken for the truth.
  private showUnknown(time: number): void {
    const robots = [...new Set(['', ...this.robots.values()])];
    const bases = robots.flatMap(robot => {
      const { bodies } = this.find(robot);
      return bodies && !bodies.group.visible ? [inCell(robot, bodies.rootName)] : [];
    });
    const joints = robots.flatMap(robot => this.unknownJoints(robot, time));
    const { closedAt } = this.link;
    const texts = [bases.length > 0 && robotMessages.basesUnknown(bases), joints.length > 0 && robotMessages.linksNotDrawn(joints)];
    const text = closedAt ? robotMessages.noConnection(localTime(closedAt)) : texts.filter(Boolean).join(' ');
    this.unknown.hidden = text === '';
    setText(this.unknown, text);
  }

  // Returns the reasons why the positions of joints of a drawn robot are not known.
  private unknownJoints(robot: string, time: number): string[] {
    const { bodies, tracks } = this.find(robot);
    if (!bodies?.group.visible) return [];
    const received = new Set(tracks.at(time)?.names);
    return bodies.joints
      .filter(joint => !received.has(joint) || !this.current.has(inCell(robot, joint)))
      .map(joint => {
        const name = inCell(robot, joint);
        if (!received.has(joint)) return tracks.has(joint) ? jointReasons.noData(name) : jointReasons.notReceived(name);
        const state = this.faults.get(name);
        return state === undefined ? jointReasons.notPublished(name) : jointReasons.inState(name, state);
      });
  }

  private showNotDrawn(): void {
    const { names, others } = this.frames.notDrawn();
    this.objects.hidden = names.length === 0;
    setText(this.objects, names.length === 0 ? '' : robotMessages.objectsNotDrawn(names, others));
  }

  // Returns the newest samples that had arrived at that time, computed from the latencies that the headset measured.
  private held(truth: JointTracks, time: number) {
    const late = this.headset && [numberOf(this.headset, 'l_app_ms'), numberOf(this.headset, 'l_visu_ms')];
    return !late || late[0] == null || late[1] == null ? null : truth.heldAt(time - (late[0] + late[1]) / 1000);
  }

  // Returns the distances of the robot that the headset displays as text, or the reason why they are not known.
  private distances(time: number): string {
    const name = this.headset?.name;
    const robot = this.displayedRobot;
    const { bodies, tracks } = robot === null ? { bodies: null, tracks: this.truth } : this.find(robot);
    if (this.link.closedAt) return '';
    if (!bodies) {
      if (name && robot) return robotMessages.displaysUnknown(name, robot);
      if (robot !== null || (!this.view.bodies && !this.others.isAnyDescribed)) return robotMessages.noDescription;
      return name ? robotMessages.toolError(name, null, null) : robotMessages.noHeadset;
    }
    if (!bodies.group.visible) return robotMessages.baseUnknown;
    // After the last sample of a joint, the true position is not known. A joint that is not current has its own message.
    const joints = bodies.toolJoints.filter(joint => this.current.has(inCell(robot!, joint)));
    if (tracks.endBefore(time, joints)) return robotMessages.late;
    if (!name) return robotMessages.noHeadset;
    if (!bodies.isToolDrawn('truth')) return robotMessages.toolUnknown;
    return robotMessages.toolError(name, bodies.distance('displayed', 'truth'), bodies.distance('hold', 'truth'));
  }
}

/** Returns the cell-wide name of a joint or link of a robot. */
function inCell(robot: string, name: string): string {
  return robot === '' ? name : `${robot}/${name}`;
}
