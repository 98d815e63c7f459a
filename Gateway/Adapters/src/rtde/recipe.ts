/** Sizes in bytes of the data types of RTDE. */
const SIZE: Record<string, number> = {
  BOOL: 1,
  UINT8: 1,
  UINT32: 4,
  INT32: 4,
  UINT64: 8,
  DOUBLE: 8,
  VECTOR3D: 24,
  VECTOR6D: 48,
  VECTOR6INT32: 24,
  VECTOR6UINT32: 24,
};

/** A requested field, with its type in UR's guide. */
export interface Field {
  name: string;
  type: 'DOUBLE' | 'VECTOR6D' | 'UINT32' | 'INT32';
  /** Whether the field is omitted for controllers that do not have it. */
  isOptional?: boolean;
}

/** Source of the positions: measured by the encoders, or commanded by the controller. */
export type PositionSource = 'actual' | 'target';

/** Gets the requested fields. Inputs, outputs and the tool's data will be added when the gateway supports signals. */
export const fieldsOf = (source: PositionSource): Field[] => [
  { name: 'timestamp', type: 'DOUBLE' },
  { name: `${source}_q`, type: 'VECTOR6D' },
  { name: `${source}_qd`, type: 'VECTOR6D', isOptional: true },
  { name: 'runtime_state', type: 'UINT32', isOptional: true },
  { name: 'robot_mode', type: 'INT32', isOptional: true },
  { name: 'safety_mode', type: 'INT32', isOptional: true },
  { name: 'safety_status_bits', type: 'UINT32', isOptional: true },
];

/** The controller cannot provide the requested fields. Waiting alone does not help. */
export class RecipeError extends Error {}

/** The controller does not have these optional fields, which are then omitted. */
export class MissingFieldsError extends Error {
  constructor(readonly names: string[]) {
    super(`the controller does not have ${names.join(', ')}`);
  }
}

/** One data package. */
export interface Cycle {
  /** Seconds since the controller was started. */
  timestamp: number;
  positions: number[];
  /** Null if the controller does not provide them. */
  velocities: number[] | null;
  runtimeState: number | null;
  robotMode: number | null;
  safetyMode: number | null;
  safetyBits: number | null;
}

/** Decodes data packages according to the recipe confirmed by the controller. */
export class Recipe {
  readonly #offsets = new Map<string, { at: number; type: Field['type'] }>();
  readonly #id: number;
  readonly size: number;

  /**
   * @param reply Payload of the answer to the request: a recipe id and the types, in the order of the fields.
   * @throws RecipeError A field is missing or has another type.
   * @throws MissingFieldsError Optional fields are missing.
   */
  constructor(
    readonly fields: Field[],
    reply: Buffer,
    readonly source: PositionSource = 'actual',
  ) {
    const types = reply.toString('latin1', 1).replace(/\0+$/, '').split(',');
    if (reply.length < 2 || types.length !== fields.length)
      throw new RecipeError(
        `the controller answered the recipe of ${fields.length} fields with ${reply.length < 2 ? 0 : types.length} types; `
          + 'check that it is an RTDE server of protocol version 2',
      );
    const missing = fields.filter((_, i) => types[i] === 'NOT_FOUND');
    const needed = missing.find(field => field.isOptional !== true);
    if (needed !== undefined) throw new RecipeError(`the controller has no field ${needed.name}; update the controller's software`);
    const wrong = fields.findIndex((field, i) => types[i] !== field.type && types[i] !== 'NOT_FOUND');
    if (wrong >= 0)
      throw new RecipeError(
        `the controller's field ${fields[wrong].name} is ${printable(types[wrong])}, not ${fields[wrong].type}; `
          + "the adapter supports the type in UR's guide only; update this adapter or the controller",
      );
    if (missing.length > 0) throw new MissingFieldsError(missing.map(field => field.name));
    this.#id = reply[0];
    let at = 1;
    for (const { name, type } of fields) {
      this.#offsets.set(name, { at, type });
      at += SIZE[type];
    }
    this.size = at;
  }

  /** Decodes a data package; returns a description of the error if it is invalid. */
  decode(payload: Buffer): Cycle | string {
    if (payload.length !== this.size) return `a data package of ${payload.length} bytes; the recipe has ${this.size}`;
    if (payload[0] !== this.#id) return `a data package of recipe ${payload[0]}, not ${this.#id}`;
    const number = (name: string): number | null => {
      const field = this.#offsets.get(name);
      if (field === undefined) return null;
      if (field.type === 'DOUBLE') return payload.readDoubleBE(field.at);
      return field.type === 'INT32' ? payload.readInt32BE(field.at) : payload.readUInt32BE(field.at);
    };
    const vector = (name: string): number[] | null => {
      const field = this.#offsets.get(name);
      return field === undefined ? null : Array.from({ length: 6 }, (_, i) => payload.readDoubleBE(field.at + 8 * i));
    };
    const timestamp = number('timestamp')!;
    if (!Number.isFinite(timestamp) || timestamp < 0 || timestamp > MAX_S) return `a data package with timestamp ${timestamp} s`;
    return {
      timestamp,
      positions: vector(`${this.source}_q`)!,
      velocities: vector(`${this.source}_qd`),
      runtimeState: number('runtime_state'),
      robotMode: number('robot_mode'),
      safetyMode: number('safety_mode'),
      safetyBits: number('safety_status_bits'),
    };
  }
}

/** Maximum time since the start: a century. A larger number is not a valid time. */
const MAX_S = 3.2e9;

const printable = (type: string): string => (/^\w{1,20}$/.test(type) ? type : 'of an unknown type');
