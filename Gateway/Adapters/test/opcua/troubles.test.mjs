// Tests how the errors of a connection attempt are reported.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';

const { opcuaRefusalMessages } = messages;
const { refusalOf } = await parts('opcua/troubles');

const own = { file: 'own.der', getCertificate: () => Buffer.from('certificate') };
const reported = status => refusalOf(new Error(`serviceResult = ${status} (0x80140000)`), { refusal: null }, {}, own);

describe('troubles of an OPC UA connection', () => {
  it('Certificate_NotValidAtTheTimeOfTheServer_NamesTheClocks', () => {
    const { text } = reported('BadCertificateTimeInvalid');

    assert.equal(text, opcuaRefusalMessages.adapterNotValidNow('BadCertificateTimeInvalid'));
  });

  for (const status of ['BadCertificateUntrusted', 'BadCertificateUriInvalid', 'BadSecurityChecksFailed'])
    it(`Certificate_${status}_NamesTheStatus`, () => {
      const { text, isRefusal } = reported(status);

      assert.ok(isRefusal && text.includes(`(${status})`), text);
    });
});
