import { gatewayReasons } from './messages/gateway';

/** Response of the gateway, or the reason why it did not respond. */
type Answer<T> = { value: T } | { trouble: string; status: number };

const PATIENCE_MS = 4000;

/** Returns a signal that aborts a request after a time in ms. Browsers before 2022 have no AbortSignal.timeout. */
export function abortAfter(ms: number): AbortSignal {
  const controller = new AbortController();
  setTimeout(() => controller.abort(), ms);
  return controller.signal;
}

/** Reason why no response arrives. After a change of a self-signed certificate, a browser refuses connections until the user accepts the new one. */
export const noAnswer = location.protocol === 'https:' ? gatewayReasons.noAnswerOrCertificate : gatewayReasons.noAnswer;

/** Returns the reason why a request was refused. The gateway states it as plain text, unlike for example a proxy. */
export async function reasonOf(response: Response): Promise<string> {
  const isPlain = response.headers.get('content-type')?.startsWith('text/plain');
  return (isPlain && (await response.text()).trim()) || gatewayReasons.notFromGateway(response.status);
}

/**
 * Sends a request to the gateway that serves this page.
 * @param fields Content of a POST request; absent for a GET request.
 */
export async function ask<T>(path: string, fields?: Record<string, string>): Promise<Answer<T>> {
  try {
    const response = await fetch(path, {
      cache: 'no-store',
      signal: abortAfter(PATIENCE_MS),
      ...(fields ? { method: 'POST', body: JSON.stringify(fields), headers: { 'Content-Type': 'application/json' } } : {}),
    });
    const isJson = response.headers.get('content-type')?.startsWith('application/json');
    if (response.ok && isJson) return { value: (await response.json()) as T };
    return { trouble: await reasonOf(response), status: response.status };
  } catch {
    return { trouble: noAnswer, status: 0 };
  }
}
