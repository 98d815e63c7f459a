using System.Diagnostics;

namespace Nowpose.Gateway.Clock;

/// <summary>Waits with an accuracy of a fraction of a millisecond: sleeps first, then spins, because a sleep may end a millisecond late.</summary>
/// <remarks>On Windows, a sleep ends that early only after <see cref="Options.WindowsProcess.SetUp"/>.</remarks>
public static class PreciseWait
{
    static readonly TimeSpan SpinLength = TimeSpan.FromMilliseconds(1.5);

    // Minimum duration of a sleep. For shorter waits, the runtime would spin.
    static readonly TimeSpan MinSleep = TimeSpan.FromMilliseconds(1);

    /// <summary>Waits until <see cref="Stopwatch.GetTimestamp"/> reaches a count.</summary>
    /// <param name="count">The count. For a past count, the method returns immediately.</param>
    public static void Until(long count)
    {
        using var never = new ManualResetEventSlim();
        While(() => Stopwatch.GetElapsedTime(Stopwatch.GetTimestamp(), count), never);
    }

    /// <summary>Waits while time remains.</summary>
    /// <param name="left">Returns the remaining time; called repeatedly. The wait ends when it returns zero or less.</param>
    /// <param name="stop">Ends the wait early when it is set.</param>
    /// <returns>False if <paramref name="stop"/> ended the wait.</returns>
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
