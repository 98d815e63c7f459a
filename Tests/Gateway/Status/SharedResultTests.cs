using Nowpose.Gateway.Status;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class SharedResultTests
{
    [Test]
    public async Task GetAsync_RequestsDuringAComputation_ShareTheNextOne()
    {
        using var mayEnd = new ManualResetEventSlim();
        using var hasBegun = new ManualResetEventSlim();
        var computed = 0;
        var shared = new SharedResult<int>(() =>
        {
            hasBegun.Set();
            mayEnd.Wait(Soon.Limit);
            return Interlocked.Increment(ref computed);
        });
        var first = shared.GetAsync();
        hasBegun.Wait(Soon.Limit);

        var later = Enumerable.Range(0, 8).Select(_ => shared.GetAsync()).ToArray();
        mayEnd.Set();

        Assert.That(await first.Bounded(), Is.EqualTo(1));
        Assert.That(await Task.WhenAll(later).Bounded(), Is.All.EqualTo(2), "a result must not be older than its request");
        Assert.That(await shared.GetAsync().Bounded(), Is.EqualTo(3));
    }

    [Test]
    public async Task GetAsync_ComputationFails_FailsOnlyItsOwnRequests()
    {
        var computed = 0;
        var shared = new SharedResult<int>(() => ++computed == 1 ? throw new InvalidOperationException("first") : computed);

        Assert.That(async () => await shared.GetAsync(), Throws.InvalidOperationException);
        Assert.That(await shared.GetAsync().Bounded(), Is.EqualTo(2));
    }
}
