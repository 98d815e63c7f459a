import type { Configuration } from './configuration';
import { secretIn } from './secret';
import type { YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/** User name and password for the login at a control system or a broker. */
export interface User {
  name: string;
  password: string;
}

/**
 * Gets the user in the section plant.user; null if it has no name. The password, which is not logged, comes from a file; without one, from the
 * environment, which all plants of a gateway have in common.
 */
export function userIn(
  file: YamlFile,
  user: { name?: string; password_file?: string } | undefined,
  configuration: Configuration,
  environment: NodeJS.ProcessEnv,
): User | null {
  if (user?.name === undefined) return null;
  const at = ['plant', 'user', 'password_file'] as const;
  const fromFile = user.password_file === undefined ? null : secretIn(file, at, user.password_file);
  const password = user.password_file === undefined ? environment.NOWPOSE_PLANT_PASSWORD : fromFile;
  if (password === undefined) file.report(at, configurationMessages.noPassword);
  configuration.secrets.push(password ?? '');
  return { name: user.name, password: password ?? '' };
}
