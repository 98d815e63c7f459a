using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Finds calls that behave differently under Unity's Mono, where tests under .NET cannot detect the difference.</summary>
/// <remarks>
/// Mono rounds the arguments of TimeSpan.FromSeconds and FromMilliseconds to whole milliseconds. A TcpClient created without an address
/// family supports only IPv4 there.
/// </remarks>
public sealed partial class MonoTests
{
    [Test]
    public void Calls_InThePackage_BehaveTheSameUnderMono()
    {
        var different = RepositoryFiles.Under(RepositoryFiles.Package, ".cs")
            .SelectMany(file => Different(RepositoryFiles.Read(file)).Select(call => file + ": " + call));

        Assert.That(different, Is.Empty);
    }

    [TestCase("TimeSpan.FromMilliseconds(0.25)")]
    [TestCase("TimeSpan.FromSeconds(seconds)")]
    [TestCase("TimeSpan.FromSeconds(1e-4)")]
    [TestCase("TimeSpan.FromSeconds(\n    2 + x)")]
    [TestCase("new TcpClient()")]
    [TestCase("new TcpClient { NoDelay = true }")]
    public void Different_FractionVariableOrUnknownFamily_IsReported(string code) => Assert.That(Different(code), Is.Not.Empty);

    [TestCase("TimeSpan.FromMilliseconds(250)")]
    [TestCase("TimeSpan.FromSeconds(-2_000)")]
    [TestCase("HeadsetTime.FromSeconds(0.25)")]
    [TestCase("TimeSpan.FromTicks(ticks)")]
    [TestCase("new TcpClient(address.AddressFamily) { NoDelay = true }")]
    [TestCase("// TimeSpan.FromSeconds(x) rounds")]
    public void Different_WholeNumberOrTicksOrFamily_IsNotReported(string code) => Assert.That(Different(code), Is.Empty);

    static IEnumerable<string> Different(string source) => OtherThanUnderNet().Matches(CSharpCode.Of(source)).Select(m => m.Value);

    [GeneratedRegex(@"TimeSpan\.From(Milliseconds|Seconds)\((?!-?[0-9_]+\))[^\n]*|new\s+TcpClient\s*(\(\s*\)|\{)")]
    private static partial Regex OtherThanUnderNet();
}
