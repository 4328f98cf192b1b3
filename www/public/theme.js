// Light or dark, as it was chosen here or else as the system is: worked out before anything is painted, so this is no
// module. www/base/theme.ts goes on from here.
{
  let chosen;
  try {
    chosen = localStorage.getItem('bubblestone.theme');
  } catch {
    // Without a storage it is the system's.
  }
  document.documentElement.dataset.theme = chosen || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
}
