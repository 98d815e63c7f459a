using MathNet.Numerics;
using NUnit.Framework;

namespace Nowpose.Headless.Tests;

/// <summary>As the command line does, for the tests of its parts.</summary>
[SetUpFixture]
public sealed class SingleThread
{
    [OneTimeSetUp]
    public void SetUp() => Control.UseSingleThread();
}
