using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class CriterionTests
{
    // "+" stands for a criterion that is met, "-" for a criterion that is not met, "?" for a criterion that was not measured, and "~" for a
    // criterion that is undecided.
    [TestCase("+", "holds")]
    [TestCase("+++", "holds")]
    [TestCase("+-+", "holds partly")]
    [TestCase("-+", "holds partly")]
    [TestCase("+?", "holds partly")]
    [TestCase("--", "does not hold")]
    [TestCase("-?", "does not hold")]
    [TestCase("??", "not measured")]
    [TestCase("~", "undecided")]
    [TestCase("+~", "undecided")]
    [TestCase("~?", "undecided")]
    [TestCase("+-~", "holds partly")]
    [TestCase("-~", "does not hold")]
    public void Judge_Criteria_DependsOnTheNumberMet(string each, string verdict)
    {
        var criteria = each.Select(sign => new Criterion("it is so", sign is '?' or '~' ? null : sign == '+', "1") { IsUndecided = sign == '~' }).ToArray();

        Assert.That(Criterion.Judge(criteria).Words(), Is.EqualTo(verdict));
    }

    [Test]
    public void Judge_NoCriterion_Throws()
    {
        Assert.That(() => Criterion.Judge([]), Throws.ArgumentException.With.Message.Contains("at least one criterion"));
    }
}
