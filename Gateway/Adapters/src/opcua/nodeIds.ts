/** Server_NamespaceArray, which every OPC UA server has. */
export const NAMESPACES = 'ns=0;i=2255';

const BY_URI = /^nsu=([^;]+);(.*)$/s;

/** Whether an id names its namespace by URI, which stays what it is when a server's configuration changes; a number may not. */
export const isByUri = (node: string): boolean => BY_URI.test(node);

/**
 * The id as the server takes it, by its list of namespaces.
 * @returns Undefined where that has no such URI.
 */
export function byNumber(node: string, namespaces: readonly string[]): string | undefined {
  const match = BY_URI.exec(node);
  if (match === null) return node;
  // What would end the URI stands in it as %3B, and the percent sign as %25.
  const uri = match[1].replace(/%3B/gi, ';').replace(/%25/g, '%'), index = namespaces.indexOf(uri);
  return index < 0 ? undefined : `ns=${index};${match[2]}`;
}
