using Nowpose.Cli.Calibrate.Vlc;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class PictureFilesTests : CalibrationFolder
{
    [Test]
    public void Of_FolderWithNumberedPictures_ReturnsThemInNumericOrder()
    {
        string[] expected =
            ["a.png", "frame1.png", "frame2.png", "frame9.png", "frame10.png", "frame0011.png", "frame60.png", "img_2_10.png", "img_10_2.png"];
        foreach (var name in expected.Reverse()) Write(name, []);

        Assert.That(PictureFiles.Of([Folder]).Select(Path.GetFileName), Is.EqualTo(expected));
    }

    [Test]
    public void Of_UnsupportedPictureFormat_ReturnsTheFile()
    {
        var heic = Write("a.HEIC", []);

        Assert.That(PictureFiles.Of([heic]), Is.EqualTo(new[] { heic }));
        Assert.That(PictureFiles.Of([Folder]), Is.EqualTo(new[] { heic }));
    }

    [Test]
    public void Compare_LeadingZerosOrManyDigits_IsATotalOrderByNumber()
    {
        var order = new NumberedNames();
        var names = new[] { "p1", "p01", "p001", "p2", "p" + new string('9', 40), "p1" + new string('0', 40), "p", "" };

        foreach (var a in names)
            foreach (var b in names)
            {
                Assert.That(Math.Sign(order.Compare(a, b)), Is.EqualTo(-Math.Sign(order.Compare(b, a))), $"{a}, {b}");
                Assert.That(order.Compare(a, b) == 0, Is.EqualTo(a == b), $"{a}, {b}");
            }
        Assert.That(order.Compare("p" + new string('9', 40), "p1" + new string('0', 40)), Is.Negative);
    }
}
