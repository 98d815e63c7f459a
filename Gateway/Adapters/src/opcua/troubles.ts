import { type OwnCertificate } from './security/ownCertificate';
import { thumbprints, type TrustList } from './security/trustList';
import type { OpcUaSettings } from './kind';
import { opcuaMessages, opcuaRefusalMessages } from '../messages/opcua';

/** The error for a server that refuses this adapter, or that this adapter refuses. A user must act, because waiting does not help. */
export class Refused extends Error {}

interface Trouble {
  isRefusal: boolean;
  /** Whether the server refuses user and password. Further attempts must then wait, because they may lock the account. */
  isLoginRefused?: boolean;
  text: string;
}

const LOGIN_REFUSED = /BadIdentityTokenRejected|BadUserAccessDenied/;

/** Patterns of errors, and functions that get the reason with the remedy. `status` is the text that matches the pattern. */
const CURES: [RegExp, (settings: OpcUaSettings, own: OwnCertificate, status: string) => string][] = [
  [/BadCertificate(Issuer)?TimeInvalid/, (_, __, status) => opcuaRefusalMessages.adapterNotValidNow(status)],
  [
    /BadSecurityChecksFailed|BadCertificate\w*|BadSecurityModeRejected/,
    (_, own, status) => opcuaRefusalMessages.adapterNotTrusted(status, own.file, thumbprints(own.getCertificate()).sha1),
  ],
  [LOGIN_REFUSED, ({ user }) => (user ? opcuaRefusalMessages.user(user.name) : opcuaRefusalMessages.anonymous)],
  [
    /cannot find an? endpoint|end point must exist/i,
    ({ security }) => (security.mode === 'none' ? opcuaRefusalMessages.noOpenEndpoint : opcuaRefusalMessages.noPolicy(security.policy)),
  ],
  [/BadIdentityTokenInvalid|cannot find .*token/i, () => opcuaRefusalMessages.login],
  [/BadTooManySessions|BadTcpNotEnoughResources/, () => opcuaRefusalMessages.noFreeSession],
];

/**
 * Classifies the error of a connection attempt: whether a user must act (a refusal), or waiting may help.
 * @param isLoggedIn Whether the error is that of a request after the login.
 */
export function refusalOf(error: Error, trust: TrustList, settings: OpcUaSettings, own: OwnCertificate, isLoggedIn: boolean): Trouble {
  if (error instanceof Refused) return { isRefusal: true, text: error.message };
  if (trust.refusal !== null) return { isRefusal: true, text: trust.refusal };
  for (const [pattern, textOf] of CURES) {
    const status = pattern.exec(error.message)?.[0];
    if (status === undefined) continue;
    if (pattern === LOGIN_REFUSED && isLoggedIn) return { isRefusal: true, text: opcuaRefusalMessages.noRight(status) };
    return { isRefusal: true, isLoginRefused: pattern === LOGIN_REFUSED && settings.user !== null, text: textOf(settings, own, status) };
  }
  return { isRefusal: false, text: isAway(error) ? opcuaMessages.noServer(settings.endpoint) : requestTrouble(error) };
}

/** Whether no OPC UA server responds. A text with a status, such as `rejected by server: BadTcpServerTooBusy`, is the response of a server. */
const isAway = ({ message }: Error): boolean =>
  !/\bBad[A-Z]/.test(message)
  && /ECONN|ENOTFOUND|EHOSTUNREACH|ETIMEDOUT|cannot be established|premature disconnection|rejected by server|socket has been/i.test(message);

/** Gets the reason why a request of an established connection failed. */
export const requestTrouble = ({ message }: Error): string => (/timed out/.test(message) ? opcuaMessages.noResponse : message);
