// Runs first, within the page (vite.config.mjs): it waits for no other file, and nothing is painted before it.
{
  const kept = (name) => {
    try {
      return localStorage.getItem(`bubblestone.${name}`);
    } catch {
      return null;
    }
  };

  /** The link that the page will open: www/state/first.ts finds it exactly. A wrong guess costs time only. */
  const link = () => {
    const asked = location.hash.slice(1);
    try {
      const last = JSON.parse(kept('work'));
      return asked === '' && last.own ? String(last.recipe) : asked;
    } catch {
      return asked;
    }
  };

  // Light or dark, as it was chosen here or else as the system is. www/base/theme.ts goes on from here.
  document.documentElement.dataset.theme = kept('theme') || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');

  // The largest files: www/module/load.ts takes them when the page's scripts are here.
  const files = document.currentScript.dataset;
  const [, make = ''] = /\bmake=(\w+)/.exec(link()) ?? [];
  for (const href of (files[make] ?? files.first).split(' ')) {
    const early = document.createElement('link');
    const how = href.endsWith('.js') ? { rel: 'modulepreload' } : { rel: 'preload', as: 'fetch', crossOrigin: 'anonymous' };
    document.head.append(Object.assign(early, how, { href }));
  }
}
