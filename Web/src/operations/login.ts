import { byId } from '../dom';
import { ask } from '../gateway';

// Key that records a login in this browser, because scripts cannot read the cookie.
const REMEMBERED = 'nowpose-logged-in';

/** The login form, which is shown if the gateway requires a token. */
export class Login {
  private readonly form = byId<HTMLFormElement>('login');
  private readonly token = byId<HTMLInputElement>('token-text');

  /** @param changed Called after the user has logged in or out. */
  constructor(changed: () => void) {
    this.form.addEventListener('submit', event => {
      event.preventDefault();
      void this.logIn(changed);
    });
    byId('logout').addEventListener('click', () => void this.logOut(changed));
    this.remember(this.isRemembered());
  }

  /** @param isNeeded Whether the gateway refused the request. */
  show(isNeeded: boolean): void {
    if (this.form.hidden === !isNeeded) return;
    // Moves the focus before the focused element is hidden. Otherwise, the focus would move to the top of the page.
    if (!isNeeded && this.form.contains(document.activeElement)) byId('content').focus();
    this.form.hidden = !isNeeded;
    if (isNeeded) this.remember(false);
  }

  private async logIn(changed: () => void): Promise<void> {
    const answer = await ask<{ role: string }>('/operations/login', { token: this.token.value });
    const trouble = 'trouble' in answer ? answer.trouble : '';
    byId('login-fault').textContent = trouble;
    if (trouble) return this.token.select();
    this.token.value = '';
    this.remember(true);
    changed();
  }

  private async logOut(changed: () => void): Promise<void> {
    await ask('/operations/logout', {});
    this.remember(false);
    changed();
  }

  private isRemembered(): boolean {
    return sessionStorage.getItem(REMEMBERED) !== null;
  }

  private remember(isIn: boolean): void {
    if (isIn) sessionStorage.setItem(REMEMBERED, '');
    else sessionStorage.removeItem(REMEMBERED);
    byId('logout').hidden = !isIn;
  }
}
