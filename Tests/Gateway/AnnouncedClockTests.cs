using System.Globalization;
using System.Net;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Compares the clock that <c>gateway simulate</c> prints at its start with the clock that it serves on the sync port.</summary>
[Platform("Linux")]
public partial class AnnouncedClockTests
{
    const int ClockMonotonic = 1;

    [Test]
    public async Task Simulate_ClockLine_MatchesTheServedClock()
    {
        using var gateway = new PeerProcess(
            "Nowpose.Gateway.dll", "simulate", "--sync-port", "0", "--ws-port", "0", "--skew-ppm", "300", "--clock-start-s", "1700000000");
        await gateway.PrintsAsync("state serving");
        var line = ClockLine().Match(gateway.ValueOf("clock"));
        Assert.That(line.Success, gateway.ValueOf("clock"));
        var intercept = decimal.Parse(line.Groups[1].Value, CultureInfo.InvariantCulture);
        var rate = decimal.Parse(line.Groups[2].Value, CultureInfo.InvariantCulture);
        decimal ControlNs(long monotonicNs) => intercept + rate * monotonicNs;
        using var sync = await RawSyncClient.ConnectAsync(IPEndPoint.Parse(gateway.ValueOf("sync")));

        var t1 = MonotonicNs();
        var reply = await sync.ExchangeAsync(SyncFrame.Request(1, t1));
        var t4 = MonotonicNs();

        // The gateway receives the request after t1 and sends the reply before t4. The times in the reply are multiples of 100 ns.
        Assert.That((decimal)reply.Value.T2Ns, Is.GreaterThanOrEqualTo(ControlNs(t1) - 200));
        Assert.That((decimal)reply.Value.T3Ns, Is.LessThanOrEqualTo(ControlNs(t4) + 200));
        Assert.That(rate, Is.EqualTo(1.0003m));
    }

    [Test]
    public async Task Simulate_MotionStart_IsBetweenTheStartOfTheClockAndTheAnnouncedTime()
    {
        using var gateway = new PeerProcess(
            "Nowpose.Gateway.dll", "simulate", "--sync-port", "0", "--ws-port", "0", "--clock-start-s", "1000");
        await gateway.PrintsAsync("state serving");

        var start = long.Parse(gateway.ValueOf("motion_start_ns"), CultureInfo.InvariantCulture);
        var announced = double.Parse(gateway.ValueOf("control_time_s"), CultureInfo.InvariantCulture);

        Assert.That(start / 1e9, Is.InRange(1000, announced));
    }

    static long MonotonicNs()
    {
        Assert.That(GetTime(ClockMonotonic, out var time), Is.Zero);
        return checked((long)time.Seconds * 1_000_000_000 + (long)time.Nanoseconds);
    }

    [DllImport("libc", EntryPoint = "clock_gettime")]
    static extern int GetTime(int clock, out UnixTime time);

    [GeneratedRegex(@"^c1_ns = (-?\d+) \+ ([0-9.]+) \* monotonic_ns$")]
    private static partial Regex ClockLine();

    [StructLayout(LayoutKind.Sequential)]
    struct UnixTime
    {
        public nint Seconds;
        public nint Nanoseconds;
    }
}
