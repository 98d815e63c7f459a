using Nowpose.Gateway.Codes;
using Nowpose.Pairing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Checks that the example codes in the manual are valid and have the stated size.</summary>
public sealed class PairingDocumentTests
{
    const string Page = RepositoryFiles.Package + "/Documentation~/pairing.md";

    static string[] Examples => [.. RepositoryFiles.Read(Page).Split('\n').SkipWhile(line => line != "```nowpose-code").Skip(1)
        .TakeWhile(line => line != "```")];

    [Test]
    public void Examples_OfTheDocument_AreValid()
    {
        Assert.That(CellCode.Parse(Examples[0]).Cell, Is.EqualTo("Press 3"));
        Assert.That(CellCode.Parse(Examples[1]).Pin, Is.Null);
        Assert.That(TokenCode.Parse(Examples[2]).ValidToUtc, Is.Not.Null);
        Assert.That(Examples, Has.Length.EqualTo(3));
    }

    [TestCase(0)]
    [TestCase(2)]
    public void Examples_OfTheDocument_HaveTheStatedSize(int index)
    {
        using var drawn = new QrCode(Examples[index]);

        var version = (drawn.Modules - 17) / 4;
        Assert.That(
            RepositoryFiles.Read(Page).ReplaceLineEndings(" "),
            Does.Match($"{Examples[index].Length} characters( and needs a QR code of| and needs) version {version} \\({drawn.Modules} modules\\)"));
    }

    [Test]
    public void LongestCode_QrVersion_IsTheHoloLensMaximum()
    {
        using var drawn = new QrCode("nowpose:cell/1?" + new string('a', PairingCode.MaxLength - 15));
        using var longer = new QrCode("nowpose:cell/1?" + new string('a', PairingCode.MaxLength - 14));

        Assert.That(drawn.Modules, Is.EqualTo(17 + 4 * 10));
        Assert.That(longer.Modules, Is.GreaterThan(drawn.Modules));
    }
}
