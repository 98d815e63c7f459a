using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class HeadsetCodeTests
{
    static Reading Read(Func<int, double> signOf) => HeadsetCode.Read(new CodeContrasts(CodeLevels.Of(CodeKind.Headset, signOf)));

    static Reading ReadBoth(int first, int second, double shareOfFirst) =>
        Read(pair => shareOfFirst * CodeWords.SignOf(first, pair) + (1 - shareOfFirst) * CodeWords.SignOf(second, pair));

    [Test]
    public void Read_OneFrame_ReturnsItsTime([Values(0, 1, 32_767, 32_768, 65_535, 12_345)] int value)
    {
        Assert.That(Read(pair => CodeWords.SignOf(value, pair)).Ms, Is.EqualTo(value));
    }

    [TestCase(0.75)]
    [TestCase(0.25)]
    public void Read_TwoFramesInOneExposure_ReturnsTheBrighterFrame(double shareOfFirst)
    {
        for (var value = 5; value < TimestampCode.PeriodMs; value += 499)
        {
            var reading = ReadBoth(value, value + 17, shareOfFirst);

            Assert.That(reading.Ms, Is.EqualTo(shareOfFirst > 0.5 ? value : (value + 17) % TimestampCode.PeriodMs), $"{value} ms");
        }
    }

    [Test]
    public void Read_TwoEquallyBrightFrames_IsRejected()
    {
        for (var value = 5; value < TimestampCode.PeriodMs; value += 499)
            Assert.That(ReadBoth(value, value + 17, 0.52).Fault, Is.Not.Null, $"{value} ms");
    }

    [Test]
    public void Read_OneWrongPair_IsRejected([Range(0, TimestampCode.PairCount - 1)] int wrong)
    {
        foreach (var said in new[] { -1.0, -0.4, 0, 0.1 })
            Assert.That(Read(pair => pair == wrong ? said * CodeWords.SignOf(9_999, pair) : CodeWords.SignOf(9_999, pair)).Fault, Is.Not.Null, $"{said}");
    }

    [Test]
    public void Read_HalfOfTheCodeCovered_IsRejected()
    {
        var whole = CodeLevels.Of(CodeKind.Headset, 9_999);
        var covered = whole with { Levels = [.. whole.Levels.Select((level, cell) => cell / TimestampCode.Side is > 3 and < 7 ? 0.9 : level)] };

        Assert.That(HeadsetCode.Read(new CodeContrasts(covered)).Fault, Is.Not.Null);
    }
}
