using NUnit.Framework;
using Nowpose.Gateway.Rosbridge;
using static Nowpose.Headless.Tests.Gateway.SendWindowTests;

namespace Nowpose.Headless.Tests.Gateway;

[Parallelizable(ParallelScope.All)]
public class SendWindowPingTests
{
    [Test]
    public void IsOpen_ClientNeverAnswersAPing_OpensAtTheAssumedRateAfterTheTimeout()
    {
        var window = new SendWindow();
        window.OnSent(SendWindow.FirstBytes, TimeSpan.Zero);
        window.OnPing(TimeSpan.Zero);

        Assert.That(window.IsOpen(SendWindow.FirstPongTimeout - Step), Is.False);
        Assert.That(window.IsAssumed, Is.False);
        Assert.That(window.IsOpen(SendWindow.FirstPongTimeout), Is.True);
        Assert.That(window.IsAssumed, Is.True);
        window.OnSent(SendWindow.FirstBytes + (int)SendWindow.AssumedBytesPerSecond, SendWindow.FirstPongTimeout);
        Assert.That(window.IsOpen(SendWindow.FirstPongTimeout + TimeSpan.FromSeconds(1)), Is.False);
        Assert.That(window.IsOpen(SendWindow.FirstPongTimeout + TimeSpan.FromSeconds(1) + Step), Is.True);
    }

    [Test]
    public void IsOpen_ClientHasAnsweredAPing_IsFalseUntilTheNextPong()
    {
        var window = new SendWindow();
        window.OnPong(window.OnPing(TimeSpan.Zero), Step);
        window.OnSent(SendWindow.FirstBytes, TimeSpan.Zero);
        var ping = window.OnPing(Step);

        Assert.That(window.IsOpen(TimeSpan.FromMinutes(1)), Is.False);
        window.OnPong(ping - 1, TimeSpan.FromMinutes(1));
        Assert.That(window.IsOpen(TimeSpan.FromMinutes(1)), Is.False, "the pong of another ping");
        window.OnPong(ping, TimeSpan.FromMinutes(1));
        Assert.That(window.IsOpen(TimeSpan.FromMinutes(1)), Is.True);
    }

    [TestCase(9, SendWindow.NearPingBytes)]
    [TestCase(11, SendWindow.FirstBytes)]
    public void IsPingDue_ShortOrLongRoundTrip_IsTrueAfterTheExpectedNumberOfBytes(int pongMs, int bytes)
    {
        var window = new SendWindow();
        window.OnSent(450, TimeSpan.Zero);
        window.OnPong(window.OnPing(TimeSpan.Zero), pongMs * Step);

        window.OnSent(bytes - 1, pongMs * Step);
        Assert.That(window.IsPingDue, Is.False);
        window.OnSent(1, pongMs * Step);
        Assert.That(window.IsPingDue, Is.True);
    }

    [Test]
    public void IsPingDueBefore_LongFirstMessage_IsTrueOnlyOnce()
    {
        var window = new SendWindow();

        Assert.That(window.IsPingDueBefore(SendWindow.FirstBytes), Is.False);
        Assert.That(window.IsPingDueBefore(SendWindow.FirstBytes + 1), Is.True);
        window.OnPing(TimeSpan.Zero);
        Assert.That(window.IsPingDueBefore(SendWindow.FirstBytes + 1), Is.False);
    }
}
