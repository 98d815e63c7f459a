using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Tests.Common;

/// <summary>Waits with a time limit for another thread or process.</summary>
static class Soon
{
    /// <summary>
    /// Time limit of each wait. It is much longer than a busy machine needs, so a wait reaches the limit only if the event does not occur.
    /// </summary>
    public static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    public static Task<T> Bounded<T>(this Task<T> task) => task.WaitAsync(Limit);
    public static Task Bounded(this Task task) => task.WaitAsync(Limit);

    /// <summary>Polls a condition until it is true, for changes that have no signal to wait for.</summary>
    /// <returns>Time until the condition was true.</returns>
    public static Task<TimeSpan> BecomesAsync(Func<bool> condition, string what) => BecomesAsync(condition, () => what);

    /// <param name="what">Describes the condition and the current state in the message of a failure.</param>
    /// <param name="intervalMs">
    /// Time between two polls, ms. A condition that sends requests to another process needs a longer one, because the requests take processor time
    /// from the processes that are tested.
    /// </param>
    public static async Task<TimeSpan> BecomesAsync(Func<bool> condition, Func<string> what, int intervalMs = 5)
    {
        var since = Stopwatch.GetTimestamp();
        while (!condition())
        {
            if (Stopwatch.GetElapsedTime(since) > Limit) Assert.Fail($"waited {Limit.TotalSeconds} s in vain: {what()}");
            await Task.Delay(intervalMs);
        }
        return Stopwatch.GetElapsedTime(since);
    }
}
