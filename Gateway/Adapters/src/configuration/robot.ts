import { besides } from './besides';
import { nearest } from './nearest';
import { readText } from './textFile';
import type { Path, YamlFile } from './yamlFile';
import { excessOf } from '../gateway/messages';
import ur10e from '../../../../Packages/com.nowpose.mril/Runtime/Robots/ur10e.urdf';
import ur16e from '../../../../Packages/com.nowpose.mril/Runtime/Robots/ur16e.urdf';
import ur3e from '../../../../Packages/com.nowpose.mril/Runtime/Robots/ur3e.urdf';
import ur5 from '../../../../Packages/com.nowpose.mril/Runtime/Robots/ur5.urdf';
import ur5e from '../../../../Packages/com.nowpose.mril/Runtime/Robots/ur5e.urdf';
import youbot from '../../../../Packages/com.nowpose.mril/Runtime/Robots/youbot.urdf';
import { robotMessages } from '../messages/configuration';

/** URDFs of the robots that are available by name. They are the same as in the gateway. */
const INCLUDED: Record<string, string> = { ur3e, ur5, ur5e, ur10e, ur16e, youbot };

/** A joint's name in the configuration, and its name in the robot description. */
export interface NamedJoint {
  joint: string;
  /** Namespace of the joint's robot; empty if the robot has no namespace. */
  robot: string;
  name: string;
  /** Whether the position is a length in m; otherwise it is an angle in rad. */
  isLinear?: boolean;
}

const ANGLE = ['rad', 'deg'];

/** Units of the position for each type of moving joint. */
const UNITS_OF: Record<string, string[]> = { revolute: ANGLE, continuous: ANGLE, prismatic: ['m', 'mm'] };

/** Splits a joint's name, such as NAMESPACE/JOINT, into the namespace and the name without it. */
export function namedIn(joint: string, namespaces: readonly string[]): NamedJoint {
  const robot = namespaces.find(namespace => joint.startsWith(`${namespace}/`)) ?? '';
  return { joint, robot, name: robot === '' ? joint : joint.slice(robot.length + 1) };
}

/** Gets the text of the URDF that an entry names. Reports a URDF that cannot be read or is invalid, and returns null. */
export function robotOf(file: YamlFile, at: Path, robot: string): string | null {
  if (Object.hasOwn(INCLUDED, robot)) return INCLUDED[robot];
  const path = besides(file.path, robot);
  const report = (text: string): null => {
    file.report(at, text);
    return null;
  };
  try {
    const text = readText(path);
    if (!text.includes('<robot')) return report(robotMessages.notUrdf(robot));
    const excess = excessOf(robot, text);
    return excess === null ? text : report(excess);
  } catch (error) {
    return report(robotMessages.notReadable(robot, (error as NodeJS.ErrnoException).code, Object.keys(INCLUDED)));
  }
}

/** Matches the name of a joint of a robot with a namespace. */
const QUALIFIED = /^([A-Za-z][A-Za-z0-9_]{0,31})\/(.+)$/;

/**
 * Reports configured joints that the robot of this namespace does not have, because headsets cannot show them, and units that do not fit the type of
 * a joint. Sets whether the position of a joint with a known type is a length.
 * @param urdf The description of the robot; null if the file has none.
 * @param namespaces The namespaces of the file's robots; null if this kind of plant has no robots with namespaces.
 */
export function requireJoints(file: YamlFile, joints: NamedJoint[], robot: string, urdf: string | null, namespaces: string[] | null): void {
  const known = urdf === null ? null : typesIn(urdf);
  joints.forEach((named, i) => {
    const { joint, robot: own, name } = named;
    if (own !== robot) return;
    if (known?.has(name) === true) return requireUnit(file, named, i, known.get(name)!);
    const path = ['joints', i, 'joint'];
    if (joint.includes('/') && robot === '' && file.isInvalid(['robots'])) return;
    const [, namespace, rest] = (robot === '' ? QUALIFIED.exec(name) : null) ?? [];
    if (namespace === undefined && known !== null) {
      // The message has the form of the file. In a file with one namespace, the joints are entered without it.
      const prefix = namespaces === null ? '' : joint.slice(0, -name.length);
      const [guess] = nearest(name, known.keys());
      file.report(path, robotMessages.noJoint(prefix + name, guess && prefix + guess));
    } else if (namespace !== undefined && namespaces !== null)
      file.report(path, robotMessages.noRobot(joint, namespace, nearest(namespace, namespaces)[0]));
    // The robot of such a plant may send a description that has a joint of this name.
    else if (namespace !== undefined) file.warn(path, robotMessages.noNamespace(joint, namespace, rest));
  });
}

/** @param type Type of the joint in the robot description; empty if it is missing. */
function requireUnit(file: YamlFile, joint: NamedJoint & { unit?: unknown }, index: number, type: string): void {
  const allowed = UNITS_OF[type];
  if (allowed === undefined) return;
  joint.isLinear = type === 'prismatic';
  if (joint.unit !== undefined && !allowed.includes(joint.unit as string))
    file.report(['joints', index, 'unit'], robotMessages.wrongUnit(joint.unit, joint.name, type, allowed));
}

/** Gets the types of the joints in a robot description, by the name of the joint. */
const typesIn = (urdf: string): Map<string, string> => {
  const types = new Map<string, string>();
  // A joint is also named in a <transmission>, without its type.
  for (const attributes of elementsIn(urdf, 'joint')) {
    const name = attributeIn(attributes, 'name');
    if (name !== undefined) types.set(name, attributeIn(attributes, 'type') ?? types.get(name) ?? '');
  }
  return types;
};

/** Gets the names of the links in a robot description. */
export const linksIn = (urdf: string): string[] => elementsIn(urdf, 'link').flatMap(attributes => attributeIn(attributes, 'name') ?? []);

/** Gets the name of the link that is not the child of any joint; null if there is none. */
export function rootLinkIn(urdf: string): string | null {
  const children = new Set(elementsIn(urdf, 'child').map(attributes => attributeIn(attributes, 'link')));
  return linksIn(urdf).find(link => !children.has(link)) ?? null;
}

/** Gets the attributes of the elements with this name, as the text of each start tag. */
const elementsIn = (urdf: string, element: string): string[] =>
  [...urdf.replace(/<!--[^]*?-->/g, '').matchAll(new RegExp(`<${element}(\\s(?:"[^"]*"|'[^']*'|[^>"'])*)`, 'g'))].map(([, attributes]) => attributes);

function attributeIn(attributes: string, name: string): string | undefined {
  const [, double, single] = new RegExp(`\\s${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`).exec(attributes) ?? [];
  return double ?? single;
}
