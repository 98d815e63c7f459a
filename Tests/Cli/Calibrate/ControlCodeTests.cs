using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

public sealed class ControlCodeTests
{
    static readonly double[] NoDelays = new double[TimestampCode.PairCount];

    static Reading Read(double start, double length) => ControlCode.Read(new CodeContrasts(CodeLevels.Run(start, length)), NoDelays);

    [TestCase(0.9)]
    [TestCase(2.3)]
    [TestCase(5.0)]
    [TestCase(8.0)]
    public void Read_ExposureOverSeveralCodes_ReturnsTheMeanTime(double exposureMs)
    {
        for (var start = 3.07; start < TimestampCode.PeriodMs; start += 611.37)
        {
            var reading = Read(start, exposureMs);

            Assert.That(reading.Fault, Is.Null, $"from {start} ms");
            // Code v is shown from v ms to v + 1 ms.
            Assert.That(reading.Ms, Is.EqualTo(start + exposureMs / 2 - 0.5).Within(0.5), $"from {start} ms");
        }
    }

    [Test]
    public void Read_ExposureAcrossTheEndOfThePeriod_IsCloseToTheTrueTime()
    {
        var reading = Read(65_534.5, 3);

        Assert.That(reading.Ms, Is.EqualTo(65_535.5).Within(0.3));
    }

    [TestCase(0)]
    [TestCase(9)]
    [TestCase(17)]
    public void Read_OnePairInverted_IsRejected(int wrong)
    {
        for (var value = 40; value < TimestampCode.PeriodMs; value += 997)
        {
            var code = CodeLevels.Of(CodeKind.Control, pair => pair == wrong ? -CodeWords.SignOf(value, pair) : CodeWords.SignOf(value, pair));

            Assert.That(ControlCode.Read(new CodeContrasts(code), NoDelays).Fault, Is.Not.Null, $"{value} ms");
        }
    }

    [Test]
    public void Read_OnePairBlank_NeverReturnsAWrongTime()
    {
        for (var value = 40; value < TimestampCode.PeriodMs; value += 997)
            for (var blank = 0; blank < TimestampCode.PairCount; blank++)
            {
                var code = CodeLevels.Of(CodeKind.Control, pair => pair == blank ? 0 : CodeWords.SignOf(value, pair));

                var reading = ControlCode.Read(new CodeContrasts(code), NoDelays);

                Assert.That(reading.Fault != null || Math.Abs(reading.Ms - value) < 2, $"{value} ms without pair {blank} was read as {reading.Ms} ms");
            }
    }

    [Test]
    public void Read_RollingShutter_ReturnsTheTimeAtTheMiddleOfTheCode()
    {
        double[] delays = [.. Enumerable.Range(0, TimestampCode.PairCount).Select(pair => 0.8 * (pair / 3 - 2.5))];
        var code = CodeLevels.Of(CodeKind.Control, pair => CodeWords.MeanSign(pair, 1022.3 + delays[pair], 2));

        var reading = ControlCode.Read(new CodeContrasts(code), delays);

        Assert.That(reading.Ms, Is.EqualTo(1022.8).Within(0.3));
    }
}
