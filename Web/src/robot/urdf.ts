import { MeshPhongMaterial, type Object3D, Vector3 } from 'three';
import URDFLoader, { type URDFJoint, type URDFRobot } from 'urdf-loader';
import { robotReasons } from '../messages/robot';

/** Possible names of the tool's link, in the order in which they are searched for. The headset uses the same order. */
const TOOLS = ['tool_centre_point', 'tool0', 'flange'];

const MOVING = ['revolute', 'continuous', 'prismatic'];

/** A robot that was read from a URDF. The positions of its joints can be set. */
export interface Robot {
  root: URDFRobot;
  tool: Object3D;
  /** Number of visual elements that are meshes, which a page cannot load. */
  meshes: number;
}

// Checks own properties only, because a joint can have the name of an inherited property.
const has = (map: object, name: string) => Object.prototype.hasOwnProperty.call(map, name);

/** @throws Error with the reason in one line if the text is not a valid URDF. */
export function readUrdf(text: string): Robot {
  const document = new DOMParser().parseFromString(text, 'text/xml');
  const fault = document.querySelector('parsererror');
  if (fault || document.documentElement.nodeName !== 'robot') throw new Error(robotReasons.notUrdf);
  // Removes textures, because they would be loaded over the network.
  document.querySelectorAll('texture').forEach(texture => texture.remove());
  let meshes = 0;
  const loader = new URDFLoader();
  loader.loadMeshCb = (_path, _manager, _material, _done) => {
    meshes++;
  };
  const root = loader.parse(document);
  // Draws measured positions even if they exceed the limits.
  for (const joint of Object.values(root.joints)) joint.ignoreLimits = true;
  return { root, tool: toolOf(root), meshes };
}

/** Sets the positions of joints by name. Ignores unknown joints, as the headset does. */
export function setJoints({ root }: Robot, names: string[], positions: ArrayLike<number>): void {
  names.forEach((name, i) => {
    if (has(root.joints, name) && Number.isFinite(positions[i])) root.joints[name].setJointValue(positions[i]);
  });
  root.updateMatrixWorld(true);
}

/** Returns the names of the joints that need positions: those that can move and do not mimic another joint. */
export function movingJoints({ root }: Robot): string[] {
  return Object.entries(root.joints)
    .filter(([, joint]) => MOVING.includes(joint.jointType) && masterOf(joint) === null)
    .map(([name]) => name);
}

/** Returns a link by its name; null for an unknown link. */
export function linkOf({ root }: Robot, name: string): Object3D | null {
  return has(root.links, name) ? root.links[name] : null;
}

/** Hides the links below joints whose position is unknown. */
export function showKnown({ root }: Robot, isKnown: (joint: string) => boolean): void {
  for (const [name, joint] of Object.entries(root.joints)) joint.visible = !MOVING.includes(joint.jointType) || isKnown(masterOf(joint) ?? name);
}

/** Returns whether an object and all of its ancestors are visible. */
export function isDrawn(object: Object3D): boolean {
  for (let at: Object3D | null = object; at; at = at.parent) if (!at.visible) return false;
  return true;
}

/** Returns the names of the joints on which the position of the tool depends. */
export function toolJoints({ tool }: Robot): string[] {
  return movingAbove(tool).map(joint => masterOf(joint) ?? joint.name);
}

function movingAbove(link: Object3D): URDFJoint[] {
  const joints: URDFJoint[] = [];
  for (let at: Object3D | null = link; at; at = at.parent) if (MOVING.includes((at as Partial<URDFJoint>).jointType!)) joints.push(at as URDFJoint);
  return joints;
}

function masterOf(joint: URDFJoint): string | null {
  return (joint as { mimicJoint?: string }).mimicJoint ?? null;
}

/** Returns the position of the tool in the robot's base frame, m. */
export function toolPosition(robot: Robot, into = new Vector3()): Vector3 {
  return robot.root.worldToLocal(robot.tool.getWorldPosition(into));
}

function toolOf(root: URDFRobot): Object3D {
  const named = TOOLS.find(name => has(root.links, name));
  if (named) return root.links[named];
  const depth = (link: Object3D) => movingAbove(link).length;
  const leaves = Object.values(root.links).filter(link => !link.children.some(child => 'jointType' in child));
  return leaves.reduce((best, leaf) => (depth(leaf) > depth(best) ? leaf : best), leaves[0] ?? root);
}

/** Replaces the materials of all meshes and sets their render order. Needed because the loader shares materials between links. */
export function paint(root: Object3D, material: MeshPhongMaterial, renderOrder: number): void {
  root.traverse(object => {
    if (!('material' in object)) return;
    (object as { material: MeshPhongMaterial }).material = material;
    object.renderOrder = renderOrder;
  });
}
