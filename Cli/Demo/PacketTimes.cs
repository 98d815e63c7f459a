using System.Diagnostics;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>Computes when the data that are sent in one direction of a connection are delivered. Not thread-safe.</summary>
/// <remarks>
/// Data that are sent within a cycle of the cell travel together, as in one packet. Otherwise, the joints and the poses of one sample would have
/// two delays, and the number of long delays would depend on how the scheduler divides the data.
/// </remarks>
/// <param name="delay">Generates one delay for each packet.</param>
sealed class PacketTimes(PathDelay delay)
{
    /// <summary>The cycle of the cell, 1 ms, in counts of <see cref="Stopwatch"/>.</summary>
    static readonly long Cycle = Stopwatch.Frequency / 1000;

    long _first = -Cycle;
    long _delay;
    long _due;

    /// <summary>Gets the time at which data are delivered, never before earlier data.</summary>
    /// <param name="sent">Time at which the data are sent, a count of <see cref="Stopwatch"/> that does not decrease.</param>
    public long DueAt(long sent)
    {
        if (sent - _first >= Cycle) (_first, _delay) = (sent, (long)(delay.Next().TotalSeconds * Stopwatch.Frequency));
        return _due = Math.Max(_due, sent + _delay);
    }
}
