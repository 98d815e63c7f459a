using MathNet.Numerics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests;

/// <summary>Sets Math.NET to a single thread, like the command line, for the tests of its parts.</summary>
[SetUpFixture]
public sealed class SingleThread
{
    [OneTimeSetUp]
    public void SetUp() => Control.UseSingleThread();
}
