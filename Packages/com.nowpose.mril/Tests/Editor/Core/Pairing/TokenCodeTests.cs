using System;
using Nowpose.Messages;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Pairing
{
    public class TokenCodeTests
    {
        const string PinText = "AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8";
        const string Token = "_-ECAwQFBgcICQoLDA0ODw";
        const string Whole = "nowpose:token/1?p=" + PinText + "&t=" + Token + "&x=1795186800";

        static readonly CertificatePin Pin = CertificatePin.Parse("sha256/AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=");
        static readonly DateTime ValidTo = new DateTime(2026, 11, 20, 15, 0, 0, DateTimeKind.Utc);

        [Test]
        public void Parse_AllFields_ReturnsEachField()
        {
            var code = TokenCode.Parse(Whole);

            Assert.That(code.Pin, Is.EqualTo(Pin));
            Assert.That(code.Token, Is.EqualTo(Token));
            Assert.That(code.ValidToUtc, Is.EqualTo(ValidTo));
        }

        [Test]
        public void Write_AllFields_ReturnsTheCode() => Assert.That(new TokenCode(Pin, Token, ValidTo).Text, Is.EqualTo(Whole));

        [Test]
        public void ToString_AnyToken_DoesNotContainTheToken() => Assert.That(TokenCode.Parse(Whole).ToString(), Does.Not.Contain(Token));

        [Test]
        public void IsFor_CellWithAnotherKey_IsFalse()
        {
            var code = TokenCode.Parse(Whole);
            var plain = TokenCode.Parse("nowpose:token/1?t=" + Token);
            var other = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

            Assert.That(code.IsFor(new CellCode("a", "10.0.0.7", Pin)), Is.True);
            Assert.That(code.IsFor(new CellCode("a", "10.0.0.7", other)), Is.False);
            Assert.That(code.IsFor(new CellCode("a", "localhost", null)), Is.False);
            Assert.That(plain.IsFor(new CellCode("a", "localhost", null)), Is.True);
            Assert.That(plain.IsFor(new CellCode("a", "10.0.0.7", Pin)), Is.False);
        }

        static readonly string[][] InvalidGrammar =
        {
            new[] { "nowpose:token/1?p=" + PinText, "token code: " + PairingCodeMessages.FieldMissing('t') },
            new[] { "nowpose:token/2?t=" + Token, "token code: " + PairingCodeMessages.OtherVersion(2, 1) },
            new[] { "nowpose:token/1?t=" + Token + "&n=a", "token code: " + PairingCodeMessages.UnknownField('n', "p, t, x") },
            new[] { "nowpose:token/1?t=" + Token + "A", PairingCodeMessages.TokenInvalid(16) },
            new[] { "nowpose:token/1?t=_-ECAwQFBgcICQoLDA0OD", PairingCodeMessages.TokenInvalid(16) },
            new[] { "nowpose:token/1?t=" + Token + "&x=-1", PairingCodeMessages.NotWhole('x', 0, LastSecond) },
            new[] { "nowpose:token/1?t=" + Token + "&x=253402300800", PairingCodeMessages.OutOfRange('x', LastSecond + 1, 0, LastSecond) },
        };

        /// <summary>The last second of the year 9999 in Unix time.</summary>
        const long LastSecond = 253402300799;

        [TestCaseSource(nameof(InvalidGrammar))]
        public void Parse_InvalidGrammar_ThrowsWithTheReasonButNotTheToken(string text, string why)
        {
            var error = Assert.Throws<InputException>(() => TokenCode.Parse(text));

            Assert.That(error.Message, Does.EndWith(why).And.Not.Contain(Token));
        }

        [Test]
        public void Parse_Damaged_ErrorDoesNotContainTheToken([Range(1, 200)] int seed)
        {
            var random = new Random(seed);
            var text = Whole.ToCharArray();
            text[random.Next(8, text.Length)] = (char)random.Next(256);

            try
            {
                TokenCode.Parse(new string(text));
            }
            catch (InputException refused)
            {
                Assert.That(refused.Message, Does.Not.Contain(Token.Substring(4, 8)), "seed " + seed);
            }
        }
    }
}
