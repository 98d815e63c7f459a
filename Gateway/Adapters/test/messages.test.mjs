// Tests the wording of the adapters' message catalogue.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { faultsIn, textsOf } from '../../../.ci/lint/wording.mjs';
import { messages } from './messages.mjs';

/** An example value for each parameter of the functions in the catalogue. */
const samples = {
  address: 'node i=1, index 2', after: 0.1, alert: 'unknown ca', allowed: ['opcua', 'ads'], apartMm: 2.4, apartMs: 12.5, arms: ['ur5e', 'ur10e'], basis: 'observed', before: 812.3, bytes: 2e6, chain: ['a', 'b', 'a'],
  choice: 7, code: 'ENOENT', command: 3, count: 3, cure: 'Move it', day: '1970-01-20', depth: 17, description: 'the node is unknown', element: 'MAIN.axes[1]', endpoint: 'mqtt://b',
  entry: 'node', evidence: 'no value arrives', expected: 4, field: 'actual_q', fields: 9, file: 'own.der', folder: '/var/lib/pki', formats: 'DER or PEM', frame: 'table', from: '2024', gateway: 'this gateway', groupMs: '0.5', guess: 'opcua',
  host: 'plc', included: ['ur5e', 'youbot'], keyFile: 'own.pem', kind: 'joint', knowledge: 'no value arrives', label: 'part x', last: 2, length: 0.5, lifetime: 750, limit: 4.1, line: 12, localNetId: '1.2.3.4.1.1',
  maxMs: 1000, maxNorm: 1.001, meant: 'kind', minNorm: 0.999, mode: 'power off', most: 512, name: 'elbow', names: ['target_qd'], nodes: ['i=1', 'i=2'], namespace: 'arm1', namespaces: ['urn:a', 'urn:b'], needed: 'DOUBLE',
  parent: 'map', root: 'arm1/base_link', netId: '5.6.7.8.1.1', node: 'ns=2;s=Axis1', axis: 'x', metres: 2e6, norm: 2, number: 1e300, own: '0.2.0', part: 'key', path: '/etc/token', pin: 'sha256/AAAA', place: 'plant.yaml, line 4',
  policy: 'Basic256Sha256', port: 851, problem: 'the stream ended', problems: 'ns 7 is unknown', program: 'paused', publishingMs: 5, radians: 3.14159265, rateHz: 500, shared: 'NOWPOSE_PASSWORD', variable: 'NOWPOSE_PASSWORD_CELL', sources: ['table'], topics: ['/tf'], isRos1: false,
  read: 'joints a, b', reason: 'the disk is full', recipe: 2, remedy: 'wss://', request: 'WriteRequest', required: 9.6, samplingMs: 10, scale: 2,
  scheme: 'ws', seconds: 2, service: '/rosapi/get_time', sha1: '0a', sha256: '1b', silence: 150, similar: ['MAIN.axis1'], size: 48, source: 'tool0', stamp: 'its stamp', stated: 'deg',
  state: 'STOP', status: 'BadNodeIdUnknown', stepMs: 20, steps: 'its clock advances in steps', symbol: 'MAIN.axis1', tag: '!pin', text: 'a text', thumbprint: '0a',
  timestamp: 'source', to: '2025', topic: 'plant/tf', type: 'LREAL', types: 8, uncertainty: 'nothing confirms it', unit: 'rad/s²', value: 'opcu',
  version: '0.3.0', world: 'world',
};

describe('the message catalogue of the adapters', () => {
  for (const [name, text] of Object.entries(textsOf(messages, samples)))
    it(`has a well-formed text ${name}`, () => assert.deepEqual(faultsIn(text, false), [], text));

  it('states the value, its unit and what is allowed', () => {
    const { configurationMessages, refusalMessages, silenceMessages, rtdeMessages } = messages;

    assert.match(configurationMessages.notAllowed('opcu', 'opcua', ['opcua', 'ads']), /"opcu".*opcua\?.*opcua, ads$/);
    assert.match(refusalMessages.ahead(1500, 1000), /1\.5 s ahead.*1\.0 s$/);
    assert.match(refusalMessages.behind(750_000, 10_000), /12\.5 minutes behind.*10\.0 s$/);
    assert.match(silenceMessages.stopTooHard(9.61, 4.06, 'rad/s²', 'configured'), /9\.6 rad\/s².*4\.1 rad\/s².*max_deceleration/);
    assert.match(rtdeMessages.restarted(812.34, 0.12), /812\.3 s.*0\.1 s/);
  });

  it('names the probable time scale of a source', () => {
    const { ahead, behind } = messages.refusalMessages, hour = 3_600_000;

    assert.match(ahead(2 * hour + 70, 1000), /2\.0 hours ahead.*local time/);
    assert.match(behind(5.5 * hour - 1500, 10_000), /5\.5 hours behind.*local time/);
    assert.match(ahead(36_930, 1000), /36\.9 s ahead.*TAI/);
    assert.match(ahead(18_000, 1000), /18\.0 s ahead.*GPS time/);
    for (const text of [behind(37_000, 10_000), ahead(905_000, 1000), ahead(24 * hour, 1000), ahead(1500, 1000)]) assert.doesNotMatch(text, /probably/);
  });

  it('omits the parts whose values are unknown', () => {
    const { adsMessages, configurationMessages, frameMessages, symbolMessages } = messages;

    assert.doesNotMatch(configurationMessages.unknownEntry(undefined, ['kind']), /mean/);
    assert.match(adsMessages.noAnswer('plc', '1.2.3.4.1.1'), /1\.2\.3\.4\.1\.1/);
    assert.doesNotMatch(adsMessages.noAnswer('plc', null), /AMS Net Id/);
    assert.notEqual(symbolMessages.unknown('plant.yaml', 'a', []), symbolMessages.unknown('plant.yaml', 'a', undefined));
    assert.match(frameMessages.cycle('a', ['a', 'a'], 'world'), /its own parent/);
    assert.match(frameMessages.cycle('b', ['a', 'b', 'a'], 'world'), /a, b, a/);
  });
});
