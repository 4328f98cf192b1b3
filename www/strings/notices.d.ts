/** The Japanese of the tables in src/notice by code. The build provides it. */
declare module 'virtual:notices-ja/*' {
  const notices: Record<string, string>;
  export default notices;
}
