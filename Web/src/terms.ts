import { el } from './dom';
import { glossary } from './messages/glossary';

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
