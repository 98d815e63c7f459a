import type { Value } from '../configuration/values';
import type { Nanoseconds } from '../times';
import type { PlantValue } from './plantOutput';
import { refusalMessages } from '../messages/values';

interface Place {
  index: number;
  /** Names and indices from the message to the value; empty if the message is the value. */
  path: string[];
}

/** The numbers and Booleans of a configuration that arrive in the messages of topics. */
export class TopicValues {
  readonly #places = new Map<string, Place[]>();

  /**
   * @param values All values that are read; those without a topic are ignored.
   * @param field The field of values without one; null for the whole message.
   */
  constructor(values: readonly Value[], field: string | null = null) {
    values.forEach(({ address }, index) => {
      if (address.topic === undefined) return;
      const path = (address.field ?? field)?.split('.') ?? [];
      this.#places.set(address.topic, [...(this.#places.get(address.topic) ?? []), { index, path }]);
    });
  }

  /** Each topic once. */
  get topics(): string[] {
    return [...this.#places.keys()];
  }

  /** Gets the indices of the values of a topic. */
  indicesOf(topic: string): number[] {
    return (this.#places.get(topic) ?? []).map(({ index }) => index);
  }

  /** Gets the values in a message of a topic. */
  in(topic: string, message: unknown, stamp: Nanoseconds | null): PlantValue[] {
    return (this.#places.get(topic) ?? []).map(({ index, path }): PlantValue => {
      const value = fieldIn(message, path);
      if (value !== undefined) return { index, value, stamp };
      return { index, value, stamp, refusal: { reason: 'field', text: refusalMessages.noField(topic, path.join('.')) } };
    });
  }
}

/** Gets a part of a message; undefined if it is not there. */
export const fieldIn = (message: unknown, path: readonly string[]): unknown =>
  path.reduce((part, name) => (isObject(part) && Object.hasOwn(part, name) ? part[name] : undefined), message);

const isObject = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null;
