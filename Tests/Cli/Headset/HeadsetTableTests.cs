using System.Text.RegularExpressions;
using Nowpose.Cli.Headset;
using Nowpose.Cli.Messages;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;
using NUnit.Framework.Constraints;
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
        [new HeadsetResult.OutageResult(8, 12, "held", ["a3"], "joint a3: no data: node deleted")], 0,
        [new HeadsetResult.PartResult("box", 4.2, "no poses")], [new HeadsetResult.PartResult("closed", null, "no source")],
        [new HeadsetResult.OtherPartResult("lid", "arm2/tool0")], null);

    static string Printed(HeadsetResult result)
    {
        using var output = new StringWriter();
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Ansi = AnsiSupport.No, Out = new AnsiConsoleOutput(output) });
        console.Profile.Width = 120;
        HeadsetTable.Print(result, console);
        return output.ToString();
    }

    static Constraint HasRow(string label, string value) => Does.Match($"{Regex.Escape(label)} +{Regex.Escape(value)}");

    [Test]
    public void Print_NameWithControlCharacters_IsPrintedWithoutThem()
    {
        var text = Printed(Result() with { ObjectsNotCurrent = [new HeadsetResult.PartResult("bo\u001b[2J\nx", 1, "gone")] });

        Assert.That(text, HasRow("object bo [2J x", "not current for 1 s: gone").And.Not.Contains("\u001b"));
    }

    [TestCase(-0.04, " 0.0 ppm")]
    [TestCase(0.04, " 0.0 ppm")]
    [TestCase(-0.06, " -0.1 ppm")]
    [TestCase(45.04, " +45.0 ppm")]
    public void Print_Skew_ShowsTheSign(double ppm, string expected) => Assert.That(Printed(Result(ppm)), Does.Contain(expected));

    [Test]
    public void Print_CoarseClock_ShowsEstimatedErrorAndBound() =>
        Assert.That(Printed(Result()), HasRow(HeadsetTexts.ClockRow, HeadsetTexts.Clock("coarse", "3120 µs", "14500 µs", "+12.3 ppm", "1.50 ms")));

    [Test]
    public void Print_OutageAndMissingJoint_NamesThem()
    {
        var text = Printed(Result());

        Assert.That(text, HasRow(HeadsetTexts.MissingJoints, "a3"));
        Assert.That(text, HasRow(HeadsetTexts.Joint("a3"), $"fault{HeadsetTexts.Duration("4 s")}: node deleted"));
        Assert.That(text, HasRow(HeadsetTexts.Outage("8.0", "12.0 s"), "held: joint a3: no data: node deleted"));
        Assert.That(text, HasRow(HeadsetTexts.Stretch(1) + HeadsetTexts.PoseRow, HeadsetTexts.CurrentShare("100.0 %", "1.5", "8.0 s")));
        Assert.That(text, HasRow(HeadsetTexts.Compensated(HeadsetTexts.Stretch(2)), HeadsetTexts.RmsP95("4.00 mm", "8.00 mm")));
    }

    [Test]
    public void Print_OutagesNotListed_StatesTheirNumber()
    {
        Assert.That(Printed(Result() with { OutagesNotListed = 44 }), HasRow(HeadsetTexts.MoreOutages, HeadsetTexts.NotListed(44)));
        Assert.That(Printed(Result()), Does.Not.Contain(HeadsetTexts.MoreOutages));
    }

    [Test]
    public void Print_PartsNotCurrent_NamesThem()
    {
        var text = Printed(Result());

        Assert.That(text, HasRow(HeadsetTexts.Object("box"), $"{StateNames.NotCurrent}{HeadsetTexts.Duration("4 s")}: no poses"));
        Assert.That(text, HasRow(HeadsetTexts.Object("lid"), HeadsetTexts.NotFollowed("arm2/tool0")));
        Assert.That(text, HasRow(HeadsetTexts.Signal("closed"), $"{StateNames.NotCurrent}: no source"));
    }

    [Test]
    public void Print_RestOfAJointUncertain_NamesTheJointAndTheReason()
    {
        const string Reason = StateNames.UncertainRestReason + "the stop itself was not observed";
        var joint = new JointStatus("a3", JointDataState.Rest, null, TimeSpan.FromSeconds(4), Reason);

        var text = Printed(Result() with { Joints = [HeadsetResult.JointResult.Of(joint)], MissingJoints = [] });

        Assert.That(text, HasRow(HeadsetTexts.Joint("a3"), $"rest{HeadsetTexts.Duration("4 s")}: {Reason}"));
    }

    [Test]
    public void Print_VersionMismatch_AddsOneRow()
    {
        Assert.That(Printed(Result() with { VersionMismatch = "9.9.9" }), HasRow(HeadsetTexts.Versions, "9.9.9"));
        Assert.That(Printed(Result()), Does.Not.Contain(HeadsetTexts.Versions));
    }

    [Test]
    public void Print_FramesNotCurrent_ReportsThemAsNotScored()
    {
        Assert.That(Printed(Result()), HasRow(HeadsetTexts.NotScored, HeadsetTexts.NotCurrent("4.60 s")));
        var pose = Result().Pose with { NotCurrentS = 0 };
        Assert.That(Printed(Result() with { Pose = pose }), Does.Not.Contain(HeadsetTexts.NotScored));
    }
}
