using MathNet.Numerics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests;

/// <summary>Limits Math.NET to a single thread, as the command line does, because tests run parts of the command line.</summary>
[SetUpFixture]
public sealed class SingleThread
{
    [OneTimeSetUp]
    public void SetUp() => Control.UseSingleThread();
}
