using System;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class SyncTokenTests
    {
        [Test]
        public void Write_Token_WritesFrameThenLengthThenUtf8()
        {
            var bytes = SyncToken.Write("aé");

            Assert.That(bytes.Length, Is.EqualTo(48 + 2 + 3));
            Assert.That(SyncFrame.TryRead(bytes.AsSpan(0, 48), out var frame, out _), Is.True);
            Assert.That(frame.Kind, Is.EqualTo(SyncFrameKind.Token));
            Assert.That(bytes.AsSpan(48).ToArray(), Is.EqualTo(new byte[] { 3, 0, (byte)'a', 0xC3, 0xA9 }));
        }

        [Test]
        public void TryRead_WrittenToken_RoundTrips()
        {
            var token = new string('x', ProtocolLimits.TokenBytes);
            var bytes = SyncToken.Write(token);

            Assert.That(SyncToken.TryReadLength(bytes.AsSpan(48, 2), out var length), Is.True);
            Assert.That(SyncToken.TryReadText(bytes.AsSpan(50, length), out var read), Is.True);
            Assert.That(read, Is.EqualTo(token));
        }

        [TestCase("")]
        [TestCase(null)]
        public void Write_NoToken_IsRefused(string token) => Assert.Throws<InputException>(() => SyncToken.Write(token));

        [Test]
        public void Write_LongerThanAllowedInUtf8_IsRefused()
        {
            var token = new string('é', ProtocolLimits.TokenBytes / 2 + 1);

            var error = Assert.Throws<InputException>(() => SyncToken.Write(token));

            Assert.That(error.Message, Does.Contain("512").And.Not.Contain("é"));
        }

        [TestCase(new byte[] { 1, 2 })]
        [TestCase(new byte[] { 0, 0 })]
        [TestCase(new byte[] { 1 })]
        public void TryReadLength_OutsideTheLimit_IsRefused(byte[] bytes) =>
            Assert.That(SyncToken.TryReadLength(bytes, out _), Is.False);

        [Test]
        public void TryReadText_NotUtf8_IsRefused() =>
            Assert.That(SyncToken.TryReadText(new byte[] { 0xC3, 0x28 }, out _), Is.False);
    }
}
