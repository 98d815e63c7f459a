using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Tests.Common;

/// <summary>Bounded waits for what another thread or process does.</summary>
static class Soon
{
    /// <summary>Far beyond what a busy machine takes: only what never comes takes as long.</summary>
    public static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    public static Task<T> Bounded<T>(this Task<T> task) => task.WaitAsync(Limit);
    public static Task Bounded(this Task task) => task.WaitAsync(Limit);

    /// <summary>For what no signal tells: a state or a counter of the other side.</summary>
    /// <returns>How long it took.</returns>
    public static Task<TimeSpan> BecomesAsync(Func<bool> condition, string what) => BecomesAsync(condition, () => what);

    /// <param name="what">Told when it does not come, with how things stand then.</param>
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
