/** A font as esbuild puts it into a bundle: in base64. */
declare module '*.ttf' {
  const font: string;
  export default font;
}
