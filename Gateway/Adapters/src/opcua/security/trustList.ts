import { createHash, X509Certificate } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type StatusCode, StatusCodes } from 'node-opcua-client';
import type { SecuritySettings } from '../kind';
import { certificateMessages } from '../../messages/opcua';

/** Maximum number of rejected certificates that are stored. The limit prevents an attacker from filling the disk. */
const MAX_REJECTED = 16;

const hash = (algorithm: string, der: Buffer): string => createHash(algorithm).update(der).digest('hex');

/** Gets the thumbprints of a certificate, by which OPC UA tools identify it. */
export const thumbprints = (der: Buffer): { sha1: string; sha256: string } => ({ sha1: hash('sha1', der), sha256: hash('sha256', der) });

/**
 * The trusted server certificates: the certificates in the folder, and the file and the thumbprint in the configuration. The server's own certificate
 * must be in the list; the certificate of its authority is not sufficient. Certificates are never added automatically.
 */
export class TrustList {
  referenceCounter = 0;
  /** The reason for the last refused certificate, with the remedy. */
  refusal: string | null = null;
  readonly #trusted: string;
  readonly #rejected: string;

  constructor(
    readonly settings: SecuritySettings,
    readonly now: () => Date = () => new Date(),
  ) {
    this.#trusted = join(settings.folder, 'trusted');
    this.#rejected = join(settings.folder, 'rejected');
  }

  async initialize(): Promise<void> {
    for (const folder of [this.#trusted, this.#rejected]) mkdirSync(folder, { recursive: true, mode: 0o700 });
  }

  async dispose(): Promise<void> {}

  async checkCertificate(certificate: Buffer | Buffer[]): Promise<StatusCode> {
    const der = leaf(certificate);
    const prints = thumbprints(der);
    this.refusal = null;
    if (!this.#contains(prints)) {
      this.refusal = certificateMessages.notTrusted(prints.sha1, prints.sha256, this.#cure(der, prints.sha1));
      return StatusCodes.BadCertificateUntrusted;
    }
    const { validFrom, validTo } = new X509Certificate(der);
    if (this.now() < new Date(validFrom) || this.now() > new Date(validTo)) {
      this.refusal = certificateMessages.outOfDate(prints.sha1, validFrom, validTo);
      return StatusCodes.BadCertificateTimeInvalid;
    }
    return StatusCodes.Good;
  }

  async verifyCertificate(): Promise<string> {
    return 'Good';
  }
  async getTrustStatus(certificate: Buffer): Promise<StatusCode> {
    return this.checkCertificate(certificate);
  }

  // The library may call these methods. They do nothing, because only a user may change the list.
  async trustCertificate(): Promise<void> {}
  async rejectCertificate(): Promise<void> {}
  async addIssuer(): Promise<void> {}
  async addRevocationList(): Promise<void> {}

  #contains({ sha1, sha256 }: { sha1: string; sha256: string }): boolean {
    const { thumbprint, serverCertificate } = this.settings;
    if (thumbprint === sha1 || thumbprint === sha256) return true;
    const files = readdirSync(this.#trusted)
      .map(name => join(this.#trusted, name))
      .concat(serverCertificate ?? []);
    return files.some(file => thumbprints(derOf(file)).sha256 === sha256);
  }

  #cure(der: Buffer, sha1: string): string {
    const file = join(this.#rejected, `${sha1}.der`);
    try {
      writeFileSync(file, der);
      this.#forgetOldest();
    } catch (error) {
      return certificateMessages.addThumbprint((error as Error).message);
    }
    return certificateMessages.move(file, this.#trusted);
  }

  #forgetOldest(): void {
    const files = readdirSync(this.#rejected).map(name => join(this.#rejected, name));
    const newestFirst = files.map(file => ({ file, time: statSync(file).mtimeMs })).sort((a, b) => b.time - a.time);
    for (const { file } of newestFirst.slice(MAX_REJECTED)) rmSync(file, { recursive: true });
  }
}

// Gets the first certificate of a chain, which is the server's own.
const leaf = (certificate: Buffer | Buffer[]): Buffer => new X509Certificate(Array.isArray(certificate) ? certificate[0] : certificate).raw;

function derOf(file: string): Buffer {
  try {
    return new X509Certificate(readFileSync(file)).raw;
  } catch {
    return Buffer.alloc(0);
  }
}
