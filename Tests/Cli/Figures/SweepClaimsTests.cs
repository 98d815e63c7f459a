using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Sweeps;
using Nowpose.Cli.Messages;
using Nowpose.Motion;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

/// <summary>Tests the verdicts on the paper's claims with artificial values.</summary>
public class SweepClaimsTests
{
    static readonly double[] Intervals = [20, 50, 100];

    static SweepData Polynomials(double[] values, double[] linear, double[] quadratic, double[] cubic) => new(values, new Dictionary<string, double[]>
    {
        ["hold"] = [.. values.Select(_ => 100.0)], ["linear"] = linear, ["quadratic"] = quadratic, ["cubic"] = cubic,
    });

    static SweepData Histories(double[] values, double[] h2, double[] h3, double[] h4) => new(values, new Dictionary<string, double[]>
    {
        ["hold"] = [.. values.Select(_ => 100.0)], ["quadratic"] = h2, ["quadratic-h3"] = h3, ["quadratic-h4"] = h4,
    });

    [TestCase(new double[] { 9, 9, 20 }, Verdict.Holds)]
    [TestCase(new double[] { 4, 9, 20 }, Verdict.HoldsPartly)]
    [TestCase(new double[] { 4, 6, 7 }, Verdict.DoesNotHold)]
    public void Figure13a_ErrorOfTheCubic_DecidesTheVerdict(double[] cubic, object verdict)
    {
        var criteria = Figure13.A.Criteria(Polynomials(Intervals, [8, 8, 11], [5, 7, 9], cubic));

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    // A move that is too short for full acceleration has fewer phases. A move with other limits exceeds the expected limits.
    [TestCase(500, 1, 100, Verdict.Holds)]
    [TestCase(500, 1, 90, Verdict.HoldsPartly)]
    [TestCase(500, 1.1, 100, Verdict.HoldsPartly)]
    [TestCase(1, 1, 100, Verdict.HoldsPartly)]
    [TestCase(1, 1.1, 90, Verdict.DoesNotHold)]
    public void Figure12_ProfileAndLag_DecideTheVerdict(double strokeMm, double factor, double lagMm, object verdict)
    {
        var move = new SevenPhaseProfile(strokeMm, 1000, 5000, factor * 50_000);

        Assert.That(Criterion.Judge(Figure12.Criteria(move, [lagMm, 150])), Is.EqualTo(verdict));
    }

    [Test]
    public void Figure13a_CubicBetterAtShortIntervals_StatesTheIntervals()
    {
        var criteria = Figure13.A.Criteria(Polynomials(Intervals, [8, 8, 11], [5, 7, 9], [4, 9, 20]));

        Assert.That(criteria[1].Measured, Is.EqualTo(Figure13Texts.CubicBetter("20 ms")));
        Assert.That(criteria[2].Measured, Is.EqualTo("cubic × 5, quadratic × 1.8"));
    }

    [TestCase(new double[] { 8, 8, 10 }, Verdict.Holds)]
    [TestCase(new double[] { 8, 8, 8 }, Verdict.HoldsPartly)]
    [TestCase(new double[] { 8, 8, 4 }, Verdict.DoesNotHold)]
    public void Figure13b_ErrorOfTheLine_DecidesTheVerdict(double[] linear, object verdict)
    {
        var criteria = Figure13.B.Criteria(Polynomials([0, 100, 250], linear, [5, 5, 5], [4, 6, 9]));

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    [TestCase(new double[] { 8, 8, 10 }, new double[0])]
    [TestCase(new double[] { 8, 8, 8 }, new double[] { 250 })]
    [TestCase(new double[] { 8, 5.5, 8 }, new double[] { 100, 250 })]
    [TestCase(new double[] { 8, 8, 4 }, new double[] { 250 })]
    public void Figure13b_CubicWorseThanTheLine_StatesTheLatencies(double[] linear, double[] worseAt)
    {
        var criteria = Figure13.B.Criteria(Polynomials([0, 100, 250], linear, [5, 5, 5], [4, 6, 9]));

        Assert.That(criteria[1].Measured, Is.EqualTo(worseAt.Length == 0 ? Figure13Texts.IsSo : Figure13Texts.WorseAt(SweepData.List(worseAt))));
    }

    [TestCase(new double[] { 9, 9, 9, 9, 9 }, Verdict.Holds)]
    [TestCase(new double[] { 9, 9, 9, 9, 4 }, Verdict.HoldsPartly)]
    [TestCase(new double[] { 9, 9, 9, 4, 4 }, Verdict.DoesNotHold)]
    public void Figure13c_ErrorOfTheLine_DecidesTheVerdict(double[] linear, object verdict)
    {
        var criteria = Figure13.C.Criteria(Polynomials([-50, -20, 0, 20, 50], linear, [5, 5, 5, 5, 5], [6, 6, 6, 6, 6]));

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    [TestCase(new double[] { 5, 8, 14 }, new double[] { 5, 20, 40 }, Verdict.Holds)]
    [TestCase(new double[] { 5, 6, 14 }, new double[] { 5, 20, 40 }, Verdict.HoldsPartly)]
    [TestCase(new double[] { 5, 6, 6 }, new double[] { 5, 6, 6 }, Verdict.DoesNotHold)]
    public void Figure13d_ErrorsOverStampError_DecideTheVerdict(double[] quadratic, double[] cubic, object verdict)
    {
        var criteria = Figure13.D.Criteria(Polynomials([0, 5, 10], [8, 8, 9], quadratic, cubic));

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    [Test]
    public void Figure13d_Criteria_NameTheErrorOfTheTimeStamps()
    {
        var criteria = Figure13.D.Criteria(Polynomials([0, 5, 10], [8, 8, 9], [5, 8, 14], [5, 20, 40]));

        Assert.That(criteria.Select(criterion => criterion.Statement), Is.All.Contains("time stamp error").And.None.Contains("latency"));
    }

    [TestCase(new double[] { 6, 6 }, new double[] { 7, 7 }, Verdict.Holds)]
    [TestCase(new double[] { 6, 4 }, new double[] { 7, 7 }, Verdict.HoldsPartly)]
    [TestCase(new double[] { 6, 4 }, new double[] { 5, 5 }, Verdict.DoesNotHold)]
    [TestCase(new double[] { 6, 4 }, new double[] { 5, 3 }, Verdict.DoesNotHold)]
    public void Figures14aTo14c_ErrorsOfLongerHistories_DecideTheVerdict(double[] h3, double[] h4, object verdict)
    {
        foreach (var claims in new[] { Figure14.A, Figure14.B, Figure14.C })
            Assert.That(Criterion.Judge(claims.Criteria(Histories([10, 20], [5, 5], h3, h4))), Is.EqualTo(verdict), claims.Number);
    }

    [TestCase(new double[] { 5, 20 }, new double[] { 6, 10 }, new double[] { 7, 9 }, Verdict.Holds)]
    [TestCase(new double[] { 5, 20 }, new double[] { 6, 8 }, new double[] { 7, 9 }, Verdict.HoldsPartly)]
    [TestCase(new double[] { 5, 8 }, new double[] { 6, 9 }, new double[] { 7, 10 }, Verdict.DoesNotHold)]
    public void Figure14d_ErrorsOverStampError_DecideTheVerdict(double[] h2, double[] h3, double[] h4, object verdict)
    {
        var criteria = Figure14.D.Criteria(Histories([0, 10], h2, h3, h4));

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }
}
