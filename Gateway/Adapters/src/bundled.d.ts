// For an import of a .urdf file, the bundler inserts the text of the file.
declare module '*.urdf' {
  const text: string;
  export default text;
}

// For this import, the bundler inserts one function per kind of plant that checks a configuration against plant.schema.json.
declare module 'plant.schema.checks' {
  import type { ValidateFunction } from 'ajv';
  export const opcua: ValidateFunction, ads: ValidateFunction, rtde: ValidateFunction, ros: ValidateFunction, broker: ValidateFunction;
}
