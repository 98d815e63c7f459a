using System.CommandLine;
using System.Diagnostics;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Interrupts commands while they read a file that does not end, and after a part of their result.</summary>
[Platform(Exclude = "Win")]
public class InterruptTests
{
    static readonly Dictionary<string, Func<Command>> Programs = new()
    {
        ["nowpose"] = Nowpose.Cli.CommandLine.Create,
        ["gateway"] = () => Nowpose.Gateway.CommandLine.Create(new ConfiguredArguments()),
    };

    /// <summary>Command lines with each option or argument that reads a file.</summary>
    static readonly string[] Lines =
    [
        "nowpose kinematics FIFO",
        "nowpose replay FIFO",
        "nowpose sync FIFO",
        "nowpose sync FOLDER/exchanges.csv --at FIFO",
        "nowpose recommend FIFO",
        "nowpose calibrate range FIFO",
        "nowpose calibrate sine FIFO",
        "nowpose calibrate sine FILE.csv --profile FIFO",
        "nowpose calibrate sine FOLDER/jog.csv --control FIFO",
        "nowpose calibrate vlc FOLDER/a.png --profile FIFO",
        "nowpose calibrate vlc FOLDER/a.png --sweep FIFO",
        "nowpose calibrate head FOLDER/a.png --profile FIFO",
        "nowpose calibrate nudge --speed-mm-s 100 --forward-mm 1 --backward-mm 1 --profile FIFO",
        "nowpose unity FOLDER",
        "nowpose headset --token-file FIFO",
        "nowpose headset --robot FIFO",
        "nowpose headset --profile FIFO",
        "nowpose demo --robot FIFO",
        "nowpose demo --profile FIFO",
        "nowpose demo --recording FIFO",
        "gateway pairings --pairing FIFO",
        "gateway cell --cell c --host h --certificate FIFO",
        "gateway pair --certificate FIFO",
        "gateway pair --token-file FIFO",
        "gateway replay FIFO",
        "gateway replay FIFO --check",
        "gateway simulate --config FIFO",
        "gateway simulate --tokens FIFO",
        "gateway serve --stationary FIFO",
        "gateway serve --robot FIFO --check",
    ];

    /// <summary>Commands that read no file.</summary>
    static readonly string[] WithoutInput = ["nowpose figures", "nowpose calibrate simulate"];

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
        await File.WriteAllTextAsync(Path.Combine(_folder.Path, "exchanges.csv"), "t1_ns,t2_ns,t3_ns,t4_ns\n0,10,20,30\n100,110,120,130\n");
        await File.WriteAllTextAsync(Path.Combine(_folder.Path, "jog.csv"), "t_s,hologram_px\n0,1\n0.1,2\n0.2,3\n");
        _fifo = Path.Combine(_folder.Path, "Packages", "manifest.json");
        using var made = Process.Start("mkfifo", [_fifo]);
        await made.WaitForExitAsync().Bounded();
    }

    [TearDown]
    public void TearDown() => _folder.Dispose();

    [TestCaseSource(nameof(Lines))]
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

    [Test]
    public void Lines_OfThisTest_ContainEachCommandThatReadsAFile()
    {
        var missing = Programs.SelectMany(program => Leaves(program.Key, program.Value()))
            .Where(command => !WithoutInput.Contains(command) && !Lines.Any(line => line.StartsWith(command + " ", StringComparison.Ordinal)));

        Assert.That(missing, Is.Empty, $"add a line for each of its options that read a file to {nameof(Lines)}, or the command to {nameof(WithoutInput)}");
    }

    [TestCase("Nowpose.Cli.dll", "kinematics FIFO", TestName = "CtrlC_Kinematics_ExitsWith130")]
    [TestCase("Nowpose.Gateway.dll", "simulate --config FIFO", TestName = "CtrlC_Simulate_ExitsWith130")]
    public async Task CtrlC_CommandReadsAFile_ExitsWith130(string program, string arguments)
    {
        using var command = new PeerProcess(program, Complete(arguments).Split(' '));
        await using var writer = await OpenAsync();

        Assert.That(await command.InterruptAsync(), Is.EqualTo(130), command.All);
    }

    [TestCase("INT", 130)]
    [TestCase("TERM", 143)]
    public async Task Signal_CommandWithAPartialResult_ExitsWithTheStatusOfTheSignal(string signal, int status)
    {
        Needs.Vision();
        using var command = new PeerProcess("Nowpose.Cli.dll", "calibrate", "simulate", "--pictures", "5000", "--out", _folder.Path);
        await Soon.BecomesAsync(() => Directory.EnumerateFiles(_folder.Path, "*.jpg", SearchOption.AllDirectories).Any(), "a picture");

        Assert.That(await command.SignalAsync(signal), Is.EqualTo(status), command.All);
    }

    static IEnumerable<string> Leaves(string path, Command command) => command.Subcommands.Count == 0
        ? [path] : command.Subcommands.SelectMany(inner => Leaves($"{path} {inner.Name}", inner));

    string Complete(string line) => line.Replace("FIFO", _fifo).Replace("FOLDER", _folder.Path);

    // The file opens when the command has opened it for reading.
    Task<FileStream> OpenAsync() => Task.Run(() => new FileStream(_fifo, FileMode.Open, FileAccess.Write)).Bounded();
}
