using System.Diagnostics;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Headset;
using Nowpose.Cli.Kinematics;
using Nowpose.Cli.Recommend;
using Nowpose.Cli.Sync;
using Nowpose.Cli.Unity;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Verbs;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Interrupts commands while they read a file that does not end.</summary>
[Platform(Exclude = "Win")]
public class InterruptTests
{
    static readonly Dictionary<string, Func<System.CommandLine.Command>> Programs = new()
    {
        ["nowpose"] = () => Invocation.Root(
            "nowpose", "", KinematicsVerb.Create(), Nowpose.Cli.Replay.ReplayVerb.Create(), SyncVerb.Create(), RecommendVerb.Create(),
            CalibrateVerb.Create(), UnityVerb.Create(), HeadsetVerb.Create(), DemoVerb.Create()),
        ["gateway"] = () => Invocation.Root(
            "gateway", "", Nowpose.Gateway.Verbs.SimulateVerb.Create(new ConfiguredArguments()), ReplayVerb.Create(new ConfiguredArguments()),
            ServeVerb.Create(new ConfiguredArguments()), MarkerCodeVerb.Create(),
            PairVerb.Create(), PairingsVerb.Create()),
    };

    TemporaryFolder _folder;
    string _fifo;

    [SetUp]
    public async Task SetUp()
    {
        _folder = new TemporaryFolder();
        Directory.CreateDirectory(Path.Combine(_folder.Path, "ProjectSettings"));
        Directory.CreateDirectory(Path.Combine(_folder.Path, "Packages"));
        await File.WriteAllTextAsync(Path.Combine(_folder.Path, "ProjectSettings", "ProjectVersion.txt"), "m_EditorVersion: 2022.3.10f1\n");
        await File.WriteAllTextAsync(Path.Combine(_folder.Path, "a.png"), "");
        _fifo = Path.Combine(_folder.Path, "Packages", "manifest.json");
        using var made = Process.Start("mkfifo", [_fifo]);
        await made.WaitForExitAsync().Bounded();
    }

    [TearDown]
    public void TearDown() => _folder.Dispose();

    [TestCase("nowpose kinematics FIFO")]
    [TestCase("nowpose replay FIFO")]
    [TestCase("nowpose sync FIFO")]
    [TestCase("nowpose recommend FIFO")]
    [TestCase("nowpose calibrate range FIFO")]
    [TestCase("nowpose calibrate sine FIFO")]
    [TestCase("nowpose calibrate sine FILE.csv --profile FIFO")]
    [TestCase("nowpose calibrate vlc FOLDER/a.png --profile FIFO")]
    [TestCase("nowpose calibrate vlc FOLDER/a.png --sweep FIFO")]
    [TestCase("nowpose calibrate head FOLDER/a.png --profile FIFO")]
    [TestCase("nowpose calibrate nudge --speed-mm-s 100 --forward-mm 1 --backward-mm 1 --profile FIFO")]
    [TestCase("nowpose unity FOLDER")]
    [TestCase("nowpose headset --token-file FIFO")]
    [TestCase("nowpose headset --robot FIFO")]
    [TestCase("nowpose demo --recording FIFO")]
    [TestCase("gateway pairings --pairing FIFO")]
    [TestCase("gateway cell --cell c --host h --certificate FIFO")]
    [TestCase("gateway pair --certificate FIFO")]
    [TestCase("gateway replay FIFO")]
    [TestCase("gateway replay FIFO --check")]
    [TestCase("gateway simulate --config FIFO")]
    [TestCase("gateway simulate --tokens FIFO")]
    [TestCase("gateway serve --stationary FIFO")]
    [TestCase("gateway serve --robot FIFO --check")]
    public async Task Cancel_CommandReadsAFile_EndsAtOnce(string line)
    {
        var words = Complete(line).Split(' ');
        using var ctrlC = new CancellationTokenSource();
        var run = Task.Run(() => CapturedConsole.OfAsync(() => Invocation.RunAsync(
            Programs[words[0]](), words[1..], complete: new ConfiguredArguments().Of, cancel: ctrlC.Token)));
        await using var writer = await OpenAsync();

        await ctrlC.CancelAsync();

        Assert.That((await run.Bounded()).Status, Is.EqualTo(130));
    }

    [TestCase("Nowpose.Cli.dll", "kinematics FIFO", TestName = "CtrlC_Kinematics_ExitsWith130")]
    [TestCase("Nowpose.Gateway.dll", "simulate --config FIFO", TestName = "CtrlC_Simulate_ExitsWith130")]
    public async Task CtrlC_CommandReadsAFile_ExitsWith130(string program, string arguments)
    {
        using var command = new PeerProcess(program, Complete(arguments).Split(' '));
        await using var writer = await OpenAsync();

        Assert.That(await command.InterruptAsync(), Is.EqualTo(130), command.All);
    }

    string Complete(string line) => line.Replace("FIFO", _fifo).Replace("FOLDER", _folder.Path);

    // The file opens when the command has opened it for reading.
    Task<FileStream> OpenAsync() => Task.Run(() => new FileStream(_fifo, FileMode.Open, FileAccess.Write)).Bounded();
}
