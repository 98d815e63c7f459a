using NUnit.Framework;
using Nowpose.Benchmarks.Links;

namespace Nowpose.Headless.Tests.Benchmarks;

public class TcpStreamTests
{
    static readonly HeadsetTime Start = HeadsetTime.FromSeconds(100);

    static double[] DelaysMs(LinkProfile link, TimeSpan? interval, int count = 4000)
    {
        var stream = new TcpStream(link, Start, seed: 7, interval);
        return Enumerable.Range(0, count).Select(i =>
        {
            var sent = Start + TimeSpan.FromMilliseconds(50 * i);
            return (stream.Send(sent) - sent).TotalMilliseconds;
        }).ToArray();
    }

    [Test]
    public void Send_LossyLink_KeepsTheOrderAndAllMessages()
    {
        var stream = new TcpStream(LinkProfile.Bad, Start, seed: 7, TimeSpan.FromMilliseconds(50));

        var before = Start;
        for (var sent = Start; sent < Start + TimeSpan.FromSeconds(200); sent += TimeSpan.FromMilliseconds(50))
        {
            var arrival = stream.Send(sent);
            Assert.That(arrival >= before, Is.True, "in order");
            Assert.That((arrival - sent).TotalMilliseconds, Is.GreaterThanOrEqualTo(LinkProfile.Bad.BaseMs));
            before = arrival;
        }
    }

    [Test]
    public void Send_LostMessage_IsRetransmittedAndBlocksLaterMessages()
    {
        var late = DelaysMs(LinkProfile.Lossy, interval: null).Select(delay => delay > 200).ToArray();

        var share = late.Average(isLate => isLate ? 1 : 0);
        var losses = Enumerable.Range(1, late.Length - 1).Count(i => late[i] && !late[i - 1]);
        Assert.That(losses / (double)late.Length, Is.EqualTo(LinkProfile.Lossy.Loss).Within(0.01));
        Assert.That(share, Is.GreaterThan(LinkProfile.Lossy.Loss), "messages after a lost message are late, too");
    }

    [Test]
    public void Send_StreamOfMessages_LossDelaysAMessageByLessThan200Ms()
    {
        var delays = DelaysMs(LinkProfile.Lossy, TimeSpan.FromMilliseconds(50));

        Assert.That(delays.Average(delay => delay > 60 ? 1 : 0), Is.InRange(0.01, 0.05));
        Assert.That(
            delays.Average(delay => delay > 200 ? 1 : 0), Is.LessThan(0.003), "a delay above 200 ms requires that the retransmission is also lost");
    }

    [Test]
    public void Send_CleanLink_DelayIsShort() => Assert.That(DelaysMs(LinkProfile.Clean, TimeSpan.FromMilliseconds(50)).Max(), Is.LessThan(5));
}
