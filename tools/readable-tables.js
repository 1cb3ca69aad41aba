// Tables that are read on a phone too: there each row is a block (style/pages.css), in which a cell says its column, and
// which assistive programs still know as a table.

/** Every tag of a kind with a role, where it has none. @param {string} html @param {string} tag @param {string} role */
const withRole = (html, tag, role) => html.replaceAll(new RegExp(`<${tag}(?=[ >])(?![^>]* role=)`, 'g'), `<${tag} role="${role}"`);

/** Words without markup, for an attribute. @param {string} html */
const words = (html) => html.replaceAll(/<[^>]*>/g, '').replaceAll('"', '&quot;').trim();

/** @param {string} table */
function readableTable(table) {
  const [, head = '', body = ''] = table.match(/<thead[^>]*>([^]*?)<\/thead>([^]*)/) ?? [];
  if (!head) throw new Error(`A table has no headings: ${table.slice(0, 200)}`);
  const columns = [...head.matchAll(/<th[^>]*>([^]*?)<\/th>/g)].map(([, heading]) => words(heading));
  const rows = body.replaceAll(/<tr>([^]*?)<\/tr>/g, (_, cells) => {
    let column = 0;
    const labelled = cells.replaceAll(/<(td|th)(?=[ >])/g, (tag) => {
      const heading = columns[column++];
      return heading ? `${tag} data-column="${heading}"` : tag;
    });
    return `<tr role="row">${labelled}</tr>`;
  });
  const header = head.replaceAll('<tr>', '<tr role="row">').replaceAll(/<th(?=[ >])/g, '<th role="columnheader"');
  let whole = `<thead>${header}</thead>${rows}`;
  for (const [tag, role] of [['thead', 'rowgroup'], ['tbody', 'rowgroup'], ['td', 'cell'], ['th', 'rowheader']]) whole = withRole(whole, tag, role);
  return `<table role="table">${whole}`;
}

/** @param {string} html of a page */
export const readable = (html) => html.replaceAll(/<table>[^]*?<\/table>/g, readableTable);
