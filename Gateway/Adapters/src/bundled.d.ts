// The bundler inserts the text of the file.
declare module '*.urdf' {
  const text: string;
  export default text;
}

// The bundler inserts a function for each kind of plant that checks a configuration against plant.schema.json.
declare module 'plant.schema.checks' {
  import type { ValidateFunction } from 'ajv';
  export const opcua: ValidateFunction, ads: ValidateFunction, rtde: ValidateFunction, ros: ValidateFunction, broker: ValidateFunction;
}
