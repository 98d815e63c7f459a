using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Prints the time that a recovery took. A missing recovery has already failed in the wait for it.</summary>
static class Recovery
{
    public static void Tell(string fault, TimeSpan took) => TestContext.Out.WriteLine($"recovery: {fault}: {took.TotalSeconds:0.00} s");
}
