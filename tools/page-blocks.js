// Blocks of the site's pages that are made of the project's own files: examples, cards of samples, fields of documents, types, the element's words.
import { readFileSync } from 'node:fs';
import { frameTag, scriptTag } from '../www/app/files/codes.js';
import { ATTRIBUTES } from '../www/element/attributes.js';
import { DESCRIPTIONS, EVENTS, MEMBERS } from '../www/element/descriptions.js';
import { inGroups } from '../www/core/mechanism-groups.js';
import { addressOf } from './social.js';

const read = (path) => readFileSync(new URL(`../${path}`, import.meta.url), 'utf8');

/** Fenced blocks by name: the words within, a Markdown renderer for a line, an escape for HTML. */
export const blocks = { example, samples, fields, declarations, attributes, members, events };

/** The text of files of examples/pages: of a notebook its code cells, as they are typed. */
function example(files, inline, escape) {
  const typed = (text) => JSON.parse(text).cells.filter(({ cell_type: kind }) => kind === 'code').map(({ source }) => source.join('')).join('\n\n');
  const one = (file) => {
    const text = read(`examples/pages/${file}`).trimEnd();
    return `<p><code>${escape(file)}</code></p>\n<pre><code>${escape(file.endsWith('.ipynb') ? typed(text) : text)}</code></pre>\n`;
  };
  return files.map(one).join('');
}

/** A sample as code for other pages: pages/embed-codes.js writes whole addresses, where the build does not know the site's. */
function embed({ file, title }, escape) {
  const name = file.replace('.json', '');
  const frame = frameTag(addressOf(`embed.html?sample=${file}`), title, 420);
  const element = `<synthetica-linkage type="${name}" poster="${addressOf(`thumbnails/${name}.webp`)}" controls style="height: 420px"></synthetica-linkage>\n${scriptTag(addressOf('inline.js'))}`;
  const code = (what, text) => `<p>${what}</p>\n<pre aria-label="${what} of ${escape(title)}"><code>${escape(text)}</code></pre>`;
  return `<details class="embed"><summary>Embed<span class="sr"> ${escape(title)}</span></summary>\n${code('Frame', frame)}\n${code('Element', element)}\n</details>`;
}

/** Every sample with its picture, in groups. */
function samples(_, inline, escape) {
  const card = ({ file, title, line, mobility }) => {
    const { about } = JSON.parse(read(`www/mechanisms/${file}`));
    return `<li>
  <a class="picture" href="./?sample=${file}" tabindex="-1" aria-hidden="true"><img vite-ignore src="./thumbnails/${file.replace('.json', '.webp')}" alt="" width="480" height="320" loading="lazy" /></a>
  <h3>${escape(title)}</h3>
  <p class="line">${escape(line)}</p>
  <p>${escape(about)}</p>
  <p class="mobility">${mobility} ${mobility === 1 ? 'freedom' : 'freedoms'}</p>
  <p class="ways"><a href="./?sample=${file}">Open <span class="sr">${escape(title)} </span>in the applet</a> <a href="./mechanisms/${file}">Document<span class="sr"> of ${escape(title)}</span></a></p>
  ${embed({ file, title }, escape)}
</li>`;
  };
  const group = ({ heading, members }) => `<h2>${escape(heading)}</h2>\n<ul class="samples">\n${members.map(card).join('\n')}\n</ul>\n`;
  return inGroups(JSON.parse(read('www/mechanisms/index.json'))).map(group).join('');
}

/** The fields of parts of a document, out of the JSON Schema; `Document` is the whole. */
function fields(names, inline, escape) {
  const schema = JSON.parse(read('src/document/schema.json'));
  const partOf = (reference) => reference.replace('#/$defs/', '');
  const number = (x) => x.toLocaleString('en', { maximumFractionDigits: 9 }).replace('-', '−');

  const type = (field) => {
    if (field.$ref) {
      const name = partOf(field.$ref);
      const choice = schema.$defs[name].enum;
      return choice ? choice.map((value) => `<code>"${value}"</code>`).join(' ') : `<a href="#fields-${name}">${name.replace('Entry', '').replace(/(.)([A-Z])/g, '$1 $2').toLowerCase()}</a>`;
    }
    if (field.anyOf) return field.anyOf.map(type).join(' or ');
    if (field.enum) return field.enum.map((value) => `<code>"${value}"</code>`).join(' ');
    // That any number may be an expression is said once, in the text.
    const types = [field.type].flat().filter((t) => !(t === 'string' && isNumber(field))).map((t) => (t === 'array' ? `list of ${listed(field.items)}` : t));
    return types.join(' or ');
  };
  const isNumber = (field) => ['number', 'integer'].some((t) => field.type.includes(t));
  const listed = (items) => (items.anyOf ? `(${type(items)})` : type(items));
  const bounds = ({ minimum, maximum, minItems, maxItems, maxLength, type: kind = '' }) =>
    [
      minimum !== undefined && maximum !== undefined && (minimum === maximum ? `${minimum}` : `${number(minimum)} to ${number(maximum)}`),
      minItems !== undefined && (minItems === maxItems ? `${minItems} entries` : maxItems === undefined ? `at least ${minItems} entries` : `${minItems} to ${number(maxItems)} entries`),
      maxLength !== undefined && !isNumber({ type: kind }) && `up to ${number(maxLength)} characters`,
    ].filter(Boolean).join(', ');
  const standard = ({ default: value, $ref }) =>
    value === undefined ? '' : typeof value === 'object' && value !== null ? 'all defaults' : `<code>${escape(JSON.stringify(value))}</code>`;

  const table = (name) => {
    const part = name === 'Document' ? schema : schema.$defs[name];
    if (!part) throw new Error(`src/document/schema.json has no ${name}`);
    const rows = Object.entries(part.properties)
      // What must be there comes first, as a person would write it.
      .sort(([a], [b]) => (part.required?.includes(b) ?? false) - (part.required?.includes(a) ?? false))
      .map(([field, about]) => {
        const must = part.required?.includes(field);
        return `<tr><th scope="row"><code>${field}</code></th><td>${type(about)}</td><td>${must ? 'required' : standard(about)}</td><td>${inline(about.description)}${bounds(about) && ` <small>${bounds(about)}</small>`}</td></tr>`;
      });
    return `<div class="scroller fields" id="fields-${name}" tabindex="0" role="group" aria-label="Fields of ${name.replace('Entry', '')}">
<table><thead><tr><th scope="col">field</th><th scope="col">type</th><th scope="col">default</th><th scope="col">what</th></tr></thead>
<tbody>${rows.join('\n')}</tbody></table></div>\n`;
  };
  return names.map(table).join('');
}

/** Declarations of src/bind/wasm.d.ts as they stand there. */
function declarations(names, inline, escape) {
  const source = read('src/bind/wasm.d.ts');
  const one = (name) => {
    const found = source.match(new RegExp(`(?:/\\*\\*(?:[^*]|\\*(?!/))*\\*/\\n)?export (?:interface ${name}(?: extends \\w+)? \\{[^]*?\\n\\}|type ${name} = [^;]*;)`));
    if (!found) throw new Error(`src/bind/wasm.d.ts has no ${name}`);
    return found[0].replaceAll(/^export /gm, '');
  };
  return `<pre><code>${escape(names.map(one).join('\n\n'))}</code></pre>\n`;
}

/** @param {string} label @param {string[]} heads @param {string[][]} rows as HTML */
const table = (label, heads, rows) => `<div class="scroller" tabindex="0" role="group" aria-label="${label}">
<table><thead><tr>${heads.map((head) => `<th scope="col">${head}</th>`).join('')}</tr></thead>
<tbody>${rows.map(([first, ...rest]) => `<tr><th scope="row">${first}</th>${rest.map((cell) => `<td>${cell}</td>`).join('')}</tr>`).join('\n')}</tbody></table></div>\n`;

const code = (words, escape) => words.map((word) => `<code>${escape(word)}</code>`).join(' ');

/** The element's attributes, out of their one list. */
function attributes(_, inline, escape) {
  const rows = Object.entries(ATTRIBUTES).map(([name, { type, words, read }]) => {
    const standard = [read(null)].flat().join(' ');
    return [code([name], escape), words ? code(words, escape) : type === 'boolean' ? 'there or not' : type === 'number' ? 'number' : 'text', standard === '' || type === 'boolean' ? '' : code([String(standard)], escape), inline(DESCRIPTIONS[name])];
  });
  return table('Attributes', ['attribute', 'accepted', 'without it', 'means'], rows);
}

/** Its properties that are no attributes, and its methods. */
function members(_, inline, escape) {
  const rows = Object.entries(MEMBERS).map(([name, { given, what, readonly }]) => [code([given === undefined ? name : `${name}(${given.replace(/\?? *:.*/, '')})`], escape), `${inline(what)}${readonly ? ' <small>to be read only</small>' : ''}`]);
  return table('Properties and methods', ['name', 'what'], rows);
}

/** Its events. */
function events(_, inline, escape) {
  return table('Events', ['event', 'when', '<code>detail</code>'], Object.entries(EVENTS).map(([name, { when, detail }]) => [code([name], escape), inline(when), detail === 'null' ? '' : code([detail === 'LinkageError' ? '{message, where, code}' : detail.replaceAll(/: \w+/g, '').replace(';', ',').replaceAll(/\{ | \}/g, (brace) => brace.trim())], escape)]));
}
