import type { DataValue } from 'node-opcua-client';
import type { Value } from '../configuration/values';
import { statusRefusal } from './nodeValues';
import type { ReadOnlySession } from './readOnlySession';
import { nodeMessages } from '../messages/opcua';

/** Units of the configuration, by UNECE's codes as OPC UA encodes them (OPC 10000-8), and by symbols for a server that states no code. */
const UNITS: Record<string | number, string> = {
  17476: 'deg',
  4405297: 'rad',
  5066068: 'mm',
  5067858: 'm',
  '°': 'deg',
  deg: 'deg',
  rad: 'rad',
  mm: 'mm',
  m: 'm',
};

const ANGLES = ['deg', 'rad'];

interface EngineeringUnits {
  unitId?: number;
  displayName?: { text?: string | null } | null;
}

/**
 * Compares the units of the configuration with those that the server states in the property EngineeringUnits of the nodes.
 * @param ids Node ids on the server, by the node ids in the configuration.
 * @returns The differences with the remedy; null if there are none. Nodes without the property, and units that a configuration cannot have, are ignored.
 */
export async function unitNotice(
  session: Pick<ReadOnlySession, 'properties'>,
  values: readonly Value[],
  ids: ReadonlyMap<string, string>,
): Promise<string | null> {
  const found = await session.properties([...ids.values()], 'EngineeringUnits');
  const stated = new Map([...ids.keys()].map((node, i) => [node, unitIn(found[i])]));
  const different = new Map<string, { stated: string; unit: string; nodes: Set<string> }>();
  for (const { path, address, unit } of values) {
    const other = stated.get(address.node!);
    if (unit === undefined || other === undefined || other === unit) continue;
    // An array with a position and angles has only one property.
    if (path[0] === 'frames' && ANGLES.includes(unit) !== ANGLES.includes(other)) continue;
    const group = different.get(`${other} ${unit}`) ?? { stated: other, unit, nodes: new Set() };
    group.nodes.add(address.node!);
    different.set(`${other} ${unit}`, group);
  }
  const texts = [...different.values()].map(group => nodeMessages.otherUnit(group.stated, group.unit, [...group.nodes]));
  return texts.length === 0 ? null : texts.join('; ');
}

function unitIn(property: DataValue | null): string | undefined {
  if (property === null || statusRefusal(property) !== null) return undefined;
  const { unitId, displayName } = (property.value.value ?? {}) as EngineeringUnits;
  return UNITS[unitId ?? -1] ?? UNITS[displayName?.text ?? ''];
}
