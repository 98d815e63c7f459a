import { createHash } from 'node:crypto';
import { StatusCodes } from 'node-opcua-client';

const print = certificate => createHash('sha1').update(Array.isArray(certificate) ? certificate[0] : certificate).digest('hex');

/** The trust list of a test server: trusts the given thumbprints, or every certificate. */
export class OpenStore {
  referenceCounter = 0;
  constructor(trusted) { this.trusted = trusted; }
  isTrusted(certificate) { return this.trusted === null || this.trusted.includes(print(certificate)); }
  async initialize() {}
  async dispose() {}
  // The server uses a callback for users' certificates and a promise for clients' certificates.
  async checkCertificate(certificate, done) {
    const status = this.isTrusted(certificate) ? StatusCodes.Good : StatusCodes.BadCertificateUntrusted;
    done?.(null, status);
    return status;
  }
  async verifyCertificate(certificate) { return this.isTrusted(certificate) ? 'Good' : 'BadCertificateUntrusted'; }
  async getTrustStatus(certificate) { return this.checkCertificate(certificate); }
  async trustCertificate() {}
  async rejectCertificate() {}
  async addIssuer() {}
  async addRevocationList() {}
}
