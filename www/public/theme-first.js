// Sets the chosen colour scheme before anything is painted; view/theme.js goes on from here.
try {
  const theme = localStorage.getItem('synthetica.theme');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage is forbidden: the system's scheme.
}
