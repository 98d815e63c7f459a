// Defines the rule nowpose/messages: user-facing text of a product must be in its message catalogue, the folder `messages` of its sources.
// Justified exceptions are marked with eslint-disable-next-line and the reason.

const MAX_WORDS = 3;

/** Matches a word with the punctuation around it. Names with an underscore, paths and units of one letter do not count as words. */
const WORD = /^[([{"“‘'<]*(?:\p{L}[\p{L}’'-]*\p{L}|[aAI])[)\]}"”’'>.,:;?!…]*$/u;

export const wordsIn = text => text.split(/\s+/).filter(part => WORD.test(part)).length;

const isSum = node => node?.type === 'BinaryExpression' && node.operator === '+';

/** Gets the text of an expression, with a digit in place of each inserted value. */
function textOf(node) {
  if (node.type === 'Literal' && typeof node.value === 'string') return node.value;
  if (node.type === 'TemplateLiteral') return node.quasis.map(({ value }) => value.cooked).join('0');
  return isSum(node) ? textOf(node.left) + textOf(node.right) : '0';
}

export const messages = {
  meta: {
    type: 'problem',
    docs: { description: 'Strings of four words or more belong in the message catalogue' },
    messages: { text: 'This text has {{words}} words; up to {{most}} are allowed here. Move it to the message catalogue (a folder messages).' },
    schema: [],
  },
  create(context) {
    const check = node => {
      if (isSum(node.parent)) return;
      const words = wordsIn(textOf(node));
      if (words > MAX_WORDS) context.report({ node, messageId: 'text', data: { words, most: MAX_WORDS } });
    };
    return { Literal: check, TemplateLiteral: check, BinaryExpression: node => isSum(node) && check(node) };
  },
};
