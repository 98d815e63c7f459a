// The bundler puts the text in.
declare module '*.urdf' {
  const text: string;
  export default text;
}
