import { gatewayReasons } from './messages/gateway';

/** Response of the gateway, or the reason why it did not respond. */
type Answer<T> = { value: T } | { trouble: string; status: number };

const PATIENCE_MS = 4000;

/**
 * Sends a request to the gateway that serves this page.
 * @param fields Content of a POST request; absent for a GET request.
 */
export async function ask<T>(path: string, fields?: Record<string, string>): Promise<Answer<T>> {
  const patience = new AbortController();
  const timer = setTimeout(() => patience.abort(), PATIENCE_MS);
  try {
    const response = await fetch(path, {
      cache: 'no-store',
      signal: patience.signal,
      ...(fields ? { method: 'POST', body: JSON.stringify(fields), headers: { 'Content-Type': 'application/json' } } : {}),
    });
    if (response.ok) return { value: (await response.json()) as T };
    return { trouble: (await response.text()).trim(), status: response.status };
  } catch {
    return { trouble: gatewayReasons.noAnswer, status: 0 };
  } finally {
    clearTimeout(timer);
  }
}
