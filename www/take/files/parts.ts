/** A file that is being made. The browser may put finished parts aside, so memory holds only its end. */

/** The bytes of a part. */
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

/** A file that is written row by row. */
export interface RowWriter {
  /** Writes whole rows, from the top. */
  write(rows: Uint8Array): Promise<void>;
  finish(): Promise<Blob>;
}
