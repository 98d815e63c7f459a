using System;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class CertificatePinTests
    {
        static readonly string Base64 = Convert.ToBase64String(new byte[32]);

        [Test]
        public void Parse_WithAndWithoutPrefix_ReturnsTheSamePin()
        {
            var pin = CertificatePin.Parse(" sha256/" + Base64 + "\n");

            Assert.That(pin, Is.EqualTo(CertificatePin.Parse(Base64)));
            Assert.That(pin.ToString(), Is.EqualTo("sha256/" + Base64));
        }

        [TestCase(null)]
        [TestCase("")]
        [TestCase("sha256/")]
        [TestCase("not base64 at all")]
        [TestCase("sha1/AAAAAAAAAAAAAAAAAAAAAAAAAAA=")]
        [TestCase("AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA==")]
        [TestCase("AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA")]
        [TestCase("AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA")]
        public void Parse_LengthNot32Bytes_ThrowsWithTheAllowedLength(string text)
        {
            var error = Assert.Throws<InputException>(() => CertificatePin.Parse(text));

            Assert.That(error.Message, Does.Contain("32 bytes"));
        }

        [Test]
        public void Matches_NoCertificate_IsFalse() => Assert.That(CertificatePin.Parse(Base64).Matches(null), Is.False);
    }
}
