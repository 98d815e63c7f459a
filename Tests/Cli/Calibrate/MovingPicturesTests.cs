using Nowpose.Cli.Calibrate.Vlc;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class MovingPicturesTests
{
    static IReadOnlyList<PictureResult> Still(int count) => new SwungPictures { Count = count, AmplitudePx = 0, NoisePx = 1 }.Take();

    // Pictures taken 20 s after the still ones.
    static IEnumerable<PictureResult> Moving(int count) =>
        new SwungPictures { Count = count }.Take()
            .Select(picture => picture with { LedMs = picture.LedMs + 20_000, HeadsetMs = picture.HeadsetMs + 20_000 });

    [Test]
    public void Rejected_StillHeadset_KeepsAll()
    {
        Assert.That(MovingPictures.Rejected(Still(100)), Has.All.Matches<PictureResult>(picture => picture.IsRead));
    }

    [Test]
    public void Rejected_SomeTakenInMotion_AreRejectedWithAReasonAndStillOnesKept()
    {
        var rejected = MovingPictures.Rejected([.. Still(100), .. Moving(40)]);

        Assert.That(rejected.Take(100), Has.All.Matches<PictureResult>(picture => picture.IsRead));
        Assert.That(
            rejected.Skip(100).Count(picture => picture.Fault == "taken while the headset moved"), Is.InRange(30, 40), "all but the turning points");
    }

    [Test]
    public void Rejected_CameraMovedOnce_KeepsAll()
    {
        PictureResult Elsewhere(PictureResult picture) => picture with { Places = picture.Places with { Control = (300, 200) } };

        var rejected = MovingPictures.Rejected([.. Still(100).Select((picture, i) => i < 50 ? picture : Elsewhere(picture))]);

        Assert.That(rejected, Has.All.Matches<PictureResult>(picture => picture.IsRead));
    }

    [Test]
    public void Rejected_MostTakenInMotion_ThrowsAndNamesTheSuitableVerb()
    {
        Assert.That(() => MovingPictures.Rejected([.. Still(40), .. Moving(100)]),
            Throws.TypeOf<InputException>().With.Message.Contains("of 140 pictures were taken while the headset or the camera moved")
                .And.Message.Contains("'calibrate head'"));
    }
}
