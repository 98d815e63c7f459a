using System.Text.RegularExpressions;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Compares the keys of the diagnostics that the operations page reads with those that a headset publishes.</summary>
public class HeadsetKeysTests
{
    const string OfPage = "Web/src/operations/headsetKeys.ts";

    [Test]
    public void KeysOfThePage_Each_IsPublishedByHeadsets()
    {
        var published = typeof(HeadsetKeys).GetFields().Select(field => (string)field.GetRawConstantValue()).ToList();
        var read = Regex.Matches(RepositoryFiles.Read(OfPage), @"\| ['`]([\w/]+)(?:\$\{string\})?['`]").Select(match => match.Groups[1].Value).ToList();

        Assert.That(read, Has.Count.GreaterThan(20));
        Assert.That(published, Is.Unique);
        Assert.That(read.Except(published), Is.Empty, $"these keys of {OfPage} are not in {nameof(HeadsetKeys)}.cs");
    }
}
