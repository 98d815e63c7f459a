using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class ReportedErrorsTests
    {
        ReportedErrors _errors;

        [SetUp]
        public void Connect() => _errors = new ReportedErrors();

        string After(double seconds, string text, string level = "error")
        {
            Assert.That(RosbridgeReader.TryRead(RosbridgeWriter.Status(level, text), out var message, out _), Is.True);
            return _errors.Add(message, HeadsetTime.FromSeconds(seconds)).Warning;
        }

        string At(double seconds) => _errors.StatusAt(HeadsetTime.FromSeconds(seconds)).Warning;

        [Test]
        public void Add_Error_IsTheWarningUntilItIsNoLongerRepeated()
        {
            var taken = ConnectionMessages.Reported("the name is taken");

            Assert.That(At(1), Is.Null);
            Assert.That(After(2, "the name is taken"), Is.EqualTo(taken));
            Assert.That(After(6, "the name is taken"), Is.EqualTo(taken));
            Assert.That(At(11), Is.EqualTo(taken), "5 s after the newest repetition");
            Assert.That(At(11.1), Is.Null);
        }

        [Test]
        public void Add_TwoErrorsAlternate_KeepsTheFirst()
        {
            var first = After(0, "first");

            for (var i = 1; i < 20; i++)
            {
                Assert.That(After(i - 0.5, "second"), Is.EqualTo(first));
                Assert.That(After(i, "first"), Is.EqualTo(first));
            }
            Assert.That(After(25, "second"), Is.EqualTo(ConnectionMessages.Reported("second")));
        }

        [TestCase("warning")]
        [TestCase("info")]
        public void Add_LowerLevel_IsNoWarning(string level) => Assert.That(After(0, "served in part", level), Is.Null);

        [Test]
        public void Add_LongTextOfSeveralLines_IsOneShortLine()
        {
            var warning = After(0, "one\ntwo" + new string('.', 2000));

            Assert.That(warning, Does.Not.Contain("\n"));
            Assert.That(warning.Length, Is.LessThan(400));
        }
    }
}
