// The first script of the chapters' pages, inside the page, before anything is painted: the theme, and scenes that come one
// a frame. The build gives its element the address of the module (`data-first`), which figures load when they come near.
{
  const page = document.documentElement;
  let theme;
  try {
    theme = localStorage.getItem('bubblestone.theme');
  } catch {
    // Storing is forbidden: the system's theme.
  }
  page.dataset.theme = theme || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');

  // One layout of a whole chapter would block the page. With a place in the address, or on the way back, all is laid out at
  // once, because the browser scrolls there.
  const [navigation] = performance.getEntriesByType('navigation');
  if (!location.hash && navigation?.type === 'navigate') {
    page.dataset.opening = '';
    const open = () => {
      const next = document.querySelector('.scene:not([data-open])');
      next?.setAttribute('data-open', '');
      if (next || document.readyState === 'loading') requestAnimationFrame(open);
      else delete page.dataset.opening;
    };
    requestAnimationFrame(open);
  }
}
