// What the components of one page know of each other: the lens that is on it, and the player that it follows.
/** @import { Leader, Lens } from './types.js' */

/** @type {Lens | undefined} */
let lens;
/** @type {Leader | undefined} */
let leader;

export const hub = {
  // The lens on the page; none where there is none, or where it was taken off.
  get lens() {
    return lens?.host.isConnected ? lens : undefined;
  },
  set lens(mounted) {
    lens = mounted;
  },
  // The player whose cursor the lens follows: { id, step, over(model) }.
  get leader() {
    return leader;
  },
  set leader(player) {
    leader = player;
  },
};
