using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Sync.Envelope;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

[NonParallelizable] // measures allocations
public class ExchangeAllocationTests
{
    [Test]
    public void Estimate_FullHistory_AllocatesNothing()
    {
        var estimator = new DefaultClockEstimator();
        var (up, down) = (NetworkProfile.BusyWifi.Up(1), NetworkProfile.BusyWifi.Down(2));
        var allocated = 0L;
        for (var i = 0; i < 1500; i++)
        {
            var sent = HeadsetTime.FromSeconds(i * 0.2);
            var arrived = sent + up.Next();
            var control = new ControlTime(arrived.SinceEpoch);
            var exchange = new SyncExchange(sent, control, control, arrived + down.Next());

            var before = GC.GetAllocatedBytesForCurrentThread();
            estimator.Add(exchange);
            if (i >= 1000) allocated += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.That(allocated, Is.EqualTo(0));
    }

    [Test]
    public void Follow_Correction_AllocatesNothing()
    {
        var clock = new ClockSynchroniser(new DefaultClockEstimator(), ClockSettings.Default);
        var display = new DisplayClock();
        var allocated = 0L;
        for (var i = 0; i < 2000; i++)
        {
            var now = HeadsetTime.FromSeconds(i / 60.0);
            var control = new ControlTime(now.SinceEpoch - TimeSpan.FromMilliseconds(i % 7));
            if (i % 12 == 0) clock.Add(new SyncExchange(now - TimeSpan.FromMilliseconds(9), control, control, now), out _);

            var before = GC.GetAllocatedBytesForCurrentThread();
            display.Follow(clock.ModelAt(now), now);
            if (i >= 500) allocated += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.That(allocated, Is.EqualTo(0));
    }
}
