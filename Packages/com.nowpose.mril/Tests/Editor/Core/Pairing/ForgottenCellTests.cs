using Nowpose.Messages;
using Nowpose.Pairing;
using NUnit.Framework;
using static Nowpose.Tests.Core.Pairing.SimulatedPairing;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Tests how a paired cell is removed.</summary>
    public class ForgottenCellTests
    {
        SimulatedPairing _pairing;

        [SetUp]
        public void Start() => _pairing = new SimulatedPairing();

        [TearDown]
        public void Stop() => _pairing.Dispose();

        [Test]
        public void Forget_CellInUse_RemovesTheCellAndAsksAgain()
        {
            _pairing.Pair(Cell, Token);

            _pairing.Flow.Forget();

            Assert.That(_pairing.Frame() & (PairingChange.Applied | PairingChange.Kept), Is.EqualTo(PairingChange.Applied | PairingChange.Kept));
            Assert.That(_pairing.Flow.Cells.All, Is.Empty);
            _pairing.Frame(Cell);
            Assert.That(_pairing.Flow.Question, Is.Not.Null);
        }

        [TestCase(true)]
        [TestCase(false)]
        public void AskToForget_CellInUse_ForgetsOnlyWithConsent(bool isAgreed)
        {
            _pairing.Pair(Cell, Token);

            _pairing.Flow.AskToForget();

            Assert.That(_pairing.Frame(Cell) & PairingChange.Asked, Is.EqualTo(PairingChange.Asked));
            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Forget(CellCode.Parse(Cell))));
            Assert.That(_pairing.Flow.Cells.Used.Cell, Is.EqualTo("Press 3"), "until the question is answered");
            if (isAgreed) _pairing.Flow.Accept();
            else _pairing.Flow.Refuse();
            Assert.That(_pairing.Flow.Question, Is.Null);
            Assert.That(_pairing.Flow.Cells.All.Count, Is.EqualTo(isAgreed ? 0 : 1));
            Assert.That(_pairing.Frame() & PairingChange.Kept, Is.EqualTo(isAgreed ? PairingChange.Kept : PairingChange.None));
        }

        [Test]
        public void AskToForget_AnotherQuestionIsOpen_IsAskedFirst()
        {
            _pairing.Pair(Cell, Token);
            _pairing.Frame(Cell, Other);

            _pairing.Flow.AskToForget();
            _pairing.Frame(Cell, Other);
            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Forget(CellCode.Parse(Cell))));
            _pairing.Flow.Refuse();
            _pairing.Look(Cell, Other);

            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Question(CellCode.Parse(Other), null)));
        }

        [Test]
        public void AskToForget_GatewayWasDeclined_AsksAgainAtTheNextSighting()
        {
            _pairing.Frame(Cell);
            _pairing.Flow.Refuse();
            _pairing.Look(Cell);
            Assert.That(_pairing.Flow.Question, Is.Null);

            _pairing.Flow.AskToForget();
            Assert.That(_pairing.Flow.Question, Is.Null, "no cell is paired");
            _pairing.Frame(Cell);

            Assert.That(_pairing.Flow.Question, Is.EqualTo(PairingMessages.Question(CellCode.Parse(Cell), null)));
        }

        [Test]
        public void Forget_DuringPairing_IgnoresTheToken()
        {
            _pairing.Agree(Cell);
            _pairing.Frame(Token);

            _pairing.Flow.Forget();
            _pairing.Answer.SetResult(PairingAnswer.Accepted(OwnToken));
            _pairing.Frame();

            Assert.That(_pairing.Flow.Cells.All, Is.Empty);
        }

        [Test]
        public void Token_PairingInterruptedByForget_IsSentAgain()
        {
            _pairing.Agree(Cell);
            _pairing.Frame(Token);
            _pairing.Flow.Forget();

            _pairing.Agree(Cell);
            _pairing.Frame(Token);

            Assert.That(_pairing.Sent.Count, Is.EqualTo(2));
        }
    }
}
