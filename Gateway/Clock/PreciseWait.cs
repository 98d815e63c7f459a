using System.Diagnostics;

namespace Nowpose.Gateway.Clock;

/// <summary>Waits to a fraction of a millisecond: sleeps while there is time, and spins the rest, since a sleep may end late by one.</summary>
public static class PreciseWait
{
    static readonly TimeSpan SpinLength = TimeSpan.FromMilliseconds(1.5);

    // What a sleep can be told; shorter ones would only be spun away in another place.
    static readonly TimeSpan ShortestSleep = TimeSpan.FromMilliseconds(1);

    /// <param name="count">Of <see cref="Stopwatch"/>; the past returns at once.</param>
    public static void Until(long count)
    {
        using var never = new ManualResetEventSlim();
        While(() => Stopwatch.GetElapsedTime(Stopwatch.GetTimestamp(), count), never);
    }

    /// <param name="left">How long is left, asked again and again; nothing left ends the wait.</param>
    /// <param name="stop">Ends the wait when it is set.</param>
    /// <returns>False when stopped.</returns>
    public static bool While(Func<TimeSpan> left, ManualResetEventSlim stop)
    {
        for (var rest = left(); rest > TimeSpan.Zero && !stop.IsSet; rest = left())
        {
            if (rest > SpinLength)
                stop.Wait(rest - SpinLength > ShortestSleep ? rest - SpinLength : ShortestSleep);
            else
                Thread.SpinWait(20);
        }

        return !stop.IsSet;
    }
}
