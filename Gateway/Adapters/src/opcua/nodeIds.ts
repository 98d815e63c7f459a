/** Server_NamespaceArray, which every OPC UA server has. */
export const NAMESPACES = 'ns=0;i=2255';

const BY_URI = /^nsu=([^;]+);(.*)$/s;

/** Whether an id has its namespace as a URI, which does not change with the server's configuration, unlike a number. */
export const isByUri = (node: string): boolean => BY_URI.test(node);

/**
 * Gets the id with the namespace index of the server's list.
 * @returns Undefined if the list does not contain the URI.
 */
export function byNumber(node: string, namespaces: readonly string[]): string | undefined {
  const match = BY_URI.exec(node);
  if (match === null) return node;
  // A semicolon in the URI is written as %3B, and the percent sign as %25.
  const uri = match[1].replace(/%3B/gi, ';').replace(/%25/g, '%');
  const index = namespaces.indexOf(uri);
  return index < 0 ? undefined : `ns=${index};${match[2]}`;
}
