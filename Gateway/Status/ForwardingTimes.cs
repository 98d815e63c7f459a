namespace Nowpose.Gateway.Status;

/// <summary>
/// Times from the receipt of a joint state until a subscriber's socket accepts it: counts since the start, and the newest times of the last minute.
/// </summary>
/// <remarks>Thread-safe. Does not include throttled subscriptions, whose messages wait on purpose.</remarks>
public sealed class ForwardingTimes(TimeProvider time = null)
{
    /// <summary>Upper bounds of the histogram's buckets, s. The last bucket has no upper bound.</summary>
    internal static readonly double[] Limits = [0.0001, 0.00025, 0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1];

    readonly TimeProvider _time = time ?? TimeProvider.System;
    readonly long[] _counts = new long[Limits.Length + 1];
    long _ticks;
    readonly Lock _lock = new();
    readonly RecentTimes _recent = new(8192, TimeSpan.FromMinutes(1), time ?? TimeProvider.System);

    /// <summary>Sum of all times since the start, s.</summary>
    internal double Sum => Interlocked.Read(ref _ticks) / (double)TimeSpan.TicksPerSecond;

    /// <summary>Gets the count of each bucket. The array has one element more than <see cref="Limits"/>.</summary>
    internal long[] Counts() => [.. Enumerable.Range(0, _counts.Length).Select(i => Interlocked.Read(ref _counts[i]))];

    /// <summary>Adds a message that was just sent.</summary>
    /// <param name="receivedAt">Time at which the message was received, a timestamp of the time provider.</param>
    public void Add(long receivedAt) => Add(_time.GetElapsedTime(receivedAt));

    internal void Add(TimeSpan length)
    {
        var seconds = length.TotalSeconds;
        var index = 0;
        while (index < Limits.Length && seconds > Limits[index]) index++;
        Interlocked.Increment(ref _counts[index]);
        Interlocked.Add(ref _ticks, length.Ticks);
        lock (_lock) _recent.Add(_time.GetTimestamp(), length);
    }

    /// <summary>Gets the newest times of the last minute, at most 8192, the shortest first.</summary>
    internal TimeSpan[] SortedRecent()
    {
        IEnumerable<(long At, TimeSpan Length)> recent;
        // Selects and sorts outside the lock, so that senders do not wait for it.
        lock (_lock) recent = _recent.Read(_time.GetTimestamp());
        return [.. recent.Select(one => one.Length).Order()];
    }
}
