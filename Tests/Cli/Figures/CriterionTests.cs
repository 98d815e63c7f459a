using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class CriterionTests
{
    // "+" stands for a criterion that is met, "-" for a criterion that is not met, "?" for a criterion that was not measured, and "~" for a
    // criterion that is undecided.
    [TestCase("+", Verdict.Holds)]
    [TestCase("+++", Verdict.Holds)]
    [TestCase("+-+", Verdict.HoldsPartly)]
    [TestCase("-+", Verdict.HoldsPartly)]
    [TestCase("+?", Verdict.HoldsPartly)]
    [TestCase("--", Verdict.DoesNotHold)]
    [TestCase("-?", Verdict.DoesNotHold)]
    [TestCase("??", Verdict.NotMeasured)]
    [TestCase("~", Verdict.Undecided)]
    [TestCase("+~", Verdict.Undecided)]
    [TestCase("~?", Verdict.Undecided)]
    [TestCase("+-~", Verdict.HoldsPartly)]
    [TestCase("-~", Verdict.DoesNotHold)]
    public void Judge_Criteria_DependsOnTheNumberMet(string each, object verdict)
    {
        var criteria = each.Select(sign => new Criterion("it is so", sign is '?' or '~' ? null : sign == '+', "1") { IsUndecided = sign == '~' }).ToArray();

        Assert.That(Criterion.Judge(criteria), Is.EqualTo(verdict));
    }

    // The page of the figures reads these words.
    [TestCase(Verdict.Holds, "holds")]
    [TestCase(Verdict.HoldsPartly, "holds partly")]
    [TestCase(Verdict.DoesNotHold, "does not hold")]
    [TestCase(Verdict.NotMeasured, "not measured")]
    [TestCase(Verdict.Undecided, "undecided")]
    public void Words_EachVerdict_AreThoseOfTheFile(object verdict, string words) => Assert.That(((Verdict)verdict).Words(), Is.EqualTo(words));

    [Test]
    public void Judge_NoCriterion_Throws()
    {
        Assert.That(() => Criterion.Judge([]), Throws.ArgumentException.With.Message.StartsWith(FigureErrors.NoCriterion));
    }
}
