/**
 * Work in pieces, without a frame in between. Input, messages and frames that wait come before the next piece. A timer in a
 * timer would wait for four milliseconds.
 */

let channel: MessageChannel | undefined;
const waiting: (() => void)[] = [];

/** Calls a function after the tasks that wait already. */
export function soon(act: () => void): void {
  channel ??= opened();
  waiting.push(act);
  channel.port2.postMessage(0);
}

function opened(): MessageChannel {
  const ports = new MessageChannel();
  ports.port1.onmessage = () => waiting.shift()?.();
  return ports;
}
