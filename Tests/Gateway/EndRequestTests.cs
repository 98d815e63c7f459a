using System.Runtime.InteropServices;
using NUnit.Framework;
using Nowpose.Gateway.Options;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests how a signal ends a program on systems that end the process as soon as the handler of some signals returns.</summary>
public class EndRequestTests
{
    [TestCase(PosixSignal.SIGHUP)]
    [TestCase(PosixSignal.SIGTERM)]
    public async Task End_SignalAfterWhichTheSystemEndsTheProcess_BlocksUntilTheProgramHasEnded(PosixSignal signal)
    {
        using ManualResetEventSlim programEnded = new();
        TaskCompletionSource<TimeSpan> blocks = new();
        var end = new EndRequest(CancellationToken.None, other => other == signal, time =>
        {
            blocks.SetResult(time);
            programEnded.Wait(Soon.Limit);
        });

        var handler = Task.Run(() => end.End(new PosixSignalContext(signal)));
        var blocked = await blocks.Task.Bounded();
        Assert.That(end.Token.WaitHandle.WaitOne(Soon.Limit), Is.True);
        // The program disposes of the object at its end, while the handler still blocks.
        end.Dispose();

        Assert.That(handler.IsCompleted, Is.False);
        Assert.That(blocked, Is.GreaterThan(TimeSpan.FromSeconds(5)));
        programEnded.Set();
        await handler.Bounded();
        end.Unregister();
    }

    [TestCase(PosixSignal.SIGINT)]
    [TestCase(PosixSignal.SIGQUIT)]
    public void End_SignalThatTheProgramHandles_ReturnsAtOnce(PosixSignal signal)
    {
        using var end = new EndRequest(
            CancellationToken.None, other => other is PosixSignal.SIGHUP or PosixSignal.SIGTERM, _ => Assert.Fail("the handler blocks"));
        var context = new PosixSignalContext(signal);

        end.End(context);

        Assert.That(context.Cancel, Is.True);
    }

    [Test]
    public void EndsAfter_OtherSystemThanWindows_IsFalse()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("Windows ends the process");

        Assert.That(WindowsProcess.EndsAfter(PosixSignal.SIGTERM), Is.False);
    }
}
