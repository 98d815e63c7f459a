import { el } from '../dom';

/** Formats text with subscripts for symbols such as T_s, t_k and L_app, as in the paper. */
export function text(words: string): (Node | string)[] {
  return words.split(/(?<![A-Za-z])([TtLε]_[a-zA-Z]+)/).map(part => {
    const [symbol, index] = part.split('_');
    return /^[TtLε]_[a-zA-Z]+$/.test(part) ? el('span', { class: 'symbol' }, symbol, el('sub', {}, index)) : part;
  });
}
