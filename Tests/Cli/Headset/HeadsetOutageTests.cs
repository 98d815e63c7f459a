using Nowpose.Cli.Headset;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Headset;

/// <summary>
/// Tests runs of 20 s in virtual time in which the samples stop once. The runs are scored in the same way as a run of the command <c>headset</c>.
/// </summary>
public class HeadsetOutageTests
{
    const int Seed = 3;
    const double FramesPerSecond = 60, Length = 20, StopsAt = 10;
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(500);

    [TestCase(0.4)]
    [TestCase(0.6)]
    [TestCase(0.9)]
    [TestCase(3.5)]
    public void Total_SamplesStop_ExcludesTheTimeWithoutSamples(double silence)
    {
        var undisturbed = Play(0).Stretches.Total;

        var total = Play(silence).Stretches.Total;

        Assert.That(undisturbed.Reduction, Is.GreaterThan(0.8));
        Assert.That(total.Reduction, Is.EqualTo(undisturbed.Reduction).Within(0.05));
        Assert.That(total.ReductionUncertainty, Is.LessThan(0.1));
        Assert.That(total.Reduction, Is.EqualTo(1 - (total.Rms / total.HoldRms)).Within(1e-12), "the reduction is defined by the two RMS errors");
    }

    [TestCase(0.4, 0)]
    [TestCase(0.6, 1)]
    [TestCase(0.9, 1)]
    [TestCase(3.5, 1)]
    public void Result_SamplesStop_SplitsTheRunAtReportedOutages(double silence, int count)
    {
        var (stretches, outages) = Play(silence);

        Assert.That(outages.Result(), Has.Count.EqualTo(count));
        var parts = stretches.Result();
        Assert.That(parts, Has.Count.EqualTo(count + 1));
        for (var i = 0; i < count; i++)
        {
            Assert.That(parts[i].ToS, Is.EqualTo(outages.Result()[i].FromS).Within(1.5 / FramesPerSecond));
            Assert.That(parts[i + 1].FromS, Is.EqualTo(outages.Result()[i].ToS).Within(1e-9));
        }
    }

    static (PoseStretches Stretches, PoseOutages Outages) Play(double silence)
    {
        var robot = RobotFiles.Load("youbot");
        var cell = new VirtualCell(
            new PickAndPlaceMotion(robot), new VirtualClock(Start, TimeSpan.FromSeconds(1000), 37e-6), Settings(0), Seed, Start);
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), new PredictionSettings()),
            robot, new StopwatchHeadsetClock());
        var (stretches, outages) = (new PoseStretches(), new PoseOutages(_ => { }));
        session.Robots[0].Hindcast.ToolJudged += stretches.AddError;
        for (var i = 0; i < Length * FramesPerSecond; i++)
        {
            var time = TimeSpan.FromSeconds(i / FramesPerSecond);
            cell.Settings = Settings(time.TotalSeconds >= StopsAt && time.TotalSeconds < StopsAt + silence ? 1 : 0);
            cell.Run(Start + time, session);
            var frame = session.Tick(Start + time);
            outages.Add(time, frame.State == PoseState.Current, () => ("held", [], ""));
            stretches.Add(time, frame.State, frame.DisplayTime, outages.IsOutage);
        }

        return (stretches, outages);
    }

    static VirtualCellSettings Settings(double loss) => new(50, 55, 105, 0, loss, NetworkProfile.Wifi);
}
