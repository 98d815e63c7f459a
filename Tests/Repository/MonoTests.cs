using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Finds calls that behave differently under Unity's Mono. Tests under .NET cannot detect these differences.</summary>
/// <remarks>
/// Mono rounds the arguments of TimeSpan.FromSeconds and FromMilliseconds to whole milliseconds. Under Mono, a TcpClient that is
/// created without an address family supports only IPv4.
/// </remarks>
public sealed partial class MonoTests
{
    [Test]
    public void Calls_InThePackage_BehaveTheSameOnMono()
    {
        var different = RepositoryFiles.Under(RepositoryFiles.Package, ".cs")
            .SelectMany(file => MonoDifferences(RepositoryFiles.Read(file)).Select(call => file + ": " + call));

        Assert.That(different, Is.Empty);
    }

    [TestCase("TimeSpan.FromMilliseconds(0.25)")]
    [TestCase("TimeSpan.FromSeconds(seconds)")]
    [TestCase("TimeSpan.FromSeconds(1e-4)")]
    [TestCase("TimeSpan.FromSeconds(\n    2 + x)")]
    [TestCase("new TcpClient()")]
    [TestCase("new TcpClient { NoDelay = true }")]
    public void MonoDifferences_InexactTimeOrMissingAddressFamily_AreReported(string code) => Assert.That(MonoDifferences(code), Is.Not.Empty);

    [TestCase("TimeSpan.FromMilliseconds(250)")]
    [TestCase("TimeSpan.FromSeconds(-2_000)")]
    [TestCase("HeadsetTime.FromSeconds(0.25)")]
    [TestCase("TimeSpan.FromTicks(ticks)")]
    [TestCase("new TcpClient(address.AddressFamily) { NoDelay = true }")]
    [TestCase("// TimeSpan.FromSeconds(x) rounds")]
    public void MonoDifferences_CallsThatBehaveTheSameOnMono_AreNotReported(string code) => Assert.That(MonoDifferences(code), Is.Empty);

    static IEnumerable<string> MonoDifferences(string source) => MonoDifference().Matches(CSharpCode.Of(source)).Select(m => m.Value);

    [GeneratedRegex(@"TimeSpan\.From(Milliseconds|Seconds)\((?!-?[0-9_]+\))[^\n]*|new\s+TcpClient\s*(\(\s*\)|\{)")]
    private static partial Regex MonoDifference();
}
