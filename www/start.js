// The first script, inside the page (vite.config.mjs): it waits for no other file, and runs before anything is painted.
{
  const kept = (name) => {
    try {
      return localStorage.getItem(`bubblestone.${name}`);
    } catch {
      return null;
    }
  };

  /** A guess of the link that the page will open; www/state/first.ts finds it exactly. A wrong guess only costs time. */
  const link = () => {
    const asked = location.hash.slice(1);
    try {
      const last = JSON.parse(kept('work'));
      return asked === '' && last.own ? String(last.recipe) : asked;
    } catch {
      return asked;
    }
  };

  // The theme that was chosen in this browser, else the system's. www/base/theme.ts handles later changes.
  document.documentElement.dataset.theme = kept('theme') || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');

  // The largest files. www/module/load.ts uses them once the page's scripts are loaded.
  const files = document.currentScript.dataset;
  const [, make = ''] = /\bmake=(\w+)/.exec(link()) ?? [];
  for (const href of (files[make] ?? files.first).split(' ')) {
    const early = document.createElement('link');
    const how = href.endsWith('.js') ? { rel: 'modulepreload' } : { rel: 'preload', as: 'fetch', crossOrigin: 'anonymous' };
    document.head.append(Object.assign(early, how, { href }));
  }
}
