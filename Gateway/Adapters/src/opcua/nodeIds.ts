/** Node id of Server_NamespaceArray, which every OPC UA server has. */
export const NAMESPACES = 'ns=0;i=2255';

/** The null node id. No server has a node with this id. */
export const NO_NODE = 'ns=0;i=0';

const BY_URI = /^nsu=([^;]+);(.*)$/s;

/** Whether a node id contains its namespace as a URI. Unlike an index, a URI does not change with the server's configuration. */
export const isByUri = (node: string): boolean => BY_URI.test(node);

/**
 * Replaces the namespace URI in a node id with the index in the server's list of namespaces.
 * @returns The node id; undefined if the list does not contain the URI.
 */
export function byNumber(node: string, namespaces: readonly string[]): string | undefined {
  const match = BY_URI.exec(node);
  if (match === null) return node;
  // Decodes the URI, in which a semicolon is written as %3B and a percent sign as %25.
  const uri = match[1].replace(/%3B/gi, ';').replace(/%25/g, '%');
  const index = namespaces.indexOf(uri);
  return index < 0 ? undefined : `ns=${index};${match[2]}`;
}
