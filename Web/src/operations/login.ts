import { byId } from '../pairing/elements';
import { ask } from './state';

// Whether somebody logged in here: the cookie itself no script can see.
const REMEMBERED = 'nowpose-logged-in';

/** The form that asks for a token where the gateway does. */
export class Login {
  private readonly form = byId<HTMLFormElement>('login');
  private readonly token = byId<HTMLInputElement>('token-text');

  /** @param changed Called when the browser has logged in or out. */
  constructor(changed: () => void) {
    this.form.addEventListener('submit', event => {
      event.preventDefault();
      void this.logIn(changed);
    });
    byId('logout').addEventListener('click', () => void this.logOut(changed));
    this.remember(this.isRemembered());
  }

  /** @param isNeeded Whether the gateway refused to tell anything. */
  show(isNeeded: boolean): void {
    if (this.form.hidden === !isNeeded) return;
    // What has the focus is about to go: it would begin at the top of the page again.
    if (!isNeeded && this.form.contains(document.activeElement)) byId('content').focus();
    this.form.hidden = !isNeeded;
    if (isNeeded) this.remember(false);
  }

  private async logIn(changed: () => void): Promise<void> {
    const answer = await ask<{ role: string }>('login', { token: this.token.value });
    const trouble = 'trouble' in answer ? answer.trouble : '';
    byId('login-fault').textContent = trouble;
    if (trouble) return this.token.select();
    this.token.value = '';
    this.remember(true);
    changed();
  }

  private async logOut(changed: () => void): Promise<void> {
    await ask('logout', {});
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
