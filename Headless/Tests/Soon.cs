using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests;

/// <summary>Bounded waits for what another thread or process does.</summary>
static class Soon
{
    public static readonly TimeSpan Limit = TimeSpan.FromSeconds(20);

    public static Task<T> Bounded<T>(this Task<T> task) => task.WaitAsync(Limit);
    public static Task Bounded(this Task task) => task.WaitAsync(Limit);

    /// <summary>For what no signal tells: a state or a counter of the other side.</summary>
    /// <returns>How long it took.</returns>
    public static async Task<TimeSpan> BecomesAsync(Func<bool> condition, string what)
    {
        var since = Stopwatch.GetTimestamp();
        while (!condition())
        {
            Assert.That(Stopwatch.GetElapsedTime(since), Is.LessThan(Limit), what);
            await Task.Delay(5);
        }
        return Stopwatch.GetElapsedTime(since);
    }
}
