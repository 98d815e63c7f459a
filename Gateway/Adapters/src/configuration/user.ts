import type { Configuration } from './configuration';
import { secretIn } from './secret';
import type { YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

/** User name and password for the login at a control system or a broker. */
export interface User {
  name: string;
  password: string;
}

/** The environment variable with the password of the plants that share one. */
const SHARED = 'NOWPOSE_PLANT_PASSWORD';

/** Gets the environment variable with the password of a plant, so that no plant receives the password of another one. */
const variableOf = (plant: string): string => `${SHARED}_${plant.toUpperCase().replaceAll('-', '_')}`;

/**
 * Gets the user in the section plant.user; null if it has no name. The password, which is not logged, comes from a file or from the environment,
 * which all plants of a gateway have in common.
 */
export function userIn(
  file: YamlFile,
  user: { name?: string; password_file?: string; shared_password?: true } | undefined,
  configuration: Configuration,
  environment: NodeJS.ProcessEnv,
): User | null {
  if (user?.name === undefined) return null;
  const at = ['plant', 'user', 'password_file'] as const;
  const variable = user.shared_password === true ? SHARED : variableOf(configuration.plant.name);
  const password = user.password_file === undefined ? environment[variable] : secretIn(file, at, user.password_file);
  if (user.password_file === undefined && variable !== SHARED) configuration.passwordVariable = variable;
  if (password === undefined) file.report(at, configurationMessages.noPassword(variable, SHARED));
  if (user.password_file !== undefined && user.shared_password === true) file.report(at, configurationMessages.twoPasswords);
  configuration.secrets.push(password ?? '');
  return { name: user.name, password: password ?? '' };
}
