// Writes the reference poses of ForwardKinematicsTests, computed by urdf-loader 0.13 and three.js in double precision:
//   npm install urdf-loader three jsdom        (in a separate folder that contains a copy of this file)
//   node make-reference.mjs OUT.json FILE.urdf …
// Joint values exceed the limits; every second case gives one mimic joint a value of its own.
import fs from 'node:fs';
import path from 'node:path';
import { JSDOM } from 'jsdom';

const dom = new JSDOM('').window;
for (const name of ['DOMParser', 'Document', 'Element', 'document']) globalThis[name] = dom[name];
const { default: URDFLoader } = await import('urdf-loader');

let seed = 20220615;
const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
const value = joint => (2 * random() - 1) * (joint.jointType === 'prismatic' ? 0.5 : 7);

function poses(robot) {
  robot.updateMatrixWorld(true);
  const toRoot = robot.matrixWorld.clone().invert();
  const rows = link => toRoot.clone().multiply(link.matrixWorld).transpose().elements;
  return Object.fromEntries(Object.entries(robot.links).map(([name, link]) => [name, [...rows(link)]]));
}

function reference(file) {
  const loader = new URDFLoader();
  loader.parseVisual = loader.parseCollision = false;
  const robot = loader.parse(fs.readFileSync(file, 'utf8'));
  const moving = Object.entries(robot.joints).filter(([, joint]) => joint.jointType !== 'fixed');
  const cases = [];
  for (let i = 0; i < 6; i++) {
    const given = moving.filter(([, joint]) => !joint.mimicJoint);
    const mimic = moving.find(([, joint]) => joint.mimicJoint && !moving.some(([name]) => name === joint.mimicJoint && robot.joints[name].mimicJoint));
    if (mimic && i % 2) given.push(mimic);
    const joints = {};
    for (const [name, joint] of moving) joint.ignoreLimits = true;
    for (const [name, joint] of given) joint.setJointValue(joints[name] = value(joint));
    cases.push({ joints, links: poses(robot) });
  }
  return { robot: robot.robotName, file: path.basename(file), cases };
}

const [out, ...files] = process.argv.slice(2);
const text = JSON.stringify({ made_with: 'make-reference.mjs: urdf-loader and three.js', robots: files.map(reference) }, null, 1);
fs.writeFileSync(out, text.replace(/\[\s+([-\d.][^\]]*?)\s+\]/g, (_, numbers) => `[${numbers.replace(/\s+/g, ' ')}]`) + '\n');
