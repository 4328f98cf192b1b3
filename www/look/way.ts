/** The two ways to compare, as the comparison uses them. */
import type { PictureHost } from '../picture/host';

/** A way to show the second picture. */
export interface Way {
  show(on: boolean): void;
  /** Shows this host, which has another recipe. */
  take(host: PictureHost, title: string): void;
  /** To be called after work on the second picture up to this stage. */
  worked(stage: string): void;
}
