import { gatewayReasons } from '../messages/gateway';

/** Response of the gateway, or one line with the reason for a missing response. */
export type Answer<T> = { value: T } | { trouble: string };

export interface ShownCode {
  text: string;
  left_s: number;
  /** Part of the gateway's key that the headset shows when it asks the wearer for consent; empty without encryption. */
  key: string;
}

export interface Beginning {
  name: string;
  hosts: string[];
  has_pin: boolean;
}

export interface Marker {
  text?: string;
  fault?: string;
}

/** Sends a request to the gateway that serves this page. */
export async function ask<T>(what: 'code' | 'cell', fields: Record<string, string>): Promise<Answer<T>> {
  try {
    const response = await fetch(`/pair/${what}`, {
      method: 'POST',
      body: JSON.stringify(fields),
      headers: { 'Content-Type': 'application/json' },
      cache: 'no-store',
    });
    return response.ok ? { value: (await response.json()) as T } : { trouble: (await response.text()).trim() };
  } catch {
    return { trouble: gatewayReasons.noAnswer };
  }
}
