import { describe, it } from 'node:test';
import { RuleTester } from 'eslint';
import { messages } from './messages.mjs';

RuleTester.describe = describe;
RuleTester.it = it;

const long = words => ({ errors: [{ messageId: 'long', data: { words, most: 3 } }] });

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
    { code: "label('the gateway does not answer')", ...long(5) },
    { code: 'label(`${name} does not answer within ${seconds} s, the gateway says`)', ...long(7) },
    { code: "label('the gateway ' + 'does not ' + 'answer')", ...long(5) },
    { code: 'label(`the gateway ${name}: ` + `no answer, ${reason}`)', ...long(4) },
    { code: "label('“a (new) gateway’s key”')", ...long(4) },
  ],
});

const onPage = code => ({ code, options: [{ isPage: true }] });
const shown = code => ({ ...onPage(code), errors: [{ messageId: 'text' }] });

new RuleTester().run('messages of a page', messages, {
  valid: [
    "el('p', { class: 'level warning', role: 'note' }, name)",
    "el('label', {}, `${labels.speed} `, select)",
    "el('a', { href: `#fig-${number}` }, '(', name, ')')",
    "setText(line, `${hop}: ${meaning}`)",
    "setText(line, `${value} ms`)",
    "line.className = isGood ? 'level ok' : `level ${level}`",
    "line.classList.toggle('Level', isShown)",
    "line.setAttribute('aria-label', description)",
    "style.font = `600 ${size}px system-ui, sans-serif`",
    "svg('path', { d: 'M0 0h1v1h-1z', style: `stroke: var(${ink}); fill: none` })",
    "document.querySelector('section label')",
    "matchMedia('(prefers-reduced-motion: reduce)')",
    "document.body.dataset.state = 'not synchronised'",
    "fetch(path, { method: 'POST', headers: { 'Content-Type': 'application/json', Authorization: `Bearer ${token}` } })",
    "if (event.key === 'Enter') send()",
    "const moves = { ArrowLeft: back, 'holds partly': 'partly' }",
    "level = item => (item.isOver ? 'over' : item.level)",
    "import { el } from './Dom files/dom'",
    "format(value, 'mm')",
    "type = 'std_msgs/msg/String'",
  ].map(onPage),
  invalid: [
    "el('p', {}, 'ended')",
    "el('p', {}, isOver ? 'ended' : state)",
    "el('p', { title: 'error' })",
    "el('div', { 'aria-label': `shown ${name}` })",
    "setText(line, 'ended')",
    "setText(line, `host ${name}`)",
    "setText(line, [host && 'host'])",
    "line.textContent = 'ended'",
    "line.setAttribute('aria-label', 'plot')",
    "document.title = `${name} · Nowpose`",
    "new LiveTable('joints', columns)",
    "columns = [{ label: 'age' }]",
    "columns = [{ cell: item => (item.isOver ? 'ended' : item.state) }]",
    "header(...labels, 'signal')",
    "chart = new Chart({ yLabel: 'speed (mm/s)' })",
    "words = 'No alarm.'",
    "words = 'Play'",
    "words = 'OUT OF RANGE'",
    "words = 'Uncom\u00adpensated'",
    "words = count + ' samples'",
    "words = isFar ? ` or ${name}` : ''",
    "function title(first = 'Name') {}",
    "throw new Error('too many frames')",
  ].map(shown),
});
