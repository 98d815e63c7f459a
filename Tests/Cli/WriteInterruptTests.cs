using System.CommandLine;
using System.IO.Pipes;
using System.Runtime.InteropServices;
using System.Text;
using Microsoft.Win32.SafeHandles;
using Nowpose.Cli.Calibrate;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Verbs;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Interrupts commands while they write a file. The file is a pipe that is smaller than the content.</summary>
[Platform("Linux")]
public class WriteInterruptTests
{
    const int SetPipeSize = 1031, PipeBytes = 4096;

    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-interrupt-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [Test]
    public Task CtrlC_CellWritesTheCode_CompletesTheFile() => AssertCompletesAsync(
        CellVerb.Create(), At("code.svg"), "</svg>", "cell", "--cell", new string('c', 40), "--host", "127.0.0.1", "--out", At("code.svg"));

    [Test]
    public Task CtrlC_NudgeWritesThePage_CompletesTheFile() => AssertCompletesAsync(
        NudgeVerb.Create(), At("calibration.html"), "</html>",
        "nudge", "--speed-mm-s", "100", "--forward-mm", "1", "--backward-mm", "-1", "--out", _folder);

    string At(string name) => Path.Combine(_folder, name);

    static async Task AssertCompletesAsync(Command verb, string path, string end, params string[] args)
    {
        await using var pipe = new AnonymousPipeServerStream(PipeDirection.In);
        Assert.That(SetPipe(pipe.SafePipeHandle, SetPipeSize, PipeBytes), Is.EqualTo(PipeBytes));
        File.CreateSymbolicLink(path, $"/proc/self/fd/{pipe.GetClientHandleAsString()}");
        using var ctrlC = new CancellationTokenSource();
        var run = Task.Run(() => CapturedConsole.OfAsync(() => Invocation.RunAsync(Invocation.Root("nowpose", "", verb), args, cancel: ctrlC.Token)));
        // The first byte shows that the command has begun to write. The rest is longer than the pipe, so the command is still writing.
        var content = new List<byte>(await ReadAsync(pipe, 1));

        await ctrlC.CancelAsync();

        Assert.That(run.IsCompleted, Is.False);
        while (!Encoding.UTF8.GetString([.. content]).TrimEnd().EndsWith(end, StringComparison.Ordinal)) content.AddRange(await ReadAsync(pipe, 1 << 20));
        Assert.That((await run.Bounded()).Status, Is.EqualTo(130));
    }

    static Task<byte[]> ReadAsync(PipeStream pipe, int maxBytes) => Task.Run(() =>
    {
        var bytes = new byte[maxBytes];
        return bytes[..pipe.Read(bytes)];
    }).Bounded();

    [DllImport("libc", EntryPoint = "fcntl")]
    static extern int SetPipe(SafePipeHandle pipe, int command, int bytes);
}
