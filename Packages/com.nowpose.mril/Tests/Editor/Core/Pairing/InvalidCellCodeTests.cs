using System;
using Nowpose.Messages;
using Nowpose.Pairing;
using NUnit.Framework;
using static Nowpose.Tests.Core.Pairing.CellCodeTexts;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Checks that invalid cell codes are refused and that the message states the reason.</summary>
    public class InvalidCellCodeTests
    {
        const string Keys = "n, h, s, w, p, o, m";

        [TestCase(2)]
        [TestCase(9999)]
        public void Parse_NewerVersion_NamesTheVersion(int version)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Whole.Replace("cell/1", "cell/" + version)));

            Assert.That(error.Message, Is.EqualTo("cell code: " + PairingCodeMessages.OtherVersion(version, 1)));
        }

        static readonly string[][] InvalidGrammar =
        {
            new[] { null, PairingCodeMessages.TooLong(0, 213) },
            new[] { "", PairingCodeMessages.OtherBegin("nowpose:cell/") },
            new[] { "nowpose:cell/1", PairingCodeMessages.NoFields(Keys) },
            new[] { "nowpose:cell/?n=a", PairingCodeMessages.NoVersion(1) },
            new[] { "nowpose:cell/01?n=a", PairingCodeMessages.NoVersion(1) },
            new[] { "nowpose:cell/99999?n=a", PairingCodeMessages.NoVersion(1) },
            new[] { "NOWPOSE:cell/1?n=a&h=127.0.0.1", PairingCodeMessages.OtherBegin("nowpose:cell/") },
            new[] { "https://a/1?n=a&h=127.0.0.1", PairingCodeMessages.OtherBegin("nowpose:cell/") },
            new[] { "nowpose:token/1?t=a", PairingCodeMessages.OtherBegin("nowpose:cell/") },
            new[] { "nowpose:cell/1?h=127.0.0.1", PairingCodeMessages.FieldMissing('n') },
            new[] { "nowpose:cell/1?n=a", PairingCodeMessages.FieldMissing('h') },
            new[] { Shortest + "&", PairingCodeMessages.NotAField(Keys) },
            new[] { Shortest + "&&s=1", PairingCodeMessages.NotAField(Keys) },
            new[] { Shortest + "&s", PairingCodeMessages.NotAField(Keys) },
            new[] { Shortest + "&sync=1", PairingCodeMessages.NotAField(Keys) },
            new[] { Shortest + "&s=", PairingCodeMessages.FieldEmpty('s') },
            new[] { Shortest + "&k=1", PairingCodeMessages.UnknownField('k', Keys) },
            new[] { Shortest + "&N=b", PairingCodeMessages.UnknownField('N', Keys) },
            new[] { Shortest + "&n=b", PairingCodeMessages.FieldTwice('n') },
            new[] { Shortest + " ", PairingCodeMessages.Character(Shortest.Length + 1, 0x20) },
            new[] { Shortest + "\n", PairingCodeMessages.Character(Shortest.Length + 1, 0xA) },
            new[] { Shortest + "\0", PairingCodeMessages.Character(Shortest.Length + 1, 0) },
            new[] { Shortest + "\u202E", PairingCodeMessages.Character(Shortest.Length + 1, 0x202E) },
            new[] { Shortest + "\u00A0", PairingCodeMessages.Character(Shortest.Length + 1, 0xA0) },
        };

        [TestCaseSource(nameof(InvalidGrammar))]
        public void Parse_InvalidGrammar_ThrowsWithTheReason(string text, string why)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(text));

            Assert.That(error.Message, Is.EqualTo("cell code: " + why));
        }

        [TestCase("s=0")]
        [TestCase("s=65536")]
        [TestCase("w=-1")]
        [TestCase("w=99999999999999999999")]
        [TestCase("s=047010")]
        [TestCase("s=+1")]
        [TestCase("s=1.0")]
        [TestCase("w=<b>")]
        public void Parse_PortOutOfRange_StatesTheAllowedRange(string field)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Shortest + "&" + field));

            Assert.That(error.Message, Does.Contain("1 to 65535").And.Not.Contain("<"));
        }

        [TestCase("1", 1)]
        [TestCase("1,2,3,4,5,6,7", 7)]
        public void Parse_OffsetWithAnotherCount_StatesTheCount(string offset, int count)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Shortest + "&o=" + offset));

            Assert.That(error.Message, Is.EqualTo(PairingCodeMessages.OffsetCount(SettingNames.CodeMarkerOffset, count)));
        }

        [TestCase("1,2,NaN", 3)]
        [TestCase("1,2,Infinity", 3)]
        [TestCase("1,2,1e3", 3)]
        [TestCase("1,,3", 2)]
        [TestCase("1,2,3.", 3)]
        [TestCase("1,2,.5", 3)]
        [TestCase("1,2,0.1234567", 3)]
        [TestCase("1,2,--3", 3)]
        [TestCase("1,2,1.2.3", 3)]
        [TestCase("1,2,9999", 3)]
        public void Parse_OffsetNotANumber_StatesThePosition(string offset, int position)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Shortest + "&o=" + offset));

            Assert.That(error.Message, Is.EqualTo(PairingCodeMessages.OffsetNumber(SettingNames.CodeMarkerOffset, position)));
        }

        [TestCase("o=1,2,101", "100 m")]
        [TestCase("o=1,2,3,0,0,361", "360 degrees")]
        [TestCase("m=0", "0.01 to 5 m")]
        [TestCase("m=NaN", "0.01 to 5 m")]
        [TestCase("m=9", "5 m")]
        [TestCase("m=-0.1", "0.01")]
        public void Parse_NumberOutOfRange_StatesTheAllowedRange(string field, string why)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Shortest + "&" + field));

            Assert.That(error.Message, Does.Contain(why));
        }

        [TestCase("p=" + PinText + "A")]
        [TestCase("p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh9")] // contains bits beyond the last byte
        [TestCase("p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwd+h8")]
        [TestCase("p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=")]
        public void Parse_InvalidPin_IsRefused(string field)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Shortest + "&" + field));

            Assert.That(error.Message, Is.EqualTo("cell code: " + PairingCodeMessages.PinInvalid));
        }

        [TestCase("g\u0430teway")] // a Cyrillic letter that looks like a Latin letter
        [TestCase("10.0.7")]
        [TestCase("010.0.0.7")]
        [TestCase("0x0a.0.0.7")]
        [TestCase("10.0.0.0x7")]
        [TestCase("167772167")]
        [TestCase("10.0.0.256")]
        [TestCase("0.0.0.0")]
        [TestCase("::")]
        [TestCase("fe80::1%eth0")]
        [TestCase("[::1]")]
        [TestCase("gateway:47011")]
        [TestCase("user@gateway")]
        [TestCase("gateway/path")]
        [TestCase("gate..way")]
        [TestCase(".gateway")]
        [TestCase("gateway.")]
        [TestCase("-gateway")]
        [TestCase("gate%77ay")]
        [TestCase("a_b")]
        public void Parse_InvalidHost_IsRefused(string host)
        {
            Assert.Throws<InputException>(() => CellCode.Parse("nowpose:cell/1?n=a&p=" + PinText + "&h=" + host));
            var error = Assert.Throws<InputException>(() => new CellCode("a", host, Pin));

            Assert.That(error.Message, Does.EndWith(PairingCodeMessages.NotAHost("", "").Split('\'')[2]));
        }

        [TestCase("a+b")]
        [TestCase("a%2")]
        [TestCase("a%")]
        [TestCase("a%GG")]
        [TestCase("a%0Ab")]
        [TestCase("a%00")]
        [TestCase("%20a")]
        [TestCase("%3Cb%3E")]
        [TestCase("%E2%80%AEa")] // right-to-left override
        [TestCase("%E2%80%8Ba")] // zero-width space
        [TestCase("Press%E3%85%A4")] // Hangul filler
        [TestCase("Pr%E1%85%9Fess")] // Hangul choseong filler
        [TestCase("Pr%CD%8Fess")] // combining grapheme joiner
        [TestCase("Press%EF%B8%8F")] // variation selector
        [TestCase("Pru%CC%88fzelle")] // u and its diaeresis as separate characters
        [TestCase("%F0%9F%A4%96")] // beyond the 16-bit range
        [TestCase("%C3")]
        [TestCase("%C0%80")]
        [TestCase("%ED%A0%80")]
        [TestCase("aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa")]
        public void Parse_InvalidName_IsRefused(string encoded)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse("nowpose:cell/1?h=127.0.0.1&n=" + encoded));

            Assert.That(error.Message, Does.StartWith("cell code: name"));
        }

        [Test]
        public void Parse_Oversized_IsRefusedWithItsLength()
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Shortest + new string('\0', 3000)));

            Assert.That(error.Message, Is.EqualTo("cell code: " + PairingCodeMessages.TooLong(3030, 213)));
        }

        [Test]
        public void Parse_AnotherMachineWithoutPin_IsRefused()
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse("nowpose:cell/1?n=a&h=10.0.0.7"));

            Assert.That(error.Message, Is.EqualTo(PairingCodeMessages.PinMissing));
        }

        [Test]
        public void Write_NamesTooLong_ThrowsWithTheMaximum()
        {
            var error = Assert.Throws<InputException>(() => new CellCode(
                new string('ü', 40), new string('a', 50), Pin, MarkerOffset.Parse("1,2,3", "")));

            Assert.That(error.Message, Does.Match("^" + PairingCodeMessages.CellCodeTooLong(0, 213).Replace(" 0 ", " \\d+ ") + "$"));
        }

        [Test]
        public void Parse_DamagedCode_SucceedsOrThrowsWithAPrintableMessage([Range(1, 300)] int seed)
        {
            var random = new Random(seed);
            var text = Whole.ToCharArray();
            for (var i = random.Next(1, 6); i > 0; i--) text[random.Next(15, text.Length)] = (char)random.Next(random.Next(2) == 0 ? 128 : 0x10000);

            try
            {
                var code = CellCode.Parse(new string(text));
                Assert.That(code.Cell.Length, Is.InRange(1, 40));
                Assert.That(code.SyncPort, Is.InRange(1, 65535));
                Assert.That(Uri.CheckHostName(code.Host), Is.Not.EqualTo(UriHostNameType.Unknown), code.Host);
            }
            catch (InputException refused)
            {
                foreach (var c in refused.Message) Assert.That(c >= (char)32 && c <= (char)126, "seed " + seed + ": " + refused.Message);
            }
        }
    }
}
