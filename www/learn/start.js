// The first script of the chapters' pages, inside the page, before anything is painted: the theme, and the head and scenes
// that come one a frame. The build gives its element the address of the module (`data-first`), which figures load when they
// come near.
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
      const next = document.querySelector(':is(header.head, .scene):not([data-open])');
      const isLoading = document.readyState === 'loading';
      // The head or a scene of which only a part has come waits for the rest, which would move what is seen.
      if (next?.nextElementSibling || !isLoading) next?.setAttribute('data-open', '');
      if (next || isLoading) requestAnimationFrame(open);
      else delete page.dataset.opening;
    };
    requestAnimationFrame(open);
  }
}
