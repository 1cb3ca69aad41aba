/** The reference was one page once: an address within it leads to the page that has what it is the address of. */
function leadOn() {
  const at = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (at instanceof HTMLAnchorElement) location.replace(at.href);
}

addEventListener('hashchange', leadOn);
leadOn();
