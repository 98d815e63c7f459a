using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class MovingPicturesTests
{
    static IReadOnlyList<PictureResult> Still(int count) => new SwungPictures { Count = count, AmplitudePx = 0, NoisePx = 1 }.Take();

    // These pictures are taken 20 s after the still ones.
    static IEnumerable<PictureResult> Moving(int count) =>
        new SwungPictures { Count = count }.Take()
            .Select(picture => picture with { LedMs = picture.LedMs + 20_000, HeadsetMs = picture.HeadsetMs + 20_000 });

    [Test]
    public void Rejected_StillHeadset_KeepsAllPictures()
    {
        Assert.That(MovingPictures.Rejected(Still(100), out _), Has.All.Matches<PictureResult>(picture => picture.IsRead));
    }

    [Test]
    public void Rejected_SomePicturesTakenInMotion_RejectsOnlyThose()
    {
        var rejected = MovingPictures.Rejected([.. Still(100), .. Moving(40)], out _);

        Assert.That(rejected.Take(100), Has.All.Matches<PictureResult>(picture => picture.IsRead));
        Assert.That(
            rejected.Skip(100).Count(picture => picture.Fault == MovingPictures.Fault), Is.InRange(30, 40), "all but the turning points");
    }

    [Test]
    public void Rejected_CameraMovedOnce_KeepsAllPictures()
    {
        PictureResult Elsewhere(PictureResult picture) => picture with { Places = picture.Places with { Control = (300, 200) } };

        var rejected = MovingPictures.Rejected([.. Still(100).Select((picture, i) => i < 50 ? picture : Elsewhere(picture))], out _);

        Assert.That(rejected, Has.All.Matches<PictureResult>(picture => picture.IsRead));
    }

    [Test]
    public void Rejected_PicturesReversedOrShuffled_RejectsTheSamePictures()
    {
        PictureResult[] pictures = [.. Still(100), .. Moving(40)];
        string[] Moved(IEnumerable<PictureResult> given) =>
            [.. MovingPictures.Rejected([.. given], out _).Where(picture => !picture.IsRead).Select(picture => picture.File).Order(StringComparer.Ordinal)];
        pictures = [.. pictures.Select((picture, i) => picture with { File = $"{i}" })];

        var expected = Moved(pictures);

        Assert.That(expected, Has.Length.InRange(30, 40));
        Assert.That(Moved(pictures.Reverse()), Is.EqualTo(expected));
        for (var seed = 1; seed <= 5; seed++)
        {
            var shuffled = pictures.ToArray();
            new Random(seed).Shuffle(shuffled);
            Assert.That(Moved(shuffled), Is.EqualTo(expected), "seed " + seed);
        }
    }

    // A hand-held camera drifts. Pictures from different periods of the codes have the same times within the period.
    [Test]
    public void Rejected_StillHeadsetOverSeveralPeriods_KeepsAllPictures()
    {
        PictureResult At(int i) => Still(1)[0] with
        {
            File = $"{i}",
            LedMs = i * 260 % TimestampCode.PeriodMs,
            Places = Still(1)[0].Places with { Control = (640 + 0.1 * i, 360) },
        };

        Assert.That(MovingPictures.Rejected([.. Enumerable.Range(0, 800).Select(At)], out _), Has.All.Matches<PictureResult>(picture => picture.IsRead));
    }

    [Test]
    public void Rejected_MostPicturesTakenInMotion_RejectsAllAndSuggestsCalibrateHead()
    {
        var rejected = MovingPictures.Rejected([.. Still(40), .. Moving(100)], out var refusal);

        Assert.That(rejected, Has.All.Matches<PictureResult>(picture => picture.Fault == MovingPictures.Fault));
        Assert.That(refusal, Does.Contain("of 140 pictures were taken while the headset or the camera moved").And.Contain("'calibrate head'"));
    }

    // The camera shakes by a few pixels after it was relocated.
    [Test]
    public void Rejected_RelocatedShakingCamera_KeepsAllPictures()
    {
        (double X, double Y)[] places = [(400, 300), (402, 300), (700, 320), (704, 321), (703, 320)];
        var still = Still(places.Length);

        var rejected = MovingPictures.Rejected([.. still.Zip(places, (picture, place) => picture with { Places = picture.Places with { Control = place } })], out _);

        Assert.That(rejected, Has.All.Matches<PictureResult>(picture => picture.IsRead));
    }
}
