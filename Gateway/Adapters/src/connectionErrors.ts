/** Whether the code of an error of Node.js states that no address of a host name was found. */
export const isUnknownHost = (code: unknown): boolean => code === 'ENOTFOUND' || code === 'EAI_AGAIN';

/** Whether the code of an error of Node.js states that the certificate of a server does not contain its host. */
export const isOtherName = (code: unknown): boolean => code === 'ERR_TLS_CERT_ALTNAME_INVALID';

/**
 * Gets the TLS alert with which a server has ended a connection, such as `unknown ca`; undefined if there is none. Reads the message of the error of
 * Node.js, because with TLS 1.2, its code is mostly EPROTO.
 */
export const alertIn = (message: string): string | undefined => /:(?:tls|ssl)(?:v\d+|\/tls) (?:alert )?([a-z ]+)/.exec(message)?.[1];

/** Whether a server refuses the certificate of this client, or its absence, with this TLS alert. */
export const isCertificateRefused = (alert: string): boolean => /certificate|unknown ca/.test(alert);

/** Whether the code of an error of Node.js states that the certificate of a server is not trusted. The code may also be an alert of the server. */
export const isUntrusted = (code: unknown): boolean => /CERT|UNABLE_TO|SELF_SIGNED/.test(String(code)) && !/_ALERT_/.test(String(code));
