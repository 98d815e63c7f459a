using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>How long a recovery took. What never recovers has failed where it was waited for.</summary>
static class Recovery
{
    public static void Tell(string fault, TimeSpan took) => TestContext.Out.WriteLine($"recovery: {fault}: {took.TotalSeconds:0.00} s");
}
