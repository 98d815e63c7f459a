using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class CriterionTests
{
    // "+" stands for a criterion that is met, "-" for a criterion that is not met, "?" for a criterion that was not measured.
    [TestCase("+", "holds")]
    [TestCase("+++", "holds")]
    [TestCase("+-+", "holds partly")]
    [TestCase("-+", "holds partly")]
    [TestCase("+?", "holds partly")]
    [TestCase("--", "does not hold")]
    [TestCase("-?", "does not hold")]
    [TestCase("??", "not measured")]
    public void Judge_Criteria_DependsOnTheNumberMet(string each, string verdict)
    {
        var criteria = each.Select(sign => new Criterion("it is so", sign == '?' ? null : sign == '+', "1")).ToArray();

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    [Test]
    public void Judge_NoCriterion_Throws()
    {
        Assert.That(() => Criterion.Judge([]), Throws.ArgumentException.With.Message.Contains("at least one criterion"));
    }
}
