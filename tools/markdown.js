// Markdown of the site as HTML: formulas as MathML, headings with addresses, and blocks made of the project's own files.
import { tex } from '@mdit/plugin-tex';
import MarkdownIt from 'markdown-it';
import temml from 'temml';
import { blocks } from './page-blocks.js';
import { readable } from './readable-tables.js';

const escape = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** Wider than a phone, so that it scrolls, and therefore takes the focus. @param {string} source */
const isWide = (source) => /matrix|\\qquad/.test(source) || source.length > 70;

/** A formula; `\tag{21}` gives it the number and the address #eq-21. @param {string} source @param {boolean} display */
function formula(source, display) {
  const [, plain, number] = source.match(/^([^]*?)(?:\\tag\{(\w+)\})?\s*$/);
  // The policy of the pages forbids style attributes; style/pages.css has what is needed of them.
  const math = temml.renderToString(plain, { displayMode: display, throwOnError: true }).replace(/ style="[^"]*"/g, '');
  if (!display) return math;
  const scrolls = isWide(plain) ? ` tabindex="0" role="group" aria-label="${number ? `Equation ${number}` : 'Equation'}"` : '';
  const side = number ? `<span class="number">(${number})</span>` : '';
  return `<div class="equation"${number ? ` id="eq-${number}"` : ''}><div class="scroller"${scrolls}>${math}</div>${side}</div>\n`;
}

const md = new MarkdownIt({ html: true, typographer: true, quotes: '“”‘’' }).use(tex, { render: formula });
// Quotes and nothing else: (R) is a joint here.
md.disable('replacements');
const { rules } = md.renderer;
const code = rules.fence;

const textOf = (token) => token.children.map(({ content }) => content).join('');
const slug = (text) => text.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-').replaceAll(/^-|-$/g, '');

/** A heading some levels up. @param {string} tag @param {number} levels */
const raised = (tag, levels) => `h${Number(tag[1]) - levels}`;

md.core.ruler.push('addresses', ({ tokens, env }) => {
  tokens.forEach((token, i) => {
    if (token.type === 'heading_close') token.tag = raised(token.tag, env.raise);
    if (token.type !== 'heading_open') return;
    token.tag = raised(token.tag, env.raise);
    const id = slug(textOf(tokens[i + 1]));
    if (env.ids.has(id)) throw new Error(`Two headings have the address #${id}`);
    env.ids.add(id);
    token.attrSet('id', id);
    if (['h2', 'h3'].includes(token.tag)) env.contents.push({ id, level: token.tag, html: md.renderer.render(tokens[i + 1].children, md.options, { equations: [] }) });
  });
});

// "Eq. 21" leads to the equation, where the page has it.
rules.text = (tokens, i, options, env) =>
  escape(tokens[i].content).replace(/\bEq\. (\d+)/g, (words, number) => (env.equations.includes(number) ? `<a href="#eq-${number}">${words}</a>` : words));
rules.table_open = () => '<div class="scroller" tabindex="0" role="group" aria-label="Table">\n<table>\n';
rules.table_close = () => '</table>\n</div>\n';

/** A fenced block named as one of tools/page-blocks.js is made by it; any other is code. */
rules.fence = (tokens, i, options, env, self) => {
  const { info, content } = tokens[i];
  const make = blocks[info.trim()];
  if (make) return make(content.trim().split(/\s+/).filter(Boolean), (text) => md.renderInline(text, env), escape);
  return code(tokens, i, options, env, self);
};

/**
 * @typedef {{id: string, level: 'h2' | 'h3', html: string}} Heading
 * @param {string} source
 * @param {{raise?: number, ids?: Set<string>}} [how] levels by which headings are raised; addresses that pages have in common
 * @returns {{body: string, contents: Heading[]}}
 */
export function render(source, { raise = 0, ids = new Set() } = {}) {
  const env = { contents: [], ids, raise, equations: [...source.matchAll(/\\tag\{(\d+)\}/g)].map(([, number]) => number) };
  return { body: readable(md.render(source, env)), contents: env.contents };
}
