using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Pairing
{
    public class PairingFlowTests
    {
        const string OwnToken = "own-token";

        static readonly CertificatePin Pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));
        static readonly CertificatePin OtherPin = CertificatePin.Parse("sha256/AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=");
        static readonly string Cell = CodeOf("Press 3", "10.0.0.7", Pin);
        static readonly string Token = TokenOf(1, Pin);

        readonly List<ConnectionSettings> _sentTo = new List<ConnectionSettings>();
        readonly List<string> _sent = new List<string>();
        TaskCompletionSource<PairingAnswer> _answer;
        PairingFlow _flow;
        HeadsetTime _now;

        static string CodeOf(string cell, string host, CertificatePin pin, double x = 0) =>
            new CellCode(cell, host, pin, new MarkerOffset(x, 0, 0)).Text;

        static string TokenOf(byte number, CertificatePin pin) =>
            new TokenCode(pin, Convert.ToBase64String(new byte[] { number, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }).TrimEnd('=')).Text;

        [SetUp]
        public void Start()
        {
            _sentTo.Clear();
            _sent.Clear();
            _now = HeadsetTime.FromSeconds(100);
            Begin(PairedCells.None);
        }

        [TearDown]
        public void Stop() => _flow.Dispose();

        void Begin(PairedCells cells)
        {
            _flow?.Dispose();
            _flow = new PairingFlow(cells, "headset 7", Send);
        }

        Task<PairingAnswer> Send(ConnectionSettings gateway, string token, CancellationToken cancel)
        {
            _sentTo.Add(gateway);
            _sent.Add(token);
            _answer = new TaskCompletionSource<PairingAnswer>();
            return _answer.Task;
        }

        PairingChange Frame(params string[] inView)
        {
            _now += TimeSpan.FromTicks(TimeSpan.TicksPerSecond / 60);
            foreach (var text in inView) _flow.See(text, _now);
            return _flow.Tick(_now);
        }

        /// <summary>Runs frames long enough that a question may be asked again, or that another cell counts as looked at.</summary>
        void Look(params string[] inView)
        {
            for (var end = _now + TimeSpan.FromTicks(TimeSpan.TicksPerSecond * 11 / 10); _now < end;) Frame(inView);
        }

        void Agree(string code)
        {
            Frame(code);
            _flow.Accept();
            Look();
        }

        void Pair(string code, string token)
        {
            Agree(code);
            Frame(token);
            _answer.SetResult(PairingAnswer.Accepted(OwnToken));
            Frame();
        }

        [Test]
        public void Frame_BothCodesSeenOnce_PairsTheHeadset()
        {
            Assert.That(Frame(Cell) & PairingChange.Asked, Is.EqualTo(PairingChange.Asked));
            Assert.That(
                _flow.Question, Does.Contain("'Press 3'").And.Contain("10.0.0.7").And.Contain("47010").And.Contain("47011").And.Contain("AAAAAAAAAAAA…"));
            _flow.Accept();
            Assert.That(_flow.Question, Is.Null);
            Frame();
            Assert.That(_flow.Words, Does.Contain("look at the code"));
            Frame(Token);
            _answer.SetResult(PairingAnswer.Accepted(OwnToken));

            var changes = Frame();

            Assert.That(changes & (PairingChange.Applied | PairingChange.Paired | PairingChange.Kept), Is.EqualTo(
                PairingChange.Applied | PairingChange.Paired | PairingChange.Kept));
            Assert.That(_sent, Is.EqualTo(new[] { TokenCode.Parse(Token).Token }));
            Assert.That(_sentTo[0].Pin, Is.EqualTo(Pin));
            Assert.That(_sentTo[0].HeadsetName, Is.EqualTo("headset 7"));
            Assert.That(_flow.Cells.Used.Token, Is.EqualTo(OwnToken));
            Assert.That(_flow.Words, Does.Contain("paired"));
        }

        [Test]
        public void Token_SeenFirst_IsUsedAfterConsent()
        {
            Frame(Token);
            Assert.That(_flow.Words, Does.Contain("now look at the robot's marker"));
            Frame(Cell);
            Assert.That(_sent, Is.Empty, "the wearer has not agreed yet");

            _flow.Accept();
            Frame();

            Assert.That(_sent.Count, Is.EqualTo(1));
        }

        [Test]
        public void Token_SeenBeforeItsValidity_IsNotUsed()
        {
            Frame(Token);
            _now += PairingLimits.CodeValidity;
            Frame();

            Agree(Cell);

            Assert.That(_sent, Is.Empty);
        }

        [Test]
        public void Question_NotAnswered_HasNoEffect()
        {
            for (var i = 0; i < 100; i++) Frame(Cell, Token);

            Assert.That(_sent, Is.Empty);
            Assert.That(_flow.Cells.Used, Is.Null);
        }

        [Test]
        public void Refuse_Gateway_DoesNotAskAgainForItsMarkersInThisRun()
        {
            Frame(Cell);
            _flow.Refuse();

            Look(Cell, CodeOf("Press 3", "10.0.0.7", Pin, 1), Token);

            Assert.That(_flow.Question, Is.Null);
            Assert.That(_sent, Is.Empty);
            Frame(CodeOf("Press 3", "10.0.0.8", Pin));
            Assert.That(_flow.Question, Is.Not.Null, "another gateway is another question");
        }

        [Test]
        public void KnownCell_SeenAgain_IsUsedWithoutAQuestion()
        {
            Pair(Cell, Token);
            Begin(_flow.Cells);

            Assert.That(Frame() & PairingChange.Applied, Is.EqualTo(PairingChange.Applied), "at once, before anything is seen");
            Frame(Cell, Token);

            Assert.That(_flow.Question, Is.Null);
            Assert.That(_sent.Count, Is.EqualTo(1), "it has its token");
        }

        [TestCase(6000, 47011, "ports 6000 and 47011 instead of 47010 and 47011")]
        [TestCase(47010, 6000, "ports 47010 and 6000 instead of 47010 and 47011")]
        public void KnownCell_WithOtherPorts_IsAskedBeforeAnythingIsSent(int syncPort, int webSocketPort, string part)
        {
            Agree(Cell);

            Frame(new CellCode("Press 3", "10.0.0.7", Pin, null, 0, syncPort, webSocketPort).Text, Token);
            Frame();

            Assert.That(_flow.Question, Does.Contain(part));
            Assert.That(_sentTo[0].WebSocketPort, Is.EqualTo(47011));
            Assert.That(_flow.Cells.Used.Codes.Count, Is.EqualTo(1));
        }

        [TestCase("10.0.0.8", false, "10.0.0.8 instead of 10.0.0.7")]
        [TestCase("10.0.0.7", true, "AAECAwQFBgcI… instead of key AAAAAAAAAAAA…")]
        public void KnownCell_WithAnotherGateway_QuestionNamesTheChange(string host, bool isOtherPin, string part)
        {
            Pair(Cell, Token);

            Frame(CodeOf("Press 3", host, isOtherPin ? OtherPin : Pin));

            Assert.That(_flow.Question, Does.Contain(part));
            Assert.That(_flow.Cells.Used.Newest.Text, Is.EqualTo(Cell), "until it is answered");
        }

        [TestCase(false, OwnToken)]
        [TestCase(true, null)]
        public void KnownCell_WithAnotherGateway_KeepsTheTokenOnlyForTheSameKey(bool isOtherPin, string token)
        {
            Pair(Cell, Token);

            Agree(CodeOf("Press 3", "10.0.0.8", isOtherPin ? OtherPin : Pin));

            Assert.That(_flow.Cells.Used.Newest.Host, Is.EqualTo("10.0.0.8"));
            Assert.That(_flow.Cells.Used.Token, Is.EqualTo(token));
        }

        [Test]
        public void KnownCell_GatewayChangedDuringPairing_IgnoresTheFormerToken()
        {
            Agree(Cell);
            Frame(Token);

            Agree(CodeOf("Press 3", "10.0.0.8", OtherPin));
            _answer.SetResult(PairingAnswer.Accepted(OwnToken));
            Frame();

            Assert.That(_flow.Cells.Used.Newest.Pin, Is.EqualTo(OtherPin));
            Assert.That(_flow.Cells.Used.Token, Is.Null);
        }

        [Test]
        public void KnownCell_AnotherMarker_IsAdded()
        {
            Pair(Cell, Token);
            var second = CodeOf("Press 3", "10.0.0.7", Pin, 0.3);

            var changes = Frame(second);

            Assert.That(changes & PairingChange.Applied, Is.EqualTo(PairingChange.Applied));
            Assert.That(_flow.Cells.Used.Codes.Count, Is.EqualTo(2));
            Assert.That(_flow.Cells.Used.Token, Is.EqualTo(OwnToken));
            Assert.That(Frame(Cell, second), Is.EqualTo(PairingChange.None));
        }

        static readonly string Other = CodeOf("Press 4", "10.0.0.9", OtherPin);

        void PairBoth()
        {
            Pair(Other, TokenOf(2, OtherPin));
            Pair(Cell, Token);
            Assert.That(_flow.Cells.Used.Cell, Is.EqualTo("Press 3"));
        }

        [TestCase(true, "Press 4")]
        [TestCase(false, "Press 3")]
        public void OtherKnownCell_AloneInView_IsUsedOnlyWithConsent(bool isAgreed, string used)
        {
            PairBoth();

            Look(Other);

            Assert.That(_flow.Question, Is.EqualTo("Use cell 'Press 4' instead of 'Press 3'?"));
            Assert.That(_flow.Cells.Used.Cell, Is.EqualTo("Press 3"), "until it is answered");
            if (isAgreed) _flow.Accept();
            else _flow.Refuse();
            Look(Other);
            Assert.That(_flow.Cells.Used.Cell, Is.EqualTo(used));
            Assert.That(_flow.Question, Is.Null);
        }

        [Test]
        public void OtherKnownCell_SeenBrieflyOrBesideTheUsedCell_DoesNotAsk()
        {
            PairBoth();

            for (var i = 0; i < 100; i++)
            {
                Frame(Other);
                Frame();
            }
            Look(Cell, Other);

            Assert.That(_flow.Question, Is.Null);
        }

        [Test]
        public void OtherKnownCell_Declined_AsksAgainAfterAMinuteOutOfView()
        {
            PairBoth();
            Look(Other);
            _flow.Refuse();

            for (var i = 0; i < 3; i++)
            {
                _now += TimeSpan.FromSeconds(50);
                Look(Other);
                Assert.That(_flow.Question, Is.Null);
            }
            Frame();
            _now += TimeSpan.FromSeconds(61);
            Frame();
            Look(Other);

            Assert.That(_flow.Question, Does.StartWith("Use cell"));
        }

        [Test]
        public void Refuse_AnotherQuestionPending_IsAskedAfterADelay()
        {
            Frame(Cell, Other);
            _flow.Refuse();

            Frame(Cell, Other);
            Assert.That(_flow.Question, Is.Null);
            Look(Cell, Other);

            Assert.That(_flow.Question, Does.StartWith("Connect to cell 'Press 4'?"));
        }

        [Test]
        public void Token_OfAnotherGateway_IsNotSent()
        {
            Agree(Cell);

            Frame(TokenOf(1, OtherPin));

            Assert.That(_sent, Is.Empty);
        }

        [Test]
        public void Token_RefusedByTheGateway_IsReportedOnceAndTheNextIsTried()
        {
            Agree(Cell);
            Frame(Token);
            _answer.SetResult(PairingAnswer.Refused("used"));

            Assert.That(Frame(Token) & PairingChange.Problem, Is.EqualTo(PairingChange.Problem));
            Assert.That(_flow.Words, Is.EqualTo("used"));
            for (var i = 0; i < 10; i++) Frame(Token);
            Assert.That(_sent.Count, Is.EqualTo(1));
            Frame(TokenOf(2, Pin));
            Assert.That(_sent.Count, Is.EqualTo(2));
            Assert.That(_flow.Problem, Is.Null);
        }

        [Test]
        public void Token_NoAnswer_IsRetriedUntilItExpires()
        {
            Agree(Cell);
            Frame(Token);
            var end = _now + PairingLimits.CodeValidity + PairingLimits.RetryInterval;
            var said = 0;

            while (_now < end)
            {
                _answer.TrySetResult(PairingAnswer.Failed("no answer"));
                if ((Frame() & PairingChange.Problem) != 0) said++;
                _now += TimeSpan.FromSeconds(1);
            }

            Assert.That(_sent.Count, Is.InRange(70, 100), "every three seconds");
            Assert.That(said, Is.EqualTo(2), "that it goes on, and that it does not");
            Assert.That(_flow.Problem, Is.EqualTo("no answer"));
        }

        [Test]
        public void Token_RefusedLater_IsReplacedByAnotherCode()
        {
            Pair(Cell, Token);
            _flow.IsTokenRefused = true;

            Frame(Token);
            Assert.That(_sent.Count, Is.EqualTo(1), "that one is used up");
            Frame(TokenOf(2, Pin));
            _answer.SetResult(PairingAnswer.Accepted("newer"));
            Frame();

            Assert.That(_flow.Cells.Used.Token, Is.EqualTo("newer"));
        }

        [Test]
        public void Forget_UsedCell_RemovesItAndAsksAgain()
        {
            Pair(Cell, Token);

            _flow.Forget();

            Assert.That(Frame() & (PairingChange.Applied | PairingChange.Kept), Is.EqualTo(PairingChange.Applied | PairingChange.Kept));
            Assert.That(_flow.Cells.All, Is.Empty);
            Frame(Cell);
            Assert.That(_flow.Question, Is.Not.Null);
        }

        [TestCase(true)]
        [TestCase(false)]
        public void AskToForget_UsedCell_IsForgottenOnlyWithConsent(bool isAgreed)
        {
            Pair(Cell, Token);

            _flow.AskToForget();

            Assert.That(Frame(Cell) & PairingChange.Asked, Is.EqualTo(PairingChange.Asked));
            Assert.That(_flow.Question, Does.StartWith("Forget cell 'Press 3'?").And.Contain("code"));
            Assert.That(_flow.Cells.Used.Cell, Is.EqualTo("Press 3"), "until it is answered");
            if (isAgreed) _flow.Accept();
            else _flow.Refuse();
            Assert.That(_flow.Question, Is.Null);
            Assert.That(_flow.Cells.All.Count, Is.EqualTo(isAgreed ? 0 : 1));
            Assert.That(Frame() & PairingChange.Kept, Is.EqualTo(isAgreed ? PairingChange.Kept : PairingChange.None));
        }

        [Test]
        public void AskToForget_AnotherQuestionIsOpen_ReplacesItUntilAnswered()
        {
            Pair(Cell, Token);
            Frame(Cell, Other);

            _flow.AskToForget();
            Frame(Cell, Other);
            Assert.That(_flow.Question, Does.StartWith("Forget cell 'Press 3'?"));
            _flow.Refuse();
            Look(Cell, Other);

            Assert.That(_flow.Question, Does.StartWith("Connect to cell 'Press 4'?"));
        }

        [Test]
        public void AskToForget_GatewayWasDeclined_AsksAgainAtTheNextSighting()
        {
            Frame(Cell);
            _flow.Refuse();
            Look(Cell);
            Assert.That(_flow.Question, Is.Null);

            _flow.AskToForget();
            Assert.That(_flow.Question, Is.Null, "no cell is paired");
            Frame(Cell);

            Assert.That(_flow.Question, Does.StartWith("Connect to cell 'Press 3'?"));
        }

        [Test]
        public void Forget_DuringPairing_IgnoresTheToken()
        {
            Agree(Cell);
            Frame(Token);

            _flow.Forget();
            _answer.SetResult(PairingAnswer.Accepted(OwnToken));
            Frame();

            Assert.That(_flow.Cells.All, Is.Empty);
        }

        [Test]
        public void Token_InterruptedByForget_IsTriedAgain()
        {
            Agree(Cell);
            Frame(Token);
            _flow.Forget();

            Agree(Cell);
            Frame(Token);

            Assert.That(_sent.Count, Is.EqualTo(2));
        }

        [Test]
        public void Token_TriedBefore_IsReported()
        {
            Pair(Cell, Token);
            _flow.IsTokenRefused = true;

            Frame(Token);

            Assert.That(_flow.Words, Is.EqualTo("this code has been tried; request another one on the gateway's page or terminal"));
            Assert.That(_flow.IsSettled, Is.False);
        }

        [Test]
        public void Gateway_OnThisMachine_NeedsNoToken()
        {
            Agree(new CellCode("desk", "localhost", null).Text);

            Assert.That(_flow.Cells.Used.IsReady, Is.True);
        }

        [TestCase("https://example.org/")]
        [TestCase("WIFI:S:plant;T:WPA;P:secret;;")]
        [TestCase("")]
        [TestCase(null)]
        public void Code_Foreign_IsIgnored(string text) => Assert.That(Frame(text) & ~PairingChange.Words, Is.EqualTo(PairingChange.None));

        [TestCase("nowpose:cell/1?n=a")]
        [TestCase("nowpose:cell/9?n=a")]
        [TestCase("nowpose:elephant/1?n=a")]
        [TestCase("NOWPOSE:CELL/1?n=a")]
        public void Code_Malformed_IsReportedOnce(string text)
        {
            Assert.That(Frame(text) & PairingChange.Problem, Is.EqualTo(PairingChange.Problem));
            Assert.That(_flow.Problem, Is.Not.Null);

            for (var i = 0; i < 10; i++) Assert.That(Frame(text), Is.EqualTo(PairingChange.None));
        }

        [Test]
        public void Code_Malformed_IsShownForTenSeconds()
        {
            Agree(Cell);
            var said = _flow.Words;
            Frame("nowpose:cell/1?n=a");
            _now += TimeSpan.FromSeconds(9);
            Frame();
            Assert.That(_flow.Words, Is.EqualTo(_flow.Problem));

            _now += TimeSpan.FromSeconds(1);

            Assert.That(Frame() & PairingChange.Words, Is.EqualTo(PairingChange.Words));
            Assert.That(_flow.Problem, Is.Null);
            Assert.That(_flow.Words, Is.EqualTo(said));
        }

        [Test]
        public void Code_MalformedBesideAValidToken_IsStillReported()
        {
            Agree(Cell);

            var changes = Frame("nowpose:cell/1?n=a", Token);

            Assert.That(_sent.Count, Is.EqualTo(1));
            Assert.That(changes & PairingChange.Problem, Is.EqualTo(PairingChange.Problem));
            Assert.That(_flow.Problem, Does.Contain("h is missing"));
        }

        [Test]
        public void Code_TooManyMarkersOfACell_IsReportedAndDropsNone()
        {
            Pair(Cell, Token);
            for (var i = 1; i < PairedCell.MaxCodes; i++) Frame(CodeOf("Press 3", "10.0.0.7", Pin, i));
            var said = 0;

            for (var i = 0; i < 5; i++)
                if ((Frame(CodeOf("Press 3", "10.0.0.7", Pin, 0.5)) & PairingChange.Problem) != 0) said++;

            Assert.That(said, Is.EqualTo(1));
            Assert.That(_flow.Problem, Does.Contain("16"));
            Assert.That(_flow.Cells.Used.Holds(CellCode.Parse(Cell)), Is.True);
        }

        [Test]
        public void Code_Oversized_IsReportedOnceAndNotStored()
        {
            var said = 0;

            for (var i = 0; i < 10; i++)
                if ((Frame("nowpose:cell/1?n=" + new string('a', 4000 + i)) & PairingChange.Problem) != 0) said++;

            Assert.That(said, Is.EqualTo(1));
            Assert.That(_flow.Problem, Does.Contain("213"));
        }

        [Test]
        public void Code_ManyMalformed_PairedCellStaysInUse()
        {
            Pair(Cell, Token);
            for (var i = 0; i < 2000; i++) Frame("nowpose:cell/1?n=a" + i);

            Frame(Cell);

            Assert.That(_flow.Cells.Used.Cell, Is.EqualTo("Press 3"));
        }

        [Test]
        public void Code_TooManyInView_IsReportedOnceUntilTheyAreOutOfView()
        {
            var said = 0;
            for (var i = 0; i < 300; i++)
                if ((Frame(TokenOf(1, Pin).Replace("t=AQ", "t=" + (char)('A' + i / 26) + (char)('a' + i % 26))) & PairingChange.Problem) != 0) said++;
            Assert.That(said, Is.EqualTo(1));
            Assert.That(_flow.Problem, Does.Contain("256 different ones"));
            Frame(Cell);
            Assert.That(_flow.Question, Is.Null, "no further codes are kept");

            _now += PairingLimits.CodeValidity;
            Frame(Cell);

            Assert.That(_flow.Question, Is.Not.Null);
        }
    }
}
