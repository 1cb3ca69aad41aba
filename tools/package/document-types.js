// The TypeScript types of a document, from its JSON Schema.

/** Names as the page has them (www/core/types.js). */
const name = (definition) => ({ KeyFrameEntry: 'KeyFrame', MotionEntry: 'MotionSpec', PlannerEntry: 'PlannerSpec', LimitsEntry: 'Limit' })[definition] ?? definition.replace(/Entry$/, '');

function type(schema) {
  const { $ref, anyOf, enum: words, items, type: kind } = schema;
  if ($ref) return name($ref.replace('#/$defs/', ''));
  if (anyOf) return anyOf.map(type).join(' | ');
  // Open to any text, so that a document that is imported as JSON fits; completion still knows the words.
  if (words) return [...words.map((word) => JSON.stringify(word)), '(string & {})'].join(' | ');
  if (Array.isArray(kind)) return kind.map((one) => type({ ...schema, type: one })).join(' | ');
  if (kind === 'array') return type(items).includes(' ') ? `(${type(items)})[]` : `${type(items)}[]`;
  return kind === 'integer' ? 'number' : kind;
}

const remark = ({ description = '' }, margin) => `${margin}/** ${description.replaceAll('\n', ' ')} */\n`;

function declaration(title, schema) {
  if (!schema.properties) return `${remark(schema, '')}export type ${title} = ${type(schema)};\n`;
  const members = Object.entries(schema.properties).map(
    ([key, value]) => `${remark(value, '  ')}  ${key}${schema.required?.includes(key) ? '' : '?'}: ${type(value)};\n`,
  );
  return `${remark(schema, '')}export interface ${title} {\n${members.join('')}}\n`;
}

/** @param {any} schema */
export const documentTypes = (schema) =>
  [['MechanismDocument', schema], ...Object.entries(schema.$defs).map(([key, value]) => [name(key), value])].map(([title, value]) => declaration(title, value)).join('\n');
