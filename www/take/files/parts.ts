/** A file in the making. The browser may move its parts out of memory, which holds only the end of the file. */

/** Bytes that are moved into one blob. */
const TOGETHER = 1 << 22;

export class FileParts {
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
