import { byId } from '../dom';
import { ask } from '../gateway';

/** The login form, which is shown if the gateway requires a token, and the button that logs out. */
export class Login {
  private readonly form = byId<HTMLFormElement>('login');
  private readonly token = byId<HTMLInputElement>('token-text');
  isLoggedIn = false;

  /** @param changed Called after the user has logged in or out. */
  constructor(changed: () => void) {
    this.form.addEventListener('submit', event => {
      event.preventDefault();
      void this.logIn(changed);
    });
    byId('logout').addEventListener('click', () => void this.logOut(changed));
  }

  /**
   * @param isNeeded Whether the gateway refused the request.
   * @param isLoggedIn Whether this browser has logged in. The gateway reports it, because scripts cannot read the cookie.
   */
  show(isNeeded: boolean, isLoggedIn: boolean): void {
    this.isLoggedIn = isLoggedIn;
    const logOut = byId('logout');
    const isLogOutFocused = document.activeElement === logOut;
    logOut.hidden = !isLoggedIn;
    if (this.form.hidden === !isNeeded) return;
    // Moves the focus before the focused element is hidden. Otherwise, the focus would move to the top of the page.
    if (!isNeeded && this.form.contains(document.activeElement)) byId('content').focus();
    this.form.hidden = !isNeeded;
    if (isNeeded && isLogOutFocused) this.token.focus();
  }

  private async logIn(changed: () => void): Promise<void> {
    const answer = await ask<{ role: string }>('/operations/login', { token: this.token.value });
    const trouble = 'trouble' in answer ? answer.trouble : '';
    byId('login-fault').textContent = trouble;
    if (trouble) return this.token.select();
    this.token.value = '';
    changed();
  }

  private async logOut(changed: () => void): Promise<void> {
    await ask('/operations/logout', {});
    changed();
  }
}
