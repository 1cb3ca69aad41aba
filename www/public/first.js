// What comes before anything is painted.

// The applet in a frame is a page of its own, which must know who is around it: it would be told of this page instead.
if (/[?&]embed(?=[=&]|$)/.test(location.search)) {
  const origin = /[?&]origin=/.test(location.search) || !document.referrer ? '' : `&origin=${new URL(document.referrer).origin}`;
  location.replace(`./embed.html${location.search}${origin}${location.hash}`);
}

// The chosen colour scheme; app/theme.js goes on from here.
try {
  const theme = localStorage.getItem('synthetica.theme');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage is forbidden: the system's scheme.
}
