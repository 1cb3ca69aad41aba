/** The gallery's codes for other pages: with this site's whole address, and buttons that copy them. */
const home = new URL('.', location.href).href;

for (const code of document.querySelectorAll('.embed code')) {
  code.textContent = (code.textContent ?? '').replaceAll('"./', `"${home}`);
  const block = code.closest('pre');
  const button = Object.assign(document.createElement('button'), { textContent: 'Copy' });
  const said = document.createElement('span');
  said.setAttribute('role', 'status');
  button.addEventListener('click', async () => {
    const copied = await navigator.clipboard?.writeText(code.textContent ?? '').then(() => true, () => false);
    if (!copied) getSelection()?.selectAllChildren(code);
    said.textContent = copied ? 'Copied.' : 'This browser does not let pages copy: it is chosen, copy it with Ctrl+C.';
  });
  button.setAttribute('aria-label', `Copy ${block?.getAttribute('aria-label') ?? ''}`);
  const line = document.createElement('p');
  line.append(button, ' ', said);
  block?.after(line);
}
