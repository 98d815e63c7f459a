using System.CommandLine;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Sync;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Verbs;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Commands that cannot complete a file: a folder has the name of the temporary file.</summary>
public sealed class OutputFailureTests
{
    TemporaryFolder _folder;

    [SetUp]
    public void SetUp() => _folder = new TemporaryFolder();

    [TearDown]
    public void TearDown() => _folder.Dispose();

    [Test]
    public Task Cell_CannotComplete_KeepsTheEarlierCode() => AssertKeptAsync(
        CellVerb.Create(), "code.svg", "cell", "--cell", "c", "--host", "127.0.0.1", "--out", At("code.svg"));

    [Test]
    public Task Nudge_CannotComplete_KeepsTheEarlierPage() => AssertKeptAsync(
        NudgeVerb.Create(), "calibration.html",
        "nudge", "--speed-mm-s", "100", "--forward-mm", "1", "--backward-mm", "-1", "--out", _folder.Path);

    const string Log = "t1_ns,t2_ns,t3_ns,t4_ns\n0,500000,500000,1000000\n1000000000,1000500000,1000500000,1001000000\n";

    [Test]
    public async Task Sync_PageOverwritesTheUnpackedLog_IsRefused()
    {
        using var file = new TemporaryFile(Log, ".csv.gz");
        var log = file.Path[..^".gz".Length];
        File.WriteAllText(log, Log);

        var run = await CliRun.OfAsync("sync", file.Path, "--page", Path.ChangeExtension(log, ".html"));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(OptionValueMessages.WouldOverwriteInput("--page", log)));
        Assert.That(File.ReadAllText(log), Is.EqualTo(Log));
        File.Delete(log);
    }

    [Test]
    [Platform(Exclude = "Win")]
    public async Task Replay_FramesOverwriteTheInputBelowALinkedFolder_IsRefused()
    {
        Directory.CreateDirectory(At("real"));
        File.CreateSymbolicLink(At("alias"), "real");
        File.WriteAllText(At("real/a.csv"), "t_s,a\n0,0\n");

        var run = await CliRun.OfAsync("replay", At("real/a.csv"), "--frames", At("alias/a.csv"));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain(OptionValueMessages.WouldOverwriteInput("--frames", At("alias/a.csv"))));
        Assert.That(File.ReadAllText(At("real/a.csv")), Is.EqualTo("t_s,a\n0,0\n"));
    }

    [Test]
    public Task Sync_CannotComplete_KeepsTheEarlierPage()
    {
        File.WriteAllText(At("log.csv"), Log);
        return AssertKeptAsync(SyncVerb.Create(), "sync.html", "sync", At("log.csv"), "--page", At("sync.html"));
    }

    string At(string name) => Path.Combine(_folder.Path, name);

    async Task AssertKeptAsync(Command verb, string name, params string[] args)
    {
        await File.WriteAllTextAsync(At(name), "earlier");
        Directory.CreateDirectory(At(name + ".new"));

        var run = await CapturedConsole.OfAsync(() => Invocation.RunAsync(Invocation.Root("nowpose", "", verb), args));

        Assert.That(run.Status, Is.EqualTo(2), run.Errors);
        Assert.That(await File.ReadAllTextAsync(At(name)), Is.EqualTo("earlier"));
    }
}
