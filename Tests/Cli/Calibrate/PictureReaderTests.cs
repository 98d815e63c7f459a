using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Vision;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class PictureReaderTests
{
    const int Height = 720;

    static PictureResult Read(PictureReader reader, params FoundCode[] codes) => reader.Read("a.png", new SeenPicture(1280, Height, codes, null));

    [TestCase(10_000, 10_040, 40)]
    [TestCase(65_520, 24, 40)]
    [TestCase(24, 65_534, -26)]
    public void Read_BothCodes_ReturnsTheirDifference(int headset, int control, double expected)
    {
        var result = Read(new PictureReader(0, 0), CodeLevels.Run(control, 1), CodeLevels.Of(CodeKind.Headset, headset));

        Assert.That(result.VisuMs, Is.EqualTo(expected).Within(0.2));
        Assert.That(result.HeadsetMs, Is.EqualTo(headset));
    }

    static readonly object[][] Implausible = [[0, 501, PictureFaults.FarApart(500)], [1000, 900, PictureFaults.HeadsetAhead(50)]];

    [TestCaseSource(nameof(Implausible))]
    public void Read_ImplausibleDifferenceBetweenTheCodes_IsRejected(int headset, int control, string fault)
    {
        var result = Read(new PictureReader(0, 0), CodeLevels.Run(control, 1), CodeLevels.Of(CodeKind.Headset, headset));

        Assert.That(result.Fault, Is.EqualTo(fault));
    }

    static readonly object[][] OtherCounts =
    [
        [2, 1, PictureFaults.ControlCodes("two")],
        [1, 2, PictureFaults.HeadsetCodes("two")],
        [3, 1, PictureFaults.ControlCodes("3")],
        [0, 2, PictureFaults.HeadsetCodes("two")],
        [1, 0, PictureFaults.NoHeadsetCode],
        [0, 1, PictureFaults.NoControlCode],
        [0, 0, PictureFaults.NoCode],
    ];

    [TestCaseSource(nameof(OtherCounts))]
    public void Read_NotExactlyOneCodeOfEachKind_IsRejected(int controls, int headsets, string fault)
    {
        var result = Read(
            new PictureReader(0, 0),
            [.. Enumerable.Repeat(CodeLevels.Run(10_040, 1), controls), .. Enumerable.Repeat(CodeLevels.Of(CodeKind.Headset, 10_000), headsets)]);

        Assert.That(result.Fault, Is.EqualTo(fault));
    }

    [TestCase(CodeKind.Control)]
    [TestCase(CodeKind.Headset)]
    public void Read_WeakSecondCode_IsRejectedOnlyIfItIsReadable(object kind)
    {
        FoundCode[] codes = [CodeLevels.Run(10_040, 1), CodeLevels.Of(CodeKind.Headset, 10_000)];
        var second = codes.Single(code => code.Kind == (CodeKind)kind) with { IsWeak = true };
        // A part of another object that looks like a weak code; its pairs match no code.
        var other = CodeLevels.Of((CodeKind)kind, pair => pair % 2 == 0 ? 1 : 0.4) with { IsWeak = true };

        Assert.That(Read(new PictureReader(0, 0), [.. codes, second]).Fault, Does.StartWith("two "));
        Assert.That(Read(new PictureReader(0, 0), [.. codes, other]).Fault, Is.Null);
    }

    [TestCase(CodeKind.Control, 0.1, true)]
    [TestCase(CodeKind.Control, 0.2, false)]
    [TestCase(CodeKind.Headset, 0.2, true)]
    public void Read_LightBetweenTheCells_IsRejectedOnlyForTheControlCode(object kind, double residual, bool isRead)
    {
        FoundCode[] codes = [CodeLevels.Run(10_040, 1), CodeLevels.Of(CodeKind.Headset, 10_000)];

        var result = Read(new PictureReader(0, 0), [.. codes.Select(code => code.Kind == (CodeKind)kind ? code with { Residual = residual } : code)]);

        Assert.That(result.IsRead, Is.EqualTo(isRead));
    }

    [Test]
    public void Read_WeakSecondCodeBehindAnotherBoard_IsStillCounted()
    {
        var control = CodeLevels.Run(10_040, 1);

        var result = Read(new PictureReader(0, 0), control, CodeLevels.Of(CodeKind.Headset, 10_000), control with { IsWeak = true, Residual = 0.2 });

        Assert.That(result.Fault, Does.StartWith("two "));
    }

    [TestCase(-4, null)]
    [TestCase(-20, PictureFaults.HeadsetCodeCutOff)]
    [TestCase(Height - 76, null)]
    [TestCase(Height - 60, PictureFaults.HeadsetCodeCutOff)]
    public void Read_CodeMoreThanHalfACellOutside_IsRejected(double top, string fault)
    {
        var headset = CodeLevels.Of(CodeKind.Headset, pair => CodeWords.SignOf(10_000, pair), top);

        Assert.That(Read(new PictureReader(0, 0), CodeLevels.Run(10_040, 1), headset).Fault, Is.EqualTo(fault));
    }

    [TestCase(0, "headset code " + PictureFaults.PartlyCovered)]
    [TestCase(1, "headset code " + PictureFaults.Disturbed)]
    public void Read_BothCellsOfAPairEqual_NamesTheCause(double light, string fault)
    {
        var headset = CodeLevels.Of(CodeKind.Headset, 10_000);
        var (levels, cell) = (headset.Levels.ToArray(), TimestampCode.CellOf(7));
        levels[cell] = levels[cell + 1] = light;

        Assert.That(Read(new PictureReader(0, 0), CodeLevels.Run(10_040, 1), headset with { Levels = levels }).Fault, Is.EqualTo(fault));
    }

    // Sums of the cells of the pairs in a rendered picture of LEDs without a dark board in front of a bright scene.
    [Test]
    public void Read_PairsDarkBecauseOfTheSceneBehindThem_IsNotReportedAsCovered()
    {
        double[] sums = [1.2, 0.05, 0.6, 1.3, 0.4, 1.2, 0.8, 1.1, 0.3, 1.2, 0.6, 1.2, 0.2, 0.9, 1.3, 0.5, 1.1, 0.7];
        var control = CodeLevels.Of(CodeKind.Control, 10_040);
        var levels = control.Levels.ToArray();
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var cell = TimestampCode.CellOf(pair);
            for (var i = cell; i < cell + 2; i++) levels[i] += (sums[pair] - 1) / 2 * CodeLevels.Light;
        }

        var result = Read(new PictureReader(0, 0), control with { Levels = levels }, CodeLevels.Of(CodeKind.Headset, 10_000));

        Assert.That(result.Fault, Is.EqualTo("control code " + PictureFaults.Disturbed));
    }

    // Values of rendered pictures with a bright wall close to the LEDs: the ring seems to be dark, and the sum of the cells of a pair is about zero.
    [TestCase(0.6, 2.2)]
    [TestCase(0.3, 3.2)]
    public void Read_BrightWallAroundTheLeds_NamesTheMissingMargin(double ring, double contrast)
    {
        var control = CodeLevels.Of(CodeKind.Control, 10_040);
        var levels = control.Levels.Select((level, cell) => ring * (TimestampCode.IsRing(cell) ? level : contrast * (level - CodeLevels.Light / 2))).ToArray();

        var result = Read(new PictureReader(0, 0), control with { Levels = levels }, CodeLevels.Of(CodeKind.Headset, 10_000));

        Assert.That(result.Fault, Is.EqualTo("control code " + PictureFaults.NoMargin));
    }

    [TestCase(0, 3, PictureFaults.PartlyDark)]
    [TestCase(4, 2, PictureFaults.PartlyDark)]
    [TestCase(1, 2, PictureFaults.PartlyCovered)]
    public void Read_DarkRowsAtTheEdgeOfTheCode_SuggestsAPartlyLitCode(int first, int count, string fault)
    {
        var headset = CodeLevels.Of(CodeKind.Headset, 10_000);
        double[] levels = [.. headset.Levels.Select((level, cell) => cell / TimestampCode.Side - 1 is var row && row >= first && row < first + count ? 0 : level)];

        Assert.That(Read(new PictureReader(0, 0), CodeLevels.Run(10_040, 1), headset with { Levels = levels }).Fault, Is.EqualTo("headset code " + fault));
    }

    [Test]
    public void Read_RollingShutter_CorrectsForTheHeightOfTheCodes()
    {
        var headset = CodeLevels.Of(CodeKind.Headset, _ => 1, top: 480) with { Levels = CodeLevels.Of(CodeKind.Headset, 10_000).Levels };

        var result = Read(new PictureReader(20, 0), CodeLevels.Run(10_040, 1), headset);

        // The headset's code is 180 px lower than the control code, and the readout of 720 px takes 20 ms.
        Assert.That(result.VisuMs, Is.EqualTo(45).Within(0.5));
    }

    [Test]
    public void Read_MonitorWithDelay_AddsTheDelay()
    {
        var result = Read(new PictureReader(0, 25), CodeLevels.Of(CodeKind.Control, 10_015), CodeLevels.Of(CodeKind.Headset, 10_000));

        Assert.That(result.VisuMs, Is.EqualTo(40));
    }

    [TestCase(1)]
    [TestCase(2.3)]
    [TestCase(5)]
    public void Read_LedsWithDelay_AddsTheDelay(double exposureMs)
    {
        for (var start = 10_020.2; start < 10_040; start += 0.7)
        {
            var result = Read(new PictureReader(0, 0.3), CodeLevels.Run(start, exposureMs), CodeLevels.Of(CodeKind.Headset, 10_000));

            Assert.That(result.VisuMs, Is.EqualTo(start + exposureMs / 2 - 0.5 - 10_000 + 0.3).Within(0.5), $"from {start} ms");
        }
    }

    [TestCase(4)]
    [TestCase(7)]
    [TestCase(17)]
    public void Read_MonitorBetweenTwoFrames_ReturnsOneFrameOrIsRejected(int step)
    {
        var read = 0;
        for (var value = 10_020; value < 10_060; value++)
            foreach (var share in new[] { 0.1, 0.3, 0.45, 0.5, 0.6, 0.8 })
            {
                var blend = CodeLevels.Of(
                    CodeKind.Control, pair => (1 - share) * CodeWords.SignOf(value, pair) + share * CodeWords.SignOf(value + step, pair));

                var result = Read(new PictureReader(0, 0), blend, CodeLevels.Of(CodeKind.Headset, 10_000));

                if (!result.IsRead) continue;
                read++;
                // The error is at most half a frame relative to the brighter frame.
                var brighter = value - 10_000 + (share < 0.5 ? 0 : step);
                Assert.That(result.VisuMs, Is.EqualTo(brighter).Within(Math.Max(2, step / 2.0)), $"{value} ms, {share}");
            }
        // Only the shares 0.1, 0.3 and 0.8 can be read. With the other shares, both frames are about equally bright.
        Assert.That(read, Is.GreaterThanOrEqualTo(40 * 3));
    }

    [Test]
    public void Read_CodeMissing_NamesTheMissingCode()
    {
        var reader = new PictureReader(0, 0);

        Assert.That(Read(reader).Fault, Is.EqualTo(PictureFaults.NoCode));
        Assert.That(Read(reader, CodeLevels.Run(5, 1)).Fault, Is.EqualTo(PictureFaults.NoHeadsetCode));
        Assert.That(Read(reader, CodeLevels.Of(CodeKind.Headset, 5)).Fault, Is.EqualTo(PictureFaults.NoControlCode));
    }
}
