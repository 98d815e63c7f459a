using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

public class CollectionTests
{
    /// <summary>
    /// At the end of a concurrent collection, <see cref="GC.GetAllocatedBytesForCurrentThread"/> rises by up to 8 kB without an allocation, so tests
    /// of allocations would fail by chance.
    /// </summary>
    [Test]
    public void TestHost_DoesNotCollectConcurrently() => Assert.That(AppContext.GetData("System.GC.Concurrent"), Is.EqualTo("false"));
}
