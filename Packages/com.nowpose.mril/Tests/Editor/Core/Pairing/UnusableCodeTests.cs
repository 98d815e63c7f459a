using System;
using Nowpose.Messages;
using Nowpose.Pairing;
using NUnit.Framework;
using static Nowpose.Tests.Core.Pairing.SimulatedPairing;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Checks that codes in view that cannot be used are ignored or reported once.</summary>
    public class UnusableCodeTests
    {
        SimulatedPairing _pairing;

        [SetUp]
        public void Start() => _pairing = new SimulatedPairing();

        [TearDown]
        public void Stop() => _pairing.Dispose();

        [TestCase("https://example.org/")]
        [TestCase("WIFI:S:plant;T:WPA;P:secret;;")]
        [TestCase("")]
        [TestCase(null)]
        public void Code_Foreign_IsIgnored(string text) => Assert.That(_pairing.Frame(text) & ~PairingChange.Words, Is.EqualTo(PairingChange.None));

        [TestCase("nowpose:cell/1?n=a")]
        [TestCase("nowpose:cell/9?n=a")]
        [TestCase("nowpose:elephant/1?n=a")]
        [TestCase("NOWPOSE:CELL/1?n=a")]
        public void Code_Malformed_IsReportedOnce(string text)
        {
            Assert.That(_pairing.Frame(text) & PairingChange.Problem, Is.EqualTo(PairingChange.Problem));
            Assert.That(_pairing.Flow.Problem, Is.Not.Null);

            for (var i = 0; i < 10; i++) Assert.That(_pairing.Frame(text), Is.EqualTo(PairingChange.None));
        }

        [Test]
        public void Code_Malformed_IsShownForTenSeconds()
        {
            _pairing.Agree(Cell);
            var words = _pairing.Flow.Words;
            _pairing.Frame("nowpose:cell/1?n=a");
            _pairing.Now += TimeSpan.FromSeconds(9);
            _pairing.Frame();
            Assert.That(_pairing.Flow.Words, Is.EqualTo(_pairing.Flow.Problem));

            _pairing.Now += TimeSpan.FromSeconds(1);

            Assert.That(_pairing.Frame() & PairingChange.Words, Is.EqualTo(PairingChange.Words));
            Assert.That(_pairing.Flow.Problem, Is.Null);
            Assert.That(_pairing.Flow.Words, Is.EqualTo(words));
        }

        [Test]
        public void Code_MalformedBesideAValidToken_IsStillReported()
        {
            _pairing.Agree(Cell);

            var changes = _pairing.Frame("nowpose:cell/1?n=a", Token);

            Assert.That(_pairing.Sent.Count, Is.EqualTo(1));
            Assert.That(changes & PairingChange.Problem, Is.EqualTo(PairingChange.Problem));
            Assert.That(_pairing.Flow.Problem, Does.EndWith(PairingCodeMessages.FieldMissing('h')));
        }

        [Test]
        public void Code_TooManyMarkersOfACell_IsReportedAndTheOthersAreKept()
        {
            _pairing.Pair(Cell, Token);
            for (var i = 1; i < PairedCell.MaxCodes; i++) _pairing.Frame(CodeOf("Press 3", "10.0.0.7", Pin, i));
            var problems = 0;

            for (var i = 0; i < 5; i++)
                if ((_pairing.Frame(CodeOf("Press 3", "10.0.0.7", Pin, 0.5)) & PairingChange.Problem) != 0) problems++;

            Assert.That(problems, Is.EqualTo(1));
            Assert.That(_pairing.Flow.Problem, Does.Contain("16"));
            Assert.That(_pairing.Flow.Cells.Used.Holds(CellCode.Parse(Cell)), Is.True);
        }

        [Test]
        public void Code_Oversized_IsReportedOnceForAllCodes()
        {
            var problems = 0;

            for (var i = 0; i < 10; i++)
                if ((_pairing.Frame("nowpose:cell/1?n=" + new string('a', 4000 + i)) & PairingChange.Problem) != 0) problems++;

            Assert.That(problems, Is.EqualTo(1));
            Assert.That(_pairing.Flow.Problem, Does.Contain("213"));
        }

        [Test]
        public void Code_ManyMalformed_PairedCellStaysInUse()
        {
            _pairing.Pair(Cell, Token);
            for (var i = 0; i < 2000; i++) _pairing.Frame("nowpose:cell/1?n=a" + i);

            _pairing.Frame(Cell);

            Assert.That(_pairing.Flow.Cells.Used.Cell, Is.EqualTo("Press 3"));
        }

        [Test]
        public void Code_TooManyDifferentTokens_AreReportedOnceUntilTheyExpire()
        {
            var problems = 0;
            for (var i = 0; i < 300; i++)
            {
                var changes = _pairing.Frame(TokenOf(1, Pin).Replace("t=AQ", "t=" + (char)('A' + i / 26) + (char)('a' + i % 26)));
                if ((changes & PairingChange.Problem) != 0) problems++;
            }
            Assert.That(problems, Is.EqualTo(1));
            Assert.That(_pairing.Flow.Problem, Is.EqualTo(PairingCodeMessages.TooManyInView(256, 5)));
            _pairing.Frame(Cell);
            Assert.That(_pairing.Flow.Question, Is.Null, "no more codes are stored");

            _pairing.Now += PairingLimits.CodeValidity;
            _pairing.Frame(Cell);

            Assert.That(_pairing.Flow.Question, Is.Not.Null);
        }
    }
}
