using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public class NudgeVerbTests : CalibrationFolder
{
    [Test]
    public async Task Nudge_OffsetsInBothDirections_CorrectsLVisuAndBase()
    {
        // The true L_visu is 46 ms, the configured one 40 ms: 6 ms at 250 mm/s are 1.5 mm. The base is displaced by 0.4 mm.
        var run = await CliRun.OfAsync(
            "calibrate", "nudge", "--speed-mm-s", "250", "--visu-ms", "40", "--forward-mm", "1.8", "2.0", "--backward-mm", "-1.2", "-1.0", "--json", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        var json = JsonDocument.Parse(run.Output).RootElement;
        Assert.That(json.GetProperty("visu_ms").GetDouble(), Is.EqualTo(46).Within(1e-3));
        Assert.That(json.GetProperty("offset_mm").GetDouble(), Is.EqualTo(0.4).Within(1e-6));
        var profile = LatencyProfileFile.Load(ProfilePath);
        Assert.That(profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(46).Within(1e-3));
        Assert.That(profile.Method, Is.EqualTo(CalibrationMethod.Nudge));
        Assert.That(profile.Measurements, Is.EqualTo(4));
        Assert.That(await File.ReadAllTextAsync(Path.Combine(Out, "calibration.html")), Does.Contain(NudgePageTexts.OffsetOverVelocity));
    }

    [Test]
    public async Task Nudge_OldNameOfVisuMs_IsAcceptedButNotShownInHelp()
    {
        var run = await CliRun.OfAsync(
            "calibrate", "nudge", "--speed-mm-s", "250", "--told-ms", "60", "--forward-mm", "2", "--backward-mm", "-1", "--json", "--out", Out);
        var help = await CliRun.OfAsync("calibrate", "nudge", "--help");

        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("visu_ms").GetDouble(), Is.EqualTo(66).Within(1e-3));
        Assert.That(help.Output, Does.Contain("--visu-ms").And.Not.Contain("--told-ms"));
    }

    [Test]
    public async Task Nudge_WithoutOptions_PrintsInstructions()
    {
        var run = await CliRun.OfAsync("calibrate", "nudge");

        Assert.That(run.ExitStatus, Is.Zero);
        Assert.That(run.Output, Is.EqualTo(NudgeGuide.Text));
    }

    [Test]
    public async Task Nudge_ExistingProfileHasALimit_WritesASecondFile()
    {
        LatencyProfileFile.Save(ProfilePath, new LatencyProfile(
            40, 1, "HoloLens 2", 60, DateTime.UnixEpoch, CalibrationMethod.VisibleLight, 9, 15.1, RenderTimeSourceKind.GpuCompletion));
        var beside = Path.Combine(Out, "profile-without-limit.json");
        string[] nudge = ["calibrate", "nudge", "--speed-mm-s", "250", "--forward-mm", "2", "--backward-mm", "-1", "--out", Out];

        var without = await CliRun.OfAsync(nudge);
        var stays = LatencyProfileFile.Load(ProfilePath);
        var with = await CliRun.OfAsync([.. nudge, "--profile", ProfilePath]);

        Assert.That(without.ExitStatus, Is.Zero);
        Assert.That(without.Errors, Does.Contain(ConsoleMessages.ProfileKept(ProfilePath, 15.1)));
        Assert.That(without.Output, Does.Contain(beside));
        Assert.That((stays.Method, stays.Visualisation.Length.TotalMilliseconds), Is.EqualTo((CalibrationMethod.VisibleLight, 40.0)));
        Assert.That(LatencyProfileFile.Load(beside).Range, Is.Null);
        Assert.That(LatencyProfileFile.Load(beside).Visualisation.Length.TotalMilliseconds, Is.EqualTo(46).Within(1e-3));
        Assert.That(with.Errors, Is.Empty);
        var both = LatencyProfileFile.Load(ProfilePath);
        Assert.That(both.Range.Limit.TotalMilliseconds, Is.EqualTo(15.1).Within(1e-3), "the render time limit of the earlier profile is adopted");
        Assert.That(both.Visualisation.Length.TotalMilliseconds, Is.EqualTo(46).Within(1e-3));
    }

    [Test]
    public async Task Nudge_ExistingProfileIsInvalid_ReplacesIt()
    {
        Directory.CreateDirectory(Out);
        await File.WriteAllTextAsync(ProfilePath, "{");

        var run = await CliRun.OfAsync("calibrate", "nudge", "--speed-mm-s", "250", "--forward-mm", "2", "--backward-mm", "-1", "--out", Out);

        Assert.That(run.ExitStatus, Is.Zero, run.Errors);
        Assert.That(LatencyProfileFile.Load(ProfilePath).Method, Is.EqualTo(CalibrationMethod.Nudge));
    }

    static readonly string[][] InvalidMarks =
    [
        ["--speed-mm-s 250 --forward-mm 2", CalibrationMessages.NoOffset("--backward-mm")],
        ["--speed-mm-s 250 --backward-mm -2", CalibrationMessages.NoOffset("--forward-mm")],
        ["--forward-mm 2 --backward-mm -2", CalibrationMessages.NoSpeed],
        ["--json", CalibrationMessages.NoSpeed],
        ["--speed-mm-s 0 --forward-mm 2 --backward-mm -2", OptionMessages.OutOfRange("--speed-mm-s", "0", " mm/s", "allowed: 1 to 10000 mm/s.")],
        ["--speed-mm-s 250 --forward-mm 2000 --backward-mm -2", OptionMessages.OutOfRange("--forward-mm", "2000", " mm", Shifts)],
        ["--speed-mm-s 250 --forward-mm 2 --backward-mm two", OptionMessages.NotANumber("--backward-mm", "two", Shifts)],
        ["--speed-mm-s 250 --forward-mm 1.5 1,5 --backward-mm -2", OptionMessages.NotANumber("--forward-mm", "1,5", Shifts)],
        [
            "--speed-mm-s 250 --visu-ms 40 --told-ms 40 --forward-mm 2 --backward-mm -2",
            CalibrationMessages.BothNames("--told-ms", "--visu-ms"),
        ],
        ["--speed-mm-s 10 --forward-mm -20 --backward-mm 20", SettingMessages.OutOfRange("visualisation latency", -1960, " ms", 0, 500)],
    ];

    const string Shifts = "allowed: -1000 to 1000 mm.";

    [TestCaseSource(nameof(InvalidMarks))]
    public async Task Nudge_InvalidMarks_StatesTheReason(string options, string named) =>
        Assert.That(await RefusalOf(["nudge", .. options.Split(' ')]), Does.Contain(named));
}
