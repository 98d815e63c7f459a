using NUnit.Framework;
using Nowpose.Cli.Headset;
using Nowpose.Protocol;
using Nowpose.Session;
using Spectre.Console;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class HeadsetTableTests
{
    static HeadsetResult Result(double skewPpm = 12.34) => new(
        20, 1200, "youBot", 400, 0, new HeadsetResult.ClockResult("coarse", 14500, skewPpm, 1.5, 0, 0.4, 1.5, 7, 3120, 9),
        new HeadsetResult.LatencyResult(80, 90, 40, 120), new HeadsetResult.PoseResult("held", 1.5, 0.7, 4, 0.7, 4.6),
        new HeadsetResult.ErrorResult(20, 40, 1, 2, 0.95, 0.01), ["a3"], [new HeadsetResult.JointResult("a3", "fault", 4.2, "node deleted")],
        [
            new HeadsetResult.StretchResult(1.5, 8, 1, new HeadsetResult.ErrorResult(20, 40, 1, 2, 0.95, 0.01)),
            new HeadsetResult.StretchResult(12, 16, 0.98, new HeadsetResult.ErrorResult(20, 40, 4, 8, 0.8, 0.02)),
        ],
        [new HeadsetResult.OutageResult(8, 12, "held", ["a3"], "joint a3: no data: node deleted")], null);

    static string Printed(HeadsetResult result)
    {
        using var output = new StringWriter();
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Ansi = AnsiSupport.No, Out = new AnsiConsoleOutput(output) });
        console.Profile.Width = 120;
        HeadsetTable.Print(result, console);
        return output.ToString();
    }

    [TestCase(-0.04, " 0.0 ppm")]
    [TestCase(0.04, " 0.0 ppm")]
    [TestCase(-0.06, " -0.1 ppm")]
    [TestCase(45.04, " +45.0 ppm")]
    public void Print_Skew_ShowsTheSign(double ppm, string expected) => Assert.That(Printed(Result(ppm)), Does.Contain(expected));

    [Test]
    public void Print_CoarseClock_ShowsEstimatedErrorAndBound() =>
        Assert.That(Printed(Result()), Does.Match(@"clock +coarse, ± 3120 µs \(proven ± 14500 µs\)"));

    [Test]
    public void Print_OutageAndMissingJoint_NamesThem()
    {
        var text = Printed(Result());

        Assert.That(text, Does.Match(@"joints without data +a3"));
        Assert.That(text, Does.Match(@"joint a3 +fault for 4 s: node deleted"));
        Assert.That(text, Does.Match(@"outage from 8\.0 to 12\.0 s +held: joint a3: no data: node deleted"));
        Assert.That(text, Does.Match(@"stretch 1: pose +current for 100\.0 % of the frames from 1\.5 to 8\.0 s"));
        Assert.That(text, Does.Match(@"stretch 2: tool, compensated +4\.00 mm RMS, 8\.00 mm P95"));
    }

    [Test]
    public void Print_RestOfAJointUncertain_NamesTheJointAndTheReason()
    {
        var joint = new JointStatus("a3", JointDataState.Rest, null, TimeSpan.FromSeconds(4), "may not be at rest: the stop itself was not observed");

        var text = Printed(Result() with { Joints = [HeadsetResult.JointResult.Of(joint)], MissingJoints = [] });

        Assert.That(text, Does.Match("joint a3 +rest for 4 s: may not be at rest: the stop itself was not observed"));
    }

    [Test]
    public void Print_VersionMismatch_AddsOneRow()
    {
        Assert.That(Printed(Result() with { VersionMismatch = "the gateway has 9.9.9" }), Does.Match(@"versions +the gateway has 9\.9\.9"));
        Assert.That(Printed(Result()), Does.Not.Contain("versions"));
    }

    [Test]
    public void Print_FramesNotCurrent_ReportsThemAsNotScored()
    {
        Assert.That(Printed(Result()), Does.Match(@"tool, not scored +frames that were not current: 4\.60 s"));
        var pose = Result().Pose with { NotCurrentS = 0 };
        Assert.That(Printed(Result() with { Pose = pose }), Does.Not.Contain("not scored"));
    }
}
