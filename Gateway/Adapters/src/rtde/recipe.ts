import type { Address } from '../configuration/values';
import { elementsOf, type FieldType, isFieldType } from './fieldTypes';
import { fieldMessages } from '../messages/rtde';

/** A requested field. */
export interface Field {
  name: string;
  /** Type in UR's guide; absent for a field from the configuration, which may have any type. */
  type?: FieldType;
  /** Whether the field may be missing. It is then omitted from the recipe. */
  isOptional?: boolean;
}

/** The address of a number. Its field is a name. */
export type RtdeAddress = Address & { field?: string };

/** Source of the positions: measured by the encoders, or commanded by the controller. */
export type PositionSource = 'actual' | 'target';

/**
 * Gets the fields to request.
 * @param source Source of the published positions.
 * @param addresses Addresses of the configured frames and signals.
 */
export function fieldsOf(source: PositionSource, addresses: RtdeAddress[] = []): Field[] {
  const fields: Field[] = [
    { name: 'timestamp', type: 'DOUBLE' },
    ...(['actual', 'target'] as const).flatMap((of): Field[] => [
      { name: `${of}_q`, type: 'VECTOR6D', isOptional: of !== source },
      { name: `${of}_qd`, type: 'VECTOR6D', isOptional: true },
    ]),
    { name: 'runtime_state', type: 'UINT32', isOptional: true },
    { name: 'robot_mode', type: 'INT32', isOptional: true },
    { name: 'safety_mode', type: 'INT32', isOptional: true },
    { name: 'safety_status_bits', type: 'UINT32', isOptional: true },
  ];
  const known = new Set(fields.map(({ name }) => name));
  const others = new Set(addresses.map(({ field }) => field!).filter(name => !known.has(name)));
  return [...fields, ...[...others].map(name => ({ name, isOptional: true }))];
}

/** The error for a controller that cannot provide the required fields. Waiting does not help. */
export class RecipeError extends Error {}

/** The error for optional fields that the controller does not have. A new request must omit them. */
export class MissingFieldsError extends Error {
  constructor(readonly names: string[]) {
    super(fieldMessages.missing(names));
  }
}

/** The decoded fields of one data package, without those of frames and signals. */
export interface Cycle {
  /** Seconds since the controller was started. */
  timestamp: number;
  positions: number[];
  /** Velocities in rad/s; null if the controller does not provide them. */
  velocities: number[] | null;
  /** Commanded minus measured positions; null if the controller does not provide both. */
  deviations: number[] | null;
  runtimeState: number | null;
  robotMode: number | null;
  safetyMode: number | null;
  safetyBits: number | null;
}

/** Decodes data packages according to the recipe that the controller has confirmed. */
export class Recipe {
  readonly #fields = new Map<string, { at: number; type: FieldType }>();
  readonly #id: number;
  readonly size: number;

  /**
   * @param reply Payload of the response to the request: the recipe id, and the types in the order of the fields.
   * @throws RecipeError A required field is missing, or a field has another type.
   * @throws MissingFieldsError Optional fields are missing.
   */
  constructor(
    readonly fields: Field[],
    reply: Buffer,
    readonly source: PositionSource = 'actual',
  ) {
    const types = reply.toString('latin1', 1).replace(/\0+$/, '').split(',');
    if (reply.length < 2 || types.length !== fields.length)
      throw new RecipeError(fieldMessages.recipe(fields.length, reply.length < 2 ? 0 : types.length));
    const missing = fields.filter((_, i) => types[i] === 'NOT_FOUND');
    const needed = missing.find(field => field.isOptional !== true);
    if (needed !== undefined) throw new RecipeError(fieldMessages.needed(needed.name));
    const wrong = fields.findIndex(({ type }, i) => types[i] !== 'NOT_FOUND' && (type === undefined ? !isFieldType(types[i]) : types[i] !== type));
    if (wrong >= 0)
      throw new RecipeError(fieldMessages.otherType(fields[wrong].name, printable(types[wrong]), fields[wrong].type ?? fieldMessages.notType));
    if (missing.length > 0) throw new MissingFieldsError(missing.map(field => field.name));
    this.#id = reply[0];
    let at = 1;
    fields.forEach(({ name }, i) => {
      const type = types[i] as FieldType;
      this.#fields.set(name, { at, type });
      at += elementsOf(type).count * elementsOf(type).size;
    });
    this.size = at;
  }

  /** Gets the reason why the number at an address cannot be read; null if it can. */
  objectionTo({ field, index, bit }: RtdeAddress): string | null {
    const found = this.#fields.get(field!);
    if (found === undefined) return fieldMessages.unknown(field!);
    const { count, size, isWhole } = elementsOf(found.type);
    if (count === 1 && index !== undefined) return fieldMessages.oneNumber(field!);
    if (count > 1 && (index === undefined || index >= count)) return fieldMessages.index(field!, count);
    if (bit !== undefined && !isWhole) return fieldMessages.noBits(field!);
    return bit !== undefined && bit >= 8 * size ? fieldMessages.bit(field!, 8 * size) : null;
  }

  /** Gets the number at a valid address in a valid data package, with all bits. */
  read(payload: Buffer, { field, index = 0 }: RtdeAddress): number | bigint {
    const { at, type } = this.#fields.get(field!)!;
    const { size, read } = elementsOf(type);
    return read(payload, at + index * size);
  }

  /** Decodes a data package; returns a description of the error if it is invalid. */
  decode(payload: Buffer): Cycle | string {
    if (payload.length !== this.size) return fieldMessages.packageSize(payload.length, this.size);
    if (payload[0] !== this.#id) return fieldMessages.packageRecipe(payload[0], this.#id);
    const number = (name: string): number | null => (this.#fields.has(name) ? Number(this.read(payload, { field: name })) : null);
    const vector = (name: string): number[] | null =>
      this.#fields.has(name) ? Array.from({ length: 6 }, (_, index) => Number(this.read(payload, { field: name, index }))) : null;
    const timestamp = number('timestamp')!;
    if (!Number.isFinite(timestamp) || timestamp < 0 || timestamp > MAX_S) return fieldMessages.packageTime(timestamp);
    const [actual, target] = [vector('actual_q'), vector('target_q')];
    return {
      timestamp,
      positions: (this.source === 'actual' ? actual : target)!,
      velocities: vector(`${this.source}_qd`),
      deviations: actual && target && target.map((position, i) => position - actual[i]),
      runtimeState: number('runtime_state'),
      robotMode: number('robot_mode'),
      safetyMode: number('safety_mode'),
      safetyBits: number('safety_status_bits'),
    };
  }
}

/** Maximum time since the start of the controller, in s: a century. A larger number is not a valid time. */
const MAX_S = 3.2e9;

const printable = (type: string): string => (/^\w{1,20}$/.test(type) ? type : fieldMessages.unknownType);
