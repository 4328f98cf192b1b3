/** The Japanese for the notices that only generators of the second module give. */
export { default as notices } from 'virtual:notices-ja/house';
