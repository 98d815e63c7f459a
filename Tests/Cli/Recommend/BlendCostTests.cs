using Nowpose.Cli;
using Nowpose.Cli.Recommend;
using Nowpose.Cli.Replay;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Recommend;

public class BlendCostTests
{
    [Test]
    public void BlendCost_BlendDoublesTheError_RecommendsNoBlend()
    {
        var runs = 0;

        var cost = new BlendCost(Of(new Subject(blendMs => blendMs > 0 ? 0.4 : 0.2)), () => runs++, CancellationToken.None);

        Assert.That((cost.Share, cost.RecommendedMs), Is.EqualTo((1.0, 0.0)));
        Assert.That(runs, Is.EqualTo(BlendCost.Runs));
    }

    [TestCase(1)]
    [TestCase(BlendCost.Runs)]
    public void BlendCost_CancelledDuringARun_HasNoShareAndNoRecommendation(int run)
    {
        var (cancelled, reports) = (run, 0);
        using var end = new CancellationTokenSource();
        var subject = new Subject(_ =>
        {
            if (--run == 0) end.Cancel();
            end.Token.ThrowIfCancellationRequested();
            return 0.2;
        });

        var cost = new BlendCost(Of(subject), () => reports++, end.Token);

        Assert.That(reports, Is.EqualTo(cancelled - 1), "finished runs");
        Assert.That((cost.Share, cost.RecommendedMs), Is.EqualTo(((double?)null, (double?)null)));
        Assert.That(run, Is.Zero, "no run after the cancellation");
    }

    static Recommendation Of(ISubject subject) => new(
        subject, [new Trial(Predictors.Default, Result(0.2), Result(0.2)), new Trial("hold", Result(1), Result(1))]);

    static ReplayResult Result(double rms) => new("f", "any", 100, [new ReplayResult.Axis("a", new ErrorComparison(1, rms, rms, rms))]);

    /// <param name="rmsOf">Gets the error for the time constant of the blend, ms.</param>
    sealed class Subject(Func<double?, double> rmsOf) : ISubject
    {
        public double? SamplingMs => 50;
        public double? LatencyMs => 100;
        public double? Fps => 60;
        public int? Phases => 1;

        public Trial Try(string predictor, double? blendMs, CancellationToken cancellation)
        {
            var rms = rmsOf(blendMs);
            return new Trial(predictor, Result(rms), Result(rms));
        }
    }
}
