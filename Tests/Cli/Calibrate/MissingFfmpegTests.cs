using Nowpose.Cli.Messages;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Tests videos on a machine without ffmpeg. All programs except node are removed from the path of this process.</summary>
[NonParallelizable]
[Platform(Exclude = "Win", Reason = "the programs are found by their Unix names")]
public sealed class MissingFfmpegTests : CalibrationFolder
{
    string _path;

    [SetUp]
    public void RemovePrograms()
    {
        // RestorePath also runs if the test is ignored.
        _path = Environment.GetEnvironmentVariable("PATH");
        Needs.Vision();
        var node = (_path ?? "").Split(Path.PathSeparator).First(folder => File.Exists(Path.Combine(folder, "node")));
        var only = Directory.CreateDirectory(Path.Combine(Folder, "only")).FullName;
        File.CreateSymbolicLink(Path.Combine(only, "node"), Path.Combine(node, "node"));
        Environment.SetEnvironmentVariable("PATH", only);
    }

    [TearDown]
    public void RestorePath() => Environment.SetEnvironmentVariable("PATH", _path);

    [Test]
    public async Task Vlc_FfmpegMissing_SuggestsInstallingFfmpegAndKeepsTheProfile()
    {
        File.WriteAllText(Path.Combine(Directory.CreateDirectory(Out).FullName, "profile.json"), "good");
        var sweep = Write("sweep.csv", [SweepLog.Header, "5,0,4,display_gpu_time,HoloLens 2,60"]);

        Assert.That(await RefusalOf("vlc", Write("sweep.mp4", []), "--sweep", sweep), Is.EqualTo(ConsoleMessages.Line(PictureMessages.FfmpegNeeded)));
        Assert.That(await File.ReadAllTextAsync(ProfilePath), Is.EqualTo("good"));
    }

    [Test]
    public async Task Sine_FfmpegMissing_SuggestsInstallingFfmpeg() => Assert.That(
        await RefusalOf("sine", Write("jog.mp4", []), "--robot-box", "10,10,32,32", "--hologram-box", "50,10,32,32"),
        Is.EqualTo(ConsoleMessages.Line(PictureMessages.FfmpegNeeded)));
}
