using System;
using System.Collections.Generic;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Nowpose.Tests
{
    /// <summary>
    /// Runs the tests of this assembly, lists the failed tests and prints the counts. The exit status is 1 if a test failed or none ran.
    /// </summary>
    /// <remarks>Excludes the studies, because they take minutes and other tests run the same code.</remarks>
    static class Program
    {
        static readonly TestFilter WithoutStudies = TestFilter.FromXml("<filter><not><cat>Study</cat></not></filter>");

        static int Main()
        {
            var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
            runner.Load(typeof(Program).Assembly, new Dictionary<string, object>());
            var result = runner.Run(new FailureLog(), WithoutStudies);
            Console.WriteLine($"Passed: {result.PassCount}, failed: {result.FailCount}, skipped: {result.SkipCount}, inconclusive: {result.InconclusiveCount}");
            return result.FailCount == 0 && result.PassCount > 0 ? 0 : 1;
        }

        sealed class FailureLog : ITestListener
        {
            public void TestStarted(ITest test)
            {
            }

            public void TestFinished(ITestResult result)
            {
                if (result.ResultState.Status != TestStatus.Failed || result.HasChildren) return;
                Console.WriteLine("  Failed " + result.FullName);
                Console.WriteLine(result.Message);
                Console.WriteLine(result.StackTrace);
            }

            public void TestOutput(TestOutput output)
            {
            }
        }
    }
}
