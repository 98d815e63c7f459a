using Nowpose.Cli.Figures.Model;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class CriterionTests
{
    [TestCase(new[] { true }, "holds")]
    [TestCase(new[] { true, true, true }, "holds")]
    [TestCase(new[] { true, false, true }, "holds partly")]
    [TestCase(new[] { false, true }, "holds partly")]
    [TestCase(new[] { false, false }, "does not hold")]
    public void Judge_Criteria_DependsOnHowManyAreMet(bool[] met, string verdict)
    {
        var criteria = met.Select(isMet => new Criterion("it is so", isMet, "1")).ToArray();

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    [Test]
    public void Judge_NoCriterion_IsRefused()
    {
        Assert.That(() => Criterion.Judge([]), Throws.ArgumentException.With.Message.Contains("at least one criterion"));
    }
}
