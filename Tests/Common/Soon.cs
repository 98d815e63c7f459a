using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Tests.Common;

/// <summary>Waits with a time limit for another thread or process.</summary>
static class Soon
{
    /// <summary>Much longer than a busy machine needs, so only an event that never comes reaches this limit.</summary>
    public static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    public static Task<T> Bounded<T>(this Task<T> task) => task.WaitAsync(Limit);
    public static Task Bounded(this Task task) => task.WaitAsync(Limit);

    /// <summary>Polls a state or a counter of the other side that has no signal.</summary>
    /// <returns>The time that it took.</returns>
    public static Task<TimeSpan> BecomesAsync(Func<bool> condition, string what) => BecomesAsync(condition, () => what);

    /// <param name="what">Describes the condition and the current state in the message of a failure.</param>
    public static async Task<TimeSpan> BecomesAsync(Func<bool> condition, Func<string> what)
    {
        var since = Stopwatch.GetTimestamp();
        while (!condition())
        {
            if (Stopwatch.GetElapsedTime(since) > Limit) Assert.Fail($"waited {Limit.TotalSeconds} s in vain: {what()}");
            await Task.Delay(5);
        }
        return Stopwatch.GetElapsedTime(since);
    }
}
