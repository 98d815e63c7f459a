using Nowpose.Latency;
using Nowpose.Latency.Calibration;
using NUnit.Framework;
using Nowpose.Messages;

namespace Nowpose.Tests.Core.Latency.Calibration
{
    public class MarkedNudgesTests
    {
        [Test]
        public void Result_SlightlyDifferentSpeeds_IsExact()
        {
            var marks = new MarkedNudges(40);
            marks.Add(0.020 * 250 + 3, 250);
            marks.Add(-0.020 * 260 + 3, -260);

            Assert.That(marks.Result.Visualisation.Length.TotalMilliseconds, Is.EqualTo(60).Within(1e-3));
        }

        [Test]
        public void Add_SignedSpeed_CountsTheMarkForItsDirection()
        {
            var marks = new MarkedNudges(40);
            marks.Add(5, 250);
            marks.Add(5, 250);
            marks.Add(-5, -250);

            Assert.That(marks.ForwardCount, Is.EqualTo(2));
            Assert.That(marks.BackwardCount, Is.EqualTo(1));
            Assert.That(marks.Result.Count, Is.EqualTo(3));
        }

        static readonly object[][] InvalidSpeeds =
        {
            new object[] { 19, NudgeMessages.TooSlow(19, 20) },
            new object[] { double.NaN, NudgeMessages.TooSlow(double.NaN, 20) },
            new object[] { -200, NudgeMessages.OtherSpeed(200, 250) },
        };

        [TestCaseSource(nameof(InvalidSpeeds))]
        public void Add_InvalidSpeed_ThrowsAndKeepsTheMarks(double speedMmPerS, string message)
        {
            var marks = new MarkedNudges(40);
            marks.Add(5, 250);

            Assert.That(Assert.Throws<InputException>(() => marks.Add(5, speedMmPerS)).Message, Is.EqualTo(message));
            Assert.That(marks.ForwardCount + marks.BackwardCount, Is.EqualTo(1));
        }

        [Test]
        public void Result_NoMark_NamesTheMissingDirection()
        {
            var marks = new MarkedNudges(40);
            marks.Add(5, 250);
            marks.Clear();

            Assert.That(Assert.Throws<InputException>(() => marks.Result.ToString()).Message, Is.EqualTo(NudgeMessages.NoMark(isForward: true)));
        }
    }
}
