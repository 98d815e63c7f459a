using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class OutliersTests
{
    static PictureResult[] Series(int count, params double[] outliers) =>
        [.. Enumerable.Range(0, count).Select(i => new PictureResult("p" + i, 0, i, 40 + i % 3, null)), .. outliers.Select(visu => new PictureResult("outlier", 0, 0, visu, null))];

    [Test]
    public void Rejected_OneOutlier_RejectsItWithTheReason()
    {
        var checkedOnes = Outliers.Rejected([PictureResult.Not("blurred", PictureFaults.NoCode), .. Series(30, 426)]);

        Assert.That(checkedOnes.Single(picture => picture.File == "outlier").Fault, Is.EqualTo(Outliers.Fault));
        Assert.That(checkedOnes.Count(picture => picture.IsRead), Is.EqualTo(30));
        Assert.That(checkedOnes[0].Fault, Is.EqualTo(PictureFaults.NoCode));
    }

    [Test]
    public void Rejected_QueuedFrames_KeepsThem() =>
        Assert.That(Outliers.Rejected(Series(30, 90, 140, 220)).All(picture => picture.IsRead), Is.True);

    [Test]
    public void Rejected_TooFewPictures_KeepsAllPictures() => Assert.That(Outliers.Rejected(Series(8, 426)).All(picture => picture.IsRead), Is.True);
}
