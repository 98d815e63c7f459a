using System.Diagnostics;

namespace Nowpose.Cli.Demo;

/// <summary>Waits to a fraction of a millisecond: sleeps while there is time, and spins the rest, since a sleep may end late by one.</summary>
static class PreciseWait
{
    static readonly long SpinCounts = Stopwatch.Frequency * 3 / 2 / 1000;

    /// <param name="count">Of <see cref="Stopwatch"/>; the past returns at once.</param>
    public static void Until(long count)
    {
        for (var left = count - Stopwatch.GetTimestamp(); left > 0; left = count - Stopwatch.GetTimestamp())
        {
            if (left > SpinCounts) Thread.Sleep((int)Math.Max(1, (left - SpinCounts) * 1000 / Stopwatch.Frequency));
            else Thread.SpinWait(20);
        }
    }
}
