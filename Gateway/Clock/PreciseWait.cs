using System.Diagnostics;

namespace Nowpose.Gateway.Clock;

/// <summary>Waits with an accuracy of a fraction of a millisecond: sleeps first, then spins, because a sleep may end a millisecond late.</summary>
public static class PreciseWait
{
    static readonly TimeSpan SpinLength = TimeSpan.FromMilliseconds(1.5);

    // Shortest duration of a sleep. The system would only spin for shorter ones.
    static readonly TimeSpan MinSleep = TimeSpan.FromMilliseconds(1);

    /// <param name="count">Count of <see cref="Stopwatch"/>; a past count returns immediately.</param>
    public static void Until(long count)
    {
        using var never = new ManualResetEventSlim();
        While(() => Stopwatch.GetElapsedTime(Stopwatch.GetTimestamp(), count), never);
    }

    /// <param name="left">Gets the remaining time; called repeatedly. Zero or less ends the wait.</param>
    /// <param name="stop">Ends the wait when it is set.</param>
    /// <returns>False if stopped.</returns>
    public static bool While(Func<TimeSpan> left, ManualResetEventSlim stop)
    {
        for (var rest = left(); rest > TimeSpan.Zero && !stop.IsSet; rest = left())
        {
            if (rest > SpinLength)
                stop.Wait(rest - SpinLength > MinSleep ? rest - SpinLength : MinSleep);
            else
                Thread.SpinWait(20);
        }

        return !stop.IsSet;
    }
}
