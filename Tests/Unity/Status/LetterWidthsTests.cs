using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Status;

public sealed class LetterWidthsTests
{
    [Test]
    public void Of_EachLetterOfTheFont_IsNotNarrowerThanTheLetter()
    {
        foreach (var (letter, width) in SeenText.Widths)
        {
            Assert.That(LetterWidths.Of(letter), Is.GreaterThanOrEqualTo(width - 1e-4), $"'{letter}'");
            if (letter < 127) Assert.That(LetterWidths.Of(letter), Is.LessThan(width + 0.06), $"'{letter}'");
        }
    }

    [Test]
    public void Of_UnknownLetter_IsAsWideAsTheWidest()
    {
        Assert.That(LetterWidths.Of('漢'), Is.GreaterThanOrEqualTo(SeenText.Widths.Values.Max()));
    }
}
