using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Bounded waits.</summary>
static class Soon
{
    public static readonly TimeSpan Limit = TimeSpan.FromSeconds(20);

    public static Task<T> Bounded<T>(this Task<T> task) => task.WaitAsync(Limit);
    public static Task Bounded(this Task task) => task.WaitAsync(Limit);

    /// <summary>For what no signal tells: a counter of the other side.</summary>
    public static async Task BecomesAsync(Func<bool> condition, string what)
    {
        var since = Stopwatch.GetTimestamp();
        while (!condition())
        {
            Assert.That(Stopwatch.GetElapsedTime(since), Is.LessThan(Limit), what);
            await Task.Delay(5);
        }
    }
}
