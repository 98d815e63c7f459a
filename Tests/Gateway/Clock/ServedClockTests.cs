using System.Diagnostics;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway.Clock;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Gateway.Clock;

/// <summary>Tests, in virtual time, how the gateway measures two clocks of one control system, which have different rates.</summary>
public class ServedClockTests
{
    [TestCase(0, 0)]
    [TestCase(40, -25)]
    [TestCase(-120, 90)]
    public void Status_TwoClocksOfOnePlant_ContainsTheirOffsetAndSkew(double adsPpm, double opcuaPpm)
    {
        var plant = new VirtualPlant();
        var ads = plant.Add("ads", 1000, adsPpm);
        var opcua = plant.Add("opcua", 1003.5, opcuaPpm);

        plant.Run(TimeSpan.FromMinutes(3));

        var status = plant.Served.Status();
        var truth = opcua.Shown - ads.Shown;
        Assert.That(status[0].IsControlClock, Is.True);
        Assert.That(status[0].OffsetToControl, Is.EqualTo(TimeSpan.Zero));
        Assert.That(status[1].State, Is.EqualTo(ClockState.Synchronised));
        Assert.That((status[1].OffsetToControl.Value - truth).Duration(), Is.LessThan(TimeSpan.FromMilliseconds(0.05)));
        Assert.That(status[1].SkewPpm.Value, Is.EqualTo(opcuaPpm - adsPpm).Within(1));
        Assert.That((plant.Served.Now - ads.Shown).Duration(), Is.LessThan(TimeSpan.FromMilliseconds(0.05)));
    }

    [Test]
    public void Now_PlantClockStepsByASecond_IsUnsynchronisedUntilTheEstimateFollows()
    {
        var plant = new VirtualPlant();
        var plc = plant.Add("plc", 1000, 20);
        plant.Run(TimeSpan.FromMinutes(1));

        plc.Step(TimeSpan.FromSeconds(-1));
        var wasUnsynchronised = false;
        var recovery = TimeSpan.Zero;
        for (var i = 0; i < 200 && (plant.Served.Now - plc.Shown).Duration() > TimeSpan.FromMilliseconds(1); i++)
        {
            plant.Run(TimeSpan.FromMilliseconds(50));
            recovery += TimeSpan.FromMilliseconds(50);
            wasUnsynchronised |= !plant.Served.IsSynchronised;
        }

        TestContext.Out.WriteLine($"followed after {recovery.TotalSeconds:0.0} s");
        Assert.That(recovery, Is.LessThan(TimeSpan.FromSeconds(5)));
        Assert.That(wasUnsynchronised, Is.True);
    }

    [TestCase(0.5)]
    [TestCase(0.997)]
    [TestCase(2)]
    public void IsSynchronised_PlantClockRunsAtAWrongRate_IsFalse(double rate)
    {
        var plant = new VirtualPlant();
        plant.Add("plc", 1000, (rate - 1) * 1e6);
        plant.Run(TimeSpan.FromSeconds(6));

        for (var i = 0; i < 600; i++)
        {
            plant.Run(TimeSpan.FromMilliseconds(50));
            Assert.That(plant.Served.IsSynchronised, Is.False);
            Assert.That(plant.Served.State, Is.EqualTo(ClockState.Converging));
        }

        Assert.That(plant.Served.WrongRate, Is.EqualTo(rate).Within(0.001 * rate));
        Assert.That(plant.Served.Status()[0].WrongRate, Is.EqualTo(plant.Served.WrongRate));
    }

    [Test]
    public void IsSynchronised_ClockWithAWrongRateIsLost_RemainsFalse()
    {
        var plant = new VirtualPlant();
        plant.Add("plc", 1000, -3000);
        plant.Run(TimeSpan.FromSeconds(30));

        plant.Pass(TimeSpan.FromSeconds(3));

        Assert.That(plant.Served.IsSynchronised, Is.False);
        Assert.That(plant.Served.State, Is.EqualTo(ClockState.Converging));
    }

    [Test]
    public void IsSynchronised_AnotherAdapterOffersTheClockAtTheRightRate_IsTrueAfterThreeSeconds()
    {
        var plant = new VirtualPlant();
        var plc = plant.Add("plc", 1000, -3000);
        plant.Run(TimeSpan.FromSeconds(30));
        var measured = plant.Clocks.Control;

        using var caller = new PlantClockCaller(measured, plant, TimeProvider.System, _ => { });
        measured.TryAttach(caller);
        var (isServed, rate) = (plant.Served.IsSynchronised, plant.Served.WrongRate);
        plc.Skew = 0;
        plant.Run(TimeSpan.FromSeconds(3));

        Assert.That(isServed, Is.False);
        Assert.That(rate, Is.Null);
        Assert.That(plant.Served.IsSynchronised, Is.True);
        Assert.That((plant.Served.Now - plc.Shown).Duration(), Is.LessThan(TimeSpan.FromMilliseconds(1)));
    }

    [Test]
    public void AtReceived_InterruptedAfterTheClockIsRead_IsNotTooEarly()
    {
        var own = new InterruptedClock();
        var served = new ServedClock(own, new PlantClocks(null, new StopwatchHeadsetClock()));
        var received = Stopwatch.GetTimestamp();

        Assert.That(served.AtReceived(received), Is.GreaterThanOrEqualTo(own.Inner.AtCount(received)));
    }

    [Test]
    public void IsSynchronised_ClockLostForMinutes_IsFalse()
    {
        var plant = new VirtualPlant();
        plant.Add("plc", 1000, 20);
        plant.Run(TimeSpan.FromMinutes(1));

        plant.Pass(TimeSpan.FromSeconds(10));
        var soon = plant.Served.IsSynchronised;
        plant.Pass(TimeSpan.FromHours(1));

        Assert.That(soon, Is.True);
        Assert.That(plant.Served.State, Is.EqualTo(ClockState.Holdover));
        Assert.That(plant.Served.ErrorBound, Is.GreaterThan(TimeSpan.FromMilliseconds(10)));
        Assert.That(plant.Served.IsSynchronised, Is.False);
    }

    [Test]
    public void Quality_SelectedClockUnknown_EqualsTheQualityOfTheGatewaysOwnClock()
    {
        var own = new StopwatchControlClock(ControlTime.FromSeconds(1), 40e-6)
        {
            ErrorBound = TimeSpan.FromMilliseconds(3), Resolution = TimeSpan.FromMilliseconds(1),
        };
        var plant = new VirtualPlant("plc", own);

        Assert.That(plant.Served.ErrorBound, Is.EqualTo(own.ErrorBound));
        Assert.That(plant.Served.Resolution, Is.EqualTo(own.Resolution));
        Assert.That(plant.Served.Skew, Is.EqualTo(own.Skew));
        Assert.That(plant.Served.IsSynchronised, Is.False, "the served clock is not the selected one");

        plant.Add("plc", 1000, -20);
        plant.Run(TimeSpan.FromMinutes(1));

        Assert.That(plant.Served.ErrorBound, Is.LessThan(own.ErrorBound));
        Assert.That(plant.Served.Resolution, Is.EqualTo(new TimeSpan(1)));
        Assert.That(plant.Served.Skew, Is.EqualTo(-20e-6).Within(1e-6));
        Assert.That(plant.Served.IsSynchronised, Is.True);
    }

    [Test]
    public void TryMap_TimeStampFarInTheFuture_IsRefused()
    {
        var plant = new VirtualPlant();
        plant.Add("ads", 1000, 0);
        plant.Add("opcua", 1001, 0);
        plant.Run(TimeSpan.FromSeconds(30));

        var isMapped = plant.Served.TryMap(plant.Clocks.All[1], new ControlTime(TimeSpan.MaxValue), out _);

        Assert.That(isMapped, Is.False);
    }

    [Test]
    public void TryMap_ClocksLostForAnHour_AcceptsOnlyTimesOfTheControlClock()
    {
        var plant = new VirtualPlant();
        var ads = plant.Add("ads", 1000, 0);
        var opcua = plant.Add("opcua", 1001, 0);
        plant.Run(TimeSpan.FromSeconds(30));

        plant.Pass(TimeSpan.FromSeconds(10));
        var isMappedSoon = plant.Served.TryMap(plant.Clocks.All[1], opcua.Shown, out var onControl);
        var error = (onControl - ads.Shown).Duration();
        plant.Pass(TimeSpan.FromHours(1));

        Assert.That(isMappedSoon, Is.True, "times are converted during a holdover of some seconds");
        Assert.That(error, Is.LessThan(TimeSpan.FromMilliseconds(1)));
        Assert.That(plant.Served.TryMap(plant.Clocks.All[1], opcua.Shown, out _), Is.False);
        Assert.That(plant.Served.TryMap(plant.Clocks.All[0], ads.Shown, out _), Is.True);
    }

    [Test]
    public void Look_ClocksDiverge_ReportsEachChangeOnce()
    {
        var plant = new VirtualPlant();
        plant.Add("ads", 1000, 0);
        plant.Add("opcua", 1001, 100);
        var lines = new List<string>();
        using var comparison = new ClockComparison(plant.Served, lines.Add);

        plant.Run(TimeSpan.FromMinutes(1));
        comparison.Look();
        comparison.Look();
        var first = lines.Count(line => line.Contains("against", StringComparison.Ordinal));
        plant.Run(TimeSpan.FromMinutes(1));
        comparison.Look();

        Assert.That(first, Is.EqualTo(1), string.Join("\n", lines));
        Assert.That(lines.Last(), Does.StartWith("clock 'opcua': +1012.").And.Contains("against 'ads', skew +100"), string.Join("\n", lines));
        Assert.That(lines[0], Is.EqualTo(PlantClockMessages.State("ads", "synchronised", isControlClock: true)));
    }

    [Test]
    public void Look_ClockIsReadAgainAfterAFailure_StatesTheReasonOnlyWhileItIsNotRead()
    {
        var plant = new VirtualPlant();
        var plc = plant.Add("plc", 1000, 0);
        var lines = new List<string>();
        using var comparison = new ClockComparison(plant.Served, lines.Add);
        plant.Run(TimeSpan.FromSeconds(30));
        comparison.Look();
        plant.Clocks.All[0].Failed("the plant has stopped");
        plant.Pass(TimeSpan.FromSeconds(10));
        comparison.Look();
        var failed = lines.Last();

        plc.Step(TimeSpan.FromSeconds(-5));
        for (var i = 0; i < 200; i++)
        {
            plant.Run(TimeSpan.FromMilliseconds(50));
            comparison.Look();
        }

        var after = lines.SkipWhile(line => line != failed).Skip(1).ToList();
        Assert.That(failed, Is.EqualTo(PlantClockMessages.State("plc", "holdover (the plant has stopped)", isControlClock: true)));
        Assert.That(after.Select(line => line.Contains("coarse", StringComparison.Ordinal)), Has.Some.True, string.Join("\n", lines));
        Assert.That(after, Has.None.Contains("the plant has stopped"));
    }

    sealed class InterruptedClock : IControlClock
    {
        public StopwatchControlClock Inner { get; } = new(default);

        public ControlTime Now
        {
            get
            {
                var now = Inner.Now;
                var until = Stopwatch.GetTimestamp() + Stopwatch.Frequency / 1000;
                while (Stopwatch.GetTimestamp() < until) ;
                return now;
            }
        }
    }
}
