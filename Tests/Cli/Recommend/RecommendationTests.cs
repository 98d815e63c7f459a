using Nowpose.Cli;
using Nowpose.Cli.Messages;
using Nowpose.Cli.Recommend;
using Nowpose.Cli.Replay;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Recommend;

public class RecommendationTests
{
    static Trial Trial(string predictor, double first, double second)
    {
        static ReplayResult Result(string predictor, double rms) => new("f", predictor, 100, [new ReplayResult.Axis("a", new ErrorComparison(1, rms, rms, rms))]);
        return new Trial(predictor, Result(predictor, first), Result(predictor, second));
    }

    static Recommendation Of(params Trial[] others) => new(null, [Trial(Predictors.Default, 0.5, 0.4), Trial("hold", 1, 1), .. others]);

    [Test]
    public void Recommended_NoCandidateBetter_IsTheDefault()
    {
        var recommendation = Of(Trial("cubic", 0.6, 0.41));

        Assert.That(recommendation.Recommended.Predictor, Is.EqualTo(Predictors.Default));
        Assert.That(recommendation.Reason, Is.EqualTo(RecommendTexts.NoneBetter));
        Assert.That(recommendation.Trials.Select(t => t.Predictor), Is.EqualTo(new[] { Predictors.Default, "cubic", "hold" }));
    }

    [Test]
    public void Recommended_CandidateBetterOnBothHalves_IsThatCandidate()
    {
        var recommendation = Of(Trial("linear", 0.4, 0.3), Trial("cubic", 0.45, 0.35));

        Assert.That(recommendation.Recommended.Predictor, Is.EqualTo("linear"));
        Assert.That(recommendation.Reason, Is.EqualTo(RecommendTexts.SmallerError(22, Predictors.Default, "20 %", "25 %")));
    }

    [Test]
    public void Recommended_CandidateBetterOnOneHalfOnly_IsTheDefault()
    {
        var lucky = Trial("linear", 0.1, 0.41);

        var recommendation = Of(lucky);

        Assert.That(recommendation.Trials[0], Is.EqualTo(lucky));
        Assert.That(recommendation.Recommended.Predictor, Is.EqualTo(Predictors.Default));
        Assert.That(recommendation.IsTie(lucky));
        Assert.That(recommendation.Reason, Is.EqualTo(RecommendTexts.EquallyGood("linear")));
    }

    [Test]
    public void Recommended_CandidateMarginallyBetter_IsTheDefault()
    {
        var recommendation = Of(Trial("linear", 0.495, 0.396));

        Assert.That(recommendation.Recommended.Predictor, Is.EqualTo(Predictors.Default));
        Assert.That(recommendation.Reason, Is.EqualTo(RecommendTexts.LittleBetter("linear", 2)));
    }

    [Test]
    public void Rms_HalvesOfDifferentLength_WeightsAllFramesEqually()
    {
        var trial = new Trial(
            "x", new ReplayResult("f", "x", 300, [new ReplayResult.Axis("a", new ErrorComparison(2, 1, 1, 1))]),
            new ReplayResult("f", "x", 100, [new ReplayResult.Axis("a", new ErrorComparison(2, 3, 3, 3))]));

        Assert.That(trial.Rms, Is.EqualTo(Math.Sqrt(3)).Within(1e-12));
        Assert.That(trial.Reduction, Is.EqualTo(1 - Math.Sqrt(3) / 2).Within(1e-12));
    }
}
