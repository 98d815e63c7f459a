using System.Diagnostics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Waits for what another thread or process does, with a generous end.</summary>
static class Eventually
{
    static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);

    /// <returns>How long it took.</returns>
    public static async Task<TimeSpan> Is(Func<bool> condition, string what, TimeSpan? patience = null)
    {
        var since = Stopwatch.StartNew();
        while (!condition())
        {
            if (since.Elapsed > (patience ?? Patience)) Assert.Fail($"not within {since.Elapsed.TotalSeconds:0.0} s: {what}");
            await Task.Delay(5);
        }
        return since.Elapsed;
    }
}
