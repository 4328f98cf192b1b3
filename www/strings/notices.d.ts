/** The Japanese of src/notice/words.txt by code, which the build takes from there. */
declare module 'virtual:notices-ja' {
  const notices: Record<string, string>;
  export default notices;
}
