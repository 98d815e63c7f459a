// Compares the units of a configuration with those that an OPC UA server states in the property EngineeringUnits.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { startProcess, until } from '../program.mjs';
import { DataType, DataValue, EUInformation, StatusCodes, Variant } from './library.mjs';
import { adapterFor, OPEN, serverFor } from './plant.mjs';
import { YoubotServer } from './server.mjs';

const { nodeMessages } = messages;

const { unitNotice } = await parts('opcua/engineeringUnits');

const node = name => `ns=1;s=${name}`;

describe('differences of units', () => {
  const property = units => new DataValue({ value: new Variant({ dataType: DataType.ExtensionObject, value: new EUInformation(units) }) });
  const noticeOf = (values, ...properties) => unitNotice(
    { properties: async nodes => nodes.map((_, i) => properties[i]) }, values.map(([section, node, unit]) => ({ path: [section, 0], address: { node }, unit })),
    new Map([...new Set(values.map(([, node]) => node))].map(node => [node, node])));
  const [millimetre, metre, radian] = [5066068, 5067858, 4405297].map(unitId => property({ unitId }));

  for (const [name, values, properties, expected] of [
    ['SeveralNodes', [['joints', 'i=1', 'deg'], ['joints', 'i=1', 'deg'], ['joints', 'i=2', 'deg']], [radian, radian], ['rad', 'deg', ['i=1', 'i=2']]],
    ['JointInAnotherQuantity', [['joints', 'i=1', 'rad']], [metre], ['m', 'rad', ['i=1']]],
    ['PositionAndAnglesInOneArray', [['frames', 'i=1', 'm'], ['frames', 'i=1', 'deg']], [millimetre], ['mm', 'm', ['i=1']]],
    ['EqualUnits', [['joints', 'i=1', 'mm'], ['frames', 'i=2', 'm']], [millimetre, metre], null],
    ['OtherUnits', [['joints', 'i=1', 'rad'], ['joints', 'i=2', 'rad']], [property({ unitId: 4403765 }), property({ displayName: 'counts' })], null],
    ['ValuesWithoutUnit', [['joints', 'i=1', undefined], ['signals', 'i=2', undefined]], [radian, millimetre], null],
    ['NoReadableProperty', [['joints', 'i=1', 'rad'], ['joints', 'i=2', 'rad'], ['joints', 'i=3', 'rad']],
      [null, new DataValue({ statusCode: StatusCodes.BadUserAccessDenied }), new DataValue({ value: new Variant({ dataType: DataType.Null }) })], null],
  ])
    it(`Notice_${name}_${expected === null ? 'IsNone' : 'NamesNodesUnitsAndRemedy'}`, async () =>
      assert.equal(await noticeOf(values, ...properties), expected && nodeMessages.otherUnit(...expected)));
});

describe('engineering units of an OPC UA server', () => {
  let server;
  before(async () => { server = await new YoubotServer().start(); });
  after(() => server.stop());

  for (const [name, launch] of [['Modules', undefined], ['Bundle', startProcess]])
    it(`Adapter_${name}ReadInOtherUnitsThanTheServerStates_HasANoticeWithNodesUnitsAndRemedy`, async t => {
      const joints = [{ joint: 'a', node: node('axis_1_deg') }, { joint: 'b', node: node('gripper_mm'), unit: 'm', scale: -1 }, { joint: 'c', node: node('arm_joint_2') }];
      const { bridge, run } = await adapterFor(t, server, OPEN, joints, launch && { launch });

      const notice = [nodeMessages.otherUnit('deg', 'rad', [node('axis_1_deg')]), nodeMessages.otherUnit('mm', 'm', [node('gripper_mm')])].join('; ');
      await until(() => bridge.state?.notice === notice, () => `${notice}: ${JSON.stringify(bridge.state)}`);
      assert.equal(bridge.status.level, 1);
      const lines = () => run.err.split('\n').filter(line => line.includes(notice)).length;
      // The output of another process arrives by another way than its state.
      await until(() => lines() > 0, () => run.err);
      assert.equal(lines(), 1);
    });

  it('Adapter_ServerRefusesSeveralBrowsePathsPerRequest_ReadsTheUnitsOfAllNodesInOneRequest', async t => {
    const limited = await serverFor(t, { pathsPerCall: 1 });
    const { bridge } = await adapterFor(t, limited, OPEN, [{ joint: 'a', node: node('axis_1_deg') }, { joint: 'b', node: node('gripper_mm'), unit: 'm', scale: -1 }]);

    await until(() => bridge.state?.notice?.includes(node('gripper_mm')), () => JSON.stringify(bridge.state));
    assert.deepEqual([limited.asked.get('TranslateBrowsePathsToNodeIdsRequest'), limited.largestRead], [3, 2]);
  });
});
