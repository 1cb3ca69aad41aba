/** The gallery's codes for other pages: with this site's whole address, and buttons that copy them. */
import { copyText, NOT_COPIED } from '../ui/copy.js';

const home = new URL('.', location.href).href;

for (const code of document.querySelectorAll('.embed code')) {
  code.textContent = (code.textContent ?? '').replaceAll('"./', `"${home}`);
  const block = code.closest('pre');
  const button = Object.assign(document.createElement('button'), { textContent: 'Copy' });
  const said = document.createElement('span');
  said.setAttribute('role', 'status');
  button.addEventListener('click', async () => {
    const copied = await copyText(code.textContent ?? '');
    if (!copied) getSelection()?.selectAllChildren(code);
    said.textContent = copied ? 'Copied.' : NOT_COPIED;
  });
  button.setAttribute('aria-label', `Copy ${block?.getAttribute('aria-label') ?? ''}`);
  const line = document.createElement('p');
  line.append(button, ' ', said);
  block?.after(line);
}
