using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.VisibleLight;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class SweepJoinTests
{
    static readonly IReadOnlyList<SweepRow> Rows = [.. Enumerable.Range(0, 20_000).Select(i => new SweepRow(
        ControlTime.FromNanoseconds(1_000_000_000_000 + i * 16_666_667L), i, 5 + i * 1e-3, RenderTimeSourceKind.DisplayGpuTime, "", double.NaN))];

    static PictureResult PictureOf(int row) => new("p" + row, 0, TimestampCode.ValueOf(Rows[row].FrameStart), 40, null);

    [Test]
    public void Join_SweepOfSeveralPeriods_FollowsThePictures()
    {
        int[] rows = [3, 900, 3_500, 6_000, 9_990, 13_000, 16_001, 19_999];

        var joined = new SweepJoin(Rows).Join(rows.Select(PictureOf));

        Assert.That(joined.Select(picture => picture.Vertices), Is.EqualTo(rows));
        Assert.That(joined[1].RenderMs, Is.EqualTo(5.9).Within(1e-9));
    }

    [Test]
    public void Join_PictureThatIsNotReadOrNotOfTheSweep_IsLeftOut()
    {
        var before = new PictureResult("before", 0, TimestampCode.ValueOf(Rows[0].FrameStart - TimeSpan.FromMilliseconds(5)), 40, null);

        var joined = new SweepJoin(Rows.Take(100).ToList()).Join([PictureResult.Not("blurred", "no code found"), before, PictureOf(50)]);

        Assert.That(joined.Select(picture => picture.File), Is.EqualTo(new[] { "p50" }));
    }
}
