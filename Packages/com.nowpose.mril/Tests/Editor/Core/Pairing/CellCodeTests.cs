using System;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Pairing
{
    public class CellCodeTests
    {
        const string PinText = "AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8";
        const string Whole = "nowpose:cell/1?n=Press%203&h=192.168.10.20&s=47020&w=47021&p=" + PinText + "&o=0.25,-0.1,0.02,0,0,90&m=0.12";
        const string Least = "nowpose:cell/1?n=a&h=127.0.0.1";

        static readonly CertificatePin Pin = CertificatePin.Parse("sha256/AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=");

        [Test]
        public void Parse_AllFields_ReadsEach()
        {
            var code = CellCode.Parse(Whole);

            Assert.That(code.Cell, Is.EqualTo("Press 3"));
            Assert.That(code.Host, Is.EqualTo("192.168.10.20"));
            Assert.That(code.SyncPort, Is.EqualTo(47020));
            Assert.That(code.WebSocketPort, Is.EqualTo(47021));
            Assert.That(code.Pin, Is.EqualTo(Pin));
            Assert.That(code.SizeMetres, Is.EqualTo(0.12));
            Assert.That(code.Text, Is.EqualTo(Whole));
        }

        [Test]
        public void Parse_Offset_ReturnsTheMarkerFrameInTheBaseFrame()
        {
            var pose = CellCode.Parse(Whole).Marker.ToPose().ToRowMajor16();

            // A quarter turn about the base's z: the marker's x axis is the base's y axis.
            var expected = new[] { 0, -1, 0, 0.25, 1, 0, 0, -0.1, 0, 0, 1, 0.02, 0, 0, 0, 1 };
            for (var i = 0; i < 16; i++) Assert.That(pose[i], Is.EqualTo(expected[i]).Within(1e-12), "element " + i);
        }

        [Test]
        public void Write_AllFields_ReturnsTheCode() => Assert.That(
            new CellCode("Press 3", "192.168.10.20", Pin, new MarkerOffset(0.25, -0.1, 0.02, 0, 0, 90), 0.12, 47020, 47021).Text, Is.EqualTo(Whole));

        [Test]
        public void Parse_Loopback_NeedsOnlyNameAndHost()
        {
            var code = CellCode.Parse(Least);

            Assert.That(code.SyncPort, Is.EqualTo(ProtocolLimits.SyncPort));
            Assert.That(code.WebSocketPort, Is.EqualTo(ProtocolLimits.WebSocketPort));
            Assert.That(code.Pin, Is.Null);
            Assert.That(code.Marker, Is.Null);
            Assert.That(code.SizeMetres, Is.EqualTo(0));
            Assert.That(new CellCode("a", "127.0.0.1", null).Text, Is.EqualTo(Least), "what is usual is not written");
        }

        [TestCase("2")]
        [TestCase("9999")]
        public void Parse_NewerVersion_NamesTheVersion(string version)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Whole.Replace("cell/1", "cell/" + version)));

            Assert.That(error.Message, Does.Contain("has version " + version).And.Contain("update Nowpose"));
        }

        [TestCase(null, "0 characters")]
        [TestCase("", "does not begin")]
        [TestCase("nowpose:cell/1", "has no fields")]
        [TestCase("nowpose:cell/?n=a", "has no version")]
        [TestCase("nowpose:cell/01?n=a", "has no version")]
        [TestCase("nowpose:cell/99999?n=a", "has no version")]
        [TestCase("NOWPOSE:cell/1?n=a&h=127.0.0.1", "does not begin")]
        [TestCase("https://a/1?n=a&h=127.0.0.1", "does not begin")]
        [TestCase("nowpose:token/1?t=a", "does not begin")]
        [TestCase("nowpose:cell/1?h=127.0.0.1", "n is missing")]
        [TestCase("nowpose:cell/1?n=a", "h is missing")]
        [TestCase(Least + "&", "KEY=VALUE")]
        [TestCase(Least + "&&s=1", "KEY=VALUE")]
        [TestCase(Least + "&s", "KEY=VALUE")]
        [TestCase(Least + "&sync=1", "KEY=VALUE")]
        [TestCase(Least + "&s=", "s is empty")]
        [TestCase(Least + "&k=1", "field k is not known")]
        [TestCase(Least + "&N=b", "field N is not known")]
        [TestCase(Least + "&n=b", "n occurs twice")]
        [TestCase(Least + " ", "U+0020")]
        [TestCase(Least + "\n", "U+000A")]
        [TestCase(Least + "\0", "U+0000")]
        [TestCase(Least + "\u202E", "U+202E")]
        [TestCase(Least + "\u00A0", "U+00A0")]
        public void Parse_InvalidGrammar_ThrowsWithTheReason(string text, string why)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(text));

            Assert.That(error.Message, Does.StartWith("cell code: ").And.Contain(why));
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
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Least + "&" + field));

            Assert.That(error.Message, Does.Contain("1 to 65535").And.Not.Contain("<"));
        }

        [TestCase("o=1", "1 numbers")]
        [TestCase("o=1,2,3,4,5,6,7", "7 numbers")]
        [TestCase("o=1,2,NaN", "value 3 is not a number")]
        [TestCase("o=1,2,Infinity", "value 3 is not a number")]
        [TestCase("o=1,2,1e3", "value 3 is not a number")]
        [TestCase("o=1,,3", "value 2 is not a number")]
        [TestCase("o=1,2,3.", "value 3 is not a number")]
        [TestCase("o=1,2,.5", "value 3 is not a number")]
        [TestCase("o=1,2,0.1234567", "value 3 is not a number")]
        [TestCase("o=1,2,--3", "value 3 is not a number")]
        [TestCase("o=1,2,1.2.3", "value 3 is not a number")]
        [TestCase("o=1,2,9999", "value 3 is not a number")]
        [TestCase("o=1,2,101", "100 m")]
        [TestCase("o=1,2,3,0,0,361", "360 degrees")]
        [TestCase("m=0", "0.01 to 5 m")]
        [TestCase("m=NaN", "0.01 to 5 m")]
        [TestCase("m=9", "5 m")]
        [TestCase("m=-0.1", "0.01")]
        public void Parse_NumberOutOfRange_StatesTheAllowedRange(string field, string why)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Least + "&" + field));

            Assert.That(error.Message, Does.Contain(why));
        }

        [TestCase("p=" + PinText + "A")]
        [TestCase("p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh9")] // bits beyond the last byte
        [TestCase("p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwd+h8")]
        [TestCase("p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=")]
        public void Parse_InvalidPin_IsRefused(string field)
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Least + "&" + field));

            Assert.That(error.Message, Does.Contain("32 bytes"));
        }

        [TestCase("gateway", "gateway")]
        [TestCase("Cell-3.plant.example", "cell-3.plant.example")]
        [TestCase("10.0.0.7", "10.0.0.7")]
        [TestCase("2001:db8::7", "2001:db8::7")]
        [TestCase("xn--bcher-kva.example", "xn--bcher-kva.example")]
        public void Parse_ValidHost_IsAccepted(string host, string read) =>
            Assert.That(CellCode.Parse("nowpose:cell/1?n=a&p=" + PinText + "&h=" + host).Host, Is.EqualTo(read));

        [TestCase("g\u0430teway")] // a Cyrillic letter that looks like a Latin one
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

            Assert.That(error.Message, Does.Contain("is not a host"));
        }

        [TestCase("Pr%C3%BCfzelle%203", "Prüfzelle 3")]
        [TestCase("%e6%97%a5", "日")]
        [TestCase("%41", "A")]
        public void Parse_EncodedName_IsDecoded(string encoded, string name) =>
            Assert.That(CellCode.Parse("nowpose:cell/1?h=127.0.0.1&n=" + encoded).Cell, Is.EqualTo(name));

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
            var error = Assert.Throws<InputException>(() => CellCode.Parse(Least + new string('\0', 3000)));

            Assert.That(error.Message, Is.EqualTo("cell code: 3030 characters; allowed are up to 213"));
        }

        [Test]
        public void Parse_AnotherMachineWithoutPin_IsRefused()
        {
            var error = Assert.Throws<InputException>(() => CellCode.Parse("nowpose:cell/1?n=a&h=10.0.0.7"));

            Assert.That(error.Message, Does.Contain("pin is missing"));
        }

        [Test]
        public void Write_NamesTooLong_ThrowsWithTheMaximum()
        {
            var error = Assert.Throws<InputException>(() => new CellCode(
                new string('ü', 40), new string('a', 50), Pin, new MarkerOffset(1, 2, 3)));

            Assert.That(error.Message, Does.Contain("up to 213").And.Contain("shorten"));
        }

        [Test]
        public void HasSameGateway_ComparesHostPortsAndPin()
        {
            var code = CellCode.Parse(Whole);
            var other = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

            CellCode Code(string host, CertificatePin pin, int syncPort = 47020, int webSocketPort = 47021) =>
                new CellCode("b", host, pin, null, 0, syncPort, webSocketPort);

            Assert.That(code.HasSameGateway(Code("192.168.10.20", Pin)), Is.True);
            Assert.That(code.HasSameGateway(Code("192.168.10.21", Pin)), Is.False);
            Assert.That(code.HasSameGateway(Code("192.168.10.20", other)), Is.False);
            Assert.That(code.HasSameGateway(Code("192.168.10.20", Pin, syncPort: 47010)), Is.False);
            Assert.That(code.HasSameGateway(Code("192.168.10.20", Pin, webSocketPort: 47011)), Is.False);
        }

        [Test]
        public void ToConnection_HasThePinAndTheToken()
        {
            var connection = CellCode.Parse(Whole).ToConnection("secret", "headset 7");

            Assert.That(connection.Security, Is.EqualTo(TransportSecurity.Pinned));
            Assert.That(connection.WebSocketUri.ToString(), Is.EqualTo("wss://192.168.10.20:47021/"));
            Assert.That(connection.SyncPort, Is.EqualTo(47020));
            Assert.That(connection.Token, Is.EqualTo("secret"));
            Assert.That(connection.HeadsetName, Is.EqualTo("headset 7"));
        }

        [Test]
        public void Write_AnyValues_RoundTrip([Range(1, 200)] int seed)
        {
            var random = new Random(seed);
            const string Letters = "abcdefgh XYZ-_.üß";
            var name = "n";
            for (var i = random.Next(12); i > 0; i--) name += Letters[random.Next(Letters.Length)];
            double Metres() => random.NextDouble() * 10 - 5;
            double Degrees() => random.NextDouble() * 720 - 360;
            var code = new CellCode(
                name.TrimEnd(), random.Next(256) == 0 ? "gateway" : "10.0.0." + random.Next(256), Pin,
                random.Next(3) == 0 ? null : new MarkerOffset(Metres(), Metres(), Metres(), Degrees(), Degrees(), Degrees()),
                random.Next(2) * (0.01 + random.NextDouble()), random.Next(1, 65536), random.Next(1, 65536));

            var read = CellCode.Parse(code.Text);

            Assert.That(read.Cell, Is.EqualTo(code.Cell), code.Text);
            Assert.That(read.HasSameGateway(code), Is.True, code.Text);
            Assert.That(read.Marker?.ToString(), Is.EqualTo(code.Marker?.ToString()));
            Assert.That(read.SizeMetres, Is.EqualTo(code.SizeMetres).Within(1e-6));
            Assert.That(read.SyncPort, Is.EqualTo(code.SyncPort));
            Assert.That(read.WebSocketPort, Is.EqualTo(code.WebSocketPort));
        }

        [Test]
        public void Parse_DamagedCode_IsReadOrRefusedInOneLine([Range(1, 300)] int seed)
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
