using Nowpose.Benchmarks.Links;
using Nowpose.Simulation;
using Nowpose.Sync;

namespace Nowpose.Benchmarks.Paths;

/// <summary>Errors of a clock estimator while a path changes, in virtual time. Exchanges use TCP on a lossy link.</summary>
/// <param name="ErrorMs">Maximum error, ms. All values cover the time that begins 5 s after the change.</param>
/// <param name="SkewPpm">Maximum deviation of the skew from its value before the change, ppm.</param>
/// <param name="Within">Share of the period in which the error does not exceed the stated error.</param>
/// <param name="StatedMs">Mean stated error, ms.</param>
readonly record struct PathRun(double ErrorMs, double SkewPpm, double Within, double StatedMs)
{
    const double ChangeAt = 150, Length = 400, Settling = 5, Step = 0.1;
    static readonly TimeSpan ReplyTime = TimeSpan.FromMicroseconds(20);
    static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(200);
    static readonly TimeSpan Silence = TimeSpan.FromSeconds(2);

    public static PathRun Play(LinkProfile link, PathChange change, double sizeMs, string estimator, int seed)
    {
        var start = HeadsetTime.FromSeconds(500);
        var control = new VirtualClock(start, TimeSpan.FromSeconds(1000), (seed % 2 == 0 ? 1e-6 : -1e-6) * (8 + (25 * (seed % 4))));
        var clock = new ClockSynchroniser(ClockEstimators.Create(estimator), ClockSettings.Default);
        var pace = new ExchangePace(Interval, Silence, new Random(seed));
        var (requests, replies) = (new TcpStream(link, start, 2 * seed), new TcpStream(link, start, (2 * seed) + 1));
        var (next, seen) = (start, 0.0);
        var (skewBefore, error, skew, stated) = (0.0, 0.0, 0.0, 0.0);
        var (looks, within) = (0, 0);
        while (seen < Length)
        {
            var (up, down) = change.Extra((next - start).TotalSeconds - ChangeAt);
            var received = requests.Send(next) + TimeSpan.FromMilliseconds(up * sizeMs);
            var sent = received + ReplyTime;
            var exchange = new SyncExchange(
                next, control.At(received), control.At(sent), replies.Send(sent) + TimeSpan.FromMilliseconds(down * sizeMs));
            for (; start + TimeSpan.FromSeconds(seen) < exchange.T4; seen += Step) Look(start + TimeSpan.FromSeconds(seen));
            clock.Add(exchange, out _);
            var due = next + pace.Next(clock, exchange.T4);
            next = due > exchange.T4 ? due : exchange.T4;
        }

        return new PathRun(error, skew * 1e6, (double)within / looks, stated / looks);

        void Look(HeadsetTime at)
        {
            var model = clock.ModelAt(at);
            if (!model.IsKnown) return;
            if (seen < ChangeAt) skewBefore = model.Skew;
            if (seen < ChangeAt + Settling) return;
            var now = Math.Abs((model.ToControl(at) - control.At(at)).TotalMilliseconds);
            error = Math.Max(error, now);
            skew = Math.Max(skew, Math.Abs(model.Skew - skewBefore));
            looks++;
            stated += model.EstimatedError.TotalMilliseconds;
            if (now <= model.EstimatedError.TotalMilliseconds) within++;
        }
    }
}
