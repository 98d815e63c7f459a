import { type Box3, Group } from 'three';
import { Bodies } from '../robot/bodies';
import { JointTracks } from '../robot/tracks';
import type { Beside } from '../robot/view';
import { JOINT_STATE, readJointState, type Rosbridge } from './rosbridge';

/** Maximum number of robots. The gateway's limit is the same. */
const MAX_ROBOTS = 16;

interface Robot {
  bodies: Bodies | null;
  /** True positions of the joints. */
  tracks: JointTracks;
}

/** Draws the robots in namespaces. The names of joints contain the namespaces, except in the history and the poses of one robot. */
export class OtherRobots implements Beside {
  readonly group = new Group();
  private readonly robots = new Map<string, Robot>();

  /**
   * @param keepS Length of the stored history, s.
   * @param isAtRest Returns whether a joint of the cell is at rest.
   */
  constructor(
    private readonly link: Rosbridge,
    private readonly keepS: number,
    private readonly isAtRest: (joint: string) => boolean,
  ) {}

  /** Whether the description of at least one robot has arrived. */
  get isAnyDescribed(): boolean {
    return [...this.robots.values()].some(({ bodies }) => bodies !== null);
  }

  /**
   * Adds robots. If there are too many, a new robot replaces one that is not listed.
   * @param listed Namespaces of all robots with joints; empty for the robot without one, which is not drawn here.
   */
  setRobots(listed: ReadonlySet<string>): void {
    for (const name of listed) {
      if (name === '' || this.robots.has(name)) continue;
      if (this.robots.size >= MAX_ROBOTS) this.remove([...this.robots.keys()].find(known => !listed.has(known)));
      if (this.robots.size < MAX_ROBOTS) this.add(name);
    }
  }

  /** Namespaces of the robots. */
  get names(): Iterable<string> {
    return this.robots.keys();
  }

  /** Returns the copies of a robot, null without a description, and its true positions. */
  find(name: string): Robot {
    return this.robots.get(name) ?? { bodies: null, tracks: new JointTracks(this.keepS) };
  }

  /** Removes the descriptions and joint positions of all robots. */
  clear(): void {
    for (const robot of this.robots.values()) {
      this.removeBodies(robot);
      robot.tracks.clear();
    }
  }

  addTo(box: Box3): void {
    for (const { bodies } of this.robots.values()) bodies?.addTo(box);
  }

  recolour(): void {
    for (const { bodies } of this.robots.values()) bodies?.recolour();
  }

  private add(name: string): void {
    const robot: Robot = { bodies: null, tracks: new JointTracks(this.keepS, joint => this.isAtRest(`${name}/${joint}`)) };
    this.robots.set(name, robot);
    const [description, states] = topicsOf(name);
    this.link.subscribe(description, 'std_msgs/msg/String', text => this.describe(robot, text));
    const take = (text: string) => {
      const state = readJointState(text);
      if (state) robot.tracks.add(state.stamp, state.names, state.positions);
    };
    this.link.subscribe(states, JOINT_STATE, take);
  }

  private remove(name: string | undefined): void {
    if (name === undefined) return;
    for (const topic of topicsOf(name)) this.link.unsubscribe(topic);
    this.removeBodies(this.robots.get(name)!);
    this.robots.delete(name);
  }

  private removeBodies(robot: Robot): void {
    if (robot.bodies) this.group.remove(robot.bodies.group);
    robot.bodies?.dispose();
    robot.bodies = null;
  }

  private describe(robot: Robot, text: string): void {
    const { data } = JSON.parse(text).msg;
    this.removeBodies(robot);
    try {
      robot.bodies = new Bodies(data);
      this.group.add(robot.bodies.group);
    } catch {
      // Ignores a description that cannot be read, because the headsets report this error.
    }
  }
}

const topicsOf = (name: string) => [`/${name}/robot_description`, `/${name}/joint_states`];
