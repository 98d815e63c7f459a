// Defines the rule nowpose/messages: user-facing text of a product must be in its message catalogue, the folder `messages` of its sources.
// Justified exceptions are marked with eslint-disable-next-line and the reason.

const MAX_WORDS = 3;

/** Matches a word with the punctuation around it. Names with an underscore, paths and units of one letter do not count as words. */
const WORD = /^[([{"“‘'<]*((?:\p{L}[\p{L}’'\u00ad-]*\p{L}|[aAI]))[)\]}"”’'>.,:;?!…]*$/u;
const CAPITALISED = /^\p{Lu}\p{Ll}/u;

/** Matches an identifier, such as ArrowLeft. */
const IDENTIFIER = /\p{Ll}\p{Lu}/u;
const UNITS = new Set(['ms', 'µs', 'ns', 'mm', 'rad', 'Hz', 'kHz', 'kB', 'MB', 'ppm']);

const partsOf = text => text.split(/\s+/).filter(Boolean);

const wordsIn = text => partsOf(text).filter(part => WORD.test(part)).length;

/** Gets the words of a string without units and identifiers. */
const plainWords = text =>
  partsOf(text).map(part => WORD.exec(part)?.[1]).filter(word => word && !UNITS.has(word) && !IDENTIFIER.test(word));

const isSum = node => node?.type === 'BinaryExpression' && node.operator === '+';

/** Gets the text of an expression, with a digit in place of each inserted value. */
function textOf(node) {
  if (node.type === 'Literal' && typeof node.value === 'string') return node.value;
  if (node.type === 'TemplateLiteral') return node.quasis.map(({ value }) => value.cooked).join('0');
  return isSum(node) ? textOf(node.left) + textOf(node.right) : '0';
}

/** Functions and classes of the pages that show strings, each with the index of the first argument that is shown. */
const SHOWN_ARGUMENTS = {
  el: 2, term: 0, setText: 1, header: 0, row: 0, scrollable: 0, factTable: 0, statisticsTable: 0, textTable: 0, dataTable: 0, numbersOf: 0, trace: 0,
  LiveTable: 0, LivePlot: 0, fillText: 0, strokeText: 0, createTextNode: 0, append: 0, prepend: 0, replaceChildren: 0, alert: 0, confirm: 0,
};

/** Properties and attributes that are shown, and functions of a table's columns that return the text of a cell. */
const SHOWN_PROPERTIES = new Set([
  'alt', 'aria-description', 'aria-label', 'aria-roledescription', 'aria-valuetext', 'ariaLabel', 'caption', 'cell', 'claim', 'description', 'innerHTML',
  'innerText', 'label', 'placeholder', 'textContent', 'title', 'words', 'xLabel', 'yLabel',
]);

/** Properties and attributes with lists of words that are not shown. */
const TECHNICAL_PROPERTIES = new Set(['Authorization', 'class', 'className', 'cssText', 'd', 'font', 'labelFont', 'style', 'viewBox']);

/** Functions whose arguments are selectors, media queries or keys. */
const TECHNICAL_CALLS = new Set([
  'closest', 'getElementById', 'getItem', 'matches', 'matchMedia', 'querySelector', 'querySelectorAll', 'removeItem', 'setItem', 'setProperty',
]);

const nameOf = node => (node.type === 'MemberExpression' ? (node.computed ? '' : node.property.name) : (node.name ?? String(node.value ?? '')));

/** Returns whether the value of an expression is the value of its parent, so that the parent's use decides. */
function isPassedOn(node, parent) {
  switch (parent.type) {
    case 'ConditionalExpression': return node !== parent.test;
    case 'LogicalExpression': case 'ArrayExpression': case 'SpreadElement': case 'TemplateLiteral': return true;
    case 'TSAsExpression': case 'TSSatisfiesExpression': case 'TSNonNullExpression': return true;
    case 'ArrowFunctionExpression': return node === parent.body;
    case 'AssignmentPattern': return node === parent.right;
    default: return isSum(parent);
  }
}

/** Returns the use of an argument. */
function useOfArgument(node, { callee, arguments: passed }) {
  const index = passed.indexOf(node), name = nameOf(callee);
  if (index < 0) return 'other';
  if (name === 'setAttribute') return index === 0 ? 'technical' : useOfProperty(nameOf(passed[0]));
  if (TECHNICAL_CALLS.has(name) || (callee.type === 'MemberExpression' && nameOf(callee.object) === 'classList')) return 'technical';
  return Object.hasOwn(SHOWN_ARGUMENTS, name) && index >= SHOWN_ARGUMENTS[name] ? 'shown' : 'other';
}

const useOfProperty = name => (SHOWN_PROPERTIES.has(name) ? 'shown' : TECHNICAL_PROPERTIES.has(name) ? 'technical' : 'other');

/** Returns how a string is used: shown to the user, technical (such as a selector or a key), or other. */
function useOf(node) {
  const { parent } = node;
  if (isPassedOn(node, parent)) return useOf(parent);
  switch (parent.type) {
    case 'Property': return node === parent.key ? 'technical' : useOfProperty(nameOf(parent.key));
    case 'PropertyDefinition': return node === parent.key ? 'technical' : useOfProperty(nameOf(parent.key));
    case 'AssignmentExpression': return isDataset(parent.left) ? 'technical' : useOfProperty(nameOf(parent.left));
    case 'CallExpression': case 'NewExpression': return useOfArgument(node, parent);
    case 'BinaryExpression': case 'SwitchCase': case 'MemberExpression': return 'technical';
    case 'ImportDeclaration': case 'ExportNamedDeclaration': case 'ExportAllDeclaration': case 'ImportExpression': return 'technical';
    case 'TSLiteralType': case 'ExpressionStatement': return 'technical';
    default: return 'other';
  }
}

const isDataset = target => target.type === 'MemberExpression' && nameOf(target.object) === 'dataset';

/** Returns whether a string is a text: a shown one that has a word, or another one that has a capitalised word or words and spaces. */
function isText(text, use) {
  const words = plainWords(text);
  if (use === 'technical' || words.length === 0) return false;
  return use === 'shown' || /\s/.test(text) || CAPITALISED.test(words[0]);
}

export const messages = {
  meta: {
    type: 'problem',
    docs: { description: 'User-facing text belongs in the message catalogue' },
    messages: {
      long: 'This text has {{words}} words; up to {{most}} are allowed here. Move it to the message catalogue (a folder messages).',
      text: 'This text can be visible to users. Move it to the message catalogue (a folder messages).',
    },
    schema: [{
      type: 'object',
      properties: { isPage: { description: 'Whether the sources are those of pages, where also short texts are not allowed', type: 'boolean' } },
      additionalProperties: false,
    }],
    defaultOptions: [{ isPage: false }],
  },
  create(context) {
    const [{ isPage }] = context.options;
    const check = node => {
      if (isSum(node.parent)) return;
      const text = textOf(node), words = wordsIn(text);
      if (words > MAX_WORDS) context.report({ node, messageId: 'long', data: { words, most: MAX_WORDS } });
      else if (isPage && isText(text, useOf(node))) context.report({ node, messageId: 'text' });
    };
    return { Literal: check, TemplateLiteral: check, BinaryExpression: node => isSum(node) && check(node) };
  },
};
