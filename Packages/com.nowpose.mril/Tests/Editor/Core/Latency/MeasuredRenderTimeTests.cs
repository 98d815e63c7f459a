using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Latency
{
    public class MeasuredRenderTimeTests
    {
        // MeasuredRenderTime and SweepRow must accept the same values. A value that only one of them accepts would be lost.
        [TestCase(0.001, true)]
        [TestCase(1000, true)]
        [TestCase(0, false)]
        [TestCase(-5, false)]
        [TestCase(1000.1, false)]
        [TestCase(double.NaN, false)]
        [TestCase(double.PositiveInfinity, false)]
        public void Is_AnyNumber_MatchesTheRenderTimesThatSweepRowAccepts(double ms, bool expected)
        {
            Assert.That(MeasuredRenderTime.Is(ms), Is.EqualTo(expected));
            Assert.That(
                IsTaken(() => new SweepRow(ControlTime.FromSeconds(1), 0, ms, RenderTimeSourceKind.DisplayGpuTime, "", 60)), Is.EqualTo(expected));
        }

        static bool IsTaken<T>(System.Func<T> make)
        {
            try
            {
                make();
                return true;
            }
            catch (InputException)
            {
                return false;
            }
        }
    }
}
