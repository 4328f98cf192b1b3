// The first script of the chapters' pages, inside the page: the theme, before anything is painted. The build gives its
// element the address of the module (`data-first`), which figures load when they come near.
{
  let theme;
  try {
    theme = localStorage.getItem('bubblestone.theme');
  } catch {
    // Storing is forbidden: the system's theme.
  }
  document.documentElement.dataset.theme = theme || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
}
