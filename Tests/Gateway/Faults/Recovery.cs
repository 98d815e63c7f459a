using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Prints how long recoveries took. If a recovery does not happen, the wait for it fails the test.</summary>
static class Recovery
{
    public static void Print(string fault, TimeSpan took) => TestContext.Out.WriteLine($"recovery: {fault}: {took.TotalSeconds:0.00} s");
}
