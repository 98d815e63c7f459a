// Checks the wording of a product's message catalogue and of its HTML. Used by the tests of the products.

/** Gets the names of a function's parameters. */
const parametersOf = text => /^\(?([\w$,\s]*?)\)?\s*=>/.exec(text)?.[1].split(',').map(name => name.trim()).filter(Boolean);

/**
 * Gets the strings of a catalogue by their names.
 * @param catalogue The exports of the catalogue's files: objects that contain strings, and functions that return strings.
 * @param samples Sample values for the parameters of the functions; the keys are the names of the parameters.
 */
export function textsOf(catalogue, samples) {
  const texts = {};
  const add = (name, entry) => {
    if (typeof entry === 'string') texts[name] = entry;
    else if (typeof entry === 'object') for (const [key, value] of Object.entries(entry)) add(`${name}.${key}`, value);
    else if (typeof entry === 'function') {
      const parameters = parametersOf(String(entry));
      const missing = parameters.filter(parameter => !(parameter in samples));
      if (missing.length > 0) throw new Error(`${name} has the parameter ${missing.join(', ')}, for which the test has no sample`);
      texts[name] = entry(...parameters.map(parameter => samples[parameter]));
    }
  };
  for (const [name, entry] of Object.entries(catalogue)) if (typeof entry === 'object') add(name, entry);
  return texts;
}

const INVISIBLE = /<!--[^]*?-->|<(script|style)[^>]*>[^]*?<\/\1>/g;
const INLINE = /<\/?(?:a|abbr|code|em|strong)\b[^>]*>/g;
const ATTRIBUTE = /\b(?:title|aria-label|alt|placeholder)="([^"]*)"/g;

/** Gets the static strings of a page, including those in its attributes. */
export function textsOfPage(html) {
  const visible = html.replace(INVISIBLE, '');
  const attributes = [...visible.matchAll(ATTRIBUTE)].map(([, text]) => text);
  const contents = visible.replace(INLINE, '').split(/<[^>]*>/).map(text => text.replace(/\r?\n/g, ' ').trim());
  return [...attributes, ...contents].filter(text => /\p{L}/u.test(text));
}

const FAULTS = [
  [/undefined|\bnull\b|\bNaN\b|\[object|=>/, 'contains a missing value or a value that is not a string'],
  [/^\s|\s$|[\n\t]| {2}/, 'has an extra space or a line break'],
  [/ [,;:.?!](\s|$)/, 'has a space before a punctuation mark'],
  [/[,;:.?!]{2}/, 'has two punctuation marks in a row'],
  [/[.!] \p{Ll}/u, 'has a sentence that begins with a lower-case letter'],
  [/\b(\w{2,}) \1\b/, 'repeats a word'],
];

const count = (text, mark) => text.split(mark).length - 1;

/**
 * Returns descriptions of the formatting errors in a string.
 * @param isSentence Whether the string consists of complete sentences. If not, it is part of a sentence.
 */
export function faultsIn(text, isSentence) {
  const faults = FAULTS.filter(([pattern]) => pattern.test(text)).map(([, fault]) => fault);
  if (count(text, '(') !== count(text, ')') || count(text, '“') !== count(text, '”')) faults.push('has an unpaired bracket or quotation mark');
  if (isSentence && !/[.?!]$/.test(text)) faults.push('does not end with a full stop, question mark or exclamation mark');
  if (!isSentence && /[.,;:!]$/.test(text)) faults.push('is part of a sentence but ends with a punctuation mark');
  return faults;
}
