// Defines the manual's pictures of web pages: their stored data, and the texts of a page that a test compares to detect changes.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';

/** Fixed time of the pictures, in UTC. */
const NOW = new Date('2026-01-15T10:00:00Z');

export const path = relative => fileURLToPath(new URL(relative, import.meta.url));
export const stored = name => JSON.parse(gunzipSync(readFileSync(path(`${name}.json.gz`))));

const manual = '../../Packages/com.nowpose.mril/Documentation~/';

/** The pictures, each with the manual page that shows it. */
export const PICTURES = {
  report: { file: '../../docs/report.png', shownBy: '../../docs/measurements.md' },
  'virtual-cell': { file: `${manual}images/virtual-cell.png`, shownBy: `${manual}first-hour.md` },
  calibration: { file: `${manual}images/calibration.png`, shownBy: `${manual}visualisation-latency.md` },
  'operations-headsets': { file: `${manual}images/operations-headsets.png`, shownBy: `${manual}operations.md` },
  operations: { file: `${manual}images/operations.png`, shownBy: `${manual}operations.md` },
};

/** Puts a fake gateway into the state that the picture shows: an active fault, a lost headset and a fault that has ended. */
export function setState(gateway) {
  // Corresponds to a tool error of 2 mm at a distance of 0.48 m from the rotation axis.
  gateway.turned = 0.004;
  // The fixture is at (0.3, 0, 0) m.
  gateway.stationary = ['fixture'];
  gateway.moving = { workpiece_1: [0.1, -0.35, 0.1] };
  const reason = 'refused: the router does not know this machine';
  const since = seconds => new Date(NOW - 1000 * seconds).toISOString();
  for (const joint of gateway.state.joints) joint.since_utc = since(3600);
  gateway.state.status = { level: 'error', text: `adapter belt is not connected: ${reason} (and 1 more)`, since_utc: since(95) };
  gateway.state.events = [
    { id: 3, kind: 'headset', which: 'right door', what: 'is lost', reason: '', level: 'warning', since_utc: since(8) },
    { id: 2, kind: 'adapter', which: 'belt', what: 'is not connected', reason, level: 'error', since_utc: since(95) },
    {
      id: 1, kind: 'joint', which: 'arm_joint_3 (press)', what: 'is stale', reason: 'samples stopped arriving', level: 'error',
      since_utc: since(600), until_utc: since(590),
    },
  ];
}

/** Opens the operations page of a fake gateway at the fixed time, and waits for state, headsets and recordings. */
export async function openOperations(browser, gateway, viewport) {
  const context = await browser.newContext({ viewport, timezoneId: 'UTC', locale: 'en-GB' });
  const page = await context.newPage();
  await page.clock.setFixedTime(NOW);
  await page.goto(gateway.address);
  const [{ name: recording }] = gateway.recordings;
  await page.waitForFunction(recording => document.querySelector('#clock').textContent !== '–'
    && document.querySelector('#headsets').textContent.includes('right door')
    && document.querySelector('#recordings').textContent.includes(recording), recording);
  return page;
}

/** Returns the texts of the page's visible elements without their numbers; null while the view of the robot does not show both distances. */
function readTexts() {
  const distances = document.querySelector('#robot .apart');
  if (distances && !/\d mm.*\d mm/.test(distances.textContent.replace(/\s/g, ' '))) return null;
  // Keeps the numbers of names such as arm_joint_1. A live distance is given as "about" or "less than" a number, depending on its size.
  const number = /(?<![\p{L}\d_])[-−]?\d(?:[\d.,:\u202f]*\d)?/gu;
  const textOf = element => (element === distances ? element.textContent.replace(/\b(?:about|less than)\s/g, '') : element.textContent)
    .replaceAll('\u00ad', '').replace(number, '…').replace(/\s+/g, ' ').trim();
  const texts = [...document.querySelectorAll('h1, h2, h3, caption, th, td, dt, dd, summary, label, button, p, li')]
    .filter(element => element.checkVisibility() && !element.matches('.legend li')).map(element => [element, textOf(element)])
    // A value and its unit without other words cannot become outdated.
    .filter(([element, text]) => (element.matches('td, dd') ? /\p{L}{3}/u : /\p{L}/u).test(text)).map(([, text]) => text);
  return [...new Set(texts)];
}

/** Returns the texts of a page: headings, labels, sentences and cells that contain words. Numbers are replaced by "…". */
export const textsOf = async page => (await page.waitForFunction(readTexts)).jsonValue();
