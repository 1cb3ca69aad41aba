// What is said of the element to other programs, from its one list of attributes: types, also for React, Vue and Svelte, and
// the manifest of elements that editors read.
import { ATTRIBUTES } from '../../www/element/attributes.js';
import { DESCRIPTIONS, EVENTS, MEMBERS } from '../../www/element/descriptions.js';

const TAG = 'synthetica-linkage';

const quoted = (words) => words.map((word) => `'${word}'`).join(' | ');

/** What its property gives and takes. */
const typeOf = ({ type, words, many, read }) => (words && !many ? quoted([...(words.includes(read(null)) ? [] : ['']), ...words]) : type);

/** What it is where it is absent, as a value of its property. */
const standard = ({ read, type }) => (type === 'string' ? `'${[read(null)].flat().join(' ')}'` : String(read(null)));

const plain = (text) => text.replace(/\[(.*?)\]\(.*?\)/g, '$1');

const field = (name, type, text, { optional = false, readonly = false } = {}) => `  /** ${plain(text)} */\n  ${readonly ? 'readonly ' : ''}${name}${optional ? '?' : ''}: ${type};\n`;

/** Types of attributes and events, for element.d.ts. */
export const attributeTypes = () => `/**
 * The attributes of <${TAG}>, as its properties, and its events.
 */
/** \`where\` is the place in the document; empty where the document is not at fault. */
export interface LinkageError {
  message: string;
  where: string;
  code: string;
}

export interface LinkageAttributes {
${Object.entries(ATTRIBUTES).map(([name, attribute]) => field(name, typeOf(attribute), DESCRIPTIONS[name])).join('')}}

export interface LinkageEventMap {
${Object.entries(EVENTS).map(([name, { when, detail }]) => field(name, `CustomEvent<${detail}>`, when)).join('')}}
`;

/** What a framework's template may give it beside its attributes. */
const GIVEN = `Partial<LinkageAttributes & Pick<SyntheticaLinkage, 'currentTime' | 'playbackRate'>> & { document?: MechanismDocument | string | null; linkage?: MechanismDocument | string | null }`;

const head = (where, use) => `/**
 * <${TAG}> in ${where}: \`import type {} from 'synthetica/${use}'\`, once in the program.
 */
import type { LinkageAttributes, LinkageEventMap, SyntheticaLinkage } from './element.js';
import type { MechanismDocument } from './types.js';

type Given = ${GIVEN};
`;

/** Declarations for frameworks: names of files and their text. */
export const frameworkTypes = () => ({
  'react.d.ts': `${head('the JSX of React 19', 'react')}import type { DetailedHTMLProps, HTMLAttributes } from 'react';

/** An event's listener is a property of its name behind \`on\`, as it is written: \`onframechange\`. */
type Heard = { [Name in keyof LinkageEventMap as \`on\${Name}\`]?: (event: LinkageEventMap[Name]) => unknown };

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      '${TAG}': Omit<DetailedHTMLProps<HTMLAttributes<SyntheticaLinkage>, SyntheticaLinkage>, keyof Given> & Given & Heard;
    }
  }
}
`,
  'vue.d.ts': `${head('templates of Vue', 'vue')}import type { HTMLAttributes, PublicProps } from 'vue';

type Heard = { [Name in keyof LinkageEventMap as \`on\${Capitalize<Name>}\`]?: (event: LinkageEventMap[Name]) => unknown };
type Element = new () => SyntheticaLinkage & {
  /** @deprecated Only for the types of templates. */
  $props: Omit<HTMLAttributes, keyof (Given & Heard)> & Given & Heard & PublicProps;
};

declare module 'vue' {
  interface GlobalComponents {
    '${TAG}': Element;
    SyntheticaLinkage: Element;
  }
}
`,
  'svelte.d.ts': `${head('Svelte', 'svelte')}import type { HTMLAttributes } from 'svelte/elements';

type Heard = { [Name in keyof LinkageEventMap as \`on\${Name}\`]?: (event: LinkageEventMap[Name]) => unknown };

declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    '${TAG}': Omit<HTMLAttributes<SyntheticaLinkage>, keyof (Given & Heard)> & Given & Heard;
  }
}
`,
});

/** custom-elements.json: https://github.com/webcomponents/custom-elements-manifest */
export function elementsManifest() {
  const description = plain;
  const attributes = Object.entries(ATTRIBUTES).map(([name, attribute]) => ({
    name, fieldName: name, type: { text: typeOf(attribute) }, default: standard(attribute), description: description(DESCRIPTIONS[name]),
  }));
  const fields = attributes.map(({ name, fieldName: _, ...rest }) => ({ kind: 'field', name, ...rest, attribute: name, reflects: true }));
  const others = Object.entries(MEMBERS).map(([name, { type, what, given, readonly }]) =>
    given === undefined
      ? { kind: 'field', name, type: { text: type }, ...(readonly && { readonly }), description: description(what) }
      : { kind: 'method', name, return: { type: { text: type } }, ...(given && { parameters: [parameter(given)] }), description: description(what) },
  );
  return {
    schemaVersion: '1.0.0',
    modules: [
      {
        kind: 'javascript-module',
        path: 'element.js',
        declarations: [
          {
            kind: 'class',
            name: 'SyntheticaLinkage',
            tagName: TAG,
            customElement: true,
            description: 'A spatial linkage with its motion, in the words of the media elements.',
            superclass: { name: 'HTMLElement' },
            attributes,
            members: [...fields, ...others],
            events: Object.entries(EVENTS).map(([name, { when, detail }]) => ({ name, type: { text: `CustomEvent<${detail}>` }, description: description(when) })),
            slots: [{ name: '', description: 'What is seen until the linkage is, and where no scripts run.' }],
            cssParts: ['bench', 'stage', 'view', 'controls', 'notices'].map((name) => ({ name })),
          },
        ],
        exports: [
          { kind: 'js', name: 'SyntheticaLinkage', declaration: { name: 'SyntheticaLinkage' } },
          { kind: 'custom-element-definition', name: TAG, declaration: { name: 'SyntheticaLinkage', module: 'element.js' } },
        ],
      },
    ],
  };
}

/** @param {string} given such as `options?: FocusOptions` */
function parameter(given) {
  const [, name, optional, text] = given.match(/^(\w+)(\?)?: (.*)$/);
  return { name, ...(optional && { optional: true }), type: { text } };
}
