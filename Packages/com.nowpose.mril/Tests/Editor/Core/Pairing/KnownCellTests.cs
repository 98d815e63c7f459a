using System;
using Nowpose.Messages;
using Nowpose.Pairing;
using NUnit.Framework;
using static Nowpose.Tests.Core.Pairing.SimulatedPairing;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>
    /// Tests how a paired cell is recognised. An unchanged cell is used without a question; a changed cell or a different paired cell
    /// needs the wearer's consent.
    /// </summary>
    public class KnownCellTests
    {
        SimulatedPairing _pairing;

        [SetUp]
        public void Start() => _pairing = new SimulatedPairing();

        [TearDown]
        public void Stop() => _pairing.Dispose();

        [Test]
        public void KnownCell_SeenAgain_IsUsedWithoutAQuestion()
        {
            _pairing.Pair(Cell, Token);
            _pairing.Restart(_pairing.Flow.Cells);

            Assert.That(_pairing.Frame() & PairingChange.Applied, Is.EqualTo(PairingChange.Applied), "at once, before anything is seen");
            _pairing.Frame(Cell, Token);

            Assert.That(_pairing.Flow.Question, Is.Null);
            Assert.That(_pairing.Sent.Count, Is.EqualTo(1), "the token was sent only once");
        }

        [TestCase(6000, 47011, "ports 6000 and 47011 instead of 47010 and 47011")]
        [TestCase(47010, 6000, "ports 47010 and 6000 instead of 47010 and 47011")]
        public void KnownCell_PortsChanged_AsksBeforeSendingTheToken(int syncPort, int webSocketPort, string part)
        {
            _pairing.Agree(Cell);

            _pairing.Frame(new CellCode("Press 3", "10.0.0.7", Pin, null, 0, syncPort, webSocketPort).Text, Token);
            _pairing.Frame();

            Assert.That(_pairing.Flow.Question, Does.Contain(part));
            Assert.That(_pairing.SentTo[0].WebSocketPort, Is.EqualTo(47011));
            Assert.That(_pairing.Flow.Cells.Used.Codes.Count, Is.EqualTo(1));
        }

        [TestCase("10.0.0.8", false, "10.0.0.8 instead of 10.0.0.7")]
        [TestCase("10.0.0.7", true, "AAECAwQFBgcI… instead of key AAAAAAAAAAAA…")]
        public void KnownCell_GatewayChanged_QuestionNamesTheChange(string host, bool isOtherPin, string part)
        {
            _pairing.Pair(Cell, Token);

            _pairing.Frame(CodeOf("Press 3", host, isOtherPin ? OtherPin : Pin));

            Assert.That(_pairing.Flow.Question, Does.Contain(part));
            Assert.That(_pairing.Flow.Cells.Used.Newest.Text, Is.EqualTo(Cell), "until the question is answered");
        }

        [TestCase(false, OwnToken)]
        [TestCase(true, null)]
        public void KnownCell_GatewayChanged_KeepsTheTokenOnlyWithTheSameKey(bool isOtherPin, string token)
        {
            _pairing.Pair(Cell, Token);

            _pairing.Agree(CodeOf("Press 3", "10.0.0.8", isOtherPin ? OtherPin : Pin));

            Assert.That(_pairing.Flow.Cells.Used.Newest.Host, Is.EqualTo("10.0.0.8"));
            Assert.That(_pairing.Flow.Cells.Used.Token, Is.EqualTo(token));
        }

        [Test]
        public void KnownCell_GatewayChangedDuringPairing_IgnoresTheTokenOfTheOldGateway()
        {
            _pairing.Agree(Cell);
            _pairing.Frame(Token);

            _pairing.Agree(CodeOf("Press 3", "10.0.0.8", OtherPin));
            _pairing.Answer.SetResult(PairingAnswer.Accepted(OwnToken));
            _pairing.Frame();

            Assert.That(_pairing.Flow.Cells.Used.Newest.Pin, Is.EqualTo(OtherPin));
            Assert.That(_pairing.Flow.Cells.Used.Token, Is.Null);
        }

        [Test]
        public void KnownCell_SecondMarkerInView_AddsItsCode()
        {
            _pairing.Pair(Cell, Token);
            var second = CodeOf("Press 3", "10.0.0.7", Pin, 0.3);

            var changes = _pairing.Frame(second);

            Assert.That(changes & PairingChange.Applied, Is.EqualTo(PairingChange.Applied));
            Assert.That(_pairing.Flow.Cells.Used.Codes.Count, Is.EqualTo(2));
            Assert.That(_pairing.Flow.Cells.Used.Token, Is.EqualTo(OwnToken));
            Assert.That(_pairing.Frame(Cell, second), Is.EqualTo(PairingChange.None));
        }

        void PairBoth()
        {
            _pairing.Pair(Other, TokenOf(2, OtherPin));
            _pairing.Pair(Cell, Token);
            Assert.That(_pairing.Flow.Cells.Used.Cell, Is.EqualTo("Press 3"));
        }

        [TestCase(true, "Press 4")]
        [TestCase(false, "Press 3")]
        public void OtherKnownCell_AloneInView_IsUsedOnlyWithConsent(bool isAgreed, string used)
        {
            PairBoth();

            _pairing.Look(Other);

            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Use("Press 4", "Press 3")));
            Assert.That(_pairing.Flow.Cells.Used.Cell, Is.EqualTo("Press 3"), "until the question is answered");
            if (isAgreed) _pairing.Flow.Accept();
            else _pairing.Flow.Refuse();
            _pairing.Look(Other);
            Assert.That(_pairing.Flow.Cells.Used.Cell, Is.EqualTo(used));
            Assert.That(_pairing.Flow.Question, Is.Null);
        }

        [Test]
        public void OtherKnownCell_SeenBrieflyOrBesideTheCellInUse_DoesNotAsk()
        {
            PairBoth();

            for (var i = 0; i < 100; i++)
            {
                _pairing.Frame(Other);
                _pairing.Frame();
            }
            _pairing.Look(Cell, Other);

            Assert.That(_pairing.Flow.Question, Is.Null);
        }

        [Test]
        public void OtherKnownCell_Declined_AsksAgainAfterAMinuteOutOfView()
        {
            PairBoth();
            _pairing.Look(Other);
            _pairing.Flow.Refuse();

            for (var i = 0; i < 3; i++)
            {
                _pairing.Now += TimeSpan.FromSeconds(50);
                _pairing.Look(Other);
                Assert.That(_pairing.Flow.Question, Is.Null);
            }
            _pairing.Frame();
            _pairing.Now += TimeSpan.FromSeconds(61);
            _pairing.Frame();
            _pairing.Look(Other);

            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Use("Press 4", "Press 3")));
        }
    }
}
