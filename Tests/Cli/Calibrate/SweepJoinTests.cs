using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class SweepJoinTests
{
    const long StartNs = 1_000_000_000_000;

    /// <summary>A sweep over five periods of the codes. Frames start up to 1 ms early or late, so the same codes occur in every period.</summary>
    static readonly IReadOnlyList<SweepRow> Rows = RowsOf(new Random(3), 20_000);

    static List<SweepRow> RowsOf(Random jitter, int count) => [.. Enumerable.Range(0, count).Select(i => new SweepRow(
        ControlTime.FromNanoseconds(StartNs + i * 16_666_667L + jitter.Next(-1_000_000, 1_000_000)), i, 5 + i * 1e-3,
        RenderTimeSourceKind.DisplayGpuTime, "", double.NaN))];

    static bool HasARow(PictureResult picture) => Rows.Any(row => TimestampCode.ValueOf(row.FrameStart) == (int)picture.HeadsetMs);

    static PictureResult PictureOf(int row) => PictureAt("p" + row, Rows[row].FrameStart);

    static PictureResult PictureAt(string name, ControlTime start)
    {
        var value = TimestampCode.ValueOf(start);
        return new(name, (value + 40) % TimestampCode.PeriodMs, value, 40, null);
    }

    [Test]
    public void Join_SweepOfSeveralPeriods_AssignsThePictures()
    {
        int[] rows = [3, 900, 3_500, 6_000, 9_990, 13_000, 16_001, 19_999];

        var joined = new SweepJoin(Rows, RenderTimeSourceKind.DisplayGpuTime).Join(rows.Select(PictureOf));

        Assert.That(joined.Select(picture => picture.Vertices), Is.EqualTo(rows));
        Assert.That(joined[1].RenderMs, Is.EqualTo(5.9).Within(1e-9));
    }

    [Test]
    public void Join_RenderTimeFromAnotherSource_IsNull()
    {
        var joined = new SweepJoin(Rows, RenderTimeSourceKind.GpuCompletion).Join([PictureOf(3)]);

        Assert.That((joined.Single().Vertices, joined.Single().RenderMs), Is.EqualTo((3, (double?)null)));
    }

    [Test]
    public void Join_PictureUnreadOrNotInTheSweep_ExcludesIt()
    {
        var before = PictureAt("before", Rows[0].FrameStart - TimeSpan.FromMilliseconds(5));

        var joined = new SweepJoin(Rows.Take(100).ToList(), RenderTimeSourceKind.DisplayGpuTime)
            .Join([PictureResult.Not("blurred", "no code found"), before, PictureOf(50)]);

        Assert.That(joined.Select(picture => picture.File), Is.EqualTo(new[] { "p50" }));
    }

    [Test]
    public void Join_ShortSweepInAnyOrder_AssignsAllPictures()
    {
        var rows = Rows.Take(3_900).ToList();
        var shuffled = Enumerable.Range(0, 70).Select(i => PictureOf(55 * i)).ToArray();
        new Random(1).Shuffle(shuffled);

        var joined = new SweepJoin(rows, RenderTimeSourceKind.DisplayGpuTime).Join(shuffled);

        Assert.That(joined.Select(picture => picture.Vertices), Is.EqualTo(Enumerable.Range(0, 70).Select(i => 55 * i)));
    }

    [Test]
    public void Join_LongSweepInReverseOrder_AssignsAllPictures()
    {
        int[] rows = [.. Enumerable.Range(0, 200).Select(i => 90 * i)];

        var joined = new SweepJoin(Rows, RenderTimeSourceKind.DisplayGpuTime).Join(rows.Reverse().Select(PictureOf));

        Assert.That(joined.Select(picture => picture.Vertices), Is.EqualTo(rows));
    }

    [Test]
    public void Join_CameraStartsInALaterPeriod_FindsTheFrames([Values(0, 4_100, 8_300, 12_500)] int first)
    {
        int[] rows = [.. Enumerable.Range(0, 60).Select(i => first + 40 * i)];

        var joined = new SweepJoin(Rows, RenderTimeSourceKind.DisplayGpuTime).Join(rows.Select(PictureOf));

        Assert.That(joined.Select(picture => picture.Vertices), Is.EqualTo(rows));
    }

    [Test]
    public void Join_CameraStartsTenSecondsEarly_ExcludesTheEarlyPictures()
    {
        for (var seed = 1; seed <= 20; seed++)
        {
            var random = new Random(seed);
            var early = Enumerable.Range(1, 20).Select(i => StartNs - 10_000_000_000 + i * 490_000_000L + random.Next(-8_000_000, 8_000_000))
                .Select(ns => PictureAt("early", ControlTime.FromNanoseconds(ns))).ToList();
            int[] rows = [.. Enumerable.Range(0, 600).Select(i => 5 + 30 * i)];
            Assert.That(early.Any(HasARow), "seed " + seed + ": nothing could go astray");

            var joined = new SweepJoin(Rows, RenderTimeSourceKind.DisplayGpuTime).Join(early.Concat(rows.Select(PictureOf)));

            Assert.That(joined.Select(picture => picture.File), Is.EqualTo(rows.Select(row => "p" + row)), "seed " + seed);
            Assert.That(joined.Select(picture => picture.Vertices), Is.EqualTo(rows), "seed " + seed);
        }
    }

    [Test]
    public void Join_MisreadCodesAndUnloggedFrames_AssignsTheOtherPictures()
    {
        for (var seed = 1; seed <= 20; seed++)
        {
            var random = new Random(seed);
            int[] rows = [.. Enumerable.Range(0, 300).Select(i => 2_000 + 60 * i)];
            var pictures = rows.Select(PictureOf).ToArray();
            for (var i = 0; i < 15; i++)
            {
                var place = random.Next(pictures.Length);
                pictures[place] = pictures[place] with { File = "astray", HeadsetMs = random.Next(TimestampCode.PeriodMs) };
            }
            var right = pictures.Count(picture => picture.File != "astray");

            var joined = new SweepJoin(Rows, RenderTimeSourceKind.DisplayGpuTime).Join(pictures);

            foreach (var picture in joined.Where(picture => picture.File != "astray"))
                Assert.That("p" + picture.Vertices, Is.EqualTo(picture.File), "seed " + seed);
            // A wrong picture whose frame matches by chance can replace a neighbouring picture.
            Assert.That(joined.Count(picture => picture.File != "astray"), Is.InRange(right - 2, right), "seed " + seed);
        }
    }
}
