using System;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Tests.Core.Pairing.CellCodeTexts;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Tests how cell codes are parsed and written.</summary>
    public class CellCodeTests
    {
        [Test]
        public void Parse_AllFields_ReturnsEachField()
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

            // The marker is turned by 90° about the base's z axis, so the marker's x axis is the base's y axis.
            var expected = new[] { 0, -1, 0, 0.25, 1, 0, 0, -0.1, 0, 0, 1, 0.02, 0, 0, 0, 1 };
            for (var i = 0; i < 16; i++) Assert.That(pose[i], Is.EqualTo(expected[i]).Within(1e-12), "element " + i);
        }

        [Test]
        public void Write_AllFields_ReturnsTheCode() => Assert.That(
            new CellCode("Press 3", "192.168.10.20", Pin, MarkerOffset.Parse("0.25,-0.1,0.02,0,0,90", ""), 0.12, 47020, 47021).Text,
                Is.EqualTo(Whole));

        [Test]
        public void Parse_Loopback_NeedsOnlyNameAndHost()
        {
            var code = CellCode.Parse(Shortest);

            Assert.That(code.SyncPort, Is.EqualTo(ProtocolLimits.SyncPort));
            Assert.That(code.WebSocketPort, Is.EqualTo(ProtocolLimits.WebSocketPort));
            Assert.That(code.Pin, Is.Null);
            Assert.That(code.Marker, Is.Null);
            Assert.That(code.SizeMetres, Is.EqualTo(0));
            Assert.That(new CellCode("a", "127.0.0.1", null).Text, Is.EqualTo(Shortest), "default values are not written");
        }

        [TestCase("gateway", "gateway")]
        [TestCase("Cell-3.plant.example", "cell-3.plant.example")]
        [TestCase("10.0.0.7", "10.0.0.7")]
        [TestCase("2001:db8::7", "2001:db8::7")]
        [TestCase("xn--bcher-kva.example", "xn--bcher-kva.example")]
        public void Parse_ValidHost_IsAccepted(string host, string read) =>
            Assert.That(CellCode.Parse("nowpose:cell/1?n=a&p=" + PinText + "&h=" + host).Host, Is.EqualTo(read));

        [TestCase("Pr%C3%BCfzelle%203", "Prüfzelle 3")]
        [TestCase("%e6%97%a5", "日")]
        [TestCase("%41", "A")]
        public void Parse_EncodedName_IsDecoded(string encoded, string name) =>
            Assert.That(CellCode.Parse("nowpose:cell/1?h=127.0.0.1&n=" + encoded).Cell, Is.EqualTo(name));

        [Test]
        public void HasSameGateway_OtherHostPortOrPin_IsFalse()
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
        public void ToConnection_Token_ReturnsPinnedSettingsWithTheToken()
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
            string Metres() => MarkerOffset.Write(random.NextDouble() * 10 - 5);
            string Degrees() => MarkerOffset.Write(random.NextDouble() * 720 - 360);
            var code = new CellCode(
                name.TrimEnd(), random.Next(256) == 0 ? "gateway" : "10.0.0." + random.Next(256), Pin,
                random.Next(3) == 0 ? null : MarkerOffset.Parse(string.Join(",", Metres(), Metres(), Metres(), Degrees(), Degrees(), Degrees()), ""),
                random.Next(2) * (0.01 + random.NextDouble()), random.Next(1, 65536), random.Next(1, 65536));

            var read = CellCode.Parse(code.Text);

            Assert.That(read.Cell, Is.EqualTo(code.Cell), code.Text);
            Assert.That(read.HasSameGateway(code), Is.True, code.Text);
            Assert.That(read.Marker?.ToString(), Is.EqualTo(code.Marker?.ToString()));
            Assert.That(read.SizeMetres, Is.EqualTo(code.SizeMetres).Within(1e-6));
            Assert.That(read.SyncPort, Is.EqualTo(code.SyncPort));
            Assert.That(read.WebSocketPort, Is.EqualTo(code.WebSocketPort));
        }
    }
}
