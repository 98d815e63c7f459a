import { describe, it } from 'node:test';
import { RuleTester } from 'eslint';
import { messages } from './messages.mjs';

RuleTester.describe = describe;
RuleTester.it = it;

const text = words => ({ errors: [{ messageId: 'text', data: { words, most: 3 } }] });

new RuleTester().run('messages', messages, {
  valid: [
    "label('Clocks in use')",
    'label(`${count} lines are missing`)',
    "font = '600 12px system-ui, sans-serif'",
    "type = 'sensor_msgs/msg/JointState geometry_msgs/msg/Pose std_msgs/msg/String tf2_msgs/msg/TFMessage'",
    'total = a + b + c + d',
    'pattern = /one or two or three/',
  ],
  invalid: [
    { code: "label('the gateway does not answer')", ...text(5) },
    { code: 'label(`${name} does not answer within ${seconds} s, the gateway says`)', ...text(7) },
    { code: "label('the gateway ' + 'does not ' + 'answer')", ...text(5) },
    { code: 'label(`the gateway ${name}: ` + `no answer, ${reason}`)', ...text(4) },
    { code: "label('“a (new) gateway’s key”')", ...text(4) },
  ],
});
