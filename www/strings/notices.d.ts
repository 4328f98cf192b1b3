/** The Japanese of src/notice/words.txt by code. The build provides it. */
declare module 'virtual:notices-ja' {
  const notices: Record<string, string>;
  export default notices;
}
