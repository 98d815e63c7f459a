/** Splits the nodes of a request into parts that the server accepts. */
export class RequestParts {
  /** @param size Maximum number of nodes per request. It is halved if the server does not accept it. */
  constructor(public size = Infinity) {}

  /** Sends a request for each part of the nodes, one after another. Returns the results of all nodes. */
  async each<T>(nodes: string[], request: (part: string[]) => Promise<T[]>): Promise<T[]> {
    const results: T[] = [];
    while (results.length < nodes.length) {
      const part = nodes.slice(results.length, results.length + this.size);
      try {
        results.push(...(await request(part)));
      } catch (error) {
        if (!String(error).includes('BadTooManyOperations') || part.length === 1) throw error;
        this.size = Math.ceil(part.length / 2);
      }
    }
    return results;
  }
}
