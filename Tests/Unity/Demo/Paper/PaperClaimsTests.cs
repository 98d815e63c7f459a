using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Demo.Paper;

/// <summary>Tests each verdict of <c>demo --paper</c> with numbers for which the claim holds and numbers for which it does not hold.</summary>
public class PaperClaimsTests
{
    static readonly PaperMeasures Good = new(
        new PaperClock(0.96, 0.2, 0.2, 0.1), new PaperSwings(0.2, 0.4, [0.2, 0.2, 0.3], 0.8, 0.2), 1.5, "the clock came late", "no whole swing");

    static IEnumerable<PaperMeasures> Bad()
    {
        var (clock, swings) = (Good.Clock, Good.Swings);
        yield return Good with { Clock = clock with { FitShare = 0.94 } };
        yield return Good with { Clock = clock with { OffsetErrorMs = 8 } };
        yield return Good with { Clock = clock with { SkewRatio = 0.6 } };
        yield return Good with { Clock = clock with { RoundTripRatio = 0.7 } };
        yield return Good with { Swings = swings with { ErrorRatio = 0.51 } };
        yield return Good with { Swings = swings with { SteadyRatio = 0.9 } };
        yield return Good with { Swings = swings with { GapRatios = [0.6, 0.2, 0.3] } };
        yield return Good with { Swings = swings with { GapRatios = [0.2, 0.6, 0.3] } };
        yield return Good with { Swings = swings with { GapRatios = [0.2, 0.2, 0.6] } };
        yield return Good with { LightErrorMs = 4.1 };
        yield return Good with { Swings = swings with { Reduction = 0.74 } };
        yield return Good with { Swings = swings with { LatencyRatio = 0.4 } };
    }

    [Test]
    public void Claims_GoodNumbers_AllHold()
    {
        var claims = PaperClaims.Of([Good]);

        Assert.That(claims.Select(claim => claim.Holds), Is.All.True);
        Assert.That(claims.Select(claim => claim.Figure).Distinct(), Is.EqualTo(new[] { "8", "16", "17", "18" }));
        Assert.That(claims.Select(claim => claim.Uncertainty), Is.All.Null, "a single repeat has no uncertainty");
    }

    [Test]
    public void Claims_OneBadNumber_OnlyItsClaimDoesNotHold()
    {
        var bad = Bad().ToList();
        Assert.That(bad, Has.Count.EqualTo(PaperClaims.Of([Good]).Count), "each claim has one bad result");

        for (var i = 0; i < bad.Count; i++)
        {
            var claims = PaperClaims.Of([bad[i]]);
            Assert.That(claims.Select(claim => claim.Holds), Is.EqualTo(bad.Select((_, c) => c != i)), claims[i].Claim);
        }
    }

    [Test]
    public void Claims_NoCompleteRepeat_AreNotMeasured()
    {
        var claims = PaperClaims.Of([]);

        Assert.That(claims, Has.Count.EqualTo(PaperClaims.Of([Good]).Count));
        Assert.That(claims.Select(claim => (claim.Measured, claim.Holds)), Is.All.EqualTo(((double?)null, false)));
        Assert.That(claims.Select(claim => claim.NotMeasured), Is.All.EndsWith(PaperClaimTexts.Interrupted));
    }

    [Test]
    public void Claims_NotMeasured_HaveNoVerdict()
    {
        var claims = PaperClaims.Of([Good with { Clock = null, Swings = null, LightErrorMs = null }]);

        Assert.That(claims.Select(claim => claim.Holds), Is.All.False);
        Assert.That(claims.Select(claim => claim.Measured), Is.All.Null);
        Assert.That(claims.Select(claim => claim.Verdict), Is.All.EqualTo(Verdict.NotMeasured.Words()));
        Assert.That(
            claims.Select(claim => claim.MeasuredText == $"{Verdict.NotMeasured.Words()}: {Good.SwingProblem}"),
            Is.EqualTo(new[] { false, false, false, false, true, true, true, true, true, false, true, true }), "the clock's claims have its reason");
        Assert.That(claims[0].MeasuredText, Is.EqualTo($"{Verdict.NotMeasured.Words()}: {Good.ClockProblem}"));
    }

    [Test]
    public void Claims_MeasuredInSomeRepeats_AreJudgedByThoseRepeatsAndStateTheirNumber()
    {
        var claims = PaperClaims.Of([Good, Good with { Swings = null }]);

        Assert.That(claims.Select(claim => claim.Holds), Is.All.True);
        Assert.That(
            claims.Single(claim => claim.Paper == 0.8).MeasuredText, Is.EqualTo($"80 % ({PaperClaimTexts.NotInAll(1, 2, Good.SwingProblem)})"));
    }

    // The limit is 75 %. Three repeats with a standard deviation of 1 % have an uncertainty of 2.5 %.
    [TestCase(0.78, true, Verdict.Holds)]
    [TestCase(0.76, false, Verdict.Undecided)]
    [TestCase(0.74, false, Verdict.Undecided)]
    [TestCase(0.72, false, Verdict.DoesNotHold)]
    public void Claims_LimitWithinTheUncertainty_AreUndecided(double mean, bool holds, object verdict)
    {
        var repeats = new[] { mean - 0.01, mean, mean + 0.01 }.Select(each => Good with { Swings = Good.Swings with { Reduction = each } }).ToList();

        var claims = PaperClaims.Of(repeats);

        var claim = claims.Single(each => each.Paper == 0.8);
        Assert.That((claim.Holds, claim.Verdict), Is.EqualTo((holds, ((Verdict)verdict).Words())), claim.MeasuredText);
        Assert.That(claims.Where(each => each != claim).Select(each => each.Verdict),
            Is.All.EqualTo(Verdict.Holds.Words()), "the uncertainty of the others is zero");
    }

    [Test]
    public void Claims_NumberNotFinite_CountsAsNotMeasured()
    {
        var claims = PaperClaims.Of([Good with { Clock = Good.Clock with { SkewRatio = double.NaN } }]);

        Assert.That((claims[2].Measured, claims[2].Holds), Is.EqualTo(((double?)null, false)));
    }

    [Test]
    public void Claims_SeveralRepeats_HaveTheMeanAndItsConfidenceInterval()
    {
        var repeats = new[] { 1.0, 2.0, 3.0 }.Select(ms => Good with { LightErrorMs = ms }).ToList();

        var claim = PaperClaims.Of(repeats).Single(each => each.Paper == 4);

        Assert.That(claim.Measured, Is.EqualTo(2).Within(1e-12));
        Assert.That(claim.Uncertainty, Is.EqualTo(4.3027 * 1 / Math.Sqrt(3)).Within(1e-3), "Student's t for two degrees of freedom");
        Assert.That(claim.MeasuredText, Is.EqualTo("2 ms ± 2.48 ms"));
        Assert.That(claim.Repeats, Is.EqualTo(new[] { 1.0, 2, 3 }));
    }

    [Test]
    public void Claims_IntervalOfAShareBeyond100Percent_IsClipped()
    {
        var repeats = new[] { 0.6, 0.75, 0.87 }.Select(share => Good with { Clock = Good.Clock with { FitShare = share } }).ToList();

        var claim = PaperClaims.Of(repeats)[0];

        Assert.That(claim.Uncertainty, Is.EqualTo(0.336).Within(1e-3));
        Assert.That(claim.MeasuredText, Is.EqualTo("74 % (40.4 % to 100 %)"));
    }

    // Standard deviation 0.05, so the interval is the mean ± 0.124.
    [TestCase(0.95, "95 % (82.6 % to 100 %)")]
    [TestCase(0.05, "5 % ± 12.4 %")]
    public void Claims_IntervalOfAReduction_IsClippedOnlyAt100Percent(double mean, string expected)
    {
        var repeats = new[] { mean - 0.05, mean, mean + 0.05 }.Select(each => Good with { Swings = Good.Swings with { Reduction = each } }).ToList();

        Assert.That(PaperClaims.Of(repeats).Single(each => each.Paper == 0.8).MeasuredText, Is.EqualTo(expected));
    }
}
