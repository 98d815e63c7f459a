/** Whether the code of an error of Node.js states that no address of a host name was found. */
export const isUnknownHost = (code: unknown): boolean => code === 'ENOTFOUND' || code === 'EAI_AGAIN';

/** Whether the code of an error of Node.js states that the certificate of a server does not contain its host. */
export const isOtherName = (code: unknown): boolean => code === 'ERR_TLS_CERT_ALTNAME_INVALID';

/** Whether the code of an error of Node.js is an alert with which a server refuses the certificate of this client, or its absence. */
export const isCertificateRefused = (code: unknown): boolean => /_ALERT_(.*CERTIFICATE|UNKNOWN_CA)/.test(String(code));

/** Whether the code of an error of Node.js states that the certificate of a server is not trusted. */
export const isUntrusted = (code: unknown): boolean => /CERT|UNABLE_TO|SELF_SIGNED/.test(String(code)) && !isCertificateRefused(code);
