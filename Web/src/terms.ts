import { el } from './dom';
import { glossary } from './messages/glossary';
import { termLabels } from './messages/terms';

/** Text of the tooltip of each term, by the term in lower case. */
const meanings = new Map(
  Object.entries(glossary).flatMap(([entry, meaning]) => entry.split(', ').map(name => [name.toLowerCase(), `${entry}: ${meaning}`] as const)),
);
const ANY = new RegExp(`\\b(${[...meanings.keys()].join('|')})\\b`, 'i');

/**
 * Returns a label that shows an explanation on hover: the label's own meaning, or the meaning of the first glossary term in the label.
 * @param own Meanings of the page's own labels.
 */
export function term(label: string, own: Record<string, string> = {}): Node | string {
  if (Object.keys(own).includes(label)) return el('abbr', { title: own[label] }, label);
  const found = ANY.exec(label);
  if (!found) return label;
  const [name] = found;
  const explained = el('abbr', { title: meanings.get(name.toLowerCase()) }, name);
  return name === label ? explained : el('span', {}, label.slice(0, found.index), explained, label.slice(found.index + name.length));
}

/** Appends a list of the explained terms to a page, because keyboards and touch screens do not show the explanations on hover. */
export function listTerms(page: HTMLElement): void {
  const found = new Map([...page.querySelectorAll('abbr')].map(({ textContent, title }) => [textContent!, title]));
  const names = [...found.keys()].sort((a, b) => a.localeCompare(b));
  const list = el('dl', {}, ...names.flatMap(name => [el('dt', {}, name), el('dd', {}, found.get(name)!)]));
  if (names.length === 0) return;
  const footer = page.querySelector('footer') ?? page.appendChild(el('footer'));
  footer.append(el('details', { class: 'terms' }, el('summary', {}, termLabels.list), list));
}
