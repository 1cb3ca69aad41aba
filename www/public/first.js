// What comes before anything is painted.

// The applet in a frame is a page of its own.
if (/[?&]embed(?=[=&]|$)/.test(location.search)) location.replace(`./embed.html${location.search}${location.hash}`);

// The chosen colour scheme; view/theme.js goes on from here.
try {
  const theme = localStorage.getItem('synthetica.theme');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage is forbidden: the system's scheme.
}
