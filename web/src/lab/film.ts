// A canvas, filmed. The film lasts as long as the person lets it run.

export class Film {
  readonly #recorder: MediaRecorder;
  readonly #pieces: Blob[] = [];

  /** Whether this browser can film at all. */
  static get possible(): boolean {
    return typeof MediaRecorder !== "undefined" && "captureStream" in HTMLCanvasElement.prototype;
  }

  /** The film has the paper behind what is drawn: a canvas of its own takes each picture. */
  constructor(canvas: HTMLCanvasElement, paper: string) {
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const pen = copy.getContext("2d");
    this.#recorder = new MediaRecorder(copy.captureStream(30), { videoBitsPerSecond: 8_000_000 });
    this.#recorder.ondataavailable = ({ data }) => this.#pieces.push(data);
    const frame = () => {
      if (this.#recorder.state === "inactive") return;
      if (pen) {
        pen.fillStyle = paper;
        pen.fillRect(0, 0, copy.width, copy.height);
        pen.drawImage(canvas, 0, 0, copy.width, copy.height);
      }
      requestAnimationFrame(frame);
    };
    this.#recorder.start();
    frame();
  }

  end(): Promise<Blob> {
    return new Promise((resolve) => {
      this.#recorder.onstop = () => {
        resolve(new Blob(this.#pieces, { type: "video/webm" }));
      };
      this.#recorder.stop();
    });
  }
}
