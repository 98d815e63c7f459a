import { type OwnCertificate } from './security/ownCertificate';
import { thumbprints, type TrustList } from './security/trustList';
import type { OpcUaSettings } from './settings';

/** The server refuses us, or we refuse the server. Waiting does not help; a user must act. */
export class Refused extends Error {}

export interface Trouble {
  isRefusal: boolean;
  text: string;
}

const CURES: [RegExp, (settings: OpcUaSettings, own: OwnCertificate) => string][] = [
  [
    /BadSecurityChecksFailed|BadCertificate|BadSecurityModeRejected/,
    (_, own) =>
      'the server does not trust this adapter; '
      + `accept the certificate ${own.file}, thumbprint ${thumbprints(own.getCertificate()).sha1}, at the server`,
  ],
  [
    /BadIdentityTokenRejected|BadUserAccessDenied/,
    settings =>
      settings.user
        ? `the server does not accept user ${settings.user.name}; see plant.user`
        : 'the server does not accept this user; set plant.user to a user with read access',
  ],
  [
    /cannot find an? endpoint|end point must exist/i,
    ({ security }) =>
      security.mode === 'none'
        ? 'the server offers no connection without security; remove plant.security.mode'
        : `the server offers no SignAndEncrypt with ${security.policy}; choose another plant.security.policy, or enable this policy at the server`,
  ],
  [/BadIdentityTokenInvalid|cannot find .*token/i, () => 'the server does not support this login; change plant.user'],
  [/BadTooManySessions|BadTcpNotEnoughResources/, () => 'the server has no free session; close a session of another client'],
];

/** Classifies the error of a connection attempt: whether to wait or to act. */
export function refusalOf(error: Error, trust: TrustList, settings: OpcUaSettings, own: OwnCertificate): Trouble {
  if (error instanceof Refused) return { isRefusal: true, text: error.message };
  if (trust.refusal !== null) return { isRefusal: true, text: trust.refusal };
  const cure = CURES.find(([pattern]) => pattern.test(error.message));
  if (cure !== undefined) return { isRefusal: true, text: cure[1](settings, own) };
  const isAway = /ECONNREFUSED|ENOTFOUND|EHOSTUNREACH|ETIMEDOUT|cannot be established|premature disconnection/i.test(error.message);
  return { isRefusal: false, text: isAway ? `no OPC UA server answers at ${settings.endpoint}; check that it runs` : error.message };
}
