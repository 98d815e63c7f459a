using NUnit.Framework;
using NUnit.Framework.Interfaces;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>
/// Runs the tests that read pictures one at a time, so that they use the same two workers. The start of a worker takes the processor time of five
/// pictures, and concurrent tests would start workers of their own.
/// </summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Method)]
sealed class ReadsPicturesAttribute : TestActionAttribute
{
    static readonly SemaphoreSlim Turn = new(1);

    public override ActionTargets Targets => ActionTargets.Test;

    public override void BeforeTest(ITest test) => Turn.Wait();

    public override void AfterTest(ITest test) => Turn.Release();

    /// <summary>Runs a command that reads or writes pictures before the tests of a fixture.</summary>
    public static async Task<CliRun> BeforeTestsAsync(params string[] arguments)
    {
        await Turn.WaitAsync();
        try
        {
            return await CliRun.OfAsync(arguments);
        }
        finally
        {
            Turn.Release();
        }
    }
}
