using Nowpose.Latency;
using NUnit.Framework;
using static Nowpose.Tests.Core.Latency.MonitoredDisplay;

namespace Nowpose.Tests.Core.Latency
{
    public class UnknownRangeTests
    {
        [Test]
        public void Add_FewerThanEightFrames_IsUnknownWithTheReason()
        {
            var monitor = Monitor();
            Add(monitor, 20, 7);
            var (early, reason) = (monitor.State, monitor.UnknownReason);
            Add(monitor, 20);

            Assert.That(early, Is.EqualTo(RangeState.Unknown));
            Assert.That(reason, Is.EqualTo(RangeUnknownReason.TooFewFrames));
            Assert.That(monitor.State, Is.EqualTo(RangeState.Outside));
            Assert.That(monitor.UnknownReason, Is.EqualTo(RangeUnknownReason.None));
        }

        [Test]
        public void Add_SourceDiffersFromTheSourceOfTheLimit_IsUnknownWithTheReason()
        {
            var monitor = Monitor();
            Add(monitor, 20, 100);

            Add(monitor, 20, 100, RenderTimeSourceKind.GpuCompletion);

            Assert.That(monitor.State, Is.EqualTo(RangeState.Unknown));
            Assert.That(monitor.UnknownReason, Is.EqualTo(RangeUnknownReason.OtherSource));
            Assert.That(monitor.Source, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
            Assert.That(monitor.RenderTime.Value.TotalMilliseconds, Is.EqualTo(20).Within(1e-3));
        }

        [Test]
        public void Add_SourceOfTheLimitReturns_DiscardsEarlierFrames()
        {
            var monitor = Monitor();
            Add(monitor, 20, 100);
            Add(monitor, 20, 1, RenderTimeSourceKind.CameraCpu);
            Add(monitor, 10, 7);
            var early = monitor.State;

            Add(monitor, 10);

            Assert.That(early, Is.EqualTo(RangeState.Unknown));
            Assert.That(monitor.State, Is.EqualTo(RangeState.Inside));
        }

        [Test]
        public void Add_SourceStopped_IsUnknown()
        {
            var monitor = Monitor();
            Add(monitor, 10, 100);

            Add(monitor, 10, 1, RenderTimeSourceKind.None);

            Assert.That(monitor.State, Is.EqualTo(RangeState.Unknown));
            Assert.That(monitor.UnknownReason, Is.EqualTo(RangeUnknownReason.NoRenderTime));
            Assert.That(monitor.RenderTime, Is.Null);
        }

        [Test]
        public void State_NoRange_IsUnknownForAnyLoad()
        {
            var monitor = new ConstantLatencyMonitor(null);

            Add(monitor, 100, 100);

            Assert.That(monitor.State, Is.EqualTo(RangeState.Unknown));
            Assert.That(monitor.UnknownReason, Is.EqualTo(RangeUnknownReason.NoLimit));
            Assert.That(monitor.RenderTime.Value.TotalMilliseconds, Is.EqualTo(100).Within(1e-3));
        }

        [TestCase(16, RangeUnknownReason.NoLimit)]
        [TestCase(18, RangeUnknownReason.LongerThanRefresh)]
        public void UnknownReason_NoRange_ReportsMissedRefreshes(double renderMs, object reason)
        {
            var monitor = new ConstantLatencyMonitor(null) { RefreshInterval = Lengths.Ms(1000 / 60.0) };

            Add(monitor, renderMs, 100);

            Assert.That((monitor.State, monitor.UnknownReason), Is.EqualTo((RangeState.Unknown, (RangeUnknownReason)reason)));
        }

        // Other sources include waiting times of up to a frame.
        [TestCase(RenderTimeSourceKind.CameraCpu)]
        [TestCase(RenderTimeSourceKind.GpuCompletion)]
        [TestCase(RenderTimeSourceKind.EngineGpuTime)]
        public void UnknownReason_NoRangeAndAnotherSource_IsNoLimit(RenderTimeSourceKind source)
        {
            var monitor = new ConstantLatencyMonitor(null) { RefreshInterval = Lengths.Ms(1000 / 60.0) };

            for (var i = 0; i < 100; i++) monitor.Add(Lengths.Ms(18), source);

            Assert.That(monitor.UnknownReason, Is.EqualTo(RangeUnknownReason.NoLimit));
        }

        [Test]
        public void UnknownReason_NoRangeAndLoadNearARefresh_DoesNotAlternate()
        {
            var monitor = new ConstantLatencyMonitor(null) { RefreshInterval = Lengths.Ms(1000 / 60.0) };
            Add(monitor, 18, 100);

            Add(monitor, 16.5, 100);
            var near = monitor.UnknownReason;
            Add(monitor, 12, 100);

            Assert.That((near, monitor.UnknownReason), Is.EqualTo((RangeUnknownReason.LongerThanRefresh, RangeUnknownReason.NoLimit)));
        }

        [Test]
        public void State_LimitNotReached_IsInsideUpToTheMeasuredMaximumAndUnknownBeyond()
        {
            var monitor = new ConstantLatencyMonitor(new ConstantLatencyRange(12, Source, isLimitReached: false));
            Add(monitor, 11, 100);
            var inside = monitor.State;

            Add(monitor, 14, 100);

            Assert.That(inside, Is.EqualTo(RangeState.Inside));
            Assert.That(monitor.State, Is.EqualTo(RangeState.Unknown));
            Assert.That(monitor.UnknownReason, Is.EqualTo(RangeUnknownReason.BeyondMeasured));
        }
    }
}
