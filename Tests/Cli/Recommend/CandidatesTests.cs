using Nowpose.Cli.Recommend;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Recommend;

public class CandidatesTests
{
    [Test]
    public void Names_Candidates_IncludeEveryPredictorAndAreUnique()
    {
        Assert.That(Candidates.Names, Is.SupersetOf(Predictors.Names).And.Contain("gp").And.Unique);
    }
}
