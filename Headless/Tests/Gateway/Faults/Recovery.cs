using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>How long a recovery took: said, and asserted so generously that only what never recovers fails.</summary>
static class Recovery
{
    static readonly TimeSpan Limit = TimeSpan.FromSeconds(15);

    public static void Tell(string fault, TimeSpan took)
    {
        TestContext.Out.WriteLine($"recovery: {fault}: {took.TotalSeconds:0.00} s");
        Assert.That(took, Is.LessThan(Limit), fault);
    }
}
