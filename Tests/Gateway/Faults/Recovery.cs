using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Prints the duration of recoveries. If a recovery does not occur, the wait for it fails the test.</summary>
static class Recovery
{
    public static void Print(string fault, TimeSpan took) => TestContext.Out.WriteLine($"recovery: {fault}: {took.TotalSeconds:0.00} s");
}
