import { createHash } from 'node:crypto';
import { StatusCodes } from './library.mjs';

const print = certificate => createHash('sha1').update(Array.isArray(certificate) ? certificate[0] : certificate).digest('hex');

/** Trust list of a test server. It trusts the given thumbprints; without any it trusts all certificates. */
export class OpenStore {
  referenceCounter = 0;
  constructor(trusted) { this.trusted = trusted; }
  isTrusted(certificate) { return this.trusted === null || this.trusted.includes(print(certificate)); }
  async initialize() {}
  async dispose() {}
  // The server passes a callback for the certificates of users, and expects a promise for the certificates of clients.
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
