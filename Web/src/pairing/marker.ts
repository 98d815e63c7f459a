import { byId, el } from '../dom';
import { ask } from '../gateway';
import { pairingLabels, pairingMessages, pairingReasons } from '../messages/codes';
import { draw, setEdge } from './drawing';

interface Beginning {
  name: string;
  hosts: string[];
  has_pin: boolean;
}

interface Marker {
  text?: string;
  fault?: string;
}

/** Time after the last keystroke until the code is updated. */
const PAUSE_MS = 250;

/** Printable width of A4 paper with the margins of the common browsers. A browser reduces what is wider, without a message. */
const PAPER_MM = 185;

const field = (id: string) => byId<HTMLInputElement>(id).value;
const poseFields = () => [...document.querySelectorAll<HTMLInputElement>('[data-offset]')];

/** Number in a field, with a point and a hyphen: the keyboards of phones may offer only a comma and a minus sign. */
const numberIn = (input: HTMLInputElement) => input.value.trim().replace(',', '.').replace('\u2212', '-');
const size = () => numberIn(byId<HTMLInputElement>('size'));

/** Returns the names of the pose's fields that meet a condition, as text. */
const fieldsWith = (condition: (value: string) => boolean) =>
  poseFields()
    .filter(input => condition(numberIn(input)))
    .map(input => input.dataset.offset)
    .join(', ');

/** Pose of the marker as in its code; empty for a code without a pose. */
function offset(): string {
  const values = poseFields().map(numberIn);
  return values.every(value => value === '') ? '' : values.join(',');
}

let newest = 0;

/** Sets up the marker page: draws the code initially and after each change of the form, and prints it when the form is submitted. */
export async function startMarker(): Promise<void> {
  const form = byId<HTMLFormElement>('form');
  let pause = 0;
  form.addEventListener('input', () => {
    clearTimeout(pause);
    pause = window.setTimeout(() => void make(), PAUSE_MS);
  });
  form.addEventListener('submit', event => {
    event.preventDefault();
    void make().then(isMade => isMade && window.print());
  });
  const beginning = await ask<Beginning>('/pair/cell', { begin: '' });
  if ('trouble' in beginning) {
    fail(beginning.trouble);
    return;
  }
  byId<HTMLInputElement>('name').value = beginning.value.name;
  byId<HTMLInputElement>('host').value = beginning.value.hosts[0] ?? '';
  byId('hosts').append(...beginning.value.hosts.map(value => el('option', { value })));
  await make();
}

async function make(): Promise<boolean> {
  const own = ++newest;
  if (field('name') === '') return fail('');
  const invalid = fieldsWith(value => !Number.isFinite(Number(value)));
  if (invalid !== '') return fail(pairingReasons.poseInvalid(invalid));
  const empty = fieldsWith(value => value === '');
  if (offset() !== '' && empty !== '') return fail(pairingReasons.poseIncomplete(empty));
  const answer = await ask<Marker>('/pair/cell', { name: field('name'), host: field('host'), offset: offset(), size_mm: size() });
  // The user has changed the form since this request.
  if (own !== newest) return false;
  if ('trouble' in answer) return fail(answer.trouble);
  return answer.value.text ? show(answer.value.text) : fail(answer.value.fault ?? '');
}

function show(text: string): boolean {
  const drawing = draw(text);
  const widthMm = setEdge(drawing, Number(size()));
  byId('cell').replaceChildren(drawing.element);
  byId('caption').textContent = pairingLabels.marker(field('name'), size(), offset(), drawing.modules, text);
  byId('print').hidden = false;
  byId('fault').textContent = widthMm > PAPER_MM ? pairingMessages.wide(widthMm, Math.floor((Number(size()) * PAPER_MM) / widthMm)) : '';
  return true;
}

function fail(fault: string): false {
  byId('fault').textContent = fault;
  byId('print').hidden = true;
  return false;
}
