/** Returns the names that two landmarks of the same kind share. A list of landmarks, which screen readers show, needs distinct names. */
export const repeatedLandmarks = page => page.evaluate(() => {
  const named = [...document.querySelectorAll('[role=region], section, nav, form, main, footer')].filter(e => e.checkVisibility())
    .map(e => e.getAttribute('aria-label') ?? document.getElementById(e.getAttribute('aria-labelledby'))?.textContent).filter(Boolean);
  return named.filter((name, i) => named.indexOf(name) < i);
});
