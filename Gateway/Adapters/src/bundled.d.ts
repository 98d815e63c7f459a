// For an import of a .urdf file, the bundler inserts the text of the file.
declare module '*.urdf' {
  const text: string;
  export default text;
}

// For this import, the bundler inserts the schema of the configuration, and for each kind of plant a function that checks its file.
declare module 'plant.schema' {
  import type { ValidateFunction } from 'ajv';
  import type { Described } from './configuration/schemaCheck';
  import type { KindName } from './configuration/plantFile';
  export const schema: Described & { $defs: Record<string, Described> };
  export const checks: Record<KindName, ValidateFunction>;
}
