/** What was asked for makes no sense: one sentence for the user, the same as on the command line. */
export class CoreError extends Error {
  override readonly name = "CoreError";
}

/** The core has broken down, which is a mistake in it or a lack of memory; load another. */
export class CoreBroken extends Error {
  override readonly name = "CoreBroken";
}
