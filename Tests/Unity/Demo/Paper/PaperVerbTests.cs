using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo.Paper;

/// <summary>Tests that <c>demo --paper</c> runs over real sockets and with pictures of its display.</summary>
public class PaperVerbTests
{
    string _folder;

    [SetUp]
    public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("nowpose-paper-").FullName;

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, recursive: true);

    JsonElement Json(string file) => JsonDocument.Parse(File.ReadAllText(Path.Combine(_folder, file))).RootElement;

    [Test]
    public async Task PaperOption_AnotherTrueDisplayLatency_IsMeasuredAndUsed()
    {
        var run = await CliRun.OfAsync("demo", "--paper", "--seconds", "20", "--visu-ms", "55", "--out", _folder);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var profile = Json("profile.json");
        var standardErrorMs = profile.GetProperty("visu_spread_ms").GetDouble() / Math.Sqrt(profile.GetProperty("measurements").GetInt32());
        Assert.That(standardErrorMs, Is.LessThan(0.2));
        Assert.That(profile.GetProperty("visu_ms").GetDouble(), Is.EqualTo(55).Within(3 * standardErrorMs), "measured in the pictures");
        // The limit does not depend on L_visu, so the reference data of PaperScene must agree with this measurement.
        var limitMs = PaperScene.MeasuredProfile(1).Range.Limit.TotalMilliseconds;
        Assert.That(profile.GetProperty("limit_render_ms").GetDouble(), Is.EqualTo(limitMs).Within(1));
        var claims = Json("result.json").GetProperty("claims").EnumerateArray().ToList();
        Assert.That(claims.Select(claim => string.Join(' ', claim.EnumerateObject().Select(each => each.Name))), Is.All.EqualTo(
            "figure claim paper measured uncertainty unit holds repeats not_measured verdict"));
        // The numbers are not checked, because they depend on the load of this machine. On a busy one, the clock may not be synchronised in time.
        Assert.That(claims, Is.Not.Empty.And.All.Matches<JsonElement>(claim =>
            claim.GetProperty("measured").ValueKind == JsonValueKind.Number || claim.GetProperty("not_measured").ValueKind == JsonValueKind.String));
        foreach (var file in new[] { "figure-8.csv", "frames.csv", "exchanges.csv", "calibration.html", "session.jsonl" })
            Assert.That(new FileInfo(Path.Combine(_folder, file)), Has.Length.GreaterThan(100), file);
        Assert.That(File.ReadAllText(Path.Combine(_folder, "report.html")), Does.Contain(PaperClaimTexts.Reduction.Split(" for ")[0]));
        Assert.That(run.Output, Does.Contain("About 80 %").And.Not.Contain("workpieces"));
        Assert.That(Json("result.json").GetProperty("bodies").ValueKind, Is.EqualTo(JsonValueKind.Null), "the swing moves no workpieces");
        Assert.That(File.ReadAllText(Path.Combine(_folder, "session.jsonl")), Does.Not.Contain("\"kind\":\"pose\""));
    }

    static readonly string[][] Contradicting =
    [
        ["--robot ur5 --load 100000", DemoMessages.NotWithPaper("--robot, --load")],
        ["--predictor linear", DemoMessages.NotWithPaper("--predictor")],
        ["--estimator default --sampling-ms 20", DemoMessages.NotWithPaper("--estimator, --sampling-ms")],
        ["--recording motion.csv", DemoMessages.NotWithPaper("--recording")],
        ["--profile profile.json --trajectory", DemoMessages.NotWithPaper("--profile, --trajectory")],
        ["--seconds 10", DemoMessages.PaperSeconds(10, 20)],
        ["--visu-ms 10", DemoMessages.VisuWithLoad(10, "--paper", 17)],
        ["--repeats 0", SettingMessages.OutOfRange("--repeats", 0, "", 1, 100)],
    ];

    [TestCaseSource(nameof(Contradicting))]
    public async Task PaperOption_WithAContradictingOption_PrintsOneLineAndExitsWith2(string options, string named)
    {
        var run = await CliRun.OfAsync(["demo", "--paper", "--out", Path.Combine(_folder, "none"), .. options.Split(' ')]);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd().Split('\n'), Has.Length.EqualTo(1), run.Errors);
        Assert.That(run.Errors, Does.Contain(named));
        Assert.That(Directory.Exists(Path.Combine(_folder, "none")), Is.False);
    }

    [Test]
    public async Task RepeatsOption_Alone_IsRefused()
    {
        var run = await CliRun.OfAsync("demo", "--repeats", "2", "--out", Path.Combine(_folder, "none"));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(DemoMessages.RepeatsAlone));
    }
}
