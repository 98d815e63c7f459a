import type { Value } from '../configuration/values';
import type { Nanoseconds } from '../times';
import type { PlantValue } from './plantOutput';
import { refusalMessages } from '../messages/values';

interface Place {
  index: number;
  /** Names and indices that lead from the message to the value; empty if the message itself is the value. */
  path: string[];
}

/** The configured values that arrive in messages of topics. */
export class TopicValues {
  readonly #places = new Map<string, Place[]>();

  /**
   * @param values All values that are read. Values without a topic are ignored.
   * @param field Default field of a value; null if the message itself is the value by default.
   */
  constructor(values: readonly Value[], field: string | null = null) {
    values.forEach(({ address }, index) => {
      if (address.topic === undefined) return;
      const path = pathOf(address.field ?? field ?? []);
      this.#places.set(address.topic, [...(this.#places.get(address.topic) ?? []), { index, path }]);
    });
  }

  /** The topics, each once. */
  get topics(): string[] {
    return [...this.#places.keys()];
  }

  /** Gets the indices of the values of a topic. */
  indicesOf(topic: string): number[] {
    return (this.#places.get(topic) ?? []).map(({ index }) => index);
  }

  /** Gets the values from a message of a topic. */
  in(topic: string, message: unknown, stamp: Nanoseconds | null): PlantValue[] {
    return (this.#places.get(topic) ?? []).map(({ index, path }): PlantValue => {
      const value = fieldIn(message, path);
      if (value !== undefined) return { index, value, stamp };
      return { index, value, stamp, refusal: { reason: 'field', text: refusalMessages.noField(topic, fieldText(path)) } };
    });
  }
}

/** Gets the names and indices that lead to a field, which the configuration has as one text with dots, or as a list. */
export const pathOf = (field: string | readonly (string | number)[] = []): string[] =>
  typeof field === 'string' ? field.split('.') : field.map(String);

/** Gets the text of a path for messages, in which a name with a dot has quotation marks. */
export const fieldText = (path: readonly string[]): string => path.map(name => (name.includes('.') ? `"${name}"` : name)).join('.');

/** Gets a part of a message by its path; undefined if the message does not have it. */
export const fieldIn = (message: unknown, path: readonly string[]): unknown =>
  path.reduce((part, name) => (isObject(part) && Object.hasOwn(part, name) ? part[name] : undefined), message);

const isObject = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null;
