/** A file in the making, which the browser may put aside part by part: memory holds its end only. */

/** Bytes that are put aside together. */
const TOGETHER = 1 << 22;

export class Parts {
  private readonly aside: Blob[] = [];
  private fresh: BlobPart[] = [];
  private size = 0;

  add(bytes: Uint8Array<ArrayBuffer>): void {
    this.fresh.push(bytes);
    this.size += bytes.length;
    if (this.size < TOGETHER) return;
    this.aside.push(new Blob(this.fresh));
    [this.fresh, this.size] = [[], 0];
  }

  file(type: string): Blob {
    return new Blob([...this.aside, ...this.fresh], { type });
  }
}

/** A file that is written row after row. */
export interface RowWriter {
  /** Whole rows from the top. */
  write(rows: Uint8Array): Promise<void>;
  finish(): Promise<Blob>;
}
