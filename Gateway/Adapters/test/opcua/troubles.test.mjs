// Tests how the errors of a connection attempt are reported.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';

const { opcuaMessages, opcuaRefusalMessages } = messages;
const { refusalOf } = await parts('opcua/troubles');

const own = { file: 'own.der', getCertificate: () => Buffer.from('certificate') };
const reported = status => refusalOf(new Error(`serviceResult = ${status} (0x80140000)`), { refusal: null }, {}, own, false);

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

  for (const [status, user, expected] of [
    ['BadIdentityTokenRejected', { name: 'me' }, true], ['BadUserAccessDenied', { name: 'me' }, true], ['BadUserAccessDenied', null, false],
    ['BadCertificateUntrusted', { name: 'me' }, false],
  ])
    it(`Login_${status}${user === null ? 'WithoutUser' : ''}_Is${expected ? '' : 'No'}RefusalOfUserAndPassword`, () => {
      const { isRefusal, isLoginRefused } = refusalOf(new Error(status), { refusal: null }, { user }, own, false);

      assert.deepEqual([isRefusal, isLoginRefused], [true, expected]);
    });

  it('Request_RefusedAfterTheLogin_IsNoRefusalOfUserAndPassword', () => {
    const trouble = refusalOf(new Error('BadUserAccessDenied'), { refusal: null }, { user: { name: 'me' } }, own, true);

    assert.deepEqual(trouble, { isRefusal: true, text: opcuaRefusalMessages.noRight('BadUserAccessDenied') });
  });

  for (const [name, message, isAway] of [
    ['RejectedWithAStatus', 'The connection has been rejected by server: BadTcpServerTooBusy (0x807d0000)', false],
    ['RejectedWithoutAStatus', 'The connection may have been rejected by server,\n Err = (premature disconnection 2)', true],
    ['NotEstablished', 'The connection cannot be established with server opc.tcp://plc:4840 (ECONNREFUSED)', true],
  ])
    it(`Connection_${name}_IsReportedAs${isAway ? 'NoServer' : 'ItsStatus'}`, () => {
      const { text, isRefusal } = refusalOf(new Error(message), { refusal: null }, { endpoint: 'opc.tcp://plc:4840' }, own, false);

      assert.deepEqual([text, isRefusal], [isAway ? opcuaMessages.noServer('opc.tcp://plc:4840') : message, false]);
    });
});
