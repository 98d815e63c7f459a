// Decides what happens to tests that need a program which a machine may not have.

/**
 * Gets the value of the test option `skip`. With NOWPOSE_CI, which .ci/run sets, they are not skipped, so that they fail without the program.
 * @param isThere Whether the program exists.
 * @param reason The reason for which the tests are skipped, with the remedy.
 */
export const skipWithout = (isThere, reason, { NOWPOSE_CI } = process.env) => {
  if (isThere) return false;
  if (NOWPOSE_CI) throw new Error(reason);
  return reason;
};
