using System;
using Nowpose.Messages;
using Nowpose.Pairing;
using NUnit.Framework;
using static Nowpose.Tests.Core.Pairing.SimulatedPairing;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Tests the pairing from the sighting of the two codes until the headset has received its token.</summary>
    public class PairingFlowTests
    {
        SimulatedPairing _pairing;

        [SetUp]
        public void Start() => _pairing = new SimulatedPairing();

        [TearDown]
        public void Stop() => _pairing.Dispose();

        [Test]
        public void Frame_BothCodesSeenOnce_PairsTheHeadset()
        {
            Assert.That(_pairing.Frame(Cell) & PairingChange.Asked, Is.EqualTo(PairingChange.Asked));
            Assert.That(
                _pairing.Flow.Question,
                Does.Contain("'Press 3'").And.Contain("10.0.0.7").And.Contain("47010").And.Contain("47011").And.Contain("AAAAAAAAAAAA…"));
            _pairing.Flow.Accept();
            Assert.That(_pairing.Flow.Question, Is.Null);
            _pairing.Frame();
            Assert.That(_pairing.Flow.Words, Is.EqualTo(PairingMessages.LookAtCode("Press 3")));
            _pairing.Frame(Token);
            _pairing.Answer.SetResult(PairingAnswer.Accepted(OwnToken));

            var changes = _pairing.Frame();

            Assert.That(changes & (PairingChange.Applied | PairingChange.Paired | PairingChange.Kept), Is.EqualTo(
                PairingChange.Applied | PairingChange.Paired | PairingChange.Kept));
            Assert.That(_pairing.Sent, Is.EqualTo(new[] { TokenCode.Parse(Token).Token }));
            Assert.That(_pairing.SentTo[0].Pin, Is.EqualTo(Pin));
            Assert.That(_pairing.SentTo[0].HeadsetName, Is.EqualTo("headset 7"));
            Assert.That(_pairing.Flow.Cells.Used.Token, Is.EqualTo(OwnToken));
            Assert.That(_pairing.Flow.Words, Does.Contain("paired"));
        }

        [Test]
        public void Token_SeenFirst_IsUsedAfterConsent()
        {
            _pairing.Frame(Token);
            Assert.That(_pairing.Flow.Words, Is.EqualTo(PairingMessages.MarkerFirst));
            _pairing.Frame(Cell);
            Assert.That(_pairing.Sent, Is.Empty, "nothing is sent before the wearer agrees");

            _pairing.Flow.Accept();
            _pairing.Frame();

            Assert.That(_pairing.Sent.Count, Is.EqualTo(1));
        }

        [Test]
        public void Token_Expired_IsNotSent()
        {
            _pairing.Frame(Token);
            _pairing.Now += PairingLimits.CodeValidity;
            _pairing.Frame();

            _pairing.Agree(Cell);

            Assert.That(_pairing.Sent, Is.Empty);
        }

        [Test]
        public void Question_NotAnswered_SendsNoToken()
        {
            for (var i = 0; i < 100; i++) _pairing.Frame(Cell, Token);

            Assert.That(_pairing.Sent, Is.Empty);
            Assert.That(_pairing.Flow.Cells.Used, Is.Null);
        }

        [Test]
        public void Refuse_Gateway_DoesNotAskAgainForAnyOfItsMarkers()
        {
            _pairing.Frame(Cell);
            _pairing.Flow.Refuse();

            _pairing.Look(Cell, CodeOf("Press 3", "10.0.0.7", Pin, 1), Token);

            Assert.That(_pairing.Flow.Question, Is.Null);
            Assert.That(_pairing.Sent, Is.Empty);
            _pairing.Frame(CodeOf("Press 3", "10.0.0.8", Pin));
            Assert.That(_pairing.Flow.Question, Is.Not.Null, "a question about another gateway is asked");
        }

        [Test]
        public void Refuse_OtherCellInView_AsksAboutTheOtherCellAfterADelay()
        {
            _pairing.Frame(Cell, Other);
            _pairing.Flow.Refuse();

            _pairing.Frame(Cell, Other);
            Assert.That(_pairing.Flow.Question, Is.Null);
            _pairing.Look(Cell, Other);

            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Question(CellCode.Parse(Other), null)));
        }

        [Test]
        public void Token_ForAnotherGateway_IsNotSent()
        {
            _pairing.Agree(Cell);

            _pairing.Frame(TokenOf(1, OtherPin));

            Assert.That(_pairing.Sent, Is.Empty);
        }

        [Test]
        public void Token_RefusedByTheGateway_IsReportedOnceAndTheNextTokenIsSent()
        {
            _pairing.Agree(Cell);
            _pairing.Frame(Token);
            _pairing.Answer.SetResult(PairingAnswer.Refused("used"));

            Assert.That(_pairing.Frame(Token) & PairingChange.Problem, Is.EqualTo(PairingChange.Problem));
            Assert.That(_pairing.Flow.Words, Is.EqualTo("used"));
            for (var i = 0; i < 10; i++) _pairing.Frame(Token);
            Assert.That(_pairing.Sent.Count, Is.EqualTo(1));
            _pairing.Frame(TokenOf(2, Pin));
            Assert.That(_pairing.Sent.Count, Is.EqualTo(2));
            Assert.That(_pairing.Flow.Problem, Is.Null);
        }

        [Test]
        public void Token_NoAnswer_IsRetriedUntilItExpires()
        {
            _pairing.Agree(Cell);
            _pairing.Frame(Token);
            var end = _pairing.Now + PairingLimits.CodeValidity + PairingLimits.RetryInterval;
            var problems = 0;

            while (_pairing.Now < end)
            {
                _pairing.Answer.TrySetResult(PairingAnswer.Failed("no answer"));
                if ((_pairing.Frame() & PairingChange.Problem) != 0) problems++;
                _pairing.Now += TimeSpan.FromSeconds(1);
            }

            Assert.That(_pairing.Sent.Count, Is.InRange(70, 100), "one attempt every three seconds");
            Assert.That(problems, Is.EqualTo(2), "one problem for the retries and one for the end of the validity");
            Assert.That(_pairing.Flow.Problem, Is.EqualTo("no answer"));
        }

        [Test]
        public void Token_RefusedAfterPairing_IsReplacedByANewToken()
        {
            _pairing.Pair(Cell, Token);
            _pairing.Flow.IsTokenRefused = true;

            _pairing.Frame(Token);
            Assert.That(_pairing.Sent.Count, Is.EqualTo(1), "the first code was used before");
            _pairing.Frame(TokenOf(2, Pin));
            _pairing.Answer.SetResult(PairingAnswer.Accepted("newer"));
            _pairing.Frame();

            Assert.That(_pairing.Flow.Cells.Used.Token, Is.EqualTo("newer"));
        }

        [Test]
        public void Token_AlreadyTried_IsReported()
        {
            _pairing.Pair(Cell, Token);
            _pairing.Flow.IsTokenRefused = true;

            _pairing.Frame(Token);

            Assert.That(_pairing.Flow.Words, Is.EqualTo(PairingMessages.CodeWasTried));
            Assert.That(_pairing.Flow.IsSettled, Is.False);
        }

        [Test]
        public void Gateway_OnThisMachine_NeedsNoToken()
        {
            _pairing.Agree(new CellCode("desk", "localhost", null).Text);

            Assert.That(_pairing.Flow.Cells.Used.IsReady, Is.True);
        }
    }
}
