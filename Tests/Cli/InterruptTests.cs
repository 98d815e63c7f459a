using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Interrupts commands that have no measurements to write while they read a file that does not end.</summary>
[Platform(Exclude = "Win")]
public class InterruptTests
{
    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-interrupt-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [TestCase("Nowpose.Cli.dll", "kinematics FIFO", TestName = "CtrlC_Kinematics_ExitsWith130")]
    [TestCase("Nowpose.Cli.dll", "calibrate nudge --speed-mm-s 100 --forward-mm 1 --backward-mm 1 --profile FIFO", TestName = "CtrlC_CalibrateNudge_ExitsWith130")]
    [TestCase("Nowpose.Cli.dll", "unity PROJECT", TestName = "CtrlC_Unity_ExitsWith130")]
    [TestCase("Nowpose.Gateway.dll", "pairings --pairing FIFO", TestName = "CtrlC_Pairings_ExitsWith130")]
    [TestCase("Nowpose.Gateway.dll", "cell --cell c --host h --certificate FIFO", TestName = "CtrlC_Cell_ExitsWith130")]
    public async Task CtrlC_CommandReadsAFile_ExitsWith130(string program, string arguments)
    {
        Directory.CreateDirectory(Path.Combine(_folder, "ProjectSettings"));
        Directory.CreateDirectory(Path.Combine(_folder, "Packages"));
        await File.WriteAllTextAsync(Path.Combine(_folder, "ProjectSettings", "ProjectVersion.txt"), "m_EditorVersion: 2022.3.10f1\n");
        var fifo = Path.Combine(_folder, "Packages", "manifest.json");
        using (var made = Process.Start("mkfifo", [fifo])) await made.WaitForExitAsync().Bounded();
        using var command = new PeerProcess(program, arguments.Replace("FIFO", fifo).Replace("PROJECT", _folder).Split(' '));
        // The file opens when the command has opened it for reading.
        await using var writer = await Task.Run(() => new FileStream(fifo, FileMode.Open, FileAccess.Write)).Bounded();

        Assert.That(await command.InterruptAsync(), Is.EqualTo(130), command.All);
    }
}
