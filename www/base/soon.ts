/**
 * Runs work in pieces without waiting for a frame in between. Input, messages and frames that are due come before the
 * next piece. Messages are used because browsers delay nested timers by four milliseconds.
 */

let channel: MessageChannel | undefined;
const waiting: (() => void)[] = [];

/** Calls a function after the tasks that are already in the queue. */
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
