// Sets the light or dark theme: the visitor's choice, or else the system's. It runs before the first paint, so it is
// no module. www/base/theme.ts continues it.
{
  let chosen;
  try {
    chosen = localStorage.getItem('bubblestone.theme');
  } catch {
    // Without a storage, the system decides.
  }
  document.documentElement.dataset.theme = chosen || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
}
