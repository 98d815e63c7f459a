// Draws the picture of the page of operations for the manual, of a cell that is made up: `npm run picture`.
import { fileURLToPath } from 'node:url';
import { Browser, WEBGL } from './test/browser.mjs';
import { FakeGateway } from './test/fakeGateway.mjs';

const SECONDS = 20;

/** As well as a headset compensates, at 0.48 m from the axis it turns about: 2 mm. */
const OFF_RADIANS = 0.004;

const gateway = await FakeGateway.start();
gateway.turned = OFF_RADIANS;
const reason = 'refused: the router does not know this machine';
gateway.state.status = { level: 'error', text: `adapter belt is not connected: ${reason} (and 1 more)` };
const since = seconds => new Date(Date.now() - 1000 * seconds).toISOString();
gateway.state.events = [
  { id: 3, kind: 'headset', which: 'right door', what: 'is lost', reason: '', level: 'warning', since_utc: since(8) },
  { id: 2, kind: 'adapter', which: 'belt', what: 'is not connected', reason, level: 'error', since_utc: since(95) },
  { id: 1, kind: 'joint', which: 'arm_joint_3 (press)', what: 'is stale', reason: 'samples stopped arriving', level: 'error', since_utc: since(600), until_utc: since(590) },
];
const browser = await Browser.start('operations', WEBGL);
try {
  const page = await browser.browser.newPage({ viewport: { width: 1280, height: 2560 } });
  await page.goto(gateway.address);
  await page.waitForTimeout(1000 * SECONDS);
  await page.waitForFunction(() => /about 2\d/.test(document.querySelector('.apart').textContent));
  await page.screenshot({
    path: fileURLToPath(new URL('../Packages/com.nowpose.mril/Documentation~/images/operations.png', import.meta.url)), fullPage: true,
    clip: { x: 0, y: 0, width: 1280, height: 2560 },
  });
} finally {
  await browser.stop();
  await gateway.stop();
}
